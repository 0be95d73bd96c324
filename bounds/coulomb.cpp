// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/coulomb.h"

#include <fmt/format.h>

#include <algorithm>
#include <future>

#include "bounds/estimate/on_mesh.h"
#include "scene/problem/law.h"

namespace bracket::bounds {

namespace {

using scene::ContactFacet;
using scene::Problem;

/// μ p at the ends of each facet, of a stress' pressure where it is one.
template <int dim> Problem<dim> with_friction_of(Problem<dim> problem, const scene::Stress<dim>& stress) {
  for (ContactFacet& pair : problem.contact) {
    if (pair.law.coulomb == 0) continue;
    const auto p = plain_pressure(problem, stress, pair);
    pair.law.friction = {pair.law.coulomb * std::max(0.0, p.front()), pair.law.coulomb * std::max(0.0, p.back())};
  }
  return problem;
}

/// μ ∫ B_i |v_t| over each contact facet, for linear B_i.
template <int dim>
Eigen::VectorXd sizes_of_slip(const Problem<dim>& problem, const scene::Displacement<dim>& displacement) {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(2 * problem.contact.size());
  for (std::size_t j = 0; j < problem.contact.size(); ++j) {
    const ContactFacet& pair = problem.contact[j];
    if (pair.law.coulomb == 0) continue;
    const auto slip = jump<dim>(problem, displacement, pair, scene::tangent(problem.facets[pair.first].normal));
    const double factor = pair.law.coulomb * scene::length(problem.mesh, pair.first);
    result[2 * j] = factor * mean_of_size(slip, {1, 0});
    result[2 * j + 1] = factor * mean_of_size(slip, {0, 1});
  }
  return result;
}

}  // namespace

template <int dim> bool has_coulomb(const Problem<dim>& problem) {
  return std::ranges::any_of(problem.contact, [](const auto& pair) { return pair.law.coulomb > 0; });
}

template <int dim> Problem<dim> with_first_friction(Problem<dim> problem, int degree) {
  if (!has_coulomb(problem)) return problem;
  const dual::Solver<dim> solver(problem, scene::stress_degree(degree), dual::Shear::by_pressure);
  const auto first = solver.solve(problem);
  if (!first.reason.empty())
    throw scene::Error(scene::Status::ill_posed, "with shear of at most mu times the pressure, " + first.reason);
  return with_friction_of(std::move(problem), first.stress);
}

template <int dim> Meshed<dim> with_friction_settled(Meshed<dim> meshed, int degree, const Observer<dim>& observer) {
  constexpr int most = 30;
  constexpr double enough = 2;           // η by the width of the step
  constexpr double of_pressure = 1e-11;  // of what strains: below that pressures are rounding, see contact_pressure()
  Problem<dim>& problem = meshed.problem;
  const int stress_degree = scene::stress_degree(degree);
  const Clock clock;
  contact::reserve_blas_memory(2);
  SolvedStep<dim>& step = meshed.step.emplace();
  std::shared_ptr<const dual::Solver<dim>> cones;
  auto other = std::async(std::launch::async, [&] {
    step.solvers.stresses = std::make_shared<const dual::Solver<dim>>(problem, stress_degree);
    cones = std::make_shared<const dual::Solver<dim>>(problem, stress_degree, dual::Shear::by_pressure);
    step.dual_seconds = clock.seconds();
  });
  step.solvers.displacements = std::make_shared<const primal::Solver<dim>>(problem, degree, true);  // for any gap
  step.primal_seconds = clock.seconds();
  other.get();
  std::vector<char> cone_closed;
  meshed.friction = {};
  const auto ended = [&] {
    step.seconds = clock.seconds();
    return std::move(meshed);
  };
  while (true) {
    ++meshed.friction.steps;
    if (observer.stage)
      observer.stage(fmt::format("friction, step {}, on {} cells", meshed.friction.steps, problem.mesh.cells.size()));
    const Clock solving;
    auto stresses = std::async(std::launch::async, [&] {
      step.dual = step.solvers.stresses->solve(problem, meshed.dual_closed);
      step.dual_seconds += solving.seconds();
    });
    step.primal = step.solvers.displacements->solve(problem, meshed.primal_closed);
    step.primal_seconds += solving.seconds();
    stresses.get();
    const primal::Result<dim>& u = step.primal;
    const dual::Result<dim>& lambda = step.dual;
    if (!u.reason.empty() || !lambda.reason.empty()) return ended();  // told when the step itself is examined
    meshed.primal_closed = u.closed;
    meshed.dual_closed = lambda.closed;
    const double width = indicator(problem, u.displacement, lambda.stress).sum;
    const auto within = cones->solve(problem, cone_closed, sizes_of_slip(problem, u.displacement));
    if (!within.reason.empty()) return ended();
    cone_closed = within.closed;
    // η = L(v) + S(λ) + ∫ μ p_λ |v_t|: the gap identity of the step that λ would make.
    meshed.friction.residual = indicator(with_friction_of(problem, within.stress), u.displacement, within.stress).sum;
    const double rounding = of_pressure * potential_energy(problem, u.displacement).strain;
    meshed.friction.settled = meshed.friction.residual <= enough * width + rounding;
    if (meshed.friction.settled || meshed.friction.steps == most) return ended();
    problem = with_friction_of(std::move(problem), lambda.stress);
  }
}

template bool has_coulomb(const Problem<2>&);
template bool has_coulomb(const Problem<3>&);
template Problem<2> with_first_friction(Problem<2>, int);
template Meshed<2> with_friction_settled(Meshed<2>, int, const Observer<2>&);

}  // namespace bracket::bounds
