// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <tuple>

#include "bounds/bounds.h"
#include "dual/dual.h"
#include "primal/primal.h"
#include "tests/compare/scene_files.h"
#include "tests/support/scenes.h"

/// The contact as displacements and stresses see it, on every scene.
namespace bracket::tests {
namespace {

using scene::Support;
using scene::Vector;

/// A continuous field, linear on cells: the values at the vertices. Bodies share no vertices.
using TestField = std::vector<Vector<2>>;

/// `direction` at the vertices of one contact pair's first side, zero at all others.
TestField on_contact(const scene::Problem<2>& problem, int pair, const Vector<2>& direction) {
  TestField field(problem.mesh.vertices.size(), Vector<2>::Zero());
  for (const auto& facet : problem.contact)
    if (facet.pair == pair)
      for (const int v : problem.mesh.boundary[facet.first].vertices) field[v] = direction;
  return field;
}

scene::Voigt<2> strain(const scene::Mesh<2>& mesh, const TestField& field, int cell) {
  const auto& v = mesh.cells[cell];
  Eigen::Matrix2d sides, differences;
  sides << mesh.vertices[v[1]] - mesh.vertices[v[0]], mesh.vertices[v[2]] - mesh.vertices[v[0]];
  differences << field[v[1]] - field[v[0]], field[v[2]] - field[v[0]];
  const Eigen::Matrix2d gradient = differences * sides.inverse();
  return {gradient(0, 0), gradient(1, 1), gradient(0, 1) + gradient(1, 0)};
}

/// ∫ T·v over a facet, T given at its ends.
double facet_work(const scene::Mesh<2>& mesh, int facet, const std::array<Vector<2>, 2>& traction,
                  const TestField& field) {
  const auto& [a, b] = mesh.boundary[facet].vertices;
  return scene::length(mesh, facet) / 6 *
         ((2 * traction[0] + traction[1]).dot(field[a]) + (traction[0] + 2 * traction[1]).dot(field[b]));
}

std::array<Vector<2>, 2> tractions_of(const scene::Problem<2>& problem, int facet) {
  const auto load = scene::load(problem, facet);
  const double length = scene::length(problem.mesh, facet);
  return {load[0] / length, load[1] / length};
}

/// ℓ(v)
double load_work(const scene::Problem<2>& problem, const TestField& field) {
  const auto& mesh = problem.mesh;
  double work = 0;
  for (std::size_t c = 0; c < mesh.cells.size(); ++c)
    for (const int v : mesh.cells[c])
      work += scene::volume(mesh, static_cast<int>(c)) / 3 * problem.bodies[mesh.cell_body[c]].force.dot(field[v]);
  for (std::size_t f = 0; f < problem.facets.size(); ++f)
    if (problem.facets[f].support == Support::traction)
      work += facet_work(mesh, static_cast<int>(f), tractions_of(problem, static_cast<int>(f)), field);
  return work;
}

/// The work of contact and supports by the stresses: ∫ λn·v over them.
double reaction_of_stresses(const bounds::Outcome<2>& outcome, const TestField& field) {
  const auto& problem = outcome.problem;
  double work = 0;
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    if (problem.facets[f].support == Support::traction) continue;
    const auto& facet = problem.mesh.boundary[f];
    const Vector<2> n = scene::normal(problem.mesh, static_cast<int>(f));
    std::array<Vector<2>, 2> traction;
    for (int i = 0; i < 2; ++i) {
      const auto& s = outcome.stress.cell[facet.cell][3 * facet.local + i];
      traction[i] = {s[0] * n[0] + s[2] * n[1], s[2] * n[0] + s[1] * n[1]};
    }
    work += facet_work(problem.mesh, static_cast<int>(f), traction, field);
  }
  return work;
}

/// The same by the displacements, A(u_h, v) − ℓ(v), and ‖v‖_A.
struct Reaction {
  double work = 0;
  double norm = 0;
};
Reaction reaction_of_displacements(const bounds::Outcome<2>& outcome, const TestField& field) {
  const auto& problem = outcome.problem;
  Reaction result{-load_work(problem, field), 0};
  for (std::size_t c = 0; c < problem.mesh.cells.size(); ++c) {
    const int cell = static_cast<int>(c);
    const scene::Voigt<2> e = strain(problem.mesh, field, cell);
    const double area = scene::volume(problem.mesh, cell);
    for (const auto& s : bounds::displacement_stress(problem, outcome.displacement, cell))
      result.work += area / 3 * s.dot(e);
    result.norm += area * e.dot(problem.bodies[problem.mesh.cell_body[c]].material.stiffness() * e);
  }
  result.norm = std::sqrt(result.norm);
  return result;
}

/// |∫ (σ(u_h) − λ_h) : ε(v)| ≤ ‖σ(u_h) − λ_h‖ ‖v‖_A, and the first factor is known cell by cell.
void expect_contact_forces_alike(const bounds::Outcome<2>& outcome) {
  const double stress_difference =
      std::sqrt(2 * std::accumulate(outcome.indicator.cell.begin(), outcome.indicator.cell.end(), 0.0));
  const double size = std::sqrt(2 * outcome.levels[0].plain.strain);
  int pairs = 0;
  for (const auto& facet : outcome.problem.contact) pairs = std::max(pairs, facet.pair + 1);
  for (int pair = 0; pair < pairs; ++pair)
    for (const Vector<2>& direction : {Vector<2>(1, 0), Vector<2>(0, 1)}) {
      const TestField field = on_contact(outcome.problem, pair, direction);
      const auto [work, norm] = reaction_of_displacements(outcome, field);
      EXPECT_LE(std::abs(work - reaction_of_stresses(outcome, field)), (stress_difference + 1e-10 * size) * norm)
          << "pair " << pair;
    }
}

/// (2.1)
void expect_contact_balances_loads(const bounds::Outcome<2>& outcome) {
  const auto& problem = outcome.problem;
  for (std::size_t b = 0; b < problem.mesh.components.size(); ++b)
    for (const auto& motion : scene::free_motions(problem, static_cast<int>(b))) {
      TestField field(problem.mesh.vertices.size(), Vector<2>::Zero());
      for (std::size_t c = 0; c < problem.mesh.cells.size(); ++c)
        if (problem.mesh.cell_component[c] == static_cast<int>(b))
          for (const int v : problem.mesh.cells[c]) field[v] = scene::displacement(motion, problem.mesh.vertices[v]);
      double size = 0;
      for (std::size_t f = 0; f < problem.facets.size(); ++f)
        for (const auto& s : outcome.stress.cell[problem.mesh.boundary[f].cell])
          size = std::max(size, s.cwiseAbs().maxCoeff() * problem.length_scale);
      EXPECT_NEAR(reaction_of_stresses(outcome, field), -load_work(problem, field), 1e-10 * size)
          << problem.mesh.components[b] << ": " << scene::describe(motion);
    }
}

/// Most of the force by the stresses passes where the displacements leave no gap; the zones differ near their ends.
void expect_zones_overlap(const bounds::Outcome<2>& outcome) {
  const auto states = bounds::contact_state(outcome.problem, outcome.displacement, outcome.stress);
  double largest = 0;
  for (const auto& u : outcome.displacement.vertex) largest = std::max(largest, u.norm());
  double all = 0, closed = 0;
  for (std::size_t j = 0; j < states.size(); ++j) {
    const auto& [pressure, gap] = states[j];
    const double force =
        scene::length(outcome.problem.mesh, outcome.problem.contact[j].first) * (pressure[0] + pressure[1]) / 2;
    all += force;
    const auto& [lower, upper] = std::tie(outcome.problem.contact[j].lower, outcome.problem.contact[j].upper);
    double open = 1e-8 * largest;  // and what is not known of the gap
    for (int i = 0; i < 3; ++i) open = std::max(open, 1e-8 * largest + upper[i] - lower[i]);
    if (std::max({gap[0], gap[1], gap[2]}) < open) closed += force;
  }
  EXPECT_TRUE(all == 0 || closed > all / 2) << closed << " of " << all;
}

/// With m such that σ_dd = m·σ: σ_dd² ≤ (m·Cm) (σ·C⁻¹σ). For linear f on a triangle T and its side e, of which the
/// part of a cell at e is one: ∫_e f² ≤ 3 |e|/|T| ∫_T f² [Warburton & Hesthaven 2003].
void expect_pressures_alike(const bounds::Outcome<2>& outcome) {
  const auto& problem = outcome.problem;
  const auto states = bounds::contact_state(problem, outcome.displacement, outcome.stress);
  double largest = 0;
  for (const auto& state : states) largest = std::max({largest, state.pressure[0], state.pressure[1]});
  for (std::size_t j = 0; j < states.size(); ++j) {
    const int first = problem.contact[j].first;
    const auto& facet = problem.mesh.boundary[first];
    const auto stress = bounds::displacement_stress(problem, outcome.displacement, facet.cell);
    const Vector<2> d = problem.facets[first].normal;
    const scene::Voigt<2> m(d[0] * d[0], d[1] * d[1], 2 * d[0] * d[1]);
    const double a = states[j].pressure[0] + m.dot(stress[(facet.local + 1) % 3]);
    const double b = states[j].pressure[1] + m.dot(stress[(facet.local + 2) % 3]);
    const double length = scene::length(problem.mesh, first), part = scene::volume(problem.mesh, facet.cell) / 3;
    const double stiffness = m.dot(problem.bodies[problem.mesh.cell_body[facet.cell]].material.stiffness() * m);
    const double rounding = 1e-10 * largest;
    EXPECT_LE(length / 3 * (a * a + a * b + b * b),
              3 * length / part * stiffness * 2 * outcome.indicator.cell[facet.cell] + length * rounding * rounding);
  }
}

class Compared : public testing::TestWithParam<std::filesystem::path> {
 protected:
  bounds::Outcome<2> run(int levels) const {
    return bounds::run(scene::read_scene<2>(
        GetParam(), {"refine.strategy=uniform", "refine.target=0", "refine.max_levels=" + std::to_string(levels)}));
  }
};

TEST_P(Compared, contact_forces_are_alike_and_balance_the_loads_of_floating_bodies) {
  const auto outcome = run(1);
  expect_contact_forces_alike(outcome);
  expect_contact_balances_loads(outcome);
}

TEST_P(Compared, zones_and_pressures_are_alike_and_formulations_approach_each_other) {
  const auto outcome = run(2);
  const auto scene = scene::read_scene<2>(GetParam());
  // A polygon in another touches at its vertices first, and its edges open between them.
  if (scene.curves.empty()) expect_zones_overlap(outcome);
  expect_pressures_alike(outcome);
  // No corner is worse than a crack, whose stress like r^-½ leaves an error of order h in the energy.
  if (scene::has_coulomb(scene)) return;  // each mesh has a bound of the shear of its own
  const auto &coarse = outcome.levels[0].plain, &fine = outcome.levels[1].plain;
  EXPECT_LE(fine.upper - fine.lower, (coarse.upper - coarse.lower) / 2 + 1e-12 * std::abs(fine.upper));
}

// Which rows are expected to be closed decides how soon the solution is found, not which.
TEST(Guess, does_not_change_the_solution) {
  const auto problem = tests::problem(tests::two_blocks(6));
  const auto stresses = dual::solve(problem, 1);
  ASSERT_EQ(stresses.termination, contact::Termination::solved) << stresses.reason;
  const auto none = std::vector<char>(problem.contact.size(), 0);
  auto one = none, wrong = stresses.closed;
  one.back() = 1;
  for (char& closed : wrong) closed = !closed;
  const double s = bounds::complementary_energy(problem, stresses.stress);
  for (const auto& guess : {none, one, wrong, stresses.closed}) {
    const auto other = dual::solve(problem, 1, guess);
    ASSERT_EQ(other.termination, contact::Termination::solved) << other.reason;
    EXPECT_EQ(other.closed, stresses.closed);
    EXPECT_NEAR(bounds::complementary_energy(problem, other.stress), s, 1e-12 * std::abs(s));
  }
  for (const int degree : {1, 2}) {
    const auto displacements = primal::solve(problem, degree);
    ASSERT_EQ(displacements.termination, contact::Termination::solved) << displacements.reason;
    const double l = bounds::potential_energy(problem, displacements.displacement).total;
    for (const auto& guess : {none, one, wrong, displacements.closed}) {
      const auto other = primal::solve(problem, degree, guess);
      ASSERT_EQ(other.termination, contact::Termination::solved) << other.reason;
      EXPECT_EQ(other.closed, displacements.closed);
      EXPECT_NEAR(bounds::potential_energy(problem, other.displacement).total, l, 1e-12 * std::abs(l));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Compared, testing::ValuesIn(scene_files()),
                         [](const auto& file) { return file.param.stem().string(); });

}  // namespace
}  // namespace bracket::tests
