// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/problem/problem.h"

namespace bracket::scene {

/// A problem on a refined mesh, and where its pieces come from.
template <int dim> struct Refined {
  Problem<dim> problem;
  std::vector<int> cell_parent;     ///< of each cell: index into the old Mesh::cells
  std::vector<int> contact_parent;  ///< of each contact facet: index into the old Problem::contact
};

/// In the plane newest-vertex bisection: all three edges of a marked cell are halved (it falls into four), and of
/// others as many as keep the mesh conforming and the two sides of each contact matched. A cell is cut from the
/// midpoint of its refinement edge to the vertex opposite; a child's refinement edge is opposite to that midpoint, so
/// that the descendants of one coarse cell have at most four shapes. The problem stays the same: bodies, names and data
/// are inherited from the first mesh, exactly (Origin) and, for the formulations, rounded; gaps that are no quadratics
/// are enclosed anew. The order is that of the parents, and vertices keep their numbers. Linear in the number of cells.
/// In space a marked cell is bisected once, others as conformity asks (scene/mesh/space/bisection.h); boundary facets
/// have the order of their vertices.
/// \pre `marked` has an entry for each cell; the mesh is from build_mesh(), read_mesh() or refine()
/// \throw Error (budget) where cells have become so small that rounding of coordinates spoils their shape, or 52
///        halvings deep
template <int dim> Refined<dim> refine(const Problem<dim>& problem, const std::vector<char>& marked);
template <> Refined<3> refine(const Problem<3>& problem, const std::vector<char>& marked);

template <int dim> struct Scene;

/// The mesh that refine() makes, its new vertices on the arcs of the scene, for fix_data(): a problem of its own. In
/// space marked cells are bisected three times, into eight, so that their facets are halved both ways, as edges are in
/// the plane.
template <int dim>
Mesh<dim> finer_mesh(const Scene<dim>& scene, const Problem<dim>& problem, const std::vector<char>& marked);
template <> Mesh<3> finer_mesh(const Scene<3>& scene, const Problem<3>& problem, const std::vector<char>& marked);

}  // namespace bracket::scene
