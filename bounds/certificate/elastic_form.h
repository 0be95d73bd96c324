// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bounds/certificate/vector2.h"
#include "scene/bernstein.h"

namespace bracket::bounds {

/// The elastic energy of strain, ½ εᵀCε, and of stress, ½ σᵀC⁻¹σ, from one factor C = L D Lᵀ (L with a unit diagonal):
/// sums of squares, which do not cancel. Isotropic: from E and ν themselves, so that neither form suffers as ν → ½.
template <class Number> struct ElasticForm {
  ElasticForm(const std::array<Number, 3>& of_d, const std::array<Number, 3>& of_l) : d(of_d), l(of_l) {
    for (int i = 0; i < 3; ++i) half_d[i] = d[i] / Number(2);
    for (int i = 0; i < 3; ++i) half_inverse[i] = Number(1) / (d[i] + d[i]);
  }

  std::array<Number, 3> d;                     ///< > 0
  std::array<Number, 3> l;                     ///< L(1,0), L(2,0), L(2,1)
  std::array<Number, 3> half_d, half_inverse;  ///< ½ D, ½ D⁻¹

  /// \param e xx, yy and twice xy
  Number strain_energy(const std::array<Number, 3>& e) const {
    const Number first = e[0] + l[0] * e[1] + l[1] * e[2], second = e[1] + l[2] * e[2];
    return half_d[0] * (first * first) + half_d[1] * (second * second) + half_d[2] * (e[2] * e[2]);
  }
  /// \param s xx, yy, xy
  Number stress_energy(const std::array<Number, 3>& s) const {
    const Number second = s[1] - l[0] * s[0], third = s[2] - l[1] * s[0] - l[2] * second;
    return squares(s[0], second, third);
  }
  /// The energy of the stress Ce − s, from L⁻¹(Ce − s) = D Lᵀe − L⁻¹s: what a large modulus has in common cancels
  /// first.
  Number difference_energy(const std::array<Number, 3>& e, const std::array<Number, 3>& s) const {
    const Number second = s[1] - l[0] * s[0], third = s[2] - l[1] * s[0] - l[2] * second;
    const std::array<Number, 3> rest = {d[0] * (e[0] + l[0] * e[1] + l[1] * e[2]) - s[0],
                                        d[1] * (e[1] + l[2] * e[2]) - second, d[2] * e[2] - third};
    return squares(rest[0], rest[1], rest[2]);
  }

 private:
  Number squares(const Number& first, const Number& second, const Number& third) const {
    return half_inverse[0] * (first * first) + half_inverse[1] * (second * second) + half_inverse[2] * (third * third);
  }
};

template <class Number> ElasticForm<Number> elastic_form(const scene::Material<2>& material) {
  const Number one(1), two(2);
  if (const auto& constants = material.constants()) {
    const Number young(constants->young), poisson(constants->poisson);
    const Number shear = young / (two * (one + poisson));
    const Number bulk = constants->plane == scene::Plane::stress
                            ? young / (two * (one - poisson))
                            : young / (two * (one + poisson) * (one - poisson - poisson));  // not 2 ν, which rounds
    // C = [bulk + shear, bulk − shear, 0; ·, bulk + shear, 0; 0, 0, shear]
    const Number sum = bulk + shear;
    return {{sum, two * two * bulk * shear / sum, shear}, {(bulk - shear) / sum, Number(0), Number(0)}};
  }
  const auto c = [&](int i, int j) { return Number(material.stiffness()(i, j)); };
  std::array<Number, 3> d, l;
  d[0] = c(0, 0);
  l[0] = c(1, 0) / d[0];
  l[1] = c(2, 0) / d[0];
  d[1] = c(1, 1) - l[0] * c(1, 0);
  l[2] = (c(2, 1) - l[1] * c(1, 0)) / d[1];
  d[2] = c(2, 2) - l[1] * c(2, 0) - l[2] * l[2] * d[1];
  return {d, l};
}

template <class Number> std::vector<ElasticForm<Number>> elastic_forms(const scene::Problem<2>& problem) {
  std::vector<ElasticForm<Number>> forms;
  for (const auto& body : problem.bodies) forms.push_back(elastic_form<Number>(body.material));
  return forms;
}

/// The same forms with another kind of number.
template <class To, class From> std::vector<ElasticForm<To>> forms_as(const std::vector<ElasticForm<From>>& forms) {
  std::vector<ElasticForm<To>> result;
  for (const auto& [d, l, half_d, half_inverse] : forms)
    result.push_back({{To(d[0]), To(d[1]), To(d[2])}, {To(l[0]), To(l[1]), To(l[2])}});
  return result;
}

/// ∫ of the energy over a triangle of a polynomial, given by its Bernstein coefficients.
/// \param energy of a field's value   \param doubled_area of the triangle
template <class Number, std::size_t n, class Energy>
Number integral(const Energy& energy, const std::vector<std::array<Number, n>>& coefficients,
                const Number& doubled_area) {
  return doubled_area / Number(2) *
         scene::mean_of_squares<Number>(energy, std::span<const std::array<Number, n>>(coefficients));
}

}  // namespace bracket::bounds
