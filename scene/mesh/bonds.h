// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/scene.h"

namespace bracket::scene {

/// The mesh with the sides of bonds joined: their vertices become one, at the place of the first side's, and their
/// facets lie inside of a component. A note says so of each bond.
/// \throw Error (input): a part that the mesh does not have; (mesh): sides that do not coincide node by node, within
///        tolerance() of the facets (scene/problem/tolerance.h); as with_topology(), at `where`
template <int dim> Mesh<dim> bonded(Mesh<dim> mesh, const std::vector<Bond>& bonds, const std::string& where);

}  // namespace bracket::scene
