// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bounds/space/cases.h"

#include <cmath>

namespace bracket::tests {

using scene::FacetData;
using scene::Problem;
using scene::Support;

namespace {

FacetData<3> as(Support support) {
  FacetData<3> data;
  data.support = support;
  return data;
}
FacetData<3> pressed(double pressure) {
  FacetData<3> data;
  data.pressure = {pressure, pressure, pressure};
  return data;
}

/// Which side of a box: −1, −2, −3 at the lower x, y, z, else 1, 2, 3.
int side(const Vector<3>& normal) {
  Eigen::Index axis;
  normal.cwiseAbs().maxCoeff(&axis);
  return static_cast<int>(normal[axis] < 0 ? -1 - axis : 1 + axis);
}

/// Gaps by a function of the place, rounded apart.
void set_gaps(Problem<3>& problem, const std::function<double(const Vector<3>&)>& gap) {
  for (auto& pair : problem.contact) {
    const auto x = positions(problem.mesh, problem.mesh.boundary[pair.first].vertices);
    for (int k = 0; k < 6; ++k) {
      double c;
      if (k < 3) {
        c = gap(x[k]);
      } else {
        const auto& [a, b] = scene::Simplex<2>::edges[k - 3];
        c = 2 * gap(0.5 * (x[a] + x[b])) - 0.5 * (gap(x[a]) + gap(x[b]));
      }
      pair.lower[k] = pair.upper[k] = c;
    }
  }
}

}  // namespace

SpaceCase clamped() {
  const std::vector<Box> boxes = {{{0, 0, -1}, {1, 1, 0}, {1, 1, 1}, crystal(), {0.125, 0, -0.25}},
                                  {{0, 0, 0}, {1, 1, 0.5}, {1, 1, 1}, steel(2, 0.3), {0, 0, -0.1}}};
  Problem<3> problem = problem_of(boxes, [](int body, const Vector<3>&, const Vector<3>& n) {
    if (body == 0 && side(n) == -3) return as(Support::fixed);
    if (body == 0 && side(n) == 3) return as(Support::contact);
    if (body == 1 && side(n) == -3) return as(Support::contact);
    if (side(n) == -1 || (body == 1 && side(n) == -2)) return as(Support::sliding);
    return as(Support::traction);
  });
  for (std::size_t f = 0; f < problem.facets.size(); ++f)
    for (int i = 0; i < 3; ++i) {
      const auto& at = problem.mesh.boundary[f];
      const Vector<3>& x = problem.mesh.vertices[at.vertices[i]];
      auto& data = problem.facets[f];
      const bool top = problem.mesh.cell_body[at.cell] == 1 && data.normal[2] > 0.5;
      if (data.support == Support::fixed) data.displacement[i] = {0.01 * x[1], 0.02 - 0.01 * x[0], 0.03 * x[0]};
      if (data.support == Support::sliding) data.normal_displacement[i] = 0.01 * x[1] - 0.02 * x[2];
      if (top) data.traction[i] = {0.1 * x[0], 0.05 - 0.1 * x[1], -1 - 0.3 * x[0]};
      if (data.support == Support::traction && data.normal[1] > 0.5) data.pressure[i] = 0.2 + 0.1 * x[0];
    }
  set_gaps(problem, [](const Vector<3>& x) { return x[0] < 0.5 ? 0 : -0.01; });
  scene::Voigt<3> mean = scene::Voigt<3>::Zero();
  mean[2] = -1.1;
  return {"clamped", problem, mean};
}

SpaceCase cornered(const Warp& warp) {
  const std::vector<Box> boxes = {{{0, 0, -1}, {1, 1, 0}, {1, 1, 1}, steel(4, 0.25)},
                                  {{0, 0, 0}, {1, 1, 1}, {1, 1, 1}, steel(1, 0.49)}};
  Problem<3> problem = problem_of(
      boxes,
      [](int body, const Vector<3>&, const Vector<3>& n) {
        if (body == 0 && side(n) == -3) return as(Support::fixed);
        if (body == 0) return side(n) == 3 ? as(Support::contact) : as(Support::traction);
        return side(n) < 0 ? as(Support::contact) : pressed(1);
      },
      warp);
  set_gaps(problem, [](const Vector<3>& x) { return 0.001 * (x.squaredNorm() - x[0] * x[1]); });
  for (auto& pair : problem.contact)
    for (int k = 0; k < 6; ++k) pair.upper[k] += 1e-4 * (1 + k);
  scene::Voigt<3> mean = scene::Voigt<3>::Zero();
  mean.head<3>().setConstant(-1);
  return {"cornered", problem, mean};
}

SpaceCase floating() {
  const std::vector<Box> boxes = {{{0, 0, -1}, {1, 1, 0}, {1, 1, 1}, steel()},
                                  {{0, 0, 0}, {1, 1, 1}, {1, 1, 1}, steel(8, 0.4999)}};
  Problem<3> problem = problem_of(boxes, [](int body, const Vector<3>&, const Vector<3>& n) {
    if (side(n) == (body == 0 ? 3 : -3)) return as(Support::contact);
    if (body == 0 && side(n) == -3) return as(Support::sliding);
    auto data = pressed(side(n) == 3 ? 1 : 0);
    const double along = side(n) == 1 ? 0.1 + 0.2 : -0.3;  // not opposite to the last bit
    if (std::abs(side(n)) == 1) data.traction.fill(Vector<3>(along, 0, 0));
    return data;
  });
  set_gaps(problem, [](const Vector<3>&) { return 0.0; });
  for (int f = 0; f < static_cast<int>(problem.facets.size()); ++f)
    for (int body = 0; body < 2; ++body) {
      const auto& at = problem.mesh.boundary[f];
      const auto count = static_cast<int>(problem.corrections.size());
      if (problem.mesh.cell_body[at.cell] != body || count >= 3 * body + 3 || count < 3 * body) continue;
      const int of = side(problem.facets[f].normal);
      const int wanted = count % 3;  // along x at the right, along y there, along y at the back
      if (wanted < 2 ? of != 1 : of != 2) continue;
      scene::Correction<3> correction{f, {}};
      correction.unit.fill(Vector<3>::Unit(wanted == 0 ? 0 : 1));
      problem.corrections.push_back(correction);
      if (wanted == 0) {
        correction.unit.fill(Vector<3>::Unit(1));
        problem.corrections.push_back(correction);
      }
    }
  problem.carries = {1};
  scene::Voigt<3> mean = scene::Voigt<3>::Zero();
  mean[2] = -1;
  mean[0] = 0.3;
  return {"floating", problem, mean};
}

SpaceCase together(double bend) {
  const std::vector<Box> boxes = {{{0, 0, -1}, {1, 1, 0}, {1, 1, 1}, steel()},
                                  {{0, 0, 0}, {1, 1, 1}, {1, 1, 1}, crystal(), {0.1, 0.2, 0.3}}};
  Problem<3> problem = problem_of(boxes, [](int body, const Vector<3>&, const Vector<3>& n) {
    if (body == 0 && side(n) == -3) return as(Support::fixed);
    if (body == 0)
      return side(n) == 3 ? as(Support::contact) : side(n) == -2 ? as(Support::sliding) : as(Support::traction);
    if (side(n) == -3 || side(n) == -1) return as(Support::contact);
    if (side(n) == -2) return as(Support::sliding);
    return pressed(side(n) == 3 ? -0.25 : 0.125);
  });
  for (auto& pair : problem.contact) pair.law.two_sided = true;
  set_gaps(problem, [bend](const Vector<3>& x) { return 0.01 - 0.02 * x[0] + 0.01 * x[1] + bend * x[0] * x[1]; });
  scene::Voigt<3> mean = scene::Voigt<3>::Zero();
  mean[2] = 0.25;
  return {bend == 0 ? "together" : "together, bent", problem, mean};
}

std::vector<SpaceCase> all_cases() { return {clamped(), cornered(), floating(), together(0), together(0.125)}; }

Warp turned_away() {
  return [](const Vector<3>& x) {
    const Eigen::AngleAxisd turn(0.7, Vector<3>(1, 2, -0.5).normalized());
    return Vector<3>(turn * x + Vector<3>(1000, -300, 77.7));
  };
}

int facet_with(const Problem<3>& problem, Support support) {
  for (std::size_t f = 0; f < problem.facets.size(); ++f)
    if (problem.facets[f].support == support) return static_cast<int>(f);
  throw std::logic_error("no such facet");
}

}  // namespace bracket::tests
