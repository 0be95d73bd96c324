// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <numeric>
#include <random>

#include "bounds/estimate/on_mesh.h"
#include "primal/primal.h"
#include "scene/balanced_block.h"
#include "tests/support/problems_in_space.h"

namespace bracket::bounds {
namespace {

using scene::Simplex;
using scene::Vector;
using scene::Voigt;

using StressAt = std::function<Voigt<3>(const Vector<3>&)>;
using Loads = std::vector<scene::FacetLoads<3, double>>;  // of each cell

std::array<double, 3> plain(const Vector<3>& v) { return {v[0], v[1], v[2]}; }

/// The loads of a stress field on the facets of the cells.
Loads loads_of(const scene::Problem<3>& problem, const std::vector<StressAt>& of_body) {
  const auto& mesh = problem.mesh;
  Loads loads(mesh.cells.size());
  for (std::size_t c = 0; c < loads.size(); ++c)
    for (int f = 0; f < 4; ++f) {
      const auto x = scene::positions(mesh, scene::facet_vertices(mesh, static_cast<int>(c), f));
      for (int i = 0; i < 3; ++i)
        loads[c][f][i] = plain(scene::traction<3>(of_body[mesh.cell_body[c]](x[i]), scene::area_vector<3>(x)));
    }
  return loads;
}

/// Adds loads on the inner facets at a vertex that are in balance with themselves on each cell there.
void add_star(const scene::Mesh<3>& mesh, int vertex, std::mt19937& random, double size, Loads& loads) {
  std::map<int, std::vector<std::array<int, 2>>> facets;  // the cells at the vertex on each
  std::vector<int> cells;
  for (std::size_t c = 0; c < mesh.cells.size(); ++c)
    for (int k = 0; k < 4; ++k)
      if (mesh.cells[c][k] == vertex) {
        for (int f = 0; f < 4; ++f)
          if (f != k) facets[scene::cell_facets(mesh, static_cast<int>(c))[f]].push_back({static_cast<int>(c), f});
        cells.push_back(static_cast<int>(c));
      }
  std::erase_if(facets, [](const auto& facet) { return facet.second.size() < 2; });
  const Vector<3> centre = mesh.vertices[vertex];
  Eigen::MatrixXd balance = Eigen::MatrixXd::Zero(6 * cells.size(), 9 * facets.size());
  // Unknown 9 facet + 3 k + c: component c at the k-th of the facet's sorted vertices, on its first cell.
  const auto rank = [](const std::array<int, 3>& vertices, int i) {
    return std::count_if(vertices.begin(), vertices.end(), [&](int v) { return v < vertices[i]; });
  };
  Eigen::Index column = 0;
  for (const auto& [number, at] : facets) {
    for (int side = 0; side < 2; ++side) {
      const auto& [cell, local] = at[side];
      const auto vertices = scene::facet_vertices(mesh, cell, local);
      const auto row = 6 * (std::find(cells.begin(), cells.end(), cell) - cells.begin());
      for (int i = 0; i < 3; ++i)
        for (int c = 0; c < 3; ++c) {
          const Vector<3> force = (side == 0 ? 1. : -1.) * Vector<3>::Unit(c) / 3;
          Vector<3> moment = Vector<3>::Zero();
          for (int j = 0; j < 3; ++j)
            moment += (mesh.vertices[vertices[j]] - centre).cross(force) * (i == j ? 2 : 1) / 4.;
          balance.col(column + 3 * rank(vertices, i) + c).segment<3>(row) += force;
          balance.col(column + 3 * rank(vertices, i) + c).segment<3>(row + 3) += moment;
        }
    }
    column += 9;
  }
  Eigen::VectorXd x =
      Eigen::VectorXd::NullaryExpr(column, [&] { return std::normal_distribution<double>(0, size)(random); });
  const auto inverse = balance.completeOrthogonalDecomposition();
  for (int step = 0; step < 2; ++step) x -= inverse.solve(balance * x);
  column = 0;
  for (const auto& [number, at] : facets) {
    for (int side = 0; side < 2; ++side) {
      const auto& [cell, local] = at[side];
      const auto vertices = scene::facet_vertices(mesh, cell, local);
      for (int i = 0; i < 3; ++i)
        for (int c = 0; c < 3; ++c)
          loads[cell][local][i][c] += (side == 0 ? 1. : -1.) * x[column + 3 * rank(vertices, i) + c];
    }
    column += 9;
  }
}

scene::Stress<3> stress_of(const scene::Problem<3>& problem, const Loads& loads) {
  scene::Stress<3> stress;
  for (std::size_t c = 0; c < loads.size(); ++c) {
    std::array<std::array<double, 3>, 4> x;
    for (int k = 0; k < 4; ++k) x[k] = plain(problem.mesh.vertices[problem.mesh.cells[c][k]]);
    const auto block = scene::balanced_stress<3, double>(scene::block_geometry<3, double>(x), loads[c],
                                                         plain(body_of(problem, static_cast<int>(c)).force));
    stress.cell.emplace_back();
    for (const auto& part : block)
      for (const auto& t : part) stress.cell.back().push_back(Eigen::Map<const Voigt<3>>(t.data()));
  }
  return stress;
}

/// An admissible pair's problem and stress: two bodies of unlike materials in contact at y = 0, the upper one clamped
/// on its left, the lower one sliding on its base; loads and weights are those of the stress.
struct Case {
  scene::Problem<3> problem;
  scene::Stress<3> stress;
};

Voigt<3> stress_at(const Vector<3>& x, double of_body) {  // no shear at right angles to y
  Voigt<3> s;
  s << 1 + of_body * x[1] - x[2], -(1.5 + .3 * x[0] - .2 * x[2] + of_body * x[1]), .3 * x[0] + of_body * x[1], 0,
      .4 - .5 * x[0] + .2 * x[1] * of_body + .1 * x[2], 0;
  return s;
}

Case some_case(double poisson, int n, unsigned seed) {
  scene::Elasticity<3> stiffness = 3 * scene::Elasticity<3>::Identity();
  stiffness.topLeftCorner<3, 3>().array() += .7;
  stiffness(0, 4) = stiffness(4, 0) = .2;
  auto problem =
      tests::problem_on(tests::mesh_of({{"lower", {{{0, 1}, {-1, 0}, {0, 1}}}, {n, n, n}},
                                        {"upper", {{{0, 1}, {0, 1}, {0, 1}}}, {n, n, n}}}),
                        {scene::isotropic<3>(1, poisson, scene::Plane::strain), scene::anisotropic<3>(stiffness)});
  tests::move(problem, [&](const Vector<3>& x, int) {
    const double bump = .2 / n * std::sin(7 * x[0] + 3 * x[2]) * x[0] * (1 - x[0]) * x[2] * (1 - x[2]) * 4;
    return Vector<3>(x[0] + bump, x[1] + (std::abs(x[1]) == 1 || x[1] == 0 ? 0 : bump / 2), x[2] - bump);
  });
  const std::vector<double> of_body = {.3, -.4};
  std::vector<StressAt> stresses;
  for (int b = 0; b < 2; ++b) {
    const double e = of_body[b];
    stresses.push_back([=](const Vector<3>& x) { return stress_at(x, e); });
    // −div: ∂x σxx + ∂z σxz, ∂y σyy, ∂x σxz + ∂z σzz
    problem.bodies[b].force = -Vector<3>(.1, -e, -.5);
  }
  tests::slide(problem, "lower.bottom", [](const Vector<3>& x) { return .1 + .2 * x[0] - .05 * x[2]; });
  tests::fix(problem, "upper.left", [](const Vector<3>& x) { return Vector<3>(.1 * x[1], -.2, .3 * x[2]); });
  tests::touch(problem, "upper.bottom", "lower.top", [](const Vector<3>& x) { return .1 * x[0] * x[2] - .05 * x[0]; });
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    auto& data = problem.facets[f];
    if (data.support != scene::Support::traction) continue;
    const auto& facet = problem.mesh.boundary[f];
    const auto x = scene::positions(problem.mesh, facet.vertices);
    for (int i = 0; i < 3; ++i)
      data.traction[i] = scene::traction<3>(stresses[problem.mesh.cell_body[facet.cell]](x[i]),
                                            scene::normal(problem.mesh, static_cast<int>(f)));
  }
  auto loads = loads_of(problem, stresses);
  std::mt19937 random(seed);
  for (std::size_t v = 0; v < problem.mesh.vertices.size(); ++v)
    add_star(problem.mesh, static_cast<int>(v), random, .1 / (n * n), loads);
  return {problem, stress_of(problem, loads)};
}

/// Any displacement that keeps the supports.
scene::Displacement<3> any_displacement(const scene::Problem<3>& problem, int degree, unsigned seed) {
  const auto& mesh = problem.mesh;
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> noise(-.3, .3);
  const auto some = [&] { return Vector<3>(noise(generator), noise(generator), noise(generator)); };
  scene::Displacement<3> u{degree, {}, {}};
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) u.vertex.push_back(some());
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    const auto& data = problem.facets[f];
    for (int i = 0; i < 3; ++i) {
      Vector<3>& at = u.vertex[mesh.boundary[f].vertices[i]];
      if (data.support == scene::Support::fixed) at = data.displacement[i];
      if (data.support == scene::Support::sliding)
        at += (data.normal_displacement[i] - at.dot(data.normal)) * data.normal;
    }
  }
  if (degree == 1) return u;
  for (const auto& [a, b] : mesh.edges) u.edge.push_back((u.vertex[a] + u.vertex[b]) / 2 + some());
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    const auto& data = problem.facets[f];
    for (const int e : scene::facet_edges(mesh, mesh.boundary[f])) {
      const auto& [a, b] = mesh.edges[e];
      const Vector<3> linear = (u.vertex[a] + u.vertex[b]) / 2;
      if (data.support == scene::Support::fixed) u.edge[e] = linear;
      if (data.support == scene::Support::sliding) u.edge[e] -= (u.edge[e] - linear).dot(data.normal) * data.normal;
    }
  }
  return u;
}

