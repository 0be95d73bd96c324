// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <functional>
#include <random>

#include "bounds/assess.h"
#include "bounds/certificate/given_field.h"
#include "tests/bounds/certificate/exact_scenes.h"
#include "tests/bounds/certificate/given_fields.h"
#include "tests/bounds/certificate/judge_given.h"
#include "tests/bounds/certificate/judge_parts.h"
#include "tests/bounds/certificate/noise.h"
#include "tests/support/sanitized.h"

/// The errors of displacements from anywhere where the solution is known, in rational numbers.
namespace bracket::bounds {
namespace {

using scene::Displacement;
using scene::Problem;

/// Cells in two corners bisected, with what closure needs.
Problem<2> partly_refined(const Problem<2>& first) {
  std::vector<char> marked(first.mesh.cells.size(), 0);
  marked.front() = marked.back() = 1;
  return scene::refine(first, marked).problem;
}

/// A problem whose stresses are known: σ_yy alone, linear in x.
struct Known {
  std::string name;
  scene::Scene<2> scene;
  tests::ExactProblem exact;
  Rational at_zero, slope;
};

std::vector<Known> known() {
  std::vector<Known> result;
  const auto patch = [&](double young, double poisson, double lowering, int n) {
    const Rational nu(poisson);
    result.push_back({"patch", tests::patch(young, poisson, lowering, n),
                      tests::exact_patch(young, poisson, lowering, n),
                      -Rational(young) * Rational(lowering) / (1 - nu * nu), 0});
  };
  const auto pressed = [&](const std::string& name, const tests::LinearPressure& p, int nx, int ny) {
    const Rational p0(p.p0), c(p.c);
    result.push_back({name, tests::linear_pressure(p, nx, ny), tests::exact_linear_pressure(p, nx, ny), -p0, p0 * c});
  };
  patch(1e6, 0.3, 0.01, 2);
  patch(1, 0.49, 0.1, 2);
  pressed("linear pressure", {}, 4, 2);
  pressed("unequal moduli", {.c = 0.875, .young_lower = 1e6}, 4, 1);
  pressed("nearly incompressible", {.poisson = 0.4999}, 2, 2);
  return result;
}

ExactStress solution(const Known& known) {
  const Problem<2>& problem = known.exact.problem;
  ExactStress result;
  for (std::size_t c = 0; c < problem.mesh.cells.size(); ++c) {
    const Corners x = corners_of(problem.mesh, static_cast<int>(c));
    const auto at = [&](const Point& point) { return Exact(known.at_zero) + Exact(known.slope) * point.x; };
    std::array<StressField, 3> parts;
    for (int i = 0; i < 3; ++i)
      parts[i][1] = Polynomial::linear({at(x[i]), at(x[(i + 1) % 3]), at(third * (x[0] + x[1] + x[2]))});
    result.cell.push_back(parts);
  }
  return result;
}

/// ‖u_x − u‖², from σ(u_x) − σ.
Exact squared_error(const Problem<2>& problem, const ExactStress& solution, const ExactDisplacement& given) {
  Exact result;
  for (const Exact& misfit : misfits(problem, solution, given)) result += Exact(2) * misfit;
  return result;
}

/// Checks of displacements of degrees 1 and 2 on these, with their squared errors.
template <class Check> void for_all_known(const Check& check) {
  std::mt19937 generator(2);
  for (const Known& one : known()) {
    const Problem<2>& first = one.exact.problem;
    const ExactStress sigma = solution(one);
    EXPECT_EQ(faults(first, sigma), std::vector<std::string>{});
    for (const int degree : {2, 1}) {
      if (tests::sanitized && degree == 1) break;
      for (const auto& [name, given] : tests::given_fields(first, degree, generator)) {
        SCOPED_TRACE(fmt::format("{}, {} of degree {}", one.name, name, degree));
        const ExactDisplacement s = on_supports(first, given);
        EXPECT_EQ(-complementary_energy(first, sigma, s), Exact(one.exact.energy));  // σ solves the problem
        check(one, given, squared_error(first, sigma, from_nodes(first.mesh, given)));
      }
    }
  }
}

/// The error as stresses have it, by a pair of fields on a mesh, whatever they are. \return whether there is an answer
bool expect_error(const Problem<2>& problem, const tests::Fields& own, const Displacement<2>& given,
                  const Exact& square) {
  const GivenDistance found = certify_distance(problem, own.displacement, own.stress, given);
  EXPECT_NE(found.valid, !found.reason.empty());
  if (!found.valid) return false;
  const Exact low = Exact(found.lower) - Exact(found.stress_error);
  const Exact high = Exact(found.upper) + Exact(found.stress_error);
  EXPECT_TRUE(low <= Exact(0) || low * low <= square) << rounded(low) << " for " << std::sqrt(rounded(square));
  EXPECT_TRUE(high * high >= square) << rounded(high) << " for " << std::sqrt(rounded(square));
  return true;
}

// The second formula of docs/theory.md §10.6, by which the interval from energies and contact is made.
TEST(GivenError, energies_and_contact_give_the_error) {
  for_all_known([](const Known& one, const Displacement<2>& given, const Exact&) {
    const Problem<2>& first = one.exact.problem;
    const ExactStress sigma = solution(one);
    const ExactDisplacement s = on_supports(first, given);
    EXPECT_EQ(squared_error(first, sigma, s),
              Exact(2) * (potential_energy(first, s, {}) - Exact(one.exact.energy) - contact_term(first, sigma, s)));
  });
}

// On the first mesh and on a finer one, by fields of three degrees as they are computed and spoilt.
TEST(GivenError, error_is_inside_whatever_it_is_judged_by) {
  std::mt19937 generator(3);
  int judged = 0;
  for_all_known([&](const Known& one, const Displacement<2>& given, const Exact& square) {
    for (const Problem<2>& problem : {one.exact.problem, partly_refined(one.exact.problem)})
      for (const int degree : {1, 2, 3}) {
        const auto [u, stress] = tests::solved(problem, degree);
        EXPECT_TRUE(expect_error(problem, {u, stress}, given, square));
        for (const auto& [keep, size] : {std::pair(1.0, 1e-9), {1.0, 1e-3}, {1.0, 0.1}, {0.0, 1.0}})
          judged += expect_error(problem,
                                 {tests::noisy(u, keep, size, generator), tests::noisy(stress, keep, size, generator)},
                                 given, square);
      }
  });
  EXPECT_GT(judged, tests::sanitized ? 250 : 500);
}

// Both intervals of every level, and what they come to together.
TEST(GivenError, assessed) {
  for_all_known([](const Known& one, const Displacement<2>& given, const Exact& square) {
    scene::Scene<2> scene = one.scene;
    scene.refine = {.strategy = scene::Strategy::adaptive};
    scene.refine.max_levels = 3;
    scene::FieldOnScene field;
    field.problem = one.exact.problem;
    field.given.displacement = given;
    const Assessment found = assess(scene, std::move(field));
    ASSERT_NE(found.guarantee, "none") << found.reason;
    EXPECT_TRUE(std::isfinite(found.levels[0].by_energy.upper));
    for (const AssessedLevel& level : found.levels)
      for (const ErrorInterval& interval : {level.by_stress, level.by_energy})
        expect_root_inside(interval.lower, interval.upper, square);
    expect_root_inside(found.error.lower, found.error.upper, square);
  });
}

// Of a finer mesh the certificate takes from the first what that has; what it does take from the finer it compares.
TEST(GivenError, changed_data_are_refused_or_do_not_count) {
  using Change = std::function<void(Problem<2>&)>;
  std::mt19937 generator(4);
  int refused = 0, accepted = 0;
  for (const Known& one : known()) {
    SCOPED_TRACE(one.name);
    const Problem<2>& first = one.exact.problem;
    const Problem<2> sound = partly_refined(first);
    const auto own = tests::solved(sound, 2);
    const Displacement<2> given = tests::given_fields(first, 2, generator)[1].displacement;
    const Exact square = squared_error(first, solution(one), from_nodes(first.mesh, given));
    std::vector<Change> changes;
    for (std::size_t v = 0; v < sound.mesh.vertices.size(); ++v)
      changes.push_back([v](auto& p) { p.mesh.vertices[v] += scene::Vector<2>(0.01, 0.02); });
    for (std::size_t c = 0; c < sound.mesh.cells.size(); ++c) {
      changes.push_back([c](auto& p) { p.mesh.cell_body[c] = 1 - p.mesh.cell_body[c]; });
      changes.push_back([c](auto& p) { p.origin.cells[c].corner[1][0] *= 0.5; });
      changes.push_back([c](auto& p) { p.origin.cells[c].of ^= 1; });
    }
    for (std::size_t f = 0; f < sound.facets.size(); ++f) {
      changes.push_back([f](auto& p) { p.facets[f].traction[0] += scene::Vector<2>(0.5, -0.25); });
      changes.push_back([f](auto& p) { p.facets[f].pressure[1] += 0.5; });
      changes.push_back([f](auto& p) { p.facets[f].displacement[0] += scene::Vector<2>(0.5, -0.25); });
      changes.push_back([f](auto& p) { p.facets[f].normal_displacement[1] += 0.5; });
      changes.push_back([f](auto& p) { p.facets[f].normal = scene::Vector<2>(0.6, 0.8); });
    }
    for (std::size_t j = 0; j < sound.contact.size(); ++j)
      for (int k = 0; k < 3; ++k) {
        changes.push_back([j, k](auto& p) { p.contact[j].lower[k] += 0.1, p.contact[j].upper[k] += 0.1; });
        changes.push_back([j, k](auto& p) { p.contact[j].lower[k] -= 0.1, p.contact[j].upper[k] -= 0.1; });
        changes.push_back([j, k](auto& p) { p.contact[j].lower[k] -= 0.1, p.contact[j].upper[k] += 0.1; });
      }
    for (int b = 0; b < 2; ++b) {
      changes.push_back([b](auto& p) { p.bodies[b].force += scene::Vector<2>(0.5, -0.25); });
      changes.push_back([b](auto& p) { p.bodies[b].material = scene::isotropic<2>(3, 0.25, scene::Plane::strain); });
    }
    for (std::size_t i = 0; i < changes.size(); ++i) {
      SCOPED_TRACE(i);
      Problem<2> changed = sound;
      changes[i](changed);
      (expect_error(changed, own, given, square) ? accepted : refused) += 1;
    }
  }
  EXPECT_GT(refused, 0);
  EXPECT_GT(accepted, 0);
}

TEST(GivenError, what_is_no_displacement_of_the_mesh_is_refused) {
  const auto [name, scene, exact, at_zero, slope] = known()[2];
  const Problem<2>& first = exact.problem;
  const auto own = tests::solved(first, 2);
  const auto expect_refused = [&](const Displacement<2>& given, const std::string& why) {
    const GivenEnergy energy = certify_given(first, given);
    EXPECT_FALSE(energy.valid);
    EXPECT_NE(energy.reason.find(why), std::string::npos) << energy.reason;
    const GivenDistance distance = certify_distance(first, own.displacement, own.stress, given);
    EXPECT_FALSE(distance.valid);
    EXPECT_FALSE(distance.reason.empty());
  };
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), -std::numeric_limits<double>::infinity()}) {
    for (std::size_t v = 0; v < own.displacement.vertex.size(); ++v) {
      Displacement<2> given = own.displacement;
      given.vertex[v][v % 2] = bad;
      expect_refused(given, "not finite");
    }
    for (std::size_t e = 0; e < own.displacement.edge.size(); ++e) {
      Displacement<2> given = own.displacement;
      given.edge[e][e % 2] = bad;
      expect_refused(given, "not finite");
    }
  }
  Displacement<2> given = own.displacement;
  given.edge.pop_back();
  expect_refused(given, "not those of this mesh");
  given = own.displacement;
  given.vertex.push_back(given.vertex[0]);
  expect_refused(given, "not those of this mesh");
  given = own.displacement;
  given.degree = 1;
  expect_refused(given, "not those of this mesh");
  for (auto* values : {&(given = own.displacement).vertex, &given.edge})
    for (auto& u : *values) u *= 1e200;
  expect_refused(given, "enclosed");
}

}  // namespace
}  // namespace bracket::bounds
