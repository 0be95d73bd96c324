// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// Planar: triangles in the plane z = 0, boundary parts of lines.
#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "scene/mesh/gmsh_file.h"
#include "scene/mesh/topology.h"
#include "scene/text.h"

namespace bracket::scene {

namespace {

using Tag = GmshFile::Tag;

/// Places of nodes by tag.
class NodeIndex {
 public:
  NodeIndex(const GmshFile& file, std::string where) : where_(std::move(where)) {
    entries_.reserve(file.nodes.size());
    for (const auto& node : file.nodes) entries_.emplace_back(node.tag, static_cast<int>(entries_.size()));
    if (!std::is_sorted(entries_.begin(), entries_.end())) std::sort(entries_.begin(), entries_.end());
    const auto twice = std::adjacent_find(entries_.begin(), entries_.end(),
                                          [](const auto& a, const auto& b) { return a.first == b.first; });
    if (twice != entries_.end()) fail(Status::mesh, where_, fmt::format("the node {} is there twice", twice->first));
  }

  int operator()(Tag tag, const char* kind, Tag element) const {
    const auto found = std::lower_bound(guess(tag), entries_.end(), std::pair(tag, 0));
    if (found != entries_.end() && found->first == tag) return found->second;
    fail(Status::mesh, where_, fmt::format("{} {} has the node {}, which is not there", kind, element, tag));
  }

 private:
  using Entries = std::vector<std::pair<Tag, int>>;

  /// Tags mostly follow each other without holes: try that place first, and search all only if it fails.
  Entries::const_iterator guess(Tag tag) const {
    if (entries_.empty() || tag < entries_.front().first) return entries_.begin();
    const auto offset = static_cast<std::uint64_t>(tag) - static_cast<std::uint64_t>(entries_.front().first);
    const bool hit = offset < entries_.size() && entries_[offset].first == tag;
    return hit ? entries_.begin() + static_cast<std::ptrdiff_t>(offset) : entries_.begin();
  }

