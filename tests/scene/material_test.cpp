// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <limits>

#include "scene/scene.h"

namespace bracket::scene {
namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

/// |C S − I|, entry by entry, by the rounding that entries of a few eps relative accuracy may cause.
double inverse_defect(const Body<2>& body) {
  const Elasticity<2> defect = (body.stiffness * body.compliance - Elasticity<2>::Identity()).cwiseAbs();
  const Elasticity<2> size = body.stiffness.cwiseAbs() * body.compliance.cwiseAbs();
  return (defect.array() / (size.array() + std::numeric_limits<double>::min())).maxCoeff();
}

TEST(Material, ComplianceIsTheInverseOfStiffness) {
  for (const double young : {1e-9, 1.0, 2.1e11}) {
    for (const double poisson : {-0.9, 0.0, 0.3, 0.4999999}) {
      for (const bool plane_stress : {false, true}) {
        EXPECT_LE(inverse_defect(isotropic<2>(young, poisson, plane_stress)), 16 * eps) << young << " " << poisson;
      }
    }
  }
  EXPECT_LE(inverse_defect(isotropic<2>(1, 0.5, true)), 16 * eps);
}

// Both tensors against the strain energy by bulk and shear modulus: each entry must be good to a few eps on its own,
// also where an inverse would lose seven digits.
TEST(Material, EntriesStayAccurateNearIncompressibility) {
  for (const double poisson : {0.0, 0.3, 0.4999999, 0.4999999999}) {
    const long double nu = poisson;
    const Body<2> body = isotropic<2>(3, poisson, false);
    const long double lame = 3 * nu / ((1 + nu) * (1 - 2 * nu)), shear = 3 / (2 * (1 + nu));
    const auto close = [](double value, long double exact) {
      EXPECT_LE(std::abs(value - exact), 8 * eps * std::abs(exact)) << value;
    };
    close(body.stiffness(0, 0), lame + 2 * shear);
    close(body.stiffness(0, 1), lame);
    close(body.stiffness(2, 2), shear);
    close(body.compliance(0, 0), (1 - nu * nu) / 3);
    close(body.compliance(0, 1), -nu * (1 + nu) / 3);
    close(body.compliance(2, 2), 1 / shear);
  }
}

// Uniaxial plane stress has strain (1, −ν, 0)/E; plane strain has a modulus of 1/(1 − ν²).
TEST(Material, UniaxialStressGivesTheStrainOfHookesLaw) {
  const Voigt<2> pull(1, 0, 0);
  const Voigt<2> stress_strain = isotropic<2>(4, 0.25, true).compliance * pull;
  EXPECT_EQ(stress_strain, Voigt<2>(0.25, -0.0625, 0));
  const Voigt<2> plane_strain = isotropic<2>(4, 0.25, false).compliance * pull;
  EXPECT_EQ(plane_strain, Voigt<2>(0.234375, -0.078125, 0));  // (1 − ν²)/E, −ν(1 + ν)/E
}

TEST(Material, AnisotropicInverseStandsBadScaling) {
  Elasticity<2> stiffness;
  stiffness << 1, 0.3, 1e-7, 0.3, 2, -2e-7, 1e-7, -2e-7, 1e-12;
  const Body<2> body = anisotropic<2>(stiffness);
  EXPECT_EQ(body.compliance, body.compliance.transpose());
  EXPECT_LE(inverse_defect(body), 64 * eps);
  EXPECT_LE(inverse_defect(anisotropic<2>(1e150 * stiffness)), 64 * eps);  // its determinant is no number
  const Body<2> known = isotropic<2>(2, 0.3, false);
  EXPECT_LE((anisotropic<2>(known.stiffness).compliance - known.compliance).cwiseAbs().maxCoeff(), 16 * eps);
}

}  // namespace
}  // namespace bracket::scene
