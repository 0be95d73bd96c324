// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "contact/contact.h"
#include "dual/local/star.h"

namespace bracket::dual {

/// The fields C′ ε(w), w = Σ ψ_a ρ_a, six unknowns a vertex (three in the plane), C′ compressible whatever the material
/// is: by these a stress is put in balance (docs/theory.md §12.3). What does not depend on loads, made once.
template <int dim> class Repair {
 public:
  Repair(const scene::Problem<dim>& problem, const std::vector<Star<dim>>& stars);

  /// Adds C′ ε(w) to a stress σ̄ such that the sum σ* has
  ///     ∫ σ* : ε(ψ_a ρ) = ∫ F · ψ_a ρ + Σ ∫ ψ_a t · ρ   for every vertex a and every motion ρ that its supports leave,
  /// t the given loads; where the system is not definite in floating point, nothing. \pre these and F are in balance
  /// along all motions that the supports leave
  void put_in_balance(const scene::Problem<dim>& problem, const Facets<dim>& facets,
                      const std::vector<Star<dim>>& stars, const std::vector<FacetVector<dim>>& given,
                      std::vector<LinearStress<dim>>& stress) const;

 private:
  std::vector<int> unknowns(const scene::Mesh<dim>& mesh, int cell) const;

  std::vector<int> node_;                  ///< of each vertex: its number among those of its component; −1: no cell's
  std::vector<int> component_;             ///< of each vertex
  std::vector<std::vector<int>> offsets_;  ///< of each component: the first unknown of its nodes, then how many
  std::vector<scene::Elasticity<dim>> material_;  ///< C′ of each body
  std::vector<Eigen::SparseMatrix<double>> matrices_;
  std::optional<contact::Bodies> bodies_;
};

}  // namespace bracket::dual
