// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "bounds/bounds.h"
#include "dual/dual.h"
#include "primal/primal.h"
#include "tests/bounds/certificate/exact_scenes.h"

/// The certificate at moduli, Poisson's ratios and units far from 1.
namespace bracket::bounds {
namespace {

Certificate certificate_of(const scene::Problem<2>& problem, int degree) {
  const auto displacements = primal::solve(problem, degree);
  const auto stresses = dual::solve(problem, 1);
  EXPECT_EQ(displacements.termination, contact::Termination::solved) << displacements.reason;
  EXPECT_EQ(stresses.termination, contact::Termination::solved) << stresses.reason;
  return certify(problem, displacements.displacement, stresses.stress);
}

double relative_width(const Certificate& certificate) {
  return (certificate.upper - certificate.lower) / std::max(std::abs(certificate.lower), std::abs(certificate.upper));
}

TEST(Extremes, contrast_and_nearly_incompressible_bodies) {
  // Both fields are in their spaces: what is left is rounding.
  for (const int n : {4, 8, 16})
    for (const double poisson : {0.3, 0.49, 0.4999, 0.499999, 0.49999999})
      for (const double ratio : {1e-12, 1e-6, 1.0, 1e6, 1e12}) {
        SCOPED_TRACE(testing::Message() << "n " << n << ", nu " << poisson << ", moduli 1 : " << ratio);
        const auto [problem, energy] =
            tests::exact_linear_pressure({.young_upper = ratio, .poisson = poisson}, n, n / 2);
        const Certificate certificate = certificate_of(problem, 2);
        ASSERT_TRUE(certificate.valid) << certificate.reason;
        EXPECT_LE(Rational(certificate.lower), energy);
        EXPECT_GE(Rational(certificate.upper), energy);
        EXPECT_LE(relative_width(certificate), poisson < 0.49995 ? 1e-9 : 1e-6);
      }
}

/// A scene with every kind of datum in units in which lengths are `length` and forces per thickness `force` times
/// larger.
scene::Scene<2> in_units(double length, double force) {
  const double modulus = force / length;  // so are tractions
  const auto times = [&](double by, auto given) {
    return scene::enclosed<2>([=](const auto& x) { return by * given(std::array{x[0] / length, x[1] / length}); });
  };
  scene::Scene<2> s;
  s.blocks = {tests::block("lower", 0, length, 0, length, 3, 4),
              tests::block("upper", 0, length, length, 2 * length, 3, 2)};
  s.bodies = {{"lower", scene::isotropic<2>(modulus, 0.3, scene::Plane::strain)},
              {"upper", scene::isotropic<2>(5 * modulus, 0.4, scene::Plane::strain)}};
  s.bodies.at("lower").force = modulus / length * scene::Vector<2>(0.01, -0.05);
  s.boundary = {{"lower.left", tests::sliding(-0.02 * length)},
                {"upper.right", tests::fixed(0.01 * length, -0.03 * length)},
                {"upper.top", tests::traction(times(0.01 * modulus, [](const auto& x) { return x[0]; }),
                                              tests::constant(-0.05 * modulus))}};
  s.contact = {
      {"upper.bottom", "lower.top", times(length, [](const auto& x) { return 0.02 * (x[0] - 0.6) * x[0]; }), ""},
      {"lower.bottom", "rigid", times(length, [](const auto& x) { return 0.01 * x[0] * x[0]; }), ""}};
  return s;
}

TEST(Extremes, units_do_not_matter) {
  for (const int degree : {1, 2}) {
    const Certificate benign = certificate_of(tests::problem(in_units(1, 1)), degree);
    ASSERT_TRUE(benign.valid) << benign.reason;
    const double size = std::max(std::abs(benign.lower), std::abs(benign.upper));
    for (const double length : {1e-12, 1e-6, 1.0, 1e3, 1e12})
      for (const double force : {1e-12, 1e-3, 1.0, 1e6, 1e12}) {
        SCOPED_TRACE(testing::Message() << "length " << length << ", force " << force << ", degree " << degree);
        const Certificate certificate = certificate_of(tests::problem(in_units(length, force)), degree);
        ASSERT_TRUE(certificate.valid) << certificate.reason;
        const double unit = force * length;  // of energy
        EXPECT_NEAR(certificate.lower / unit, benign.lower, 1e-12 * size);
        EXPECT_NEAR(certificate.upper / unit, benign.upper, 1e-12 * size);
        EXPECT_NEAR(relative_width(certificate), relative_width(benign), 1e-12);
      }
  }
}

}  // namespace
}  // namespace bracket::bounds
