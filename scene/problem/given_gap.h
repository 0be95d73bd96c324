// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "scene/scene.h"

/// What a scene asks of the sides of a contact facet, as functions on its first side.
namespace bracket::scene {

/// The gap along d: as it is written, or, in the plane, that of a prescribed jump, or the distance to a circle; empty:
/// as it is drawn.
std::optional<Function<2>> given_gap(const ContactPair<2>& pair, const Vector<2>& d);
std::optional<Function<3>> given_gap(const ContactPair<3>& pair, const Vector<3>& d);
/// Planar: what friction does not see of v_t where a jump is prescribed; empty: nothing.
std::optional<Function<2>> given_slip(const ContactPair<2>& pair, const Vector<2>& d);

}  // namespace bracket::scene
