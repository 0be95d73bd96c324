// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/quantities/functional.h"

#include <gtest/gtest.h>

#include <random>

#include "dual/dual.h"
#include "primal/primal.h"
#include "tests/bounds/certificate/judge_parts.h"
#include "tests/support/sanitized.h"
#include "tests/support/scenes.h"

namespace bracket::bounds {
namespace {

using scene::Quantity;
using scene::QuantityKind;
using scene::Vector;

/// All kinds of data, so short that their sums with perturbations by powers of two are doubles.
scene::Scene<2> short_numbers() {
  using namespace tests;
  scene::Scene<2> s = two_bodies(0, 2, 1, 1, 4, 1);
  s.bodies = {{"lower", scene::isotropic<2>(1, 0.25, scene::Plane::strain)},
              {"upper", scene::isotropic<2>(4, 0.125, scene::Plane::strain)}};
  s.bodies.at("lower").force = {1.0 / 64, -1.0 / 32};
  s.boundary = {{"lower.bottom", fixed(1.0 / 64, 0)},
                {"lower.left", sliding(-1.0 / 64)},
                {"upper.right", sliding(1.0 / 32)},
                {"upper.top", traction(scene::enclosed<2>([](const auto& x) { return x[0] / 16; }), constant(-0.125))}};
  s.contact[0].gap = scene::enclosed<2>([](const auto& x) { return x[0] * x[0] / 128; });
  return s;
}

Quantity<2> quantity(QuantityKind kind, const std::string& of) {
  Quantity<2> result;
  result.name = of;
  result.kind = kind;
  result.of = of;
  return result;
}

std::vector<Quantity<2>> quantities() {
  std::vector<Quantity<2>> all = {quantity(QuantityKind::displacement, "upper.top"),
                                  quantity(QuantityKind::displacement, "upper.left"),
                                  quantity(QuantityKind::body, "upper"),
                                  quantity(QuantityKind::rotation, "upper.top"),
                                  quantity(QuantityKind::force, "upper.bottom"),
                                  quantity(QuantityKind::opening, "upper.bottom"),
                                  quantity(QuantityKind::reaction, "lower.bottom"),
                                  quantity(QuantityKind::reaction, "upper.right"),
                                  quantity(QuantityKind::stress, "lower"),
                                  quantity(QuantityKind::stress, "upper"),
                                  quantity(QuantityKind::energy, ""),
                                  quantity(QuantityKind::slip, "upper.bottom"),
                                  quantity(QuantityKind::force, "upper.bottom"),
                                  quantity(QuantityKind::displacement, "upper.bottom"),
                                  quantity(QuantityKind::displacement, "lower.top"),
                                  quantity(QuantityKind::rotation, "lower.top"),
                                  quantity(QuantityKind::displacement, "upper.right"),
                                  quantity(QuantityKind::displacement, "lower.left")};
  all[0].direction = Vector<2>(1, -2);
  all[2].direction = Vector<2>(0, 1);
  all[6].direction = Vector<2>(0, 1);
  all[8].component = scene::StressComponent::xy;
  all[9].component = scene::StressComponent::yy;
  all[12].of_force = scene::ForceComponent::shear;
  all[13].direction = Vector<2>(2, 1);
  all[16].direction = Vector<2>(1, 1);
  all[17].direction = Vector<2>(0, 1);
  Quantity<2> weighted = all[4];
  weighted.weight = scene::enclosed<2>([](const auto& x) { return x[0] * x[0] - x[0]; });
  all.push_back(weighted);
  for (const int kind : {4, 5}) {
    all.push_back(all[kind]);
    all.back().stretch = scene::LineStretch{0.25, 1.75};
  }
  return all;
}

/// What each quantity is checked with: both bounds, both signs.
const int perturbations = tests::sanitized ? 1 : 4;

/// A problem with a perturbation of it, and fields for its sum with f times that.
struct Posed {
  scene::Problem<2> problem;
  std::shared_ptr<const scene::Perturbation<2>> by;
  double f;
  scene::Problem<2> perturbed() const { return scene::perturbed(problem, by, f, f); }
};

/// L(v) + S(λ) − ¼ ‖σ(v) − λ‖², springs being bodies, with the data without the perturbation: what bounds f J, by
/// docs/theory.md §10, as the theorem has it; the certificate evaluates another form of it.
Exact bound_by_definition(const Posed& posed, const Judged& exact, const ExactDisplacement& unperturbed) {
  const scene::Problem<2> perturbed = posed.perturbed();
  scene::Problem<2> own_gaps = perturbed;
  own_gaps.contact = posed.problem.contact;
  own_gaps.perturbed.kinematics = 0;
  const Exact l = potential_energy(posed.problem, exact.displacement, exact.stress.added) +
                  law_energy(perturbed, exact.displacement).lower;
  const Exact s = complementary_energy(own_gaps, exact.stress, unperturbed) +
                  law_complementary_energy(perturbed, exact.stress).lower;
  const Exact contact = contact_term(perturbed, exact.stress, exact.displacement);
  return l + s -
         half * (distance(perturbed, exact.stress, exact.displacement) - contact +
                 springs_misfit(perturbed, exact.stress, exact.displacement));
}

/// Those of `all` that a scene has bounds of. \param first the scene on its first mesh   \param degree of displacements
/// \param on_finer also on a mesh that refinement made, where data are cut
/// \return how many checks there were
template <class Check>
int for_each_of(const std::vector<Quantity<2>>& all, const scene::Scene<2>& scene, const scene::Problem<2>& first,
                int degree, bool on_finer, const Check& check) {
  std::vector<char> marked(first.mesh.cells.size(), 0);
  marked[0] = marked[4] = marked.back() = 1;
  const scene::Problem<2> problem = on_finer ? scene::refine(first, marked).problem : first;
  int checked = 0;
  const auto plain = primal::solve(problem, degree);
  EXPECT_EQ(plain.reason, "");
  const auto supports = supports_of(problem);
  const auto own = exact_displacement(problem, *admissible_field(problem, plain.displacement, supports).field);
  for (const Quantity<2>& asked : all) {
    SCOPED_TRACE(name(asked.kind) + " of " + asked.of);
    Functionals<2> functionals;
    try {
      functionals = bounds::functionals(scene, problem, asked);
    } catch (const scene::Error&) {
      continue;
    }
    for (int i = 0; i < perturbations; ++i) {
      const auto& by = i < 2 ? functionals.below : functionals.above;
      const double f = (i % 2 == 0 ? 1.0 : -1.0) / 64;
      const Posed posed{problem, by, f};
      const auto u = primal::solve(scene::perturbed(problem, by, -f, f), degree);
      const auto lambda = dual::solve(scene::perturbed(problem, by, f, -f), scene::stress_degree(degree));
      EXPECT_EQ(u.reason + lambda.reason, "");
      check(posed, u.displacement, lambda.stress, own);
      ++checked;
    }
  }
  return checked;
}
template <class Check> int for_all_quantities(const scene::Scene<2>& scene, bool on_finer, const Check& check) {
  return for_each_of(quantities(), scene, balanced(tests::problem(scene), 2), 2, on_finer, check);
}

void expect_bound(const Posed& posed, const scene::Displacement<2>& u, const scene::Stress<2>& lambda,
                  const ExactDisplacement& own, double slack) {
  const scene::Problem<2> perturbed = posed.perturbed();
  const FunctionalBound bound = certify_functional(perturbed, u, lambda);
  ASSERT_TRUE(bound.valid) << bound.reason;
  const Judged exact = judged(perturbed, u, lambda);
  EXPECT_EQ(faults(perturbed, exact.displacement), std::vector<std::string>{});
  EXPECT_EQ(faults(perturbed, exact.stress), std::vector<std::string>{});
  const Exact meant = bound_by_definition(posed, exact, own);
  EXPECT_GE(Exact(bound.above), meant);
  EXPECT_LE(rounded(Exact(bound.above) - meant), slack);
}

// The bound of f J is what Theorem 1 says of the fields that the certificate has moved, in rational numbers.
TEST(Functional, is_what_the_theorem_says_exactly) {
  const int checked =
      for_all_quantities(short_numbers(), true,
                         [](const Posed& posed, const scene::Displacement<2>& u, const scene::Stress<2>& lambda,
                            const ExactDisplacement& own) { expect_bound(posed, u, lambda, own, 1e-14); });
  EXPECT_EQ(checked, 19 * perturbations);
}

// The same with contact laws, the energies of which are bounded from above, by both.
TEST(Functional, is_what_the_theorem_says_of_contact_laws) {
  struct GivenLaw {
    scene::Law law;
    double value;
    bool lifts_off;
    int quantities;  ///< slip and shear force of friction alone, openings and stretches where the law has bounds of
                     ///< them
  };
  for (const auto& [law, value, lifts_off, quantities] :
       {GivenLaw{scene::Law::bilateral, 0, true, 16}, GivenLaw{scene::Law::winkler, 4, true, 19},
        GivenLaw{scene::Law::winkler, 4, false, 17}, GivenLaw{scene::Law::tresca, 1.0 / 64, true, 21},
        GivenLaw{scene::Law::tresca, 1.0 / 64, false, 18}}) {
    if (tests::sanitized && !lifts_off) continue;
    SCOPED_TRACE(name(law) + (lifts_off ? "" : ", without lift-off"));
    scene::Scene<2> scene = short_numbers();
    scene.contact[0].law = law;
    scene.contact[0].lifts_off = lifts_off;
    if (value > 0) scene.contact[0].value = tests::constant(value);
    const int checked =
        for_all_quantities(scene, true,
                           [](const Posed& posed, const scene::Displacement<2>& u, const scene::Stress<2>& lambda,
                              const ExactDisplacement& own) { expect_bound(posed, u, lambda, own, 1e-4); });
    EXPECT_EQ(checked, perturbations * quantities);
  }
}

// Loads of degree 2 and 3 are part of half of all data; to other quantities they are data that stay.
TEST(Functional, is_what_the_theorem_says_with_higher_loads) {
  for (const int degree : {3, 4}) {
    const scene::Scene<2> scene = short_numbers();
    scene::Problem<2> first = balanced(tests::problem(scene), 2);
    for (std::size_t f = 0; f < first.facets.size(); ++f) {
      const std::string& part = first.mesh.parts[first.mesh.boundary[f].part];
      auto& data = first.facets[f];
      for (int k = 0; k < degree - 2; ++k) {
        if (part == "upper.top") data.higher_traction[k] = {0.125 - k / 16.0, 1.0 / 32};
        if (part == "lower.right") data.higher_pressure[k] = 0.0625 * (k + 1);
      }
    }
    const std::vector<Quantity<2>> asked = {quantity(QuantityKind::energy, ""),
                                            quantity(QuantityKind::stress, "upper")};
    const int checked =
        for_each_of(asked, scene, first, degree, true,
                    [](const Posed& posed, const scene::Displacement<2>& u, const scene::Stress<2>& lambda,
                       const ExactDisplacement& own) { expect_bound(posed, u, lambda, own, 1e-14); });
    EXPECT_EQ(checked, 2 * perturbations);
  }
}

// Whatever the fields are: they are moved, and what they then say is a bound.
TEST(Functional, holds_for_sabotaged_fields) {
  std::mt19937 generator(1);
  std::normal_distribution<double> noise(0, 1e-3);
  scene::Scene<2> rubbing = short_numbers();
  rubbing.contact[0].law = scene::Law::tresca;
  rubbing.contact[0].value = tests::constant(1.0 / 64);
  for (const auto& [scene, slack] : {std::pair(short_numbers(), 1e-13), {rubbing, 1e-4}})
    for_all_quantities(scene, false,
                       [&, slack = slack](const Posed& posed, scene::Displacement<2> u, scene::Stress<2> lambda,
                                          const ExactDisplacement& own) {
                         for (auto& value : u.vertex) value += Vector<2>(noise(generator), noise(generator));
                         for (auto& value : u.edge) value += Vector<2>(noise(generator), noise(generator));
                         for (auto& cell : lambda.cell)
                           for (auto& s : cell)
                             s += scene::Voigt<2>(noise(generator), noise(generator), noise(generator));
                         expect_bound(posed, u, lambda, own, slack);
                       });
}

}  // namespace
}  // namespace bracket::bounds
