// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/field/field.h"
#include "scene/mesh/raw_mesh.h"

/// What files of displacements hold, whatever they are written in. Each reader gives a RawField; its nodes are then
/// matched to a mesh.
namespace bracket::scene {

template <int dim> struct RawField {
  /// A triangle or quadrilateral: its corners, of second order the middles of its sides from corner 0 on, and perhaps
  /// the node in the middle. In space a tetrahedron: its corners, of second order the middles of edges_in_files().
  struct Cell {
    int corners;
    std::vector<int> nodes;  ///< places in `nodes`
  };
  std::string file;
  std::string word;  ///< what a node is called in messages: "line" (its tag is that of the line), "point", "node"
  std::vector<RawMesh::Node> nodes = {};
  std::vector<Vector<dim>> values = {};  ///< of each node
  std::vector<std::string> bodies = {};  ///< of each node; empty: the file does not say
  std::vector<Cell> cells = {};          ///< empty: the file has none
  /// By how much coordinates and values may be off by their size: the last place of what they are written in.
  double coordinate_rounding = 0, value_rounding = 0;
  std::vector<std::string> notes = {};
};

/// The most nodes that a cell has.
template <int dim> constexpr int most_nodes = dim == 2 ? 9 : 10;

/// "x,y,ux,uy", in the plane perhaps a third coordinate and displacement that are 0, in space "x,y,z,ux,uy,uz", in any
/// order, and the column `body`.
/// \throw Error (input); so below
template <int dim> RawField<dim> read_csv_field(const std::filesystem::path& file);
/// What VTK reads as an unstructured grid, in a process of its own.
template <int dim> RawField<dim> read_vtu_field(const std::filesystem::path& file);
/// CalculiX's results, ASCII; plane elements that it has made solid are taken back.
template <int dim> RawField<dim> read_frd_field(const std::filesystem::path& file);

/// Of a file of any of these kinds.
template <int dim> RawField<dim> read_raw_field(const std::filesystem::path& file);

/// \param name what it is called in messages, in place of a file
template <int dim> RawField<dim> raw_field_of(const NodalDisplacementOf<dim>& field, const std::string& name);

/// By cells, by place or interpolated, as it can be: see read_field().
template <int dim> GivenDisplacementOf<dim> matched(const RawField<dim>& field, const Mesh<dim>& mesh);

/// Throws Error (input) with the place of a node.
template <int dim> [[noreturn]] void refuse(const RawField<dim>& field, int node, const std::string& message);

/// How far a node of the file may be from the mesh's: both are rounded; midpoints are computed of rounded ones and
/// rounded again, or places of all nodes by basis functions.
template <int dim> double place_tolerance(const RawField<dim>& field, const Mesh<dim>& mesh);
/// By how much two values may differ that are meant to be one: each is the sum of at most as many terms as a cell
/// has nodes, rounded once more where it is written.
template <int dim> double value_tolerance(const RawField<dim>& field);

/// Checks what is so of fields from all formats: finite values of a size that is known, in the plane no displacement
/// out of it. \param out_of_plane the third component of the values, of each node; empty: there is none
template <int dim> void check_values(const RawField<dim>& field, const std::vector<double>& out_of_plane);

/// By place alone. Where several nodes of the mesh lie at one place the column `body` tells them apart; without it the
/// file must have one displacement there.
template <int dim> GivenDisplacementOf<dim> matched_by_place(const RawField<dim>& field, const Mesh<dim>& mesh);

/// By cells, if each of the file's is one of the mesh.
/// \return nothing: it is another mesh, or one whose nodes the digits do not tell apart   \throw Error (input): cells
/// of the mesh that the file does not have, two
///         displacements at one node
template <int dim>
std::optional<GivenDisplacementOf<dim>> matched_by_cells(const RawField<dim>& field, const Mesh<dim>& mesh);

/// At the vertices and midpoints of the mesh, component by component of it.
/// \throw Error (input): cells outside of the mesh, nodes outside of the cells, jumps; in space curved edges
template <int dim> GivenDisplacementOf<dim> interpolated(const RawField<dim>& field, const Mesh<dim>& mesh);

}  // namespace bracket::scene
