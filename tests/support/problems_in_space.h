// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "scene/problem/problem.h"

/// Problems in space made by hand, without a scene.
namespace bracket::tests {

/// A cuboid of cells[0] × cells[1] × cells[2] smaller ones, each cut in six (Kuhn); sides "body.left", ".right" along
/// x,
/// ".bottom", ".top" along y, ".back", ".front" along z.
struct Box {
  std::string body;
  std::array<std::array<double, 2>, 3> range;
  std::array<int, 3> cells;
};
/// \param leave_out (centre of a small cuboid): whether it is no part of the body
scene::Mesh<3> mesh_of(const std::vector<Box>& boxes,
                       const std::function<bool(const scene::Vector<3>&)>& leave_out = {});

/// Without supports, loads and contact. Facets whose normals agree within 1e-9 have one.
scene::Problem<3> problem_on(scene::Mesh<3> mesh, const std::vector<scene::Body<3>>& bodies);

/// Puts the vertices elsewhere; to be done before there are data.
void move(scene::Problem<3>& problem, const std::function<scene::Vector<3>(const scene::Vector<3>& x, int vertex)>& to);

using VectorAt = std::function<scene::Vector<3>(const scene::Vector<3>&)>;
using NumberAt = std::function<double(const scene::Vector<3>&)>;
inline NumberAt everywhere(double value) {
  return [=](const scene::Vector<3>&) { return value; };
}
inline VectorAt nowhere() {
  return [](const scene::Vector<3>&) { return scene::Vector<3>(0, 0, 0); };
}
void fix(scene::Problem<3>& problem, const std::string& part, const VectorAt& displacement);
void slide(scene::Problem<3>& problem, const std::string& part, const NumberAt& normal_displacement);
void load(scene::Problem<3>& problem, const std::string& part, const VectorAt& traction);
/// \param second empty: a rigid wall   \param gap quadratic on each facet
void touch(scene::Problem<3>& problem, const std::string& first, const std::string& second, const NumberAt& gap,
           bool two_sided = false);

}  // namespace bracket::tests
