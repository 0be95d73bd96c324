// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>

#include "contact/contact.h"
#include "scene/scene.h"

/// Stresses: the lower bound. Self-equilibrated triangular block elements of degree 1, 2 or 3 (docs/theory.md §4; HH81
/// §2.1, §3).
namespace bracket::dual {

template <int dim> struct Result {
  contact::Termination termination = contact::Termination::solved;
  std::string reason;  ///< if not solved: one line
  scene::Stress<dim> stress;
  std::vector<char> closed;  ///< per Problem::contact: scene::FacetState; to start the next mesh from
  contact::Statistics statistics;
};

/// By what the shear is bounded where contact has friction, coefficient by coefficient.
enum class Shear {
  bounded,     ///< by FacetLaw::friction
  by_pressure  ///< where FacetLaw::coulomb is not zero, by that times the stress' own pressure
};

/// Minimises S over the block-element stresses in K⁺_{F,P} [HH81, (1.13), (2.12)] by the hybrid method: edge
/// displacements, of their degree on each edge, are the multipliers of traction continuity; contact rows are the
/// Bernstein moments of r, whose multipliers are coefficients of the pressure. The bodies are factorised once and
/// solved for any data.
template <int dim> class Solver {
 public:
  /// \param degree of the block elements, 1 to 3
  Solver(const scene::Problem<dim>& problem, int degree, Shear shear = Shear::bounded);

  /// \param problem on the same mesh with the same materials, supports and contact facets; loads, gaps and prescribed
  ///     displacements are its own
  /// \param closed contact facets expected to be closed (as Result::closed, or empty: all)
  /// \param wider what is added to the gap, ∫ B_i of it over each contact facet, degree + 1 numbers each; empty:
  /// nothing \throw std::invalid_argument where other displacements are unknown, or other facets in contact, than in
  /// the
  ///     problem that was factorised
  Result<dim> solve(const scene::Problem<dim>& problem, const std::vector<char>& closed = {},
                    const Eigen::VectorXd& wider = {}) const;

 private:
  struct Factorised;
  std::shared_ptr<const Factorised> factorised_;
};

/// The same, once.
template <int dim>
Result<dim> solve(const scene::Problem<dim>& problem, int degree, const std::vector<char>& closed = {});

/// Block-element stresses in K⁺_{F,P} without a global dual system (docs/theory.md §12): the stress of a displacement
/// is handed out star by star. Exactly balanced but for rounding, whatever the displacement is; the closer that is to
/// the solution, the closer S is to its minimum.
template <int dim> class LocalSolver {
 public:
  using Pressure = std::vector<std::array<double, std::size_t{dim}>>;

  /// What the stresses of a problem are made from.
  struct Start {
    const scene::Problem<dim>& problem;
    const Pressure& pressure;
    const scene::Displacement<dim>& displacement;
  };

  /// \param again whether problems are to be solved more than once: then the cells' forms and what puts a stress in
  ///     balance are kept, where a quarter of the machine's memory holds them
  explicit LocalSolver(const scene::Problem<dim>& problem, bool again = false);

  /// \param problem on the same mesh with the same materials, supports and contact facets; loads, gaps and prescribed
  ///     displacements are its own
  /// \param pressure of each contact at the vertices of its first facet, ≥ 0 where the sides can part, in balance with
  ///     the loads of bodies that float
  /// \param displacement of degree 1 or 2, best that by these pressures without contact
  /// \param sweeps how often S is then minimised star by star
  /// \return solved, whatever the field is worth, or not_definite; `closed` is empty
  Result<dim> solve(const scene::Problem<dim>& problem, const Pressure& pressure,
                    const scene::Displacement<dim>& displacement, int sweeps) const;

  /// The same for several problems, star by star for all of them: what is made of the stars is made once.
  /// \return in their order, statistics of all together
  std::vector<Result<dim>> solve(const std::vector<Start>& starts, int sweeps) const;

 private:
  struct Frame;
  std::shared_ptr<const Frame> frame_;
};

/// The same, once.
template <int dim>
Result<dim> local(const scene::Problem<dim>& problem, const std::vector<std::array<double, std::size_t{dim}>>& pressure,
                  const scene::Displacement<dim>& displacement, int sweeps);

/// The same minimum by Uzawa's iteration on the multipliers of (3.13), (3.14) [HH81, §3], until the stress is known to
/// about 1e-9 of its size and meets the constraints as well. It needs ~ h⁻² iterations; it terminates as solved or
/// not_converged, the latter also where no pressure balances the loads or the time is spent.
/// \param particular λ̄ [HH81, §2]: linear on the parts of each cell, tractions continuous, div λ̄ = −F, λ̄n = P on
///     Γ_τ, no shear on Γ_0 and Γ_K, one pressure for both sides of Γ_K, which may be a tension (Remark 2.1)
/// \throw std::invalid_argument where contact has another law than to be frictionless
/// \param time_is_spent asked now and then; empty: it never is
template <int dim>
Result<dim> uzawa(const scene::Problem<dim>& problem, const scene::Stress<dim>& particular,
                  const std::function<bool()>& time_is_spent = {});

}  // namespace bracket::dual