TEST(EstimateInSpace, gap_identity_holds_for_any_displacement_that_keeps_the_supports) {
  for (const double poisson : {.3, .49})
    for (const int n : {1, 2, 3}) {
      const auto [problem, stress] = some_case(poisson, n, 3 + n);
      const double s = complementary_energy(problem, stress);
      for (const int degree : {1, 2}) {
        const auto u = any_displacement(problem, degree, 5);
        const auto energy = potential_energy(problem, u);
        const Indicator found = indicator(problem, u, stress);
        EXPECT_NEAR(found.sum, energy.total + s, 1e-13 * (energy.strain + std::abs(s))) << "degree " << degree;
        EXPECT_GT(found.sum, .01 * energy.strain);
        const auto plain = plain_energies(problem, u, stress, found);
        EXPECT_LE(plain.gap_identity, 1e-13);
        EXPECT_EQ(plain.lower, -s);
        EXPECT_EQ(plain.upper, energy.total);
      }
    }
}

TEST(EstimateInSpace, balanced_stresses_pass_the_checks_and_spoilt_ones_do_not) {
  const auto [problem, stress] = some_case(.3, 2, 8);
  const auto u = any_displacement(problem, 2, 6);
  const Checks good = admissibility(problem, u, stress);
  EXPECT_LE(good.equilibrium, 1e-13);
  EXPECT_LE(good.interface_jump, 1e-13);
  EXPECT_LE(good.boundary_traction, 1e-13);
  EXPECT_LE(good.tension, 0);
  EXPECT_GT(good.penetration, 1e-4);  // the displacements know nothing of the contact
  for (const int part : {0, 1, 2, 3})
    for (const int corner : {0, 1, 2, 3}) {
      auto spoilt = stress;
      spoilt.cell[5][4 * part + corner] += Voigt<3>::Constant(1e-3);
      EXPECT_GT(admissibility(problem, u, spoilt).equilibrium, 1e-5) << part << ' ' << corner;
    }
  for (const auto& facet : {problem.mesh.boundary[0], problem.mesh.boundary[7]}) {
    auto spoilt = stress;
    for (auto& value : spoilt.cell[facet.cell]) value[1] += 1e-3;  // in balance by itself
    const Checks found = admissibility(problem, u, spoilt);
    EXPECT_LE(found.equilibrium, 1e-13);
    EXPECT_GT(found.interface_jump, 1e-6);
  }
  {
    auto spoilt = problem;
    for (auto& data : spoilt.facets)
      if (data.support == scene::Support::traction) data.traction[1] += Vector<3>(0, 0, 1e-3);
    EXPECT_GT(admissibility(spoilt, u, stress).boundary_traction, 1e-5);
  }
}

