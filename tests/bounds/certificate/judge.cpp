// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/bounds/certificate/judge_parts.h"

namespace bracket::bounds {

using scene::Support;

ExactDisplacement exact_displacement(const scene::Problem<2>& problem, const PlainField& field) {
  const auto& mesh = problem.mesh;
  const auto supports = vertex_supports(problem);
  ExactDisplacement u;
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
    u.vertex.push_back(vector2<Exact>(field.vertex[v]) + shift<Exact>(supports[v], field.vertex[v]));
  for (const auto& [a, b] : mesh.edges) u.edge.push_back(half * (u.vertex[a] + u.vertex[b]));
  if (field.bubble.empty()) return u;
  std::vector<Point> bubbles;
  for (const auto& w : field.bubble) bubbles.push_back(vector2<Exact>(w));
  for (std::size_t f = 0; f < problem.facets.size(); ++f)
    if (problem.facets[f].support == Support::sliding) {
      Point& w = bubbles[mesh.boundary[f].edge];
      w = w + onto(w, problem.facets[f].normal, Exact(0));
    }
  for (std::size_t e = 0; e < bubbles.size(); ++e) u.edge[e] = u.edge[e] + bubbles[e];
  return u;
}

ExactStress exact_stress(const scene::Problem<2>& problem, const EdgeLoads<Exact>& loads,
                         const std::vector<Corrected<Exact>>& added) {
  const auto& mesh = problem.mesh;
  ExactStress stress;
  stress.added = added;
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    LoadedCell<Exact> cell = loaded_cell(problem, loads, static_cast<int>(c));
    const Point force = vector2<Exact>(problem.bodies[mesh.cell_body[c]].force);
    // −(F_x y, F_y x) as shear stress and its like: −(0, 0, F_x y + F_y x) has the divergence −F.
    const auto carried = [&](const Point& x) {
      return ExactVoigt{Exact(0), Exact(0), -(force.x * x.y + force.y * x.x)};
    };
    for (int i = 0; i < 3; ++i) {
      const Point n = outward(cell.x[(i + 1) % 3] - cell.x[i]);
      for (int end = 0; end < 2; ++end)
        cell.load[i][end] = cell.load[i][end] - on_normal(carried(cell.x[(i + end) % 3]), n);
    }
    auto parts = stress_of_balanced(cell.x, cell.load);
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k) parts[i][k] = sum(parts[i][k], carried(at(cell.x, part_corners(i)[k])), Exact(1));
    stress.cell.push_back(parts);
  }
  return stress;
}

std::vector<std::string> faults(const scene::Problem<2>& problem, const ExactDisplacement& u) {
  const auto& mesh = problem.mesh;
  std::vector<std::string> result;
  std::vector<char> fixed(mesh.vertices.size(), 0);
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    const auto& data = problem.facets[f];
    if (data.support != Support::fixed) continue;
    const OnFacet on = displacement_on(mesh, u, static_cast<int>(f));
    for (int i = 0; i < 2; ++i) {
      fixed[mesh.boundary[f].vertices[i]] = 1;
      if (!is_zero(on[i] - vector2<Exact>(data.displacement[i]))) result.push_back(fmt::format("fixed facet {}", f));
    }
    if (!is_zero(on[0] + on[1] - Exact(2) * on[2])) result.push_back(fmt::format("middle of fixed facet {}", f));
  }
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    const auto& data = problem.facets[f];
    if (data.support != Support::sliding) continue;
    const OnFacet on = displacement_on(mesh, u, static_cast<int>(f));
    const Point n = vector2<Exact>(data.normal);
    for (int i = 0; i < 2; ++i)  // where a fixed facet begins, that one rules
      if (!fixed[mesh.boundary[f].vertices[i]] && dot(on[i], n) != Exact(data.normal_displacement[i]))
        result.push_back(fmt::format("sliding facet {}", f));
    if (!is_zero(dot(on[0] + on[1] - Exact(2) * on[2], n)))
      result.push_back(fmt::format("middle of sliding facet {}", f));
  }
  for (const auto& pair : problem.contact) {  // r − g is a parabola: its maximum on [0, 1]
    const ExactVoigt r = sum(approach(problem, u, pair), gap(pair), Exact(-1));
    const Exact bend = Exact(2) * (r[0] + r[1] - Exact(2) * r[2]), slope = r[1] - r[0] - bend;
    Exact largest = std::max(r[0], r[1]);
    if (bend < Exact(0) && slope > Exact(0) && slope + Exact(2) * bend < Exact(0))
      largest = r[0] - slope * slope / (Exact(4) * bend);
    if (largest > Exact(0)) result.push_back(fmt::format("{} into contact facet {}", rounded(largest), pair.first));
  }
  return result;
}

