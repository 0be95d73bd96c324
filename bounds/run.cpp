// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>
#include <future>
#include <limits>
#include <new>
#include <stdexcept>
#include <system_error>

#include "bounds/bounds.h"
#include "bounds/particular.h"
#include "bounds/skipped.h"
#include "bounds/unstrained.h"
#include "contact/clock.h"
#include "dual/dual.h"
#include "primal/primal.h"

namespace bracket::bounds {

namespace {

using scene::Status;

/// A mesh to be solved on, and what is expected of its contact.
template <int dim> struct Step {
  scene::Problem<dim> problem;
  std::vector<char> primal_closed = {}, dual_closed = {};  ///< empty: unknown
  double seconds = 0;                                      ///< that it took to make
  bool changed = false;                                    ///< the data are no more those of the scene
};

/// Both formulations on one mesh.
template <int dim> struct Solved {
  primal::Result<dim> primal;
  dual::Result<dim> dual;
  Seconds seconds;
};

/// \param run_clock since the run began: Uzawa's iteration, alone in being slow, ends when the time is spent
template <int dim>
dual::Result<dim> solve_stresses(const Step<dim>& step, const scene::Scene<dim>& scene, const Clock& run_clock) {
  if (scene.solve.dual == "uzawa")
    return dual::uzawa(step.problem, particular_stress(step.problem),
                       [&] { return run_clock.seconds() >= scene.refine.max_seconds; });
  return dual::solve(step.problem, step.dual_closed);
}

/// The two formulations side by side; each is mostly serial, so that two cores are well used.
template <int dim>
Solved<dim> solve_both(const Step<dim>& step, const scene::Scene<dim>& scene, const Clock& run_clock) {
  const Clock clock;
  contact::reserve_blas_memory(2);
  Solved<dim> solved;
  auto stresses = std::async(std::launch::async, [&] {
    solved.dual = solve_stresses(step, scene, run_clock);
    solved.seconds.dual = clock.seconds();
  });
  solved.primal = primal::solve(step.problem, scene.solve.degree, step.primal_closed);
  solved.seconds.primal = clock.seconds();
  stresses.get();
  return solved;
}

template <int dim> Level describe(const Step<dim>& step, const Solved<dim>& solved) {
  Level level;
  level.cells = static_cast<int>(step.problem.mesh.cells.size());
  level.primal_dofs = solved.primal.unknowns;
  level.dual_dofs = solved.dual.unknowns;
  level.contact_rows = solved.primal.rows;
  level.contact_active = solved.primal.active_rows;
  level.contact_iterations = solved.primal.iterations;
  level.dual_contact_rows = solved.dual.rows;
  level.dual_contact_active = solved.dual.active_rows;
  level.dual_contact_iterations = solved.dual.iterations;
  level.primal_imbalance = solved.primal.imbalance;
  level.dual_imbalance = solved.dual.imbalance;
  level.primal_assemble = solved.primal.assemble;
  level.dual_assemble = solved.dual.assemble;
  level.primal_phases = solved.primal.seconds;
  level.dual_phases = solved.dual.seconds;
  level.seconds = solved.seconds;
  level.seconds.mesh = step.seconds;
  return level;
}

/// Where nothing is strained λ = 0 is the best stress and, if it is admissible, a translation of all bodies alike a
/// displacement without rounding: none, or the one that some vertex is held by.
template <int dim> void set_at_rest(const scene::Problem<dim>& problem, Solved<dim>& solved) {
  solved.dual.stress = no_stress(problem.mesh);
  Certificate best = certify(problem, solved.primal.displacement, solved.dual.stress);
  std::vector<scene::Vector<dim>> translations = {scene::Vector<dim>::Zero()};
  for (const auto& facet : problem.facets)
    if (facet.support == scene::Support::fixed && translations.size() == 1)
      translations.push_back(facet.displacement[0]);
  for (const auto& translation : translations) {
    const auto moved = translated(problem.mesh, solved.primal.displacement.degree, translation);
    const Certificate other = certify(problem, moved, solved.dual.stress);
    if (!other.valid || (best.valid && best.upper < other.upper)) continue;
    best = other;
    solved.primal.displacement = moved;
  }
}

/// Bracket and checks of a solved level. The data were fixed on the first mesh, and so was what that did to the energy.
template <int dim>
Level estimate(const scene::Scene<dim>& scene, const Step<dim>& step, const Solved<dim>& solved,
               const Indicator& shares, const std::vector<Level>& earlier) {
  const auto& problem = step.problem;
  const auto& displacement = solved.primal.displacement;
  const auto& stress = solved.dual.stress;
  Level level = describe(step, solved);
  const Clock clock;
  level.certificate = certify(problem, displacement, stress);
  level.seconds.certify = clock.seconds();
  level.plain = plain_energies(problem, displacement, stress, shares);
  const Certificate& sure = level.certificate;
  level.bracket = sure.valid ? bracket(sure.lower, sure.upper, sure.strain_energy, shares)
                             : bracket(level.plain.lower, level.plain.upper, level.plain.strain, shares);
  level.checks = admissibility(problem, displacement, stress);
  level.checks.gap_identity = level.plain.gap_identity;
  if (!earlier.empty())
    level.oscillation_energy = earlier.front().oscillation_energy;
  else if (!step.changed)
    level.oscillation_energy = oscillation_energy(scene, problem, displacement, stress);
  return level;
}

/// Why a level has no bounds; empty: it has.
std::string uncertified(const Level& level) {
  if (level.certificate.valid) return "";
  const Check worst = level.checks.worst();
  return fmt::format(
      "no certificate on {} cells: {} (worst check: {}, {:.1e} by the scene's scale); try cells of "
      "better shape, or moduli and sizes that differ less",
      level.cells, level.certificate.reason, worst.name, worst.value);
}

/// What a level's bounds contradict, themselves or those of earlier levels, which are of the same problem to the last
/// bit; empty: nothing. A contradiction proves that some bound is wrong.
template <int dim> std::string contradiction(const Outcome<dim>& earlier, const Level& level) {
  const auto [lower, upper] = std::pair(level.bracket.lower, level.bracket.upper);
  const bool crossing = lower > upper;
  if (!crossing && upper >= earlier.lower && lower <= earlier.upper) return "";
  return fmt::format("{} on {} cells{}: a fault of this program; please report it with the scene",
                     crossing ? "the bounds cross" : "the bounds", level.cells,
                     crossing ? "" : " and those before exclude each other");
}

/// What some units in the last place of displacements and gaps do to L(u_h): near its minimum to second order in the
/// bodies, to first order across the contact.
template <int dim> double rounding_of_solution(const scene::Problem<dim>& problem, const Solved<dim>& solved) {
  double largest = 0;
  for (const auto& u : solved.primal.displacement.vertex) largest = std::max(largest, u.norm());
  for (const auto& pair : problem.contact)
    for (const double gap : pair.upper) largest = std::max(largest, std::abs(gap));
  const double size = 8 * std::numeric_limits<double>::epsilon() * largest;
  double energy = energy_of_noise(problem, size);
  const auto states = contact_state(problem, solved.primal.displacement, solved.dual.stress);
  for (std::size_t j = 0; j < states.size(); ++j) {
    const auto& [p0, p1] = states[j].pressure;
    energy += scene::length(problem.mesh, problem.contact[j].first) * (std::abs(p0) + std::abs(p1)) / 2 * size;
  }
  return energy;
}

/// How the upper bound rose although the displacement spaces are nested: by more than what the two certificates added
/// to the energies as computed, and rounding to the solution. That proves no bound wrong, but solvers that went astray.
/// Empty: it did not.
template <int dim>
std::string risen(const Outcome<dim>& earlier, const Level& level, const scene::Problem<dim>& problem,
                  const Solved<dim>& solved) {
  if (earlier.levels.empty()) return "";
  const auto own = [](const Level& of) { return std::abs(of.certificate.upper - of.plain.upper); };
  const Level& last = earlier.levels.back();
  const double risen = level.certificate.upper - last.certificate.upper;
  if (risen <= own(level) + own(last) || risen <= own(level) + own(last) + rounding_of_solution(problem, solved))
    return "";
  return fmt::format(
      "the upper bound rose from {} to {} on {} cells, although the spaces are nested: the solvers went "
      "astray; the levels before stand",
      last.certificate.upper, level.certificate.upper, level.cells);
}

/// Makes a level the last of the run. Its bracket is intersected with that of the levels before.
template <int dim>
void append(Outcome<dim>& outcome, const Level& level, Step<dim>& step, Solved<dim>& solved, Indicator shares) {
  const Bracket& bracket = level.bracket;
  outcome.levels.push_back(level);  // first: what follows cannot fail
  outcome.lower = std::max(outcome.lower, bracket.lower);
  outcome.upper = std::min(outcome.upper, bracket.upper);
  outcome.relative_error_bound = bracket.relative_error_bound;
  const double width = outcome.upper - outcome.lower, own_width = bracket.upper - bracket.lower;
  if (width < own_width) outcome.relative_error_bound *= std::sqrt(width / own_width);  // an earlier level knew better
  outcome.problem = std::move(step.problem);
  outcome.displacement = std::move(solved.primal.displacement);
  outcome.stress = std::move(solved.dual.stress);
  outcome.indicator = std::move(shares);
}

/// Takes back what was guaranteed: the levels stay, to be reported.
template <int dim> void disown(Outcome<dim>& outcome) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  outcome.guarantee = "none";
  outcome.lower = -infinity;
  outcome.upper = infinity;
  outcome.relative_error_bound = infinity;
}

template <int dim> bool reached(const Outcome<dim>& outcome, double target) {
  return target > 0 && outcome.relative_error_bound <= target;
}

/// Why there is no bracket on a mesh; empty: there is one.
template <int dim> std::string unsolved(const Solved<dim>& solved) {
  return solved.primal.reason.empty() ? solved.dual.reason : solved.primal.reason;
}

/// Pressures that are linear on each edge reach less far than those of the displacements, which act at the vertices: a
/// finer mesh may balance what a coarse one cannot.
template <int dim> bool finer_mesh_may_help(const Solved<dim>& solved) {
  return solved.primal.outcome == contact::Outcome::solved && solved.dual.outcome == contact::Outcome::no_equilibrium;
}

/// Which budget is spent after `meshes` meshes; empty: none.
std::string spent(const scene::Refine& refine, int meshes, double seconds) {
  if (refine.strategy == "none") return "the mesh is not refined (strategy \"none\")";
  if (meshes >= refine.max_levels) return fmt::format("max_levels = {}", refine.max_levels);
  if (seconds >= refine.max_seconds) return fmt::format("max_seconds = {:g}", refine.max_seconds);
  return "";
}

std::vector<char> inherited(const std::vector<char>& closed, const std::vector<int>& parent) {
  std::vector<char> result;
  for (const int facet : parent) result.push_back(closed[facet]);
  return result;
}

/// \param marked cells to refine; the contact starts from what it was
template <int dim>
Step<dim> finer(const scene::Problem<dim>& problem, const std::vector<char>& marked, const Solved<dim>& solved) {
  auto [refined, cell_parent, contact_parent] = scene::refine(problem, marked);
  return {std::move(refined), inherited(solved.primal.closed, contact_parent),
          inherited(solved.dual.closed, contact_parent)};
}

/// Ends a run that has not reached its target.
/// \param early before any budget was spent
template <int dim>
Outcome<dim> ended(Outcome<dim> outcome, const scene::Refine& refine, const std::string& why, bool early) {
  if (outcome.guarantee == "none") {
    outcome.status = Status::not_guaranteed;
    outcome.reason = why;
  } else if (early || refine.target > 0) {
    outcome.status = Status::budget;
    outcome.reason = fmt::format("{}; the guaranteed relative error is {:.3g}", why, outcome.relative_error_bound);
    if (refine.target > 0) outcome.reason += fmt::format(", the target {:g}", refine.target);
  }
  return outcome;
}

/// A run from its first mesh on. \param clock since the run began
/// \param outcome that of the levels so far, as each is done   \param size of what the memory has to hold now
template <int dim>
Outcome<dim> run_from(const scene::Scene<dim>& scene, Step<dim> step, Clock clock, const Observer<dim>& observer,
                      Outcome<dim>& outcome, std::string& size) {
  const auto tell = [&](const std::string& stage) {
    if (observer.stage) observer.stage(stage);
  };
  const contact::BlasThreads one_thread(1);  // each of the two formulations has a thread of its own
  const scene::Refine& refine = scene.refine;
  const Clock run_clock = clock;
  size = fmt::format("{} cells", step.problem.mesh.cells.size());
  step.problem = balanced(std::move(step.problem), scene.solve.degree);
  outcome.skipped = skipped_stages(scene, step.problem);
  step.seconds = clock.seconds();

  for (int meshes = 1;; ++meshes) {
    tell(fmt::format("displacements and stresses on {} cells", step.problem.mesh.cells.size()));
    Solved<dim> solved = solve_both(step, scene, run_clock);
    std::string why = unsolved(solved);
    const bool bracketed = why.empty();
    if (bracketed) {
      tell("estimate");
      const Clock estimate_clock;
      const bool unstrained = outcome.levels.empty() && is_unstrained(step.problem, solved.primal.displacement);
      if (unstrained) set_at_rest(step.problem, solved);
      Indicator shares = indicator(step.problem, solved.primal.displacement, solved.dual.stress);
      Level level = estimate(scene, step, solved, shares, outcome.levels);
      level.seconds.estimate = estimate_clock.seconds() - level.seconds.certify;
      level.seconds.total = clock.seconds();
      if (why = uncertified(level); !why.empty()) {
        if (outcome.levels.empty()) append(outcome, level, step, solved, std::move(shares));
        if (outcome.guarantee == "none") disown(outcome);
        return ended(std::move(outcome), refine, why, true);
      }
      if (why = contradiction(outcome, level); !why.empty()) {
        append(outcome, level, step, solved, std::move(shares));
        disown(outcome);
        return ended(std::move(outcome), refine, why, true);
      }
      if (why = risen(outcome, level, step.problem, solved); !why.empty())
        return ended(std::move(outcome), refine, why, true);
      append(outcome, level, step, solved, std::move(shares));
      outcome.guarantee = "rounding-safe";
      if (observer.level) observer.level(outcome);
      if (unstrained || reached(outcome, refine.target)) return std::move(outcome);
    } else if (!finer_mesh_may_help(solved) || refine.strategy == "none") {
      return ended(std::move(outcome), refine, why, true);
    }
    if (observer.stop.stop_requested()) return ended(std::move(outcome), refine, "stopped on request", true);
    const std::string budget = spent(refine, meshes, run_clock.seconds());
    if (!budget.empty()) return ended(std::move(outcome), refine, bracketed ? budget : why + "; " + budget, false);

    tell("refinement");
    size = "more than " + size;
    clock = Clock();
    const scene::Problem<dim>& problem = bracketed ? outcome.problem : step.problem;
    const bool adaptive = bracketed && refine.strategy == "adaptive";
    const auto marked =
        adaptive ? mark(problem, outcome.indicator, refine.bulk) : std::vector<char>(problem.mesh.cells.size(), 1);
    try {
      step = finer(problem, marked, solved);
    } catch (const scene::Error& error) {  // cells at the resolution of the coordinates; the levels so far stand
      return ended(std::move(outcome), refine, error.what(), true);
    }
    step.seconds = clock.seconds();
    size = fmt::format("{} cells", step.problem.mesh.cells.size());
    if (static_cast<int>(step.problem.mesh.cells.size()) > refine.max_cells)
      return ended(std::move(outcome), refine, fmt::format("max_cells = {}", refine.max_cells), false);
  }
}

/// A run that ends where the machine does not hold more; the levels so far stand.
/// \param make its first mesh
template <int dim, class Make>
Outcome<dim> run_within_memory(const scene::Scene<dim>& scene, const Make& make, const Observer<dim>& observer) {
  const Clock clock;
  Outcome<dim> outcome;
  std::string size = "the mesh", missing = "memory";
  try {
    return run_from(scene, make(), clock, observer, outcome, size);
  } catch (const std::bad_alloc&) {
  } catch (const std::length_error&) {
  } catch (const std::system_error& error) {
    if (error.code() != std::errc::resource_unavailable_try_again) throw;
    missing = "memory or number of threads";
  }
  return ended(std::move(outcome), scene.refine, fmt::format("the {} did not suffice for {}", missing, size), true);
}

}  // namespace

template <int dim> Outcome<dim> run(const scene::Scene<dim>& scene, const Observer<dim>& observer) {
  if (observer.stage) observer.stage("mesh");
  const auto make = [&] { return Step<dim>{.problem = scene::fix_data(scene, scene::build_mesh(scene))}; };
  return run_within_memory(scene, make, observer);
}

template <int dim>
Outcome<dim> run(const scene::Scene<dim>& scene, scene::Problem<dim> problem, const Observer<dim>& observer) {
  const auto make = [&] { return Step<dim>{.problem = std::move(problem), .changed = true}; };
  return run_within_memory(scene, make, observer);
}

template struct Outcome<2>;
template struct Observer<2>;
template Outcome<2> run(const scene::Scene<2>&, const Observer<2>&);
template Outcome<2> run(const scene::Scene<2>&, scene::Problem<2>, const Observer<2>&);

}  // namespace bracket::bounds
