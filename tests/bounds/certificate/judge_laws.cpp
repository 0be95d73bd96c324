// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bounds/certificate/judge_parts.h"

namespace bracket::bounds {

namespace {

Around operator+(const Around& a, const Around& b) { return {a.lower + b.lower, a.upper + b.upper}; }
Around operator*(const Exact& factor, const Around& a) { return {factor * a.lower, factor * a.upper}; }

/// ∫ g |v|, g ≥ 0 and linear, on halves as long as signs are mixed.
Around absolute_integral(const Polynomial& g, const Polynomial& v, int halvings) {
  const bool mixed = v.has_positive() && (Exact(-1) * v).has_positive();
  if (mixed && halvings > 0)
    return half * (absolute_integral(g.half_of_segment(0), v.half_of_segment(0), halvings - 1) +
                   absolute_integral(g.half_of_segment(1), v.half_of_segment(1), halvings - 1));
  const Exact whole = (g * v).mean();
  return {whole < Exact(0) ? -whole : whole, (g * v.with_sizes()).mean()};
}

/// ∫ k (c)₊² likewise.
Around square_integral(const Polynomial& k, const Polynomial& c, int halvings) {
  if (!c.has_positive()) return {};
  const bool mixed = (Exact(-1) * c).has_positive();
  if (mixed && halvings > 0)
    return half * (square_integral(k.half_of_segment(0), c.half_of_segment(0), halvings - 1) +
                   square_integral(k.half_of_segment(1), c.half_of_segment(1), halvings - 1));
  const Polynomial size = c.with_sizes();
  return {mixed ? Exact(0) : (k * c * c).mean(), (k * size * size).mean()};
}

/// ∫ p (c)₊, p ≥ 0, likewise, from below.
Exact positive_product(const Polynomial& p, const Polynomial& c, int halvings) {
  if (!c.has_positive()) return {};
  if (!(Exact(-1) * c).has_positive()) return (p * c).mean();
  if (halvings == 0) return {};
  return half * (positive_product(p.half_of_segment(0), c.half_of_segment(0), halvings - 1) +
                 positive_product(p.half_of_segment(1), c.half_of_segment(1), halvings - 1));
}

/// ∫ p² / k: 1/k lies between its tangent in the middle and its chord.
Around divided_integral(const Polynomial& k, const Polynomial& p, int halvings) {
  const Exact k0 = k.at_end(0), k1 = k.at_end(1);
  if (halvings > 0 && !(k0 == k1))
    return half * (divided_integral(k.half_of_segment(0), p.half_of_segment(0), halvings - 1) +
                   divided_integral(k.half_of_segment(1), p.half_of_segment(1), halvings - 1));
  const Exact one(1), middle = half * (k0 + k1), slope = half * (k1 - k0) / (middle * middle);
  const Polynomial tangent = Polynomial::linear({one / middle + slope, one / middle - slope});
  const Polynomial chord = Polynomial::linear({one / k0, one / k1});
  return {(p * p * tangent).mean(), (p * p * chord).mean()};
}

}  // namespace

Around law_energy(const scene::Problem<2>& problem, const ExactDisplacement& u) {
  constexpr int halvings = 10;
  Around sum;
  for (const auto& pair : problem.contact) {
    if (scene::has_friction(pair.law))
      sum = sum + length_of(problem, pair) *
                      absolute_integral(linear_on(pair.law.friction), slip(problem, u, pair), halvings);
    if (!scene::has_springs(pair.law)) continue;
    const Polynomial k = linear_on(pair.law.modulus);
    const Polynomial c = approach(problem, u, pair) - (pair.law.two_sided ? gap(problem, pair) : gap_of(pair.upper));
    const Exact square = (k * c * c).mean();
    const Around energy = pair.law.two_sided ? Around{square, square} : square_integral(k, c, halvings);
    sum = sum + half * length_of(problem, pair) * energy;
  }
  return sum;
}

Around law_complementary_energy(const scene::Problem<2>& problem, const ExactStress& stress) {
  constexpr int halvings = 6;
  Around sum;
  for (const auto& pair : problem.contact)
    if (scene::has_springs(pair.law))
      sum = sum + half / length_of(problem, pair) *
                      divided_integral(linear_on(pair.law.modulus), pressure(problem, stress, pair), halvings);
  return sum;
}

Exact springs_misfit(const scene::Problem<2>& problem, const ExactStress& stress, const ExactDisplacement& u) {
  scene::Problem<2> one = problem;
  Exact sum;
  for (const auto& pair : problem.contact) {
    if (!scene::has_springs(pair.law)) continue;
    one.contact = {pair};
    const Polynomial c = approach(problem, u, pair) - (pair.law.two_sided ? gap(problem, pair) : gap_of(pair.upper));
    const Polynomial p = pressure(problem, stress, pair);
    sum += law_energy(one, u).upper + law_complementary_energy(one, stress).upper -
           (pair.law.two_sided ? (p * c).mean() : positive_product(p, c, 10));
  }
  return sum;
}

}  // namespace bracket::bounds
