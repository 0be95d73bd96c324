// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bounds/certificate/space/vector3.h"

namespace bracket::bounds::space {

/// The elastic energy of strain, ½ εᵀCε, and of stress, ½ σᵀC⁻¹σ, from one factor C = L D Lᵀ (L with a unit diagonal):
/// sums of squares, which do not cancel. Isotropic: from E and ν themselves, so that neither form suffers as ν → ½.
template <class Number> struct ElasticForm {
  std::array<Number, 6> d;                     ///< > 0
  std::array<std::array<Number, 6>, 6> l;      ///< below the diagonal
  int coupled = 6;                             ///< L is the unit matrix from this row on
  std::array<Number, 6> half_d, half_inverse;  ///< ½ D, ½ D⁻¹

  /// \param e in the order of Simplex<3>::voigt, shear twice
  Number strain_energy(const std::array<Number, 6>& e) const {
    Number sum(0);
    for (int k = 0; k < 6; ++k) {
      Number part = e[k];
      for (int i = k + 1; i < coupled; ++i) part += l[i][k] * e[i];
      sum += half_d[k] * (part * part);
    }
    return sum;
  }
  /// \param s in the same order, shear once
  Number stress_energy(std::array<Number, 6> s) const {
    Number sum(0);
    for (int k = 0; k < 6; ++k) {
      for (int i = 0; i < k && k < coupled; ++i) s[k] -= l[k][i] * s[i];
      sum += half_inverse[k] * (s[k] * s[k]);
    }
    return sum;
  }
  /// The energy of the stress Ce − s, from L⁻¹(Ce − s) = D Lᵀe − L⁻¹s: what a large modulus has in common cancels
  /// first.
  Number difference_energy(const std::array<Number, 6>& e, std::array<Number, 6> s) const {
    Number sum(0);
    for (int k = 0; k < 6; ++k) {
      Number part = e[k];
      for (int i = k + 1; i < coupled; ++i) part += l[i][k] * e[i];
      for (int i = 0; i < k && k < coupled; ++i) s[k] -= l[k][i] * s[i];
      const Number rest = d[k] * part - s[k];
      sum += half_inverse[k] * (rest * rest);
    }
    return sum;
  }

  void halve() {
    for (int k = 0; k < 6; ++k) half_d[k] = d[k] / Number(2);
    for (int k = 0; k < 6; ++k) half_inverse[k] = Number(1) / (d[k] + d[k]);
  }
};

template <class Number> ElasticForm<Number> elastic_form(const scene::Material<3>& material) {
  const Number one(1);
  ElasticForm<Number> form;
  for (auto& row : form.l) row.fill(Number(0));
  if (const auto& constants = material.constants()) {
    const Number young(constants->young), poisson(constants->poisson);
    const Number shear = young / (Number(2) * (one + poisson));
    // What is left of a direction's stiffness once the stresses of those before may vanish: of none, one, two.
    form.d = {young * (one - poisson) / ((one + poisson) * (one - poisson - poisson)),  // not 2 ν, which rounds
              young / ((one + poisson) * (one - poisson)),
              young,
              shear,
              shear,
              shear};
    form.l[1][0] = form.l[2][0] = poisson / (one - poisson);
    form.l[2][1] = poisson;
    form.coupled = 3;
    form.halve();
    return form;
  }
  for (int k = 0; k < 6; ++k) {
    std::array<Number, 6> column;  // of L D
    for (int i = k; i < 6; ++i) {
      column[i] = Number(material.stiffness()(i, k));
      for (int j = 0; j < k; ++j) column[i] -= form.l[i][j] * form.d[j] * form.l[k][j];
    }
    form.d[k] = column[k];
    for (int i = k + 1; i < 6; ++i) form.l[i][k] = column[i] / column[k];
  }
  form.halve();
  return form;
}

template <class Number> std::vector<ElasticForm<Number>> elastic_forms(const scene::Problem<3>& problem) {
  std::vector<ElasticForm<Number>> forms;
  for (const auto& body : problem.bodies) forms.push_back(elastic_form<Number>(body.material));
  return forms;
}

/// The mean of a quadratic form over a tetrahedron of what is linear on it, given at its corners.
template <class Number, class Form, std::size_t n>
Number mean_of_squares(const Form& form, const std::array<std::array<Number, n>, 4>& value) {
  std::array<Number, n> all = value[0];
  Number sum = form(value[0]);
  for (int k = 1; k < 4; ++k) {
    for (std::size_t i = 0; i < n; ++i) all[i] += value[k][i];
    sum += form(value[k]);
  }
  return (sum + form(all)) / Number(20);
}

}  // namespace bracket::bounds::space
