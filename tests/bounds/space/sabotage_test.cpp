// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "bounds/certificate/space/displacement_energy.h"
#include "bounds/certificate/space/stress_energy.h"
#include "tests/bounds/space/cases.h"
#include "tests/bounds/space/judge.h"

/// The certificate in space of fields that no solver gave: it holds, or there is none.
namespace bracket::bounds::space {
namespace {

using scene::Problem;
using scene::Vector;

struct Fields {
  scene::Displacement<3> displacement;
  scene::Stress<3> stress;
};
Fields fields_of(const tests::SpaceCase& given, double size, std::mt19937& generator) {
  return {tests::random_displacement(given.problem, 2, size, generator),
          tests::random_stress(given.problem, given.mean_stress, size, generator)};
}

TEST(SpaceSabotage, each_bound_stands_for_itself_and_none_crosses_the_other) {
  std::mt19937 generator(1);
  for (const auto& given : tests::all_cases()) {
    SCOPED_TRACE(given.name);
    double highest_lower = -INFINITY, least_upper = INFINITY;
    for (int trial = 0; trial < 10; ++trial) {
      const auto [u, stress] = fields_of(given, trial < 5 ? 0.02 : 1, generator);
      const Certificate one = certify(given.problem, u, stress);
      EXPECT_NE(one.valid, !one.reason.empty());
      if (!one.valid) {
        EXPECT_GE(trial, 5) << one.reason;
        continue;
      }
      highest_lower = std::max(highest_lower, one.lower);
      least_upper = std::min(least_upper, one.upper);
      EXPECT_GE(one.contact, 0);
      const auto other = fields_of(given, 0.02, generator);
      EXPECT_EQ(certify(given.problem, other.displacement, stress).lower, one.lower);
      EXPECT_EQ(certify(given.problem, u, other.stress).upper, one.upper);
    }
    EXPECT_LE(highest_lower, least_upper);
  }
}

TEST(SpaceSabotage, what_is_not_finite_or_of_another_mesh_is_refused) {
  std::mt19937 generator(2);
  const auto given = tests::clamped();
  const auto [u, stress] = fields_of(given, 0.02, generator);
  ASSERT_TRUE(certify(given.problem, u, stress).valid);
  const auto refused = [&](const scene::Displacement<3>& v, const scene::Stress<3>& s, const std::string& named) {
    const Certificate certificate = certify(given.problem, v, s);
    EXPECT_FALSE(certificate.valid);
    EXPECT_NE(certificate.reason.find(named), std::string::npos) << certificate.reason;
  };
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    for (std::size_t i = 0; i < u.vertex.size(); ++i) {
      auto v = u;
      v.vertex[i][static_cast<Eigen::Index>(i % 3)] = bad;
      refused(v, stress, "not finite");
    }
    for (std::size_t i = 0; i < u.edge.size(); ++i) {
      auto v = u;
      v.edge[i][static_cast<Eigen::Index>(i % 3)] = bad;
      refused(v, stress, "not finite");
    }
    for (std::size_t i = 0; i < 16 * stress.cell.size(); ++i) {
      auto s = stress;
      s.cell[i / 16][i % 16][static_cast<Eigen::Index>(i % 6)] = bad;
      refused(u, s, "not finite");
    }
  }
  auto v = u;
  v.edge.pop_back();
  refused(v, stress, "not those of this mesh");
  v = u;
  v.degree = 3;
  refused(v, stress, "degree");
  auto s = stress;
  s.cell[0].pop_back();
  refused(u, s, "not those of this mesh");
  s = stress;
  s.degree = 2;
  refused(u, s, "degree");
  v = u;
  for (auto& value : v.vertex) value *= 1e200;
  refused(v, stress, "enclosed");
}

/// What rounds is far below what is computed, wherever the body lies and however far it moves.
TEST(SpaceSabotage, motions_far_larger_than_strains_and_bodies_far_away) {
  std::mt19937 generator(4);
  constexpr double along = 1e6;
  auto given = tests::cornered(tests::turned_away());
  Problem<3>& problem = given.problem;
  scene::Voigt<3> mean;
  mean << -1, -1, -1, 0, 0, 0;
  auto u = tests::random_displacement(problem, 2, 1e-3, generator);
  // The upper body moves as a whole, out of contact.
  const Vector<3> way =
      along * Vector<3>(Eigen::AngleAxisd(0.7, Vector<3>(1, 2, -0.5).normalized()) * Vector<3>(1, 1, 1));
  std::vector<char> upper(problem.mesh.vertices.size(), 0);
  for (std::size_t c = 0; c < problem.mesh.cells.size(); ++c)
    for (const int v : problem.mesh.cells[c]) upper[v] = problem.mesh.cell_body[c] == 1;
  for (std::size_t v = 0; v < upper.size(); ++v)
    if (upper[v]) u.vertex[v] += way;
  for (std::size_t e = 0; e < problem.mesh.edges.size(); ++e)
    if (upper[problem.mesh.edges[e][0]]) u.edge[e] += way;
  const auto stress = tests::random_stress(problem, mean, 1e-3, generator);
  const Certificate certificate = certify(problem, u, stress);
  ASSERT_TRUE(certificate.valid) << certificate.reason;
  const Judged exact = judged(problem, u, stress);
  ASSERT_EQ(exact.reason, "");
  EXPECT_EQ(displacement_faults(problem, exact), std::vector<std::string>{});
  EXPECT_EQ(stress_faults(problem, exact), std::vector<std::string>{});
  const Exact l = potential_energy(problem, exact), s = complementary_energy(problem, exact);
  EXPECT_GE(Exact(certificate.upper), l);
  EXPECT_LE(Exact(certificate.lower), -s);
  EXPECT_LE(certificate.upper - rounded(l), 2e-16 * std::abs(rounded(l)) + 1e-18 * along);
  EXPECT_LE(-certificate.lower - rounded(s), 1e-14 * std::abs(rounded(s)));
}

/// A plate of cells that are so much flatter than wide, turned, with a constant stress that turned tractions carry:
/// what the closed form loses on them (docs/theory.md §7).
double lost_on(double flat) {
  const Eigen::AngleAxisd turn(0.7, Vector<3>(1, 2, -0.5).normalized());
  const auto warp = [&](const Vector<3>& x) {
    const Vector<3> sheared(x[0] + 0.05 * x[1] * x[2], x[1] + 0.1 * x[2] * x[0], flat * x[2]);
    return Vector<3>(turn * sheared + Vector<3>(1000, -300, 77.7));
  };
  const std::vector<tests::Box> boxes = {{{0, 0, 0}, {1, 1, 1}, {1, 1, 1}, tests::steel()}};
  const Problem<3> problem = tests::problem_of(
      boxes,
      [](int, const Vector<3>&, const Vector<3>&) {
        scene::FacetData<3> data;
        data.support = scene::Support::fixed;
        return data;
      },
      warp);
  std::mt19937 generator(5);
  scene::Voigt<3> mean;
  mean << 1, 0.5, 0.3, 0.2, 0.1, 0.4;
  const auto u = tests::random_displacement(problem, 2, 0, generator);
  const auto stress = tests::random_stress(problem, mean, 0, generator);
  const Certificate certificate = certify(problem, u, stress);
  EXPECT_TRUE(certificate.valid) << certificate.reason;
  const auto faces = faces_of(problem.mesh);
  const auto exact = judged(problem, u, stress);
  EXPECT_EQ(stress_faults(problem, exact), std::vector<std::string>{});
  const Exact s = complementary_energy(problem, exact);
  EXPECT_LE(Exact(certificate.lower), -s);
  return (-certificate.lower - rounded(s)) / rounded(s);
}
TEST(SpaceSabotage, flat_cells_widen_the_interval_and_never_spoil_it) {
  EXPECT_LE(lost_on(1), 1e-14);
  EXPECT_LE(lost_on(1e-1), 1e-12);
  EXPECT_LE(lost_on(1e-2), 1e-9);
  EXPECT_LE(lost_on(1e-3), 1e-5);
}

}  // namespace
}  // namespace bracket::bounds::space
