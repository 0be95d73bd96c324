// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bounds/certificate/admissible_displacement.h"
#include "scene/problem/law.h"

/// What contact laws add to the energies, from above (docs/theory.md §7, §11): real numbers that `Number` encloses or
/// holds exactly.
namespace bracket::bounds {

/// The law of a facet of the problem's mesh: at its ends, as the first mesh has it.
template <class Number> struct LawOn {
  std::array<Number, 2> modulus, friction;
  Number length;
};
template <class Number>
LawOn<Number> law_on(const scene::Problem<2>& problem, const FirstContacts& contacts, const scene::ContactFacet& pair) {
  const auto [of, corner] = scene::piece_of_facet(problem, pair.first);
  const scene::FacetLaw& law = scene::first_of(problem).contact[contacts.of_facet[of]].law;
  const Vector2<Number> e = along<Number>(problem, pair.first);
  LawOn<Number> result{{}, {}, root(dot(e, e))};
  for (int i = 0; i < 2; ++i) {
    result.modulus[i] = between_ends(Number(law.modulus[0]), Number(law.modulus[1]), corner[i][0]);
    result.friction[i] = law.coulomb > 0  // a step's bound, given anew on each mesh
                             ? Number(pair.law.friction[i])
                             : between_ends(Number(law.friction[0]), Number(law.friction[1]), corner[i][0]);
  }
  return result;
}

/// A polynomial s ≥ c of the same degree for which ∫ k s² is small: c itself where c ≥ 0 is certain, 0 where c ≤ 0. As
/// s² ≥ (c)₊² (where s < 0 there is c < 0), ½ ∫ k s² bounds what springs of penetration c store.   \param k at the ends
template <class Number> std::vector<Number> spring_stretch(const std::array<Number, 2>& k, std::vector<Number> c) {
  if (std::ranges::all_of(c, [](const Number& one) { return certainly_non_negative(one); })) return c;
  std::vector<double> least;
  for (const Number& one : c) least.push_back(upper(one));
  const std::vector<double> s = scene::shortening({upper(k[0]), upper(k[1])}, least);
  return {s.begin(), s.end()};
}

/// What springs are shortened by in law_energy(): s ≥ r − g, of springs that pull r − g.
template <class Number>
std::vector<Number> springs_shortened(const scene::Problem<2>& problem, const Supports& supports,
                                      const PlainField& field, const scene::ContactFacet& pair,
                                      const std::array<Number, 2>& modulus) {
  std::vector<Number> s = penetration<Number>(problem, supports, field, pair);
  if (!pair.law.two_sided) s = spring_stretch(modulus, std::move(s));
  return s;
}

/// |x|, or a number around all that it can be.
template <class Number> Number absolute(const Number& x) {
  if (certainly_non_negative(x)) return x;
  if constexpr (std::is_same_v<Number, Enclosure>) {
    if (!certainly_non_negative(-x)) {
      const Enclosure half = scene::Real(magnitude(x)) / 2;
      return {half.middle, half.middle};
    }
  }
  return -x;
}

inline double rounded(const Enclosure& x) { return static_cast<double>(x.middle); }

/// Σ |c_i| ∫ g B_i ≥ ∫ g |c| over the parameter, g ≥ 0 linear: halved where coefficients have both signs, up to so
/// often.
template <class Number> Number absolute_integral(const std::array<Number, 2>& g, std::vector<Number> c, int halvings) {
  const bool mixed = std::ranges::any_of(c, [](const Number& x) { return rounded(x) > 0; }) &&
                     std::ranges::any_of(c, [](const Number& x) { return rounded(x) < 0; });
  const Number half = Number(1) / Number(2);
  if (mixed && halvings > 0) {
    auto [left, right] = scene::halves(std::move(c));
    const Number middle = half * (g[0] + g[1]);
    return half * (absolute_integral<Number>({g[0], middle}, std::move(left), halvings - 1) +
                   absolute_integral<Number>({middle, g[1]}, std::move(right), halvings - 1));
  }
  for (Number& x : c) x = absolute(x);
  return scene::bernstein_product(std::vector<Number>{g[0], g[1]}, c);
}

/// ∫ φ over a contact facet, not below: of springs ½ ∫ k s² with s ≥ r − g, of friction ∫ g_T |v_t − j_t|, j_t what
/// it does not see.
template <class Number>
Number law_energy(const scene::Problem<2>& problem, const Supports& supports, const PlainField& field,
                  const scene::ContactFacet& pair) {
  Number sum(0);
  if (!scene::has_springs(pair.law) && !scene::has_friction(pair.law)) return sum;
  const LawOn<Number> law = law_on<Number>(problem, supports.contacts, pair);
  if (scene::has_friction(pair.law))
    sum += law.length *
           absolute_integral(law.friction, rubbing_on<Number>(problem, supports, field, pair), scene::halvings_of_slip);
  if (scene::has_springs(pair.law)) {
    const std::vector<Number> k = {law.modulus[0], law.modulus[1]};
    const std::vector<Number> s = springs_shortened(problem, supports, field, pair, law.modulus);
    sum += law.length / Number(2) * scene::bernstein_product(scene::bernstein_times(k, s), s);
  }
  return sum;
}

/// The gap that S pays for, as coefficients of such a degree.
template <class Number>
std::vector<Number> gap_paid(const scene::Problem<2>& problem, const FirstContacts& contacts,
                             const scene::ContactFacet& pair, int degree) {
  if (!pair.law.two_sided) return gap_on<Number>(pair.upper, degree);
  const auto gap = kept_gap<Number>(problem, contacts, pair);
  return scene::raised_to<Number>(degree, std::vector<Number>(gap.begin(), gap.end()));
}

/// What friction has of ∫ φ*: ∫ τ j_t, j_t what it does not see of the slip.   \param shear per unit of the facet's
/// parameter
template <class Number>
Number friction_paid(const scene::Problem<2>& problem, const FirstContacts& contacts, const scene::ContactFacet& pair,
                     const std::vector<Number>& shear) {
  const std::vector<Number> unseen = unseen_slip<Number>(problem, contacts, pair);
  return unseen.empty() ? Number(0) : scene::bernstein_product(shear, unseen);
}

/// What springs have of ∫ φ*, not below: ½ ∫ p² C. \param pressure per unit of the facet's parameter
template <class Number>
Number compliance_energy(const scene::Problem<2>& problem, const FirstContacts& contacts,
                         const scene::ContactFacet& pair, const std::vector<Number>& pressure) {
  if (!scene::has_springs(pair.law)) return Number(0);
  const LawOn<Number> law = law_on<Number>(problem, contacts, pair);
  const auto c = scene::compliance_on(law.modulus[0], law.modulus[1]);
  return scene::bernstein_product(scene::bernstein_times(std::vector<Number>(c.begin(), c.end()), pressure), pressure) /
         (Number(2) * law.length);
}

/// The largest shear per unit of the facet's parameter, as coefficients of such a degree.
template <class Number>
std::vector<Number> shear_bound(const scene::Problem<2>& problem, const FirstContacts& contacts,
                                const scene::ContactFacet& pair, int degree) {
  const LawOn<Number> law = law_on<Number>(problem, contacts, pair);
  return scene::raised_to<Number>(degree,
                                  std::vector<Number>{law.length * law.friction[0], law.length * law.friction[1]});
}

}  // namespace bracket::bounds
