// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// Planar: rectangles of triangles.
#include "scene/mesh/readers.h"
#include "scene/mesh/topology.h"
#include "scene/text.h"

namespace bracket::scene {

namespace {

/// The boundary edges of a grid of nx × ny squares whose lower left vertex is `first`; parts in the order left, right,
/// bottom, top, from `part` on.
std::vector<PartEdge> grid_boundary(int first, int nx, int ny, int part) {
  const auto vertex = [=](int i, int j) { return first + j * (nx + 1) + i; };
  std::vector<PartEdge> edges;
  for (int j = 0; j < ny; ++j) {
    edges.push_back({{vertex(0, j), vertex(0, j + 1)}, part});
    edges.push_back({{vertex(nx, j), vertex(nx, j + 1)}, part + 1});
  }
  for (int i = 0; i < nx; ++i) {
    edges.push_back({{vertex(i, 0), vertex(i + 1, 0)}, part + 2});
    edges.push_back({{vertex(i, ny), vertex(i + 1, ny)}, part + 3});
  }
  return edges;
}

Mesh<2> build_blocks(const std::vector<Block<2>>& blocks, const std::string& where) {
  Mesh<2> mesh;
  std::vector<PartEdge> part_edges;
  for (const Block<2>& block : blocks) {
    const auto [nx, ny] = block.cells;
    const int first = static_cast<int>(mesh.vertices.size());
    const int body = static_cast<int>(mesh.bodies.size());
    const auto at = [&](int axis, int i) {  // exact at both ends, so that blocks meet
      const auto& [from, to] = block.range[axis];
      const int n = block.cells[axis];
      return i == n ? to : from + (to - from) * i / n;
    };
    for (int j = 0; j <= ny; ++j) {
      for (int i = 0; i <= nx; ++i) mesh.vertices.push_back({at(0, i), at(1, j)});
    }
    for (int j = 0; j < ny; ++j) {
      for (int i = 0; i < nx; ++i) {
        const int corner = first + j * (nx + 1) + i;
        mesh.cells.push_back({corner, corner + 1, corner + nx + 2});
        mesh.cells.push_back({corner, corner + nx + 2, corner + nx + 1});
      }
    }
    mesh.cell_body.resize(mesh.cells.size(), body);
    mesh.bodies.push_back(block.body);
    for (const PartEdge& edge : grid_boundary(first, nx, ny, 4 * body)) part_edges.push_back(edge);
    for (const char* side : {".left", ".right", ".bottom", ".top"}) mesh.parts.push_back(block.body + side);
  }
  return with_topology(std::move(mesh), part_edges, where);
}

}  // namespace

template <int dim> Mesh<dim> build_mesh(const Scene<dim>& scene) {
  static_assert(dim == 2);
  check(scene);
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

template Mesh<2> build_mesh(const Scene<2>&);

}  // namespace bracket::scene
