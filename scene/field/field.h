// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scene/fields.h"
#include "scene/mesh/mesh.h"

/// Displacements that another program computed.
namespace bracket::scene {

template <int dim> struct GivenDisplacementOf {
  /// Of degree 2 if the file has the middles of the edges or is interpolated, else of degree 1.
  Displacement<dim> displacement;
  /// Whether it was computed on another mesh, and is here its values at the vertices and midpoints of this one.
  bool interpolated = false;
  double off = 0;  ///< the largest distance, a length, between a node of the mesh and the file's; 0 where interpolated
  std::vector<std::string> notes;  ///< what was chosen or left out on reading, one line each
};
using GivenDisplacement = GivenDisplacementOf<2>;

/// The edges in whose middles a simplex of second order has nodes, in their order, by the places of its corners.
template <int dim> constexpr std::array<std::array<int, 2>, Simplex<dim>::n_edges> edges_in_files() {
  if constexpr (dim == 2) return {{{0, 1}, {1, 2}, {2, 0}}};
  if constexpr (dim == 3) return {{{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}};
}
/// Values at nodes, as another program has them in its arrays.
template <int dim> struct NodalDisplacementOf {
  std::vector<Vector<dim>> nodes, values;
  std::vector<std::string> bodies = {};  ///< of each node, where bodies touch; empty: they are not told
  /// Triangles and quadrilaterals by places in `nodes`: 3 or 4 corners and, of second order, the middles of the sides
  /// from the one behind corner 0 on, of quadrilaterals perhaps the node in the middle. In space tetrahedra: 4 corners
  /// and, of second order, the middles of edges_in_files(). Empty: nodes are matched by their place
  /// alone.
  std::vector<std::vector<int>> cells = {};
};
using NodalDisplacement = NodalDisplacementOf<2>;

/// Reads the nodal displacements of a file: CSV, VTK's .vtu or CalculiX's .frd (docs/other-programs.md). Its nodes are
/// taken for those of the mesh by their place, to the digits that they are written with, and where bodies touch by the
/// cells that have them; a .vtu or .frd of another mesh of the same bodies is interpolated.
/// \param mesh that of the problem the displacement is for
/// \throw Error (input), one line with the file and, where there is one, the line in it: not readable, truncated, no
///        displacement, values that are not finite or, for the plane, not plane, nodes that the mesh has not or of the
///        mesh that are missing, another domain, two displacements at one node
template <int dim> GivenDisplacementOf<dim> read_field(const std::filesystem::path& file, const Mesh<dim>& mesh);

}  // namespace bracket::scene
