// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/scene.h"

/// Plane scenes in space.
namespace bracket::tests::space {

/// A scene of plane strain between two ends, z = 0 and z = thickness, that slide: its energy is `thickness` times the
/// plane's. One layer of prisms over the triangles of `mesh`, the scene's first, each cut in three.
/// \pre frictionless contact, rigid walls but no obstacles, no quantities
scene::Scene<3> extruded(const scene::Scene<2>& plane, const scene::Mesh<2>& mesh, double thickness);

}  // namespace bracket::tests::space