namespace {

/// Whether a part of a cell is in equilibrium with the body force.
bool in_equilibrium(const std::array<ExactVoigt, 3>& s, const Corners& x, const Point& force) {
  const std::array<Point, 3> d = gradients(x);
  Point divergence = force;
  for (int k = 0; k < 3; ++k) divergence = divergence + on_normal(s[k], d[k]);
  return is_zero(divergence);
}

void check_cells(const scene::Problem<2>& problem, const ExactStress& stress, std::vector<std::string>& result) {
  const auto& mesh = problem.mesh;
  std::vector<std::vector<std::array<Point, 2>>> on_edge(mesh.edges.size());
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    const Corners x = corners_of(mesh, static_cast<int>(c));
    const Point centroid = third * (x[0] + x[1] + x[2]);
    const auto& s = stress.cell[c];
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3;
      if (!in_equilibrium(s[i], {x[i], x[j], centroid}, vector2<Exact>(problem.bodies[mesh.cell_body[c]].force)))
        result.push_back(fmt::format("no equilibrium in cell {}", c));
      const Point inner = outward(centroid - x[j]);  // between the parts i and j
      for (int k = 1; k < 3; ++k)
        if (!is_zero(on_normal(s[i][k], inner) - on_normal(s[j][k == 1 ? 0 : 2], inner)))
          result.push_back(fmt::format("tractions jump in cell {}", c));
      const int edge = mesh.cell_edges[c][(i + 2) % 3];
      const bool along = mesh.edges[edge][0] == mesh.cells[c][i];
      const Point n = outward(x[j] - x[i]);
      on_edge[edge].push_back({on_normal(s[i][along ? 0 : 1], n), on_normal(s[i][along ? 1 : 0], n)});
    }
  }
  for (std::size_t e = 0; e < on_edge.size(); ++e)
    if (on_edge[e].size() == 2 &&
        !(is_zero(on_edge[e][0][0] + on_edge[e][1][0]) && is_zero(on_edge[e][0][1] + on_edge[e][1][1])))
      result.push_back(fmt::format("tractions jump across edge {}", e));
}

}  // namespace

std::vector<std::string> faults(const scene::Problem<2>& problem, const ExactStress& stress) {
  std::vector<std::string> result;
  check_cells(problem, stress, result);
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    const auto& data = problem.facets[f];
    const int facet = static_cast<int>(f);
    const OnFacet load = load_on(problem.mesh, stress, facet), given = traction_on(problem, stress.added, facet);
    for (int i = 0; i < 2; ++i) {
      if (data.support == Support::traction && !is_zero(load[i] - given[i]))
        result.push_back(fmt::format("traction on facet {}", f));
      if ((data.support == Support::sliding || data.support == Support::contact) &&
          !is_zero(cross(load[i], vector2<Exact>(data.normal))))
        result.push_back(fmt::format("shear on facet {}", f));
    }
  }
  for (const auto& pair : problem.contact) {
    const OnFacet first = load_on(problem.mesh, stress, pair.first);
    const ExactVoigt p = pressure(problem, stress, pair);
    if (p[0] < Exact(0) || p[1] < Exact(0)) result.push_back(fmt::format("tension on facet {}", pair.first));
    if (pair.second < 0) continue;
    const OnFacet second = load_on(problem.mesh, stress, pair.second);
    if (!is_zero(first[0] + second[1]) || !is_zero(first[1] + second[0]))
      result.push_back(fmt::format("pressures differ on facet {}", pair.first));
  }
  return result;
}

Judged judged(const scene::Problem<2>& problem, const scene::Displacement<2>& displacement,
              const scene::Stress<2>& stress) {
  Judged result;
  result.field = admissible_field(problem, displacement, vertex_supports(problem)).field.value();
  const auto [corrections, reason] = corrected<Exact, RationalSum>(scene::first_of(problem));
  EXPECT_EQ(reason, "");
  result.loads = balanced<Exact, RationalSum>(problem, corrections, plain_loads(problem, stress)).loads.value();
  result.displacement = exact_displacement(problem, result.field);
  result.stress = exact_stress(problem, result.loads, corrections);
  return result;
}

void expect_holds_exactly(const scene::Problem<2>& problem, const Certificate& certificate, const Judged& exact) {
  EXPECT_EQ(faults(problem, exact.displacement), std::vector<std::string>{});
  EXPECT_EQ(faults(problem, exact.stress), std::vector<std::string>{});
  const Exact l = potential_energy(problem, exact.displacement, exact.stress.added);
  const Exact s = complementary_energy(problem, exact.stress, exact.displacement);
  EXPECT_LE(Exact(certificate.lower), -s);
  EXPECT_GE(Exact(certificate.upper), l);
  EXPECT_EQ(l + s, distance(problem, exact.stress, exact.displacement));
}

}  // namespace bracket::bounds
