// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/level.h"

#include <fmt/format.h>

#include <future>
#include <numeric>

#include "bounds/asked.h"
#include "bounds/estimate/on_mesh.h"
#include "bounds/particular.h"
#include "bounds/unstrained.h"
#include "scene/problem/gap.h"

namespace bracket::bounds {

namespace {

/// λ̄ and Uzawa's iteration, or the hybrid method; where quantities are asked for, its solver is kept.
template <int dim>
void solve_stresses(const Meshed<dim>& meshed, const scene::Scene<dim>& scene, bool keep, const Clock& run_clock,
                    Examined<dim>& solved) {
  const bool uzawa = scene.solve.dual == scene::Dual::uzawa;
  if (uzawa)
    solved.dual = dual::uzawa(meshed.problem, particular_stress(meshed.problem),
                              [&] { return run_clock.seconds() >= scene.refine.max_seconds; });
  if (uzawa && !keep) return;
  auto solver = std::make_shared<const dual::Solver<dim>>(meshed.problem, scene::stress_degree(scene.solve.degree));
  if (!uzawa) solved.dual = solver->solve(meshed.problem, meshed.dual_closed);
  if (keep) solved.solvers.stresses = std::move(solver);
}

template <int dim> std::string unsolved(const Examined<dim>& solved) {
  return solved.primal.reason.empty() ? solved.dual.reason : solved.primal.reason;
}

/// Displacements, then stresses from them star by star.
template <int dim> Examined<dim> solve_in_turn(const Meshed<dim>& meshed, const scene::Scene<dim>& scene) {
  Clock clock;
  const auto& problem = meshed.problem;
  Examined<dim> solved;
  const bool keep = asks_for_quantities(scene);
  auto solver = std::make_shared<const primal::Solver<dim>>(problem, scene.solve.degree, keep);
  solved.primal = solver->solve(problem, meshed.primal_closed);
  solved.level.seconds.primal = clock.lap();
  if (solved.unsolved = solved.primal.reason; !solved.unsolved.empty()) return solved;
  auto stresses = std::make_shared<const LocalStresses<dim>>(*solver, problem, sweeps_of(scene, problem.mesh), keep);
  solved.dual = stresses->solve(problem, solved.primal);
  solved.unsolved = solved.dual.reason;
  if (keep) solved.solvers = {std::move(solver), nullptr, std::move(stresses)};
  solved.level.seconds.dual = clock.seconds();
  return solved;
}

/// The two formulations side by side; each is mostly serial, so that two cores are well used. The last of Coulomb's
/// steps is solved already.
template <int dim>
Examined<dim> solve_side_by_side(const Meshed<dim>& meshed, const scene::Scene<dim>& scene, const Clock& run_clock) {
  if (const auto& step = meshed.step) {
    Examined<dim> solved;
    solved.primal = step->primal;
    solved.dual = step->dual;
    solved.solvers = step->solvers;
    solved.level.seconds.primal = step->primal_seconds;
    solved.level.seconds.dual = step->dual_seconds;
    solved.unsolved = unsolved(solved);
    return solved;
  }
  const Clock clock;
  contact::reserve_blas_memory(2);
  const bool keep = asks_for_quantities(scene);
  Examined<dim> solved;
  auto stresses = std::async(std::launch::async, [&] {
    solve_stresses(meshed, scene, keep, run_clock, solved);
    solved.level.seconds.dual = clock.seconds();
  });
  auto solver = std::make_shared<const primal::Solver<dim>>(meshed.problem, scene.solve.degree, keep);
  solved.primal = solver->solve(meshed.problem, meshed.primal_closed);
  if (keep) solved.solvers.displacements = std::move(solver);
  solved.level.seconds.primal = clock.seconds();
  stresses.get();
  solved.unsolved = unsolved(solved);
  return solved;
}

/// The same by another solver's displacements.
template <int dim>
Examined<dim> solve_by(const primal::Engine<dim>& engine, const Meshed<dim>& meshed, const scene::Scene<dim>& scene) {
  Clock clock;
  const auto& problem = meshed.problem;
  Examined<dim> solved;
  primal::Solved<dim> found = engine(problem, scene.solve.degree, meshed.primal_closed);
  const auto& pressed = found.with_pressure;
  solved.primal = std::move(found.displacements);
  solved.level.seconds.primal = clock.lap();
  solved.unsolved = solved.primal.reason.empty() ? pressed.reason : solved.primal.reason;
  if (!solved.unsolved.empty()) {
    solved.dual.termination = pressed.termination;
    return solved;
  }
  solved.dual = dual::local(problem, pressed.pressure, pressed.displacement, sweeps_of(scene, problem.mesh));
  solved.unsolved = solved.dual.reason;
  solved.level.seconds.dual = clock.seconds();
  return solved;
}

template <int dim>
Examined<dim> solve_both(const Meshed<dim>& meshed, const scene::Scene<dim>& scene, const Clock& run_clock,
                         const primal::Engine<dim>& engine) {
  if (engine) return solve_by(engine, meshed, scene);
  if constexpr (dim == 3) return solve_in_turn(meshed, scene);
  if constexpr (dim == 2)
    return scene.solve.dual == scene::Dual::local ? solve_in_turn(meshed, scene)
                                                  : solve_side_by_side(meshed, scene, run_clock);
}

/// Two fields of one problem and their certificate.
template <int dim> struct Pair {
  scene::Displacement<dim> displacement;
  scene::Stress<dim> stress;
  Certificate certificate;
};

/// Where nothing is strained λ = 0 is the best stress and, if it is admissible, a translation of all bodies alike a
/// displacement without rounding: none, or the one that some vertex is held by.
template <int dim> Pair<dim> at_rest(const scene::Problem<dim>& problem, const scene::Displacement<dim>& displacement) {
  const scene::Stress<dim> stress = no_stress(problem.mesh, scene::stress_degree(displacement.degree));
  Pair<dim> best{displacement, stress, certify(problem, displacement, stress)};
  std::vector<scene::Vector<dim>> translations = {scene::Vector<dim>::Zero()};
  for (const auto& facet : problem.facets)
    if (facet.support == scene::Support::fixed && translations.size() == 1)
      translations.push_back(facet.displacement[0]);
  for (const auto& translation : translations) {
    const auto moved = translated(problem.mesh, displacement.degree, translation);
    const Certificate other = certify(problem, moved, stress);
    if (other.valid && (!best.certificate.valid || other.upper <= best.certificate.upper))
      best = {moved, stress, other};
  }
  return best;
}

/// So many cells are enclosed in extended precision within a fifth of a second. Then each bound is as sharp as its own
/// field: one that is exact shows all digits, however far the other one is.
constexpr std::size_t few_cells = std::size_t{1} << 14;

template <int dim>
double largest_motion(const scene::Problem<dim>& problem, const scene::Displacement<dim>& displacement) {
  double largest = largest_at_vertices(displacement);
  for (const auto& pair : problem.contact)
    for (const double gap : pair.upper) largest = std::max(largest, std::abs(gap));
  return largest;
}

/// What some units in the last place of displacements and gaps do to L(u_h): near its minimum to second order in the
/// bodies, to first order across the contact.
template <int dim>
double rounding_of_solution(const scene::Problem<dim>& problem, const scene::Displacement<dim>& displacement,
                            const scene::Stress<dim>& stress) {
  const double size = 8 * std::numeric_limits<double>::epsilon() * largest_motion(problem, displacement);
  double energy = energy_of_noise(problem, displacement.degree, size);
  const auto states = contact_state(problem, displacement, stress);
  for (std::size_t j = 0; j < states.size(); ++j) {
    double pressure = 0;  // coefficient by coefficient not below the mean of its size
    for (const double p : states[j].pressure) pressure += std::abs(p) / static_cast<double>(states[j].pressure.size());
    energy += scene::length(problem.mesh, problem.contact[j].first) * pressure * size;
  }
  return energy;
}

std::string uncertified(const Level& level) {
  if (level.certificate.valid) return "";
  const Check worst = level.checks.worst();
  return fmt::format(
      "no certificate on {} cells: {} (worst check: {}, {:.1e} by the scene's scale); try cells of "
      "better shape, or moduli and sizes that differ less",
      level.cells, level.certificate.reason, worst.name, worst.value);
}

/// All levels of one problem are so to the last bit: a contradiction proves that some bound is wrong.
template <int dim> std::string contradiction(const Outcome<dim>& earlier, const Level& level, bool one_problem) {
  const auto [lower, upper] = std::pair(level.bracket.lower, level.bracket.upper);
  const bool crossing = lower > upper;
  if (!crossing && !one_problem) return "";
  if (!crossing && upper >= earlier.lower && lower <= earlier.upper) return "";
  return fmt::format("{} on {} cells{}: a fault of this program; please report it with the scene",
                     crossing ? "the bounds cross" : "the bounds", level.cells,
                     crossing ? "" : " and those before exclude each other");
}

/// Where refinement nests the cones of admissible displacements: by more than what the two certificates added to the
/// energies as computed, and rounding to the solution. That proves no bound wrong, but solvers that went astray.
template <int dim>
std::string risen(const Outcome<dim>& earlier, const scene::Problem<dim>& problem, const Examined<dim>& examined) {
  if (earlier.levels.empty() || !scene::has_quadratic_gaps(problem)) return "";
  const auto own = [](const Level& of) { return std::abs(of.certificate.upper - of.plain.upper); };
  const Level &level = examined.level, &last = earlier.levels.back();
  const double risen = level.certificate.upper - last.certificate.upper, explained = own(level) + own(last);
  if (risen <= explained ||
      risen <= explained + rounding_of_solution(problem, examined.primal.displacement, examined.dual.stress))
    return "";
  return fmt::format(
      "the upper bound rose from {} to {} on {} cells, although those before are admissible, too: the solvers went "
      "astray; the levels before stand",
      last.certificate.upper, level.certificate.upper, level.cells);
}

}  // namespace

template <int dim> int sweeps_of(const scene::Scene<dim>& scene, const scene::Mesh<dim>& mesh) {
  return scene.solve.sweeps ? *scene.solve.sweeps : scene::sweeps_for(scene::common_flatness(scene::flatness(mesh)));
}

template <int dim>
Examined<dim> examine(const scene::Scene<dim>& scene, const Meshed<dim>& meshed, const std::vector<Level>& earlier,
                      const Clock& run_clock, const Observer<dim>& observer, const primal::Engine<dim>& engine) {
  const Clock clock;
  const auto& problem = meshed.problem;
  if (observer.stage && !meshed.step)
    observer.stage(fmt::format("displacements and stresses on {} cells", problem.mesh.cells.size()));
  Examined<dim> examined = solve_both(meshed, scene, run_clock, engine);
  if (!examined.unsolved.empty()) return examined;

  if (observer.stage) observer.stage("estimate");
  const Clock estimating;
  auto& displacement = examined.primal.displacement;
  auto& stress = examined.dual.stress;
  Level& level = examined.level;
  const Clock certifying;
  examined.unstrained = earlier.empty() && is_unstrained(problem, displacement);
  if (examined.unstrained) {
    Pair<dim> rest = at_rest(problem, displacement);
    displacement = std::move(rest.displacement);
    stress = std::move(rest.stress);
    level.certificate = rest.certificate;
  } else {
    const Digits digits = problem.mesh.cells.size() > few_cells ? Digits::enough : Digits::extended;
    level.certificate = certify(problem, displacement, stress, digits);
  }
  level.seconds.certify = certifying.seconds();

  examined.indicator = indicator(problem, displacement, stress);
  level.cells = static_cast<int>(problem.mesh.cells.size());
  level.primal = examined.primal.statistics;
  level.dual = examined.dual.statistics;
  level.friction = meshed.friction;
  level.plain = plain_energies(problem, displacement, stress, examined.indicator);
  const Certificate& sure = level.certificate;
  level.bracket =
      sure.valid ? bracket(sure.lower, sure.upper, sure.strain_energy, sure.contact)
                 : bracket(level.plain.lower, level.plain.upper, level.plain.strain,
                           std::accumulate(examined.indicator.contact.begin(), examined.indicator.contact.end(), 0.0));
  level.checks = admissibility(problem, displacement, stress);
  level.checks.gap_identity = level.plain.gap_identity;
  // The data were fixed on the first mesh, and so was what that did to the energy.
  if (!earlier.empty()) {
    level.oscillation_energy = earlier.front().oscillation_energy;
    level.oscillation_part = earlier.front().oscillation_part;
  } else if (!meshed.changed) {
    examined.effect = data_effect(scene, problem, displacement, stress);
    level.oscillation_energy = examined.effect.energy;
    const auto& shares = examined.effect.facet;
    const auto& most = problem.mesh.boundary[std::max_element(shares.begin(), shares.end()) - shares.begin()];
    if (examined.effect.energy > 0) level.oscillation_part = problem.mesh.parts[most.part];
  }
  level.seconds.mesh = meshed.seconds;
  level.seconds.estimate = estimating.seconds() - level.seconds.certify;
  level.seconds.total = meshed.seconds + clock.seconds() + (meshed.step ? meshed.step->seconds : 0);
  return examined;
}

template <int dim>
Objection objection(const Outcome<dim>& earlier, const scene::Problem<dim>& problem, const Examined<dim>& examined,
                    bool one_problem) {
  const bool first = earlier.levels.empty();
  if (const std::string why = uncertified(examined.level); !why.empty()) return {why, first, !first};
  if (const std::string why = contradiction(earlier, examined.level, one_problem); !why.empty())
    return {why, true, false};
  return {one_problem ? risen(earlier, problem, examined) : "", false, true};
}

#define INSTANTIATE(dim)                                                                                  \
  template struct Examined<dim>;                                                                          \
  template int sweeps_of(const scene::Scene<dim>&, const scene::Mesh<dim>&);                              \
  template Examined<dim> examine(const scene::Scene<dim>&, const Meshed<dim>&, const std::vector<Level>&, \
                                 const Clock&, const Observer<dim>&, const primal::Engine<dim>&);         \
  template Objection objection(const Outcome<dim>&, const scene::Problem<dim>&, const Examined<dim>&, bool);
INSTANTIATE(2)
INSTANTIATE(3)
#undef INSTANTIATE

}  // namespace bracket::bounds
