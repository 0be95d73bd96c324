// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/scene/space/boxes.h"

#include <map>
#include <numbers>

namespace bracket::scene::test {

Scene<3> unit_boxes(int cells) {
  Scene<3> scene;
  scene.blocks = {{"lower", {{{0, 1}, {0, 1}, {0, 1}}}, {cells, cells, cells}, ""},
                  {"upper", {{{0, 1}, {1, 2}, {0, 1}}}, {cells, cells, cells}, ""}};
  scene.bodies.emplace("lower", isotropic<3>(1, 0.3));
  scene.bodies.emplace("upper", isotropic<3>(1, 0.3));
  scene.boundary["lower.bottom"] = {ConditionKind::fixed, {0.0, 0.0, 0.0}};
  scene.contact = {{"upper.bottom", "lower.top", 0.0, ""}};
  return scene;
}

Scene<3> given(const Mesh<3>& mesh, Scene<3> scene) {
  scene.blocks.clear();
  scene.given = GivenMesh<3>{mesh.vertices, mesh.cells, {}, {}};
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
    scene.given->bodies[mesh.bodies[mesh.cell_body[cell]]].push_back(static_cast<int>(cell));
  for (const auto& facet : mesh.boundary)
    if (facet.part >= 0) scene.given->parts[mesh.parts[facet.part]].push_back(facet.vertices);
  return scene;
}

Mesh<3> shaken(Mesh<3> mesh, Random& random, double size) {
  std::vector<std::array<char, 3>> held(mesh.vertices.size(), {0, 0, 0});  // axes along which sides hold a vertex
  for (std::size_t f = 0; f < mesh.boundary.size(); ++f) {
    const Vector<3> n = normal(mesh, static_cast<int>(f));
    for (int c = 0; c < 3; ++c)
      for (const int v : mesh.boundary[f].vertices)
        if (n[c] != 0) held[v][c] = 1;
  }
  std::map<std::array<double, 3>, Vector<3>> moved;  // alike where vertices of two bodies lie on each other
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    const Vector<3> x = mesh.vertices[v];
    auto [place, fresh] = moved.try_emplace({x[0], x[1], x[2]}, x);
    if (fresh)
      for (int c = 0; c < 3; ++c)
        if (!held[v][c]) place->second[c] += uniform(random, -size, size);
    mesh.vertices[v] = place->second;
  }
  return mesh;
}

Mesh<3> turned_about(Mesh<3> mesh, const Eigen::Matrix3d& rotation, const Vector<3>& by) {
  for (Vector<3>& x : mesh.vertices) x = rotation * x + by;
  return mesh;
}

Eigen::Matrix3d random_rotation(Random& random) {
  Vector<3> axis;
  for (double& x : axis) x = uniform(random, -1, 1);
  return Eigen::AngleAxisd(uniform(random, 0, std::numbers::pi), axis.normalized()).toRotationMatrix();
}

int generation(const Problem<3>& problem, std::size_t cell) {
  const Piece<3> piece = piece_of_cell(problem, static_cast<int>(cell));
  Eigen::Matrix3d edges;
  for (int k = 0; k < 3; ++k)
    for (int i = 0; i < 3; ++i) edges(i, k) = piece.corner[k + 1][i] - piece.corner[0][i];
  return static_cast<int>(std::lround(-std::log2(std::abs(edges.determinant()))));
}

}  // namespace bracket::scene::test
