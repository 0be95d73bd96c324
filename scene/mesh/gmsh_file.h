// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "scene/mesh/raw_mesh.h"

/// The text of a Gmsh file, before it is a mesh.
namespace bracket::scene {

struct GmshFile {
  using Tag = RawMesh::Tag;
  /// A line, triangle, quadrilateral or tetrahedron.
  struct Element {
    Tag tag;
    Tag entity;  ///< number of its curve, surface or volume, 0: none
    int groups;  ///< the physical groups it is in: index into `groups`
    int corners;
    bool second_order;
    std::array<Tag, 10> nodes;  ///< corners, then, of second order, a node in the middle of each side
  };
  std::vector<RawMesh::Node> nodes;
  std::vector<Element> lines, cells;                 ///< cells: triangles and quadrilaterals
  std::vector<Element> solids;                       ///< tetrahedra
  std::vector<std::set<Tag>> groups = {{}};          ///< numbers; the first: in none
  std::map<std::pair<Tag, Tag>, std::string> names;  ///< of physical groups, by dimension and number
  std::set<Tag> named_points;                        ///< physical groups of points
};

/// \throw Error (input: no such file; mesh: not ASCII 2.2 or 4.1, truncated, elements of another kind)
GmshFile read_gmsh_file(const std::filesystem::path& file);

}  // namespace bracket::scene
