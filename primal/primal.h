// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>

#include "contact/contact.h"
#include "scene/scene.h"

/// Displacements: the upper bound. Polynomials on triangles and tetrahedra in Bernstein form, exactly
/// admissible: u_h ∈ K (docs/theory.md §3).
namespace bracket::primal {

template <int dim> struct Result {
  contact::Termination termination = contact::Termination::solved;
  std::string reason;  ///< if not solved: one line, with the body and the motion
  scene::Displacement<dim> displacement;
  std::vector<char> closed;  ///< per Problem::contact: scene::FacetState; to start the next mesh from
  contact::Statistics statistics;
};

/// Pressures that are linear on each contact facet, as stresses that are made from displacements locally need them.
template <int dim> struct PressureResult {
  contact::Termination termination = contact::Termination::solved;
  std::string reason;  ///< if not solved: one line
  /// Per Problem::contact, at the vertices of the first facet, force per area: ≥ 0 but where the sides keep together.
  std::vector<std::array<double, dim>> pressure;
  /// ũ, with these pressures in place of contact: A(ũ,v) = ℓ(v) − ∫ p r(v) for all v that keep the supports at zero.
  scene::Displacement<dim> displacement;
};

/// What can be said of a contact without a solve: whether the displacements prescribed on both of its sides leave any
/// that are admissible, K_h ≠ ∅ there.
/// \param degree 1 to 4, in space 1 or 2, as for Solver
/// \throw scene::Error (input: another degree; ill_posed: they alone already close a gap by more than it has)
template <int dim> void check_prescribed(const scene::Problem<dim>& problem, int degree);

template <int dim> class PressureSolver;

/// Minimises the potential energy L over K_h ⊂ K [HH81, (1.2)]; rows bound the Bernstein coefficients of r by those of
/// g on each contact facet. The bodies are factorised once and solved for any data.
template <int dim> class Solver {
 public:
  /// \param degree of the displacements
  /// \param any_gap whether problems are to follow whose gaps are not linear where those of this one are, or the other
  ///     way round
  /// \throw scene::Error (input) for another degree; as check_prescribed()
  Solver(const scene::Problem<dim>& problem, int degree, bool any_gap = false);

  /// \param problem on the same mesh with the same materials, supports and contact facets; loads, gaps and prescribed
  ///     displacements are its own
  /// \param closed contact facets expected to be closed (as Result::closed, or empty: all)
  /// \throw std::invalid_argument where other displacements are unknown, or contact needs other rows, than in the
  ///     problem that was factorised; scene::Error as check_prescribed()
  Result<dim> solve(const scene::Problem<dim>& problem, const std::vector<char>& closed = {}) const;

  /// PressureSolver::solve(), once.
  PressureResult<dim> solve_with_pressure(const scene::Problem<dim>& problem,
                                          const std::vector<char>& closed = {}) const;

 private:
  friend class PressureSolver<dim>;
  struct Factorised;
  std::shared_ptr<const Factorised> factorised_;
};

/// The pressures of least complementary energy, F the compliance for the moments of r against the facets' hat
/// functions, with a term for their jumps from facet to facet. F is made once, on the factors of the displacements.
template <int dim> class PressureSolver {
 public:
  /// \param problem without springs and friction, as for Solver::solve()
  PressureSolver(const Solver<dim>& displacements, const scene::Problem<dim>& problem);

  /// Whether any pressures balance the loads is decided first; if not: no_equilibrium, though Solver::solve() may find
  /// displacements. \param problem as for the constructor   \param closed contact facets expected to be pressed (as
  ///     Result::closed, or empty: all)
  PressureResult<dim> solve(const scene::Problem<dim>& problem, const std::vector<char>& closed = {}) const;

 private:
  struct Rows;
  std::shared_ptr<const Rows> rows_;
};

/// Both displacements of a problem.
template <int dim> struct Solved {
  Result<dim> displacements;
  PressureResult<dim> with_pressure;  ///< if the former are solved
};

/// Who solves a problem in place of Solver, as Solver::solve() and Solver::solve_with_pressure() would; each call may
/// be on a mesh of its own.
template <int dim>
using Engine =
    std::function<Solved<dim>(const scene::Problem<dim>& problem, int degree, const std::vector<char>& closed)>;

/// The same, once.
template <int dim>
Result<dim> solve(const scene::Problem<dim>& problem, int degree, const std::vector<char>& closed = {});

}  // namespace bracket::primal
