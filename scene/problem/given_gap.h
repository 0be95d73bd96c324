// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "scene/scene.h"

/// Planar: what a scene asks of the sides of a contact facet, as functions on its first side.
namespace bracket::scene {

/// The gap along d: as it is written, that of a prescribed jump, or the distance to a circle; empty: as it is drawn.
std::optional<Function<2>> given_gap(const ContactPair<2>& pair, const Vector<2>& d);
/// What friction does not see of v_t where a jump is prescribed; empty: nothing.
std::optional<Function<2>> given_slip(const ContactPair<2>& pair, const Vector<2>& d);

}  // namespace bracket::scene
