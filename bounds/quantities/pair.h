// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <span>

#include "bounds/certificate/certificate.h"
#include "bounds/estimate/estimate.h"
#include "contact/clock.h"
#include "dual/dual.h"
#include "primal/primal.h"

/// The two perturbed problems that bound a functional, by both formulations (docs/theory.md §10).
namespace bracket::bounds {

/// Stresses star by star, from the displacements with pressures that are linear on each contact facet.
template <int dim> class LocalStresses {
 public:
  /// \param sweeps over all stars   \param again whether several problems are to be solved: see dual::LocalSolver
  LocalStresses(const primal::Solver<dim>& displacements, const scene::Problem<dim>& problem, int sweeps,
                bool again = false)
      : LocalStresses(displacements, problem, sweeps, again, Clock()) {}

  /// \param problem as for primal::Solver::solve()
  /// \param displacements its own, if they are known: the contact that they close is where pressure is expected; where
  ///     nothing touches they are what is needed
  /// \return with that termination where there are no such pressures
  dual::Result<dim> solve(const scene::Problem<dim>& problem, const primal::Result<dim>& displacements = {}) const;
  /// The same for several problems together, which is quicker. \param displacements of each
  std::vector<dual::Result<dim>> solve(std::span<const scene::Problem<dim>> problems,
                                       std::span<const primal::Result<dim>> displacements) const;

 private:
  LocalStresses(const primal::Solver<dim>& displacements, const scene::Problem<dim>& problem, int sweeps, bool again,
                const Clock& clock);

  primal::PressureSolver<dim> pressures_;
  double of_pressures_;  ///< seconds that it took to make them
  dual::LocalSolver<dim> stars_;
  int sweeps_;
};

/// What has factorised a level, and what its contact is expected to be.
template <int dim> struct Solvers {
  std::shared_ptr<const primal::Solver<dim>> displacements;
  std::shared_ptr<const dual::Solver<dim>> stresses;         ///< in the plane
  std::shared_ptr<const LocalStresses<dim>> local_stresses;  ///< in space
};
struct Closed {
  std::vector<char> primal, dual;
};

/// The problems with loads + s, kinematics − s (first) and the other way round (second), solved.
template <int dim> struct PerturbedPair {
  double s = 0;
  std::array<scene::Displacement<dim>, 2> displacement = {};
  std::array<scene::Stress<dim>, 2> stress = {};
  std::array<Closed, 2> closed = {};
  /// The width of the interval for J, a sum of squares over cells and contact facets: (1/s) (A + B) with
  /// A = ½‖σ(v̄) − λ̄‖² + 2 ∫ p̄ (g − r(v̄)) of the means, B the same of the half differences, without contact. Springs
  /// count as cells do.
  double width = 0;
  std::vector<double> of_difference = {};          ///< the cells' shares of B
  std::vector<double> of_contact_difference = {};  ///< the contact facets': of springs
  double of_means = 0, of_differences = 0;         ///< A, B
  double rounding = 0;                             ///< of the energies of the two, as far as it comes from s
  /// The largest displacement or stress of the half differences by that of the means: how large s is.
  double strength = 0;
};

template <int dim> struct Attempt {
  std::optional<PerturbedPair<dim>> pair;
  std::string reason;  ///< if there is none, as one of the four has no solution: one line
};

/// \param s > 0   \param closed contact facets expected to be closed in the two problems
template <int dim>
Attempt<dim> solve_pair(const scene::Problem<dim>& problem, const Solvers<dim>& solvers,
                        const std::shared_ptr<const scene::Perturbation<dim>>& by, double s,
                        const std::array<Closed, 2>& closed);

/// The bound that a pair gives, of J from above (`sign` 1) or of −J (−1).
template <int dim>
FunctionalBound functional_bound(const scene::Problem<dim>& problem,
                                 const std::shared_ptr<const scene::Perturbation<dim>>& by,
                                 const PerturbedPair<dim>& pair, int sign);

/// One bound alone, for functionals that have no other: of f J / |f| from above, with stresses of the problem with
/// loads f and displacements of that with kinematics f, the loads of the other left out. \return not valid, with a
/// reason, where one of the problems has no solution
template <int dim>
FunctionalBound one_sided_bound(const scene::Problem<dim>& problem, const Solvers<dim>& solvers,
                                const std::shared_ptr<const scene::Perturbation<dim>>& by, double f);

}  // namespace bracket::bounds
