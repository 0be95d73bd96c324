// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/problem/problem.h"

/// The contact laws (docs/theory.md §11) in terms that both formulations and the certificate share. With d the
/// direction of a contact facet, first side to second, and t as below, for displacements v′ of the first side and v″ of
/// the second (zero for a wall):
///     r = (v′ − v″)·d,     v_t = (v′ − v″)·t,     λ′n′ = −p d − τ t on the first side, the opposite on the second.
/// So p and τ do the work −∫ (p r + τ v_t) on the bodies: a shear τ of the sign of v_t resists the slip, and
/// τ v_t ≤ g_T |v_t| where |τ| ≤ g_T.
namespace bracket::scene {

/// d turned by 90° counter-clockwise.
inline Vector<2> tangent(const Vector<2>& d) { return {-d[1], d[0]}; }

/// What was found of a contact facet, as flags: some row of the normal direction is closed; some of the slip holds.
enum FacetState : char { touches = 1, sticks = 2 };

/// The cubic C that agrees with 1/k, k linear and positive from k0 to k1, at the ends of a facet and twice in its
/// middle: its Bernstein coefficients. C ≥ 1/k, for 1/k − C = (1/k)''''(ξ) t (t − ½)² (t − 1) / 24 with a fourth
/// derivative that is positive; for constant k they are equal. So ½ ∫ p² C is not less than ½ ∫ p²/k.
template <class Number> std::array<Number, 4> compliance_on(const Number& k0, const Number& k1) {
  const Number at0 = Number(1) / k0, at1 = Number(1) / k1, sum = k0 + k1;
  const auto inner = [&](const Number& near, const Number& far, const Number& k) {
    return Number((Number(16) * (k / sum / sum) - (near + near) + far) / Number(3));
  };
  return {at0, inner(at0, at1, k1), inner(at1, at0, k0), at1};
}

/// How often a facet is halved on which v_t changes its sign, for ∫ g_T |v_t| by the sizes of coefficients: what that
/// is too large falls to a quarter with each, on the one half that has the change.
constexpr int halvings_of_slip = 6;

/// What unilateral springs of a facet are shortened by, s ≥ r − g by Bernstein coefficients: nearly the least ½ ∫ k s².
/// Any such s has an energy not below ½ ∫ k (r − g)₊², also where it is negative: there r < g.
/// \param modulus k > 0 at the ends   \param c of r − g
std::vector<double> shortening(const std::array<double, 2>& modulus, const std::vector<double>& c);

}  // namespace bracket::scene
