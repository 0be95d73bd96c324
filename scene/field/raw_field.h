// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/field/field.h"
#include "scene/mesh/raw_mesh.h"

/// What files of displacements hold, whatever they are written in. Each reader gives a RawField; its nodes are then
/// matched to a mesh.
namespace bracket::scene {

struct RawField {
  /// A triangle or quadrilateral: its corners, of second order the middles of its sides from corner 0 on, and perhaps
  /// the node in the middle.
  struct Cell {
    int corners;
    std::vector<int> nodes;  ///< places in `nodes`
  };
  std::string file;
  std::string word;  ///< what a node is called in messages: "line" (its tag is that of the line), "point", "node"
  std::vector<RawMesh::Node> nodes = {};
  std::vector<Vector<2>> values = {};    ///< of each node
  std::vector<std::string> bodies = {};  ///< of each node; empty: the file does not say
  std::vector<Cell> cells = {};          ///< empty: the file has none
  /// By how much coordinates and values may be off by their size: the last place of what they are written in.
  double coordinate_rounding = 0, value_rounding = 0;
  std::vector<std::string> notes = {};
};

/// "x,y,ux,uy", in any order, a third coordinate and displacement that are 0, and the column `body`.
/// \throw Error (input); so below
RawField read_csv_field(const std::filesystem::path& file);
/// What VTK reads as an unstructured grid, in a process of its own.
RawField read_vtu_field(const std::filesystem::path& file);
/// CalculiX's results, ASCII; plane elements that it has made solid are taken back.
RawField read_frd_field(const std::filesystem::path& file);

/// Of a file of any of these kinds.
RawField read_raw_field(const std::filesystem::path& file);

/// \param name what it is called in messages, in place of a file
RawField raw_field_of(const NodalDisplacement& field, const std::string& name);

/// By cells, by place or interpolated, as it can be: see read_field().
GivenDisplacement matched(const RawField& field, const Mesh<2>& mesh);

/// Throws Error (input) with the place of a node.
[[noreturn]] void refuse(const RawField& field, int node, const std::string& message);

/// How far a node of the file may be from the mesh's: both are rounded; midpoints are computed of rounded ones and
/// rounded again, or places of all nodes by basis functions.
double place_tolerance(const RawField& field, const Mesh<2>& mesh);
/// By how much two values may differ that are meant to be one: each is the sum of at most nine terms, rounded once more
/// where it is written.
double value_tolerance(const RawField& field);

/// Checks what is so of fields from all formats: finite values of a size that is known, no displacement out of the
/// plane. \param out_of_plane the third component of the values, of each node; empty: there is none
void check_values(const RawField& field, const std::vector<double>& out_of_plane);

/// By place alone. Where several nodes of the mesh lie at one place the column `body` tells them apart; without it the
/// file must have one displacement there.
GivenDisplacement matched_by_place(const RawField& field, const Mesh<2>& mesh);

/// By cells, if each of the file's is one of the mesh.
/// \return nothing: it is another mesh, or one whose nodes the digits do not tell apart   \throw Error (input): cells
/// of the mesh that the file does not have, two
///         displacements at one node
std::optional<GivenDisplacement> matched_by_cells(const RawField& field, const Mesh<2>& mesh);

/// At the vertices and midpoints of the mesh, component by component of it.
/// \throw Error (input): cells outside of the mesh, nodes outside of the cells, jumps
GivenDisplacement interpolated(const RawField& field, const Mesh<2>& mesh);

}  // namespace bracket::scene
