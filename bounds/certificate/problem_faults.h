// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "scene/problem/problem.h"

namespace bracket::bounds {

/// Why a problem is not one that certify() can stand for, in one line; empty: it is. In linear time it checks that
/// - every index is in range, every number finite, every material definite;
/// - cells are counter-clockwise, an edge belongs to one cell or to two that walk it in opposite ways, the boundary is
///   what has one cell;
/// - each component hangs together through edges, and is all that does;
/// - after refinement: cells are dyadic pieces of the first mesh's which meet in the same points, facets are pieces
///   that cover the first mesh's, each with its support and direction, gaps enclose the first mesh's, as
///   scene::enclosed_gap() finds them where they are no quadratics, and bodies have its materials and weights;
/// - the two facets of a contact lie on each other, cut alike; directions are unit vectors, opposite to the last bit on
///   the two sides and within 25° of the geometric normals;
/// - laws of contacts are finite, springs at both ends or none, friction not negative, only of sides that coincide and
///   not beside springs, gaps of two-sided ones known up to rounding; after refinement they are the first mesh's;
/// - displacements that are prescribed twice agree.
/// It trusts that the cells of the first mesh do not overlap beyond their edges, and that the first mesh and its data
/// are what the user meant; and that functions over intervals, and so enclosed_gap(), enclose what they say.
std::string problem_fault(const scene::Problem<2>& problem);

/// Of each vertex, the boundary facet that ends there and the one that begins; −1: none.
std::vector<std::array<int, 2>> facets_that_meet(const scene::Mesh<2>& mesh);

inline bool in_range(int index, std::size_t size) { return index >= 0 && static_cast<std::size_t>(index) < size; }

/// Parts of it. Of cells, edges and boundary, where all indices are in range:
std::string topology_fault(const scene::Problem<2>& problem);
/// of cells and facets as pieces of those of the first mesh, for a problem after refinement;
std::string piece_fault(const scene::Problem<2>& problem);
/// and of materials and weights, as the first mesh has them. \pre perturbation_fault() finds none
std::string body_fault(const scene::Problem<2>& problem);

/// A part of it, of contact laws. \pre the contacts are those of the first mesh
std::string law_fault(const scene::Problem<2>& problem);

/// A part of it, empty for a problem that is not perturbed: what is added to the data fits the first mesh, is finite,
/// loads no facet of Γ_u (and contacts by pairs of forces, too, along t where they have friction), and is made of
/// traces of finite energy: displacements that are one at a vertex, and ψ that does not jump along a contact line.
std::string perturbation_fault(const scene::Problem<2>& problem);

}  // namespace bracket::bounds
