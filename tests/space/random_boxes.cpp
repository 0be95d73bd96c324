// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/space/random_boxes.h"

#include <algorithm>
#include <numeric>

#include "bounds/bounds.h"
#include "tests/scene/space/boxes.h"

namespace bracket::tests::space {

namespace {

using scene::ConditionKind;
using scene::test::uniform;

const std::array<const char*, 2> names = {"lower", "upper"};
const std::map<std::string, scene::Vector<3>> normals = {{"left", {-1, 0, 0}},   {"right", {1, 0, 0}},
                                                         {"bottom", {0, -1, 0}}, {"top", {0, 1, 0}},
                                                         {"back", {0, 0, -1}},   {"front", {0, 0, 1}}};

using Affine = std::array<double, 4>;  ///< a + b x + c y + d z
template <class Place> auto value(const Affine& c, const Place& x) {
  return x[0] * c[1] + x[1] * c[2] + x[2] * c[3] + c[0];
}
scene::Function<3> function(const Affine& c) {
  return scene::enclosed<3>([c](const auto& x) { return value(c, x); });
}

/// Of turned places what an affine function is of straight ones.
Affine turned(double constant, const scene::Vector<3>& slope, const Eigen::Matrix3d& rotation) {
  const scene::Vector<3> c = rotation * slope;
  return {constant, c[0], c[1], c[2]};
}

/// The same of vectors, which are turned, too.
std::vector<scene::Function<3>> turned_vector(const scene::Vector<3>& constant, const Eigen::Matrix3d& slope,
                                              const Eigen::Matrix3d& rotation) {
  const scene::Vector<3> there = rotation * constant;
  const Eigen::Matrix3d along = rotation * slope;
  std::vector<scene::Function<3>> result;
  for (int i = 0; i < 3; ++i) result.push_back(function(turned(there[i], along.row(i).transpose(), rotation)));
  return result;
}

}  // namespace

RandomBoxes::RandomBoxes(std::mt19937& random) {
  const auto within = [&](double size) { return uniform(random, -size, size); };
  const double ratio = std::pow(10, uniform(random, 0, 3));
  young = random() % 2 == 0 ? std::array{1.0, ratio} : std::array{ratio, 1.0};
  for (double& nu : poisson) nu = uniform(random, 0, 0.49);
  strain.setZero();  // what is prescribed along y is 0 at the wall, and in contact alike on both sides
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k)
      if (i != 1 || k == 1) strain(i, k) = within(0.02);
  force = {within(0.02), within(0.02), within(0.02)};
  for (auto& one : load)
    for (double& c : one.reshaped()) c = within(0.05);
  on_wall = random() % 3 != 0;
  std::array<bool, 2> held = {false, false};
  for (int body = 0; body < 2; ++body)
    for (const auto& [side, normal] : normals) {
      if (side == (body == 0 ? "top" : "bottom") || (body == 0 && side == std::string("bottom") && on_wall)) continue;
      const double draw = uniform(random, 0, 1);
      if (draw > 0.8) continue;
      kinds[names[body] + ("." + side)] = draw < 0.15   ? ConditionKind::fixed
                                          : draw < 0.4  ? ConditionKind::sliding
                                          : draw < 0.65 ? ConditionKind::traction
                                                        : ConditionKind::pressure;
      held[body] = held[body] || draw < 0.15;
    }
  gap = {uniform(random, 0, 0.01), uniform(random, 0, 0.01), uniform(random, 0, 0.01), uniform(random, 0, 0.01)};
  if (!held[0] || !held[1]) gap[0] -= 0.01;
}

scene::Mesh<3> RandomBoxes::mesh(int n, std::mt19937& random) const {
  return scene::test::shaken(scene::build_mesh(scene::test::unit_boxes(n)), random, 0.15 / n);
}

