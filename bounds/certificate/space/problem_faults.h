// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "scene/problem/problem.h"

namespace bracket::bounds::space {

/// Why a problem is not one that certify() can stand for, in one line; empty: it is. In linear time it checks that
/// - every index is in range, every number finite, every material definite;
/// - volumes are positive; a facet belongs to one cell or to two that walk it in opposite ways and have its edges in
///   common; the boundary is what has one cell;
/// - each component hangs together through facets, and is all that does;
/// - after refinement: cells are dyadic pieces of the first mesh's which meet in the same points, facets are pieces
///   that cover the first mesh's, each with its support and direction, gaps enclose the first mesh's, exactly, and
///   bodies have its materials and weights;
/// - the two facets of a contact coincide to the last bit on the first mesh and are cut alike; directions are unit
///   vectors, opposite to the last bit on the two sides and within 25° of the geometric normals;
/// - contacts have no law but that sides press and slide, or keep together with a gap that is known up to rounding;
/// - displacements that are prescribed more than once agree, exactly.
/// Then pieces tile the first mesh: they are positive, so their map onto it covers every point of a component equally
/// often, which is once, as it does so on the boundary.
/// It trusts that the cells of the first mesh do not overlap beyond their facets, and that the first mesh and its data
/// are what the user meant.
std::string problem_fault(const scene::Problem<3>& problem);

inline bool in_range(int index, std::size_t size) { return index >= 0 && static_cast<std::size_t>(index) < size; }

/// Parts of it. Of indices and numbers:
std::string index_fault(const scene::Problem<3>& problem);
std::string number_fault(const scene::Problem<3>& problem);
/// of cells, facets, edges and boundary, where all indices are in range;
std::string topology_fault(const scene::Problem<3>& problem);
/// of cells, facets and bodies as those of the first mesh, for a problem after refinement;
std::string piece_fault(const scene::Problem<3>& problem);
/// of directions, contacts and their laws;
std::string contact_fault(const scene::Problem<3>& problem);
/// of loads and displacements on the first mesh;
std::string support_fault(const scene::Problem<3>& first);
/// of what is added to the data, where they are perturbed: it fits the first mesh, is finite, loads Γ_τ alone (and
/// contacts by their opening), and is made of traces of finite energy: displacements that are one at a vertex, and ψ
/// that does not jump along a contact.
std::string perturbation_fault(const scene::Problem<3>& problem);

}  // namespace bracket::bounds::space
