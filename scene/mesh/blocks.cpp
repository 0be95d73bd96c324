// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// Planar: rectangles of triangles.
#include <algorithm>
#include <map>
#include <tuple>

#include "scene/mesh/bonds.h"
#include "scene/mesh/readers.h"
#include "scene/mesh/topology.h"
#include "scene/text.h"

namespace bracket::scene {

namespace {

/// The boundary edges of a grid of nx × ny squares with these vertices, row by row; of the parts in the order left,
/// right, bottom, top.
std::vector<PartEdge> grid_boundary(const std::vector<int>& vertices, int nx, int ny, const std::array<int, 4>& parts) {
  const auto vertex = [&](int i, int j) { return vertices[j * (nx + 1) + i]; };
  std::vector<PartEdge> edges;
  for (int j = 0; j < ny; ++j) {
    edges.push_back({{vertex(0, j), vertex(0, j + 1)}, parts[0]});
    edges.push_back({{vertex(nx, j), vertex(nx, j + 1)}, parts[1]});
  }
  for (int i = 0; i < nx; ++i) {
    edges.push_back({{vertex(i, 0), vertex(i + 1, 0)}, parts[2]});
    edges.push_back({{vertex(i, ny), vertex(i + 1, ny)}, parts[3]});
  }
  return edges;
}

/// The place of a name in the list, to which it is added if it is not there.
int place_of(const std::string& name, std::vector<std::string>& names) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) return static_cast<int>(found - names.begin());
  names.push_back(name);
  return static_cast<int>(names.size()) - 1;
}

/// Without those that two blocks of a body share.
std::vector<PartEdge> outer(const std::vector<PartEdge>& edges) {
  std::map<std::array<int, 2>, int> times;
  const auto key = [](const PartEdge& edge) {
    return std::array{std::ranges::min(edge.vertices), std::ranges::max(edge.vertices)};
  };
  for (const PartEdge& edge : edges) ++times[key(edge)];
  std::vector<PartEdge> result;
  for (const PartEdge& edge : edges)
    if (times[key(edge)] == 1) result.push_back(edge);
  return result;
}

Mesh<2> build_blocks(const std::vector<Block<2>>& blocks, const std::string& where) {
  Mesh<2> mesh;
  std::vector<PartEdge> part_edges;
  std::map<std::tuple<int, double, double>, int> on_sides;  // vertices of each body, which blocks may share
  for (const Block<2>& block : blocks) {
    const auto [nx, ny] = block.cells;
    const int body = place_of(block.body, mesh.bodies);
    const auto at = [&](int axis, int i) {  // exact at both ends, so that blocks meet
      const auto& [from, to] = block.range[axis];
      const int n = block.cells[axis];
      return i == n ? to : from + (to - from) * i / n;
    };
    std::vector<int> vertices;
    for (int j = 0; j <= ny; ++j) {
      for (int i = 0; i <= nx; ++i) {
        const int next = static_cast<int>(mesh.vertices.size());
        const bool inside = i > 0 && i < nx && j > 0 && j < ny;
        vertices.push_back(inside ? next : on_sides.try_emplace({body, at(0, i), at(1, j)}, next).first->second);
        if (vertices.back() == next) mesh.vertices.push_back({at(0, i), at(1, j)});
      }
    }
    for (int j = 0; j < ny; ++j) {
      for (int i = 0; i < nx; ++i) {
        const int* corner = &vertices[j * (nx + 1) + i];
        mesh.cells.push_back({corner[0], corner[1], corner[nx + 2]});
        mesh.cells.push_back({corner[0], corner[nx + 2], corner[nx + 1]});
      }
    }
    mesh.cell_body.resize(mesh.cells.size(), body);
    std::array<int, 4> parts;
    for (int side = 0; side < 4; ++side) {
      static constexpr std::array<const char*, 4> names = {".left", ".right", ".bottom", ".top"};
      parts[side] = place_of(block.body + (block.name.empty() ? "" : "." + block.name) + names[side], mesh.parts);
    }
    for (const PartEdge& edge : grid_boundary(vertices, nx, ny, parts)) part_edges.push_back(edge);
  }
  return with_topology(std::move(mesh), outer(part_edges), where);
}

/// As build_mesh(), before sides are joined.
Mesh<2> with_bonds_open(const Scene<2>& scene) {
  if (scene.given) return mesh_of(raw_mesh_of(*scene.given), scene, scene.mesh_where);
  if (scene.mesh_file.empty()) return build_blocks(scene.blocks, scene.mesh_where);
  RawMesh raw;
  try {
    raw = read_raw_mesh(scene.mesh_file);
  } catch (const Error& error) {
    // That there is no such file is to be mended in the scene, the rest in the mesh file.
    if (error.status() == Status::input) fail(Status::input, scene.mesh_where, error.what());
    throw;
  }
  return mesh_of(raw, scene, scene.mesh_file.string());
}

}  // namespace

template <int dim> Mesh<dim> build_mesh(const Scene<dim>& scene) {
  static_assert(dim == 2);
  check(scene);
  return bonded(with_bonds_open(scene), scene.bonds,
                scene.mesh_file.empty() ? scene.mesh_where : scene.mesh_file.string());
}

template Mesh<2> build_mesh(const Scene<2>&);

}  // namespace bracket::scene
