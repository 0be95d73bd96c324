// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

/// The text of a Gmsh file, before it is a mesh.
namespace bracket::scene {

struct GmshFile {
  using Tag = std::int64_t;
  struct Node {
    Tag tag;
    std::array<double, 3> x;
  };
  template <int n> struct Element {
    Tag tag;
    Tag physical;  ///< number of its physical group, 0: none
    std::array<Tag, n> nodes;
  };
  std::vector<Node> nodes;
  std::vector<Element<2>> lines;
  std::vector<Element<3>> triangles;
  std::map<std::pair<Tag, Tag>, std::string> names;  ///< of physical groups, by dimension and number
};

/// \throw Error (input: no such file; mesh: not ASCII 2.2 or 4.1, truncated, other elements than points, lines and
///        triangles of first order)
GmshFile read_gmsh_file(const std::filesystem::path& file);

}  // namespace bracket::scene
