// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <limits>
#include <type_traits>

#include "tests/scene/inputs.h"

namespace bracket::scene {
namespace {

using namespace test;

/// |C S − I|, entry by entry, by the rounding that entries of a few eps relative accuracy may cause.
double inverse_defect(const Material<2>& material) {
  const Elasticity<2> defect = (material.stiffness() * material.compliance() - Elasticity<2>::Identity()).cwiseAbs();
  const Elasticity<2> size = material.stiffness().cwiseAbs() * material.compliance().cwiseAbs();
  return (defect.array() / (size.array() + std::numeric_limits<double>::min())).maxCoeff();
}

TEST(Material, ComplianceIsTheInverseOfStiffness) {
  for (const double young : {1e-9, 1.0, 2.1e11}) {
    for (const double poisson : {-0.9, 0.0, 0.3, 0.4999999}) {
      for (const Plane plane : {Plane::strain, Plane::stress}) {
        EXPECT_LE(inverse_defect(isotropic<2>(young, poisson, plane)), 16 * eps) << young << " " << poisson;
      }
    }
  }
  EXPECT_LE(inverse_defect(isotropic<2>(1, 0.5, Plane::stress)), 16 * eps);
}

// Both tensors against the strain energy by bulk and shear modulus: each entry must be good to a few eps on its own,
// also where an inverse would lose seven digits.
TEST(Material, EntriesStayAccurateNearIncompressibility) {
  for (const double poisson : {0.0, 0.3, 0.4999999, 0.4999999999}) {
    const long double nu = poisson;
    const Material<2> material = isotropic<2>(3, poisson, Plane::strain);
    const long double lame = 3 * nu / ((1 + nu) * (1 - 2 * nu)), shear = 3 / (2 * (1 + nu));
    const auto close = [](double value, long double exact) {
      EXPECT_LE(std::abs(value - exact), 8 * eps * std::abs(exact)) << value;
    };
    close(material.stiffness()(0, 0), lame + 2 * shear);
    close(material.stiffness()(0, 1), lame);
    close(material.stiffness()(2, 2), shear);
    close(material.compliance()(0, 0), (1 - nu * nu) / 3);
    close(material.compliance()(0, 1), -nu * (1 + nu) / 3);
    close(material.compliance()(2, 2), 1 / shear);
  }
}

// Uniaxial plane stress has strain (1, −ν, 0)/E; plane strain has a modulus of 1/(1 − ν²).
TEST(Material, UniaxialStressGivesTheStrainOfHookesLaw) {
  const Voigt<2> pull(1, 0, 0);
  const Voigt<2> stress_strain = isotropic<2>(4, 0.25, Plane::stress).compliance() * pull;
  EXPECT_EQ(stress_strain, Voigt<2>(0.25, -0.0625, 0));
  const Voigt<2> plane_strain = isotropic<2>(4, 0.25, Plane::strain).compliance() * pull;
  EXPECT_EQ(plane_strain, Voigt<2>(0.234375, -0.078125, 0));  // (1 − ν²)/E, −ν(1 + ν)/E
}

TEST(Material, AnisotropicInverseStandsBadScaling) {
  Elasticity<2> stiffness;
  stiffness << 1, 0.3, 1e-7, 0.3, 2, -2e-7, 1e-7, -2e-7, 1e-12;
  const Material<2> material = anisotropic<2>(stiffness);
  EXPECT_EQ(material.compliance(), material.compliance().transpose());
  EXPECT_LE(inverse_defect(material), 64 * eps);
  EXPECT_LE(inverse_defect(anisotropic<2>(1e150 * stiffness)), 64 * eps);  // its determinant is no number
  const Material<2> known = isotropic<2>(2, 0.3, Plane::strain);
  EXPECT_LE((anisotropic<2>(known.stiffness()).compliance() - known.compliance()).cwiseAbs().maxCoeff(), 16 * eps);
}

// A material comes from its factories only, and what is read of it cannot be written to.
using M = Material<2>;
static_assert(!std::is_default_constructible_v<M> && !std::is_aggregate_v<M>);
static_assert(!std::is_constructible_v<M, Elasticity<2>, Elasticity<2>>);
static_assert(!std::is_constructible_v<M, Elasticity<2>, Elasticity<2>, std::optional<IsotropicConstants>>);
static_assert(!std::is_assignable_v<decltype((std::declval<M&>().stiffness())), Elasticity<2>>);
static_assert(!std::is_assignable_v<decltype((std::declval<M&>().compliance())), Elasticity<2>>);
static_assert(!std::is_assignable_v<decltype((std::declval<M&>().constants()->young)), double>);
static_assert(!std::is_default_constructible_v<Body<2>>);

void expect_no_material(const std::function<void()>& make, const std::string& named) {
  const auto error = test::error_of(make);
  ASSERT_TRUE(error.has_value()) << named << ": accepted";
  EXPECT_EQ(error->status(), Status::input);
  EXPECT_NE(std::string(error->what()).find(named), std::string::npos) << error->what();
}

TEST(Material, InadmissibleConstantsAreRefused) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  const std::vector<std::tuple<double, double, Plane, std::string>> wrong = {
      {0, 0.3, Plane::strain, "E must be > 0"},
      {-1, 0.3, Plane::stress, "E must be > 0, is -1"},
      {nan, 0.3, Plane::strain, "E must be finite"},
      {infinity, 0.3, Plane::strain, "E must be finite"},
      {1e-310, 0.3, Plane::strain, "out of range"},
      {1.7e308, 0.4999, Plane::strain, "out of range"},
      {1, -1, Plane::strain, "nu must lie in (-1, 0.5) in plane strain"},
      {1, 0.5, Plane::strain, "nu must lie in (-1, 0.5) in plane strain, is 0.5"},
      {1, nan, Plane::strain, "nu"},
      {1, 0.5 * (1 + eps), Plane::stress, "nu must lie in (-1, 0.5] in plane stress"},
  };
  for (const auto& [young, poisson, plane, named] : wrong)
    expect_no_material([&, e = young, nu = poisson, p = plane] { isotropic<2>(e, nu, p); }, named);
  EXPECT_NO_THROW(isotropic<2>(1, 0.5 * (1 - eps), Plane::strain));
  EXPECT_NO_THROW(isotropic<2>(1, -1 + eps, Plane::strain));
}

// Scaled rotations of diag(1, 1, least): indefinite, singular and definite by rounding only are told from definite.
TEST(Material, StiffnessesThatAreNoneAreRefused) {
  const auto with = [](int i, int j, double entry) {
    Elasticity<2> stiffness;
    stiffness << 3, 1, 0, 1, 2, 0, 0, 0, 1;
    stiffness(i, j) = entry;
    return stiffness;
  };
  expect_no_material([&] { anisotropic<2>(with(0, 1, 1.001)); }, "the stiffness is not symmetric");
  expect_no_material([&] { anisotropic<2>(with(2, 2, 0)); }, "the stiffness is not positive definite");
  expect_no_material([&] { anisotropic<2>(with(2, 2, -1)); }, "not positive definite");
  expect_no_material([&] { anisotropic<2>(with(1, 1, std::numeric_limits<double>::quiet_NaN())); }, "finite");
  expect_no_material([&] { anisotropic<2>(with(1, 1, 1e-310)); }, "the stiffness");
  EXPECT_NO_THROW(anisotropic<2>(with(0, 1, 1 + eps)));
  EXPECT_EQ(anisotropic<2>(with(0, 1, 1 + eps)).stiffness()(1, 0), 1 + eps);  // the upper triangle counts
  for (const double least : {-1e-3, 0.0, 1e-16, 1e-3})
    for (const double unit : {1e-30, 1.0, 1e30}) {
      const Voigt<2> axis = Voigt<2>(1, 2, -2) / 3, scale(unit, 1, 1e-3);
      const Elasticity<2> reflection = Elasticity<2>::Identity() - 2 * axis * axis.transpose();
      const Elasticity<2> rotated = reflection * Voigt<2>(1, 1, least).asDiagonal() * reflection;
      const Elasticity<2> stiffness = scale.asDiagonal() * rotated * scale.asDiagonal();
      if (least == 1e-3)
        EXPECT_NO_THROW(anisotropic<2>(stiffness)) << unit;
      else
        expect_no_material([&] { anisotropic<2>(stiffness); }, "not positive definite");
    }
}

}  // namespace
}  // namespace bracket::scene