TEST(EstimateInSpace, pressure_and_gap_are_those_of_the_fields) {
  const auto [problem, stress] = some_case(.3, 2, 8);
  const auto u = any_displacement(problem, 2, 6);
  const auto states = contact_state(problem, u, stress);
  ASSERT_EQ(states.size(), problem.contact.size());
  for (std::size_t j = 0; j < states.size(); ++j) {
    const auto& pair = problem.contact[j];
    const auto x = scene::positions(problem.mesh, problem.mesh.boundary[pair.first].vertices);
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(states[j].pressure[i], 1.5 + .3 * x[i][0] - .2 * x[i][2], 1e-12);
      const Vector<3> jump = u.vertex[problem.mesh.boundary[pair.first].vertices[i]] -
                             u.vertex[problem.mesh.boundary[pair.second].vertices[pair.meets[i]]];
      EXPECT_NEAR(states[j].gap_left[i], .1 * x[i][0] * x[i][2] - .05 * x[i][0] + jump[1], 1e-14);
    }
    for (int e = 0; e < 3; ++e) {  // at the middle of an edge: (c_a + 2 c_e + c_b) / 4
      const auto& [a, b] = Simplex<2>::edges[e];
      const Vector<3> middle = (x[a] + x[b]) / 2;
      const auto edges = scene::facet_edges(problem.mesh, problem.mesh.boundary[pair.first]);
      const auto other = scene::facet_edges(problem.mesh, problem.mesh.boundary[pair.second]);
      const Vector<3> jump = u.edge[edges[e]] - u.edge[other[Simplex<2>::edge_between(pair.meets[a], pair.meets[b])]];
      const auto& left = states[j].gap_left;
      EXPECT_NEAR((left[a] + 2 * left[3 + e] + left[b]) / 4, .1 * middle[0] * middle[2] - .05 * middle[0] + jump[1],
                  1e-14);
    }
  }
}