scene::Scene<3> RandomBoxes::on(const scene::Mesh<3>& mesh) const {
  scene::Scene<3> scene = scene::test::given(scene::test::turned_about(mesh, rotation, scene::Vector<3>::Zero()));
  for (int body = 0; body < 2; ++body) {
    scene.bodies.emplace(names[body], scene::isotropic<3>(young[body], poisson[body]));
    scene.bodies.at(names[body]).force = rotation * force;
  }
  for (const auto& [part, kind] : kinds) {
    const auto& of = load[part.starts_with("upper")];
    std::vector<scene::Function<3>> given;
    switch (kind) {
      case ConditionKind::fixed: given = turned_vector(scene::Vector<3>::Zero(), strain, rotation); break;
      case ConditionKind::sliding:
        given = {function(turned(0, strain.transpose() * normals.at(part.substr(6)), rotation))};
        break;
      case ConditionKind::traction: given = turned_vector(of.col(0), of.rightCols<3>(), rotation); break;
      case ConditionKind::pressure:
        given = {function(turned(of(0, 0), of.row(0).tail<3>().transpose(), rotation))};
        break;
    }
    scene.boundary[part] = {kind, given, ""};
  }
  const Affine x = turned(0, {1, 0, 0}, rotation), z = turned(0, {0, 0, 1}, rotation);
  scene.contact = {{"upper.bottom", "lower.top", scene::enclosed<3>([x, z, g = gap](const auto& at) {
                      return value(x, at) * (value(z, at) * g[3] + g[1]) + value(z, at) * g[2] + g[0];
                    }),
                    ""}};
  if (on_wall) scene.contact.push_back({"lower.bottom", "rigid", 0.0, ""});
  return scene;
}

RandomBoxes solvable_boxes(std::mt19937& random) {
  for (;;) {
    const RandomBoxes boxes(random);
    try {
      const scene::Scene<3> scene = boxes.on(boxes.mesh(2, random));
      bounds::balanced(scene::fix_data(scene, scene::build_mesh(scene)), 2);
      return boxes;
    } catch (const scene::Error& error) {
      if (error.status() != scene::Status::ill_posed) throw;
    }
  }
}

scene::Mesh<3> refined_once(const RandomBoxes& boxes, int n, std::mt19937& random) {
  const scene::Mesh<3> mesh = boxes.mesh(n, random);
  const scene::Scene<3> scene = boxes.on(mesh);
  std::vector<char> marked(mesh.cells.size());
  for (char& mark : marked) mark = uniform(random, 0, 1) < 1 / 3.0;
  return scene::refine(scene::fix_data(scene, scene::build_mesh(scene)), marked).problem.mesh;
}

scene::Scene<3> renumbered(scene::Scene<3> scene, std::mt19937& random) {
  scene::GivenMesh<3>& given = *scene.given;
  const auto drawn = [&](std::size_t n) {
    std::vector<int> order(n);
    std::iota(order.begin(), order.end(), 0);
    std::ranges::shuffle(order, random);
    return order;
  };
  const std::vector<int> vertex = drawn(given.vertices.size()), cell = drawn(given.cells.size());
  const scene::GivenMesh<3> old = given;
  for (std::size_t v = 0; v < vertex.size(); ++v) given.vertices[vertex[v]] = old.vertices[v];
  const auto anew = [&](auto simplex) {
    for (int& v : simplex) v = vertex[v];
    std::ranges::shuffle(simplex, random);  // those that are inside out then are turned
    return simplex;
  };
  for (std::size_t c = 0; c < cell.size(); ++c) given.cells[cell[c]] = anew(old.cells[c]);
  for (auto& [name, cells] : given.bodies) {
    for (int& c : cells) c = cell[c];
    std::ranges::shuffle(cells, random);
  }
  for (auto& [name, facets] : given.parts) {
    for (auto& facet : facets) facet = anew(facet);
    std::ranges::shuffle(facets, random);
  }
  return scene;
}

}  // namespace bracket::tests::space