  Entries entries_;
  std::string where_;
};

/// The physical groups that `elements` are in: numbers, sorted.
template <typename Elements> std::vector<Tag> groups_of(const Elements& elements) {
  std::vector<Tag> groups;
  for (const auto& element : elements) {
    if (groups.empty() || groups.back() != element.physical) groups.push_back(element.physical);
  }
  std::sort(groups.begin(), groups.end());
  groups.erase(std::unique(groups.begin(), groups.end()), groups.end());
  return groups;
}

int place(const std::vector<Tag>& groups, Tag group) {
  return static_cast<int>(std::lower_bound(groups.begin(), groups.end(), group) - groups.begin());
}

/// Their names. Two groups of one name would be one body or part in the scene file, so they are refused.
std::vector<std::string> names_of(const GmshFile& file, Tag dimension, const std::vector<Tag>& groups,
                                  const std::string& where) {
  std::vector<std::string> names;
  for (const Tag group : groups) {
    const auto named = file.names.find({dimension, group});
    std::string name = named == file.names.end() ? std::to_string(group) : named->second;
    if (std::find(names.begin(), names.end(), name) != names.end()) {
      fail(Status::mesh, where, fmt::format("two physical groups are named '{}'", name));
    }
    names.push_back(std::move(name));
  }
  return names;
}

/// Refuses a mesh whose nodes do not lie in the plane z = 0, to rounding of its size.
void check_plane(const GmshFile& file, const std::vector<int>& vertex_of_node, const std::string& where) {
  double size = 0;
  for (std::size_t i = 0; i < file.nodes.size(); ++i) {
    if (vertex_of_node[i] >= 0) size = std::max({size, std::abs(file.nodes[i].x[0]), std::abs(file.nodes[i].x[1])});
  }
  for (std::size_t i = 0; i < file.nodes.size(); ++i) {
    if (vertex_of_node[i] < 0 || std::abs(file.nodes[i].x[2]) <= 1e-9 * size) continue;
    fail(Status::mesh, where,
         fmt::format("the node {} has z = {}: the mesh is 3D, only meshes in the plane z = 0 are read",
                     file.nodes[i].tag, file.nodes[i].x[2]));
  }
}

void check_triangles(const GmshFile& file, const std::string& where) {
  if (file.triangles.empty()) {
    fail(Status::mesh, where,
         "the mesh has no triangles; Gmsh saves only those in physical surfaces, which name the bodies");
  }
  if (file.triangles.size() + file.nodes.size() > std::numeric_limits<int>::max() / 8) {
    fail(Status::mesh, where, "the mesh is too large");
  }
  const auto stray = std::find_if(file.triangles.begin(), file.triangles.end(),
                                  [](const auto& triangle) { return triangle.physical == 0; });
  if (stray == file.triangles.end()) return;
  fail(Status::mesh, where,
       fmt::format("the triangle {} is in no physical surface; physical surfaces name the bodies", stray->tag));
}

std::vector<GmshFile::Element<2>> lines_in_groups(const GmshFile& file) {
  std::vector<GmshFile::Element<2>> lines;
  std::copy_if(file.lines.begin(), file.lines.end(), std::back_inserter(lines),
               [](const auto& line) { return line.physical != 0; });
  return lines;
}

/// What the digits of a file leave open of its coordinates, by their size: they have as many as the longest of them
/// has. Fewer than six are not taken for rounding, but for what is meant.
double rounding_of(const std::vector<Vector<2>>& points) {
  std::size_t digits = 0;
  for (const Vector<2>& x : points)
    for (int c = 0; c < 2; ++c) {
      const std::string text = fmt::format("{:e}", x[c]);  // the shortest that reads back
      digits = std::max<std::size_t>(digits, std::count_if(text.begin(), text.begin() + text.find('e'),
                                                           [](char sign) { return sign >= '0' && sign <= '9'; }));
    }
  if (digits < 6 || digits > 15) return std::numeric_limits<double>::epsilon() / 2;
  return 5 * std::pow(10.0, -static_cast<double>(digits));
}

}  // namespace

template <int dim> Mesh<dim> read_gmsh(const std::filesystem::path& path) {
  static_assert(dim == 2);
  const std::string where = path.string();
  const GmshFile file = read_gmsh_file(path);
  check_triangles(file, where);
  const std::vector<Tag> surfaces = groups_of(file.triangles);
  Mesh<dim> mesh;
  mesh.bodies = names_of(file, 2, surfaces, where);
  const NodeIndex index(file, where);
  std::vector<int> vertex(file.nodes.size(), -1);
  mesh.cells.reserve(file.triangles.size());
  mesh.cell_body.reserve(file.triangles.size());
  for (const auto& triangle : file.triangles) {
    std::array<int, 3> cell;
    for (int k = 0; k < 3; ++k) {
      cell[k] = index(triangle.nodes[k], "the triangle", triangle.tag);
      vertex[cell[k]] = 0;
    }
    mesh.cells.push_back(cell);
    mesh.cell_body.push_back(place(surfaces, triangle.physical));
  }
  check_plane(file, vertex, where);
  for (std::size_t node = 0; node < vertex.size(); ++node) {
    if (vertex[node] == -1) continue;
    vertex[node] = static_cast<int>(mesh.vertices.size());
    mesh.vertices.push_back({file.nodes[node].x[0], file.nodes[node].x[1]});
  }
  mesh.coordinate_rounding = rounding_of(mesh.vertices);
  for (auto& cell : mesh.cells) {
    for (int& corner : cell) corner = vertex[corner];
  }

  const std::vector<GmshFile::Element<2>> lines = lines_in_groups(file);
  const std::vector<Tag> curves = groups_of(lines);
  mesh.parts = names_of(file, 1, curves, where);
  std::vector<PartEdge> part_edges;
  for (const auto& line : lines) {
    const int part = place(curves, line.physical);
    const std::array<int, 2> ends = {vertex[index(line.nodes[0], "the line", line.tag)],
                                     vertex[index(line.nodes[1], "the line", line.tag)]};
    if (ends[0] < 0 || ends[1] < 0) {
      fail(Status::mesh, where,
           fmt::format("the line {} of '{}' has a node that no triangle has", line.tag, mesh.parts[part]));
    }
    part_edges.push_back({ends, part});
  }
  return with_topology(std::move(mesh), part_edges, where);
}

template Mesh<2> read_gmsh(const std::filesystem::path&);

}  // namespace bracket::scene
