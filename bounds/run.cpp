// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <chrono>
#include <fmt/format.h>
#include <future>

#include "bounds/bounds.h"

namespace bracket::bounds {

namespace {

class Clock {
 public:
  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

template <int dim> std::vector<std::string> skipped_stages(const scene::Scene<dim>& scene, const scene::Problem<dim>& problem) {
  using scene::Support;
  std::vector<std::string> skipped;
  bool force = false, floating = false, prescribed = false;
  for (std::size_t b = 0; b < problem.bodies.size(); ++b) {
    force = force || !problem.bodies[b].force.isZero(0);
    floating = floating || !scene::free_motions(problem, static_cast<int>(b)).empty();
  }
  for (const auto& data : problem.facets) {
    if (data.support == Support::fixed) prescribed = prescribed || !data.displacement[0].isZero(0) || !data.displacement[1].isZero(0);
    if (data.support == Support::sliding) prescribed = prescribed || data.normal_displacement[0] != 0 || data.normal_displacement[1] != 0;
  }
  if (problem.contact.empty()) skipped.push_back("interface problem: no contact");
  if (!force) skipped.push_back("particular stress field: no body force");
  if (!floating) skipped.push_back("rigid motions: every body is held by its supports");
  if (!prescribed) skipped.push_back("work of supports: no displacement is prescribed but zero");
  if (scene.refine.strategy == "none") skipped.push_back("marking and refinement: strategy \"none\"");
  return skipped;
}

/// The two formulations side by side; each is mostly serial, so that two cores are well used.
template <int dim>
std::pair<primal::Result<dim>, dual::Result<dim>> solve_both(const scene::Problem<dim>& problem, int degree,
                                                             Seconds& seconds) {
  const Clock clock;
  contact::set_blas_threads(1);
  auto stresses = std::async(std::launch::async, [&] {
    auto result = dual::solve(problem);
    return std::pair(std::move(result), clock.seconds());
  });
  auto displacements = primal::solve(problem, degree);
  seconds.primal = clock.seconds();
  auto [result, dual_seconds] = stresses.get();
  seconds.dual = dual_seconds;
  return {std::move(displacements), std::move(result)};
}

}  // namespace

template <int dim> Outcome<dim> run(const scene::Scene<dim>& scene, const Progress& progress) {
  const Clock total;
  const auto tell = [&](const std::string& stage) {
    if (progress) progress(stage);
  };
  Outcome<dim> outcome;
  Level level;
  tell("mesh");
  outcome.problem = scene::fix_data(scene, scene::build_mesh(scene));
  const auto& problem = outcome.problem;
  check_solvability(problem);
  outcome.skipped = skipped_stages(scene, problem);
  level.cells = static_cast<int>(problem.mesh.cells.size());
  level.seconds.mesh = total.seconds();

  tell("displacements and stresses");
  auto [displacements, stresses] = solve_both(problem, scene.solve.degree, level.seconds);
  level.primal_dofs = displacements.unknowns;
  level.dual_dofs = stresses.unknowns;
  level.contact_rows = displacements.rows;
  level.contact_active = displacements.active_rows;
  level.contact_iterations = displacements.iterations;
  level.dual_contact_rows = stresses.rows;
  level.dual_contact_active = stresses.active_rows;
  level.dual_contact_iterations = stresses.iterations;
  level.primal_imbalance = displacements.imbalance;
  level.dual_imbalance = stresses.imbalance;
  level.primal_assemble = displacements.assemble;
  level.dual_assemble = stresses.assemble;
  level.primal_phases = displacements.seconds;
  level.dual_phases = stresses.seconds;

  const bool both = displacements.outcome == contact::Outcome::solved && stresses.outcome == contact::Outcome::solved;
  if (both) {
    tell("estimate");
    const Clock clock;
    outcome.displacement = std::move(displacements.displacement);
    outcome.stress = std::move(stresses.stress);
    outcome.indicator = indicator(problem, outcome.displacement, outcome.stress);
    level.bracket = bracket(problem, outcome.displacement, outcome.stress, outcome.indicator);
    level.checks = admissibility(problem, outcome.displacement, outcome.stress);
    level.checks.gap_identity = level.bracket.gap_identity;
    level.oscillation_energy = oscillation_energy(scene, problem, outcome.displacement, outcome.stress);
    level.seconds.estimate = clock.seconds();
  }
  level.seconds.total = total.seconds();
  outcome.levels.push_back(level);

  if (!both) {
    outcome.status = scene::Status::not_guaranteed;
    outcome.reason = displacements.reason.empty() ? stresses.reason : displacements.reason;
  } else if (!level.checks.passed()) {
    outcome.status = scene::Status::not_guaranteed;
    outcome.reason = fmt::format("the computed fields are not admissible to {:g} of the scene's scale", Checks::tolerance);
  } else {
    outcome.guarantee = "discretisation";
    const double target = scene.refine.target;
    if (target > 0 && !(level.bracket.relative_error_bound <= target)) {
      outcome.status = scene::Status::budget;
      outcome.reason = fmt::format("the guaranteed relative error {:.3g} is above the target {:g} and the mesh is not refined",
                                   level.bracket.relative_error_bound, target);
    }
  }
  return outcome;
}

template struct Outcome<2>;
template Outcome<2> run(const scene::Scene<2>&, const Progress&);

}  // namespace bracket::bounds
