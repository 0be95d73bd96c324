// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/space/extruded.h"

#include <algorithm>

namespace bracket::tests::space {

namespace {

/// The same at every z.
scene::Function<3> of_x_and_y(const scene::Function<2>& f) {
  const auto at_points = [f](const scene::Vector<3>& x) { return f({x[0], x[1]}); };
  if (!f.is_enclosed()) return at_points;
  return {at_points, [f](const scene::Function<3>::Range& x) { return f.over({x[0], x[1]}); }};
}

scene::Condition<3> condition(const scene::Condition<2>& plane) {
  scene::Condition<3> result{plane.kind, {}, plane.where};
  for (const auto& value : plane.value) result.value.push_back(of_x_and_y(value));
  if (result.value.size() == 2) result.value.push_back(0.0);
  return result;
}

scene::GivenMesh<3> prisms(const scene::Mesh<2>& mesh, double thickness) {
  scene::GivenMesh<3> given;
  const int above = static_cast<int>(mesh.vertices.size());
  for (const double z : {0.0, thickness})
    for (const auto& x : mesh.vertices) given.vertices.emplace_back(x[0], x[1], z);
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    auto [i, j, k] = mesh.cells[c];
    const std::string& body = mesh.bodies[mesh.cell_body[c]];
    given.parts[body + ".back"].push_back({i, j, k});
    given.parts[body + ".front"].push_back({i + above, j + above, k + above});
    std::array<int, 3> v = {i, j, k};  // rising, so that the sides of neighbours are cut alike
    std::ranges::sort(v);
    for (int n = 0; n < 3; ++n) {
      std::array<int, 4> cell;
      for (int m = 0; m < 4; ++m) cell[m] = m <= n ? v[m] : v[m - 1] + above;
      given.bodies[body].push_back(static_cast<int>(given.cells.size()));
      given.cells.push_back(cell);
    }
  }
  for (const auto& facet : mesh.boundary) {
    if (facet.part < 0) continue;
    const auto [a, b] = std::minmax(facet.vertices[0], facet.vertices[1]);
    auto& part = given.parts[mesh.parts[facet.part]];
    part.push_back({a, b, b + above});
    part.push_back({a, a + above, b + above});
  }
  return given;
}

}  // namespace

scene::Scene<3> extruded(const scene::Scene<2>& plane, const scene::Mesh<2>& mesh, double thickness) {
  scene::Scene<3> result;
  result.given = prisms(mesh, thickness);
  for (const auto& [name, body] : plane.bodies) {
    // The plane's stress by strain (11, 22, 12) is the rest of what an isotropic material has in space.
    const auto c = body.material.stiffness();
    const double shear = c(2, 2), lame = c(0, 1);
    const double poisson = lame / (2 * (lame + shear));
    result.bodies.emplace(name, scene::Body<3>{scene::isotropic<3>(2 * shear * (1 + poisson), poisson)});
    result.bodies.at(name).force = {body.force[0], body.force[1], 0};
    for (const char* end : {".back", ".front"})
      result.boundary[name + end] = {scene::ConditionKind::sliding, {0.0}, ""};
  }
  for (const auto& [name, given] : plane.boundary) result.boundary[name] = condition(given);
  for (const auto& pair : plane.contact) {
    scene::ContactPair<3> contact;
    contact.first.parts = pair.first.parts;
    contact.second.parts = pair.second.parts;
    if (pair.gap) contact.gap = of_x_and_y(*pair.gap);
    result.contact.push_back(contact);
  }
  return result;
}

}  // namespace bracket::tests::space