TEST(EstimateInSpace, patch_and_exact_dual_have_no_width) {
  for (const double poisson : {.3, .49, .4999}) {
    auto problem = tests::problem_on(
        tests::mesh_of(
            {{"lower", {{{-1, 1}, {-1, 0}, {-1, 1}}}, {2, 2, 2}}, {"upper", {{{-1, 1}, {0, 1}, {-1, 1}}}, {2, 2, 2}}}),
        {scene::isotropic<3>(1, poisson, scene::Plane::strain), scene::isotropic<3>(2, poisson, scene::Plane::strain)});
    tests::slide(problem, "lower.bottom", [](const Vector<3>&) { return 0.; });
    tests::touch(problem, "upper.bottom", "lower.top", [](const Vector<3>&) { return 0.; });
    const auto pressure = [](const Vector<3>& x) { return 1 - .5 * x[0] - .25 * x[2]; };
    tests::load(problem, "upper.top", [&](const Vector<3>& x) { return Vector<3>(0, -pressure(x), 0); });
    const auto result = primal::solve(problem, 2);
    ASSERT_EQ(result.termination, contact::Termination::solved) << result.reason;
    const StressAt uniaxial = [&](const Vector<3>& x) { return -pressure(x) * Voigt<3>::Unit(1); };
    const auto stress = stress_of(problem, loads_of(problem, {uniaxial, uniaxial}));
    const Indicator found = indicator(problem, result.displacement, stress);
    const auto plain = plain_energies(problem, result.displacement, stress, found);
    EXPECT_NEAR(plain.upper, -3.3125, 1e-11);
    EXPECT_NEAR(plain.lower, -3.3125, 1e-13);
    EXPECT_LE(found.sum, 1e-11);
    EXPECT_LE(admissibility(problem, result.displacement, stress).worst().value, 1e-11);
  }
}

TEST(EstimateInSpace, marked_are_as_few_cells_as_carry_the_bulk) {
  const auto [problem, stress] = some_case(.3, 2, 8);
  const Indicator found = indicator(problem, any_displacement(problem, 2, 6), stress);
  std::vector<double> share = found.cell;
  for (std::size_t j = 0; j < problem.contact.size(); ++j)
    for (const int side : {problem.contact[j].first, problem.contact[j].second})
      share[problem.mesh.boundary[side].cell] += found.contact[j] / 2;
  const auto marked = mark(problem, found, .5);
  double sum = 0, least = 1e300, largest = 0;
  for (std::size_t c = 0; c < share.size(); ++c) {
    if (marked[c]) sum += share[c];
    if (marked[c]) least = std::min(least, share[c]);
    if (!marked[c]) largest = std::max(largest, share[c]);
  }
  const double all = std::accumulate(share.begin(), share.end(), 0.);
  EXPECT_GE(sum, .5 * all);
  EXPECT_LT(sum - least, .5 * all);
  EXPECT_GE(least, largest);
}

}  // namespace
}  // namespace bracket::bounds
