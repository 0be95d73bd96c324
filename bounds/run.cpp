// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <optional>
#include <stdexcept>
#include <system_error>
#include <thread>

#include "bounds/asked.h"
#include "bounds/bounds.h"
#include "bounds/coulomb.h"
#include "bounds/friction_forces.h"
#include "bounds/level.h"
#include "bounds/resolve_data.h"
#include "bounds/skipped.h"

namespace bracket::bounds {

namespace {

using scene::Status;

/// A run whose last level is new: its bracket is intersected with that of the levels before; where each level is a
/// problem of its own it takes its place. Cannot fail.
template <int dim> Outcome<dim> narrowed(Outcome<dim> outcome, bool one_problem) {
  const Bracket& bracket = outcome.levels.back().bracket;
  if (!one_problem) {
    const double middle = bracket.lower + 0.5 * (bracket.upper - bracket.lower);
    if (outcome.levels.size() > 1) outcome.moved = std::abs(middle - (outcome.lower + outcome.upper) / 2);
    outcome.lower = -std::numeric_limits<double>::infinity();
    outcome.upper = -outcome.lower;
  }
  outcome.lower = std::max(outcome.lower, bracket.lower);
  outcome.upper = std::min(outcome.upper, bracket.upper);
  outcome.relative_error_bound = bracket.relative_error_bound;
  const double width = outcome.upper - outcome.lower, own_width = bracket.upper - bracket.lower;
  if (width < own_width) outcome.relative_error_bound *= std::sqrt(width / own_width);  // an earlier level knew better
  return outcome;
}

/// Nothing is strained but by rounding, and no error can be told relative to that.
template <int dim> Outcome<dim> unstrained(Outcome<dim> outcome) {
  outcome.unstrained = true;
  if (outcome.lower == outcome.upper) return outcome;
  outcome.relative_error_bound = std::numeric_limits<double>::quiet_NaN();
  outcome.levels.back().bracket.relative_error_bound = outcome.relative_error_bound;
  return outcome;
}

/// Nothing is guaranteed any more: the levels stay, to be reported.
template <int dim> Outcome<dim> disowned(Outcome<dim> outcome) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  outcome.guarantee = "none";
  outcome.lower = -infinity;
  outcome.upper = infinity;
  outcome.relative_error_bound = infinity;
  for (QuantityInterval& one : outcome.quantities) {
    one.lower = -infinity;
    one.upper = infinity;
    one.relative_width = std::numeric_limits<double>::quiet_NaN();
    one.target_reached = false;
  }
  return outcome;
}

/// Pressures that are linear on each edge reach less far than those of the displacements, which act at the vertices: a
/// finer mesh may balance what a coarse one cannot.
template <int dim> bool finer_mesh_may_help(const Examined<dim>& examined) {
  return examined.primal.termination == contact::Termination::solved &&
         examined.dual.termination == contact::Termination::no_equilibrium;
}

/// Which budget is spent after `meshes` meshes; empty: none.
std::string spent(const scene::Refine& refine, int meshes, double seconds) {
  if (refine.strategy == scene::Strategy::none) return "the mesh is not refined (strategy \"none\")";
  if (meshes >= refine.max_levels) return fmt::format("max_levels = {}", refine.max_levels);
  if (seconds >= refine.max_seconds) return fmt::format("max_seconds = {:g}", refine.max_seconds);
  return "";
}

/// \param closed empty: nothing is inherited
std::vector<char> inherited(const std::vector<char>& closed, const std::vector<int>& parent) {
  std::vector<char> result;
  if (closed.empty()) return result;
  for (const int facet : parent) result.push_back(facet < 0 ? 0 : closed[facet]);
  return result;
}

/// Of each contact facet of a problem, the nearest one of the same pair on the mesh before, −1: none.
std::vector<int> nearest_contacts(const scene::Problem<2>& before, const scene::Problem<2>& problem) {
  const auto middle = [](const scene::Problem<2>& of, const scene::ContactFacet& pair) {
    const auto [a, b] = scene::positions(of.mesh, of.mesh.boundary[pair.first].vertices);
    return scene::Vector<2>((a + b) / 2);
  };
  std::vector<scene::Vector<2>> old;
  for (const auto& pair : before.contact) old.push_back(middle(before, pair));
  std::vector<int> nearest;
  for (const auto& pair : problem.contact) {
    const scene::Vector<2> x = middle(problem, pair);
    nearest.push_back(-1);
    for (std::size_t j = 0; j < old.size(); ++j)
      if (before.contact[j].pair == pair.pair &&
          (nearest.back() < 0 || (old[j] - x).squaredNorm() < (old[nearest.back()] - x).squaredNorm()))
        nearest.back() = static_cast<int>(j);
  }
  return nearest;
}

/// Whether all levels are one problem. Arcs are another polygon on each mesh, and Coulomb's friction has another bound;
/// data that were changed by hand stay.
template <int dim> bool is_one_problem(const scene::Scene<dim>& scene, const Meshed<dim>& meshed) {
  return !has_coulomb(meshed.problem) && (meshed.changed || scene.curves.empty());
}

/// \param marked cells to refine; empty: all. The contact starts from what it was   \param one_problem as for `old`
template <int dim>
Meshed<dim> finer(const scene::Scene<dim>& scene, const Meshed<dim>& old, const scene::Problem<dim>& problem,
                  std::vector<char> marked, const Examined<dim>& examined, bool one_problem) {
  if (marked.empty()) marked.assign(problem.mesh.cells.size(), 1);
  if constexpr (dim == 2)
    if (!one_problem) {
      scene::Mesh<dim> mesh = scene::finer_mesh(scene, problem, marked);
      mesh.notes = old.notes;
      Meshed<dim> meshed{.problem = balanced(scene::fix_data(scene, std::move(mesh)), scene.solve.degree),
                         .notes = old.notes};
      const std::vector<int> nearest = nearest_contacts(problem, meshed.problem);
      meshed.primal_closed = inherited(examined.primal.closed, nearest);
      meshed.dual_closed = inherited(examined.dual.closed, nearest);
      return meshed;
    }
  auto [refined, cell_parent, contact_parent] = scene::refine(problem, marked);
  return {.problem = std::move(refined),
          .primal_closed = inherited(examined.primal.closed, contact_parent),
          .dual_closed = inherited(examined.dual.closed, contact_parent),
          .changed = old.changed,
          .notes = old.notes};
}

bool is_settled(const Level& level) { return level.friction.steps == 0 || level.friction.settled; }

/// Ends a run that has not reached its target.
/// \param early before any budget was spent
template <int dim>
Outcome<dim> ended(Outcome<dim> outcome, const scene::Refine& refine, const std::vector<Asked<dim>>& asked,
                   const std::string& why, bool early) {
  const Targets wanted = targets(outcome, refine, asked);
  const bool settled = outcome.levels.empty() || is_settled(outcome.levels.back());
  if (outcome.guarantee == "none") {
    outcome.status = Status::not_guaranteed;
    outcome.reason = why;
  } else if (early || !settled || (wanted.any && !wanted.met())) {
    outcome.status = Status::budget;
    outcome.reason =
        fmt::format("{}{}; the guaranteed relative error is {:.3g}", why,
                    settled ? "" : "; the steps of Coulomb's friction did not settle", outcome.relative_error_bound);
    if (refine.target > 0) outcome.reason += fmt::format(", the target {:g}", refine.target);
    for (const QuantityInterval& one : outcome.quantities)
      if (!one.target_reached) outcome.reason += fmt::format("; the target of '{}' is not reached", one.name);
  }
  return outcome;
}

template <int dim> int count_of_cells(const Meshed<dim>& meshed) {
  return static_cast<int>(meshed.problem.mesh.cells.size());
}

/// A run, level by level: problem → {displacement | stress} → certificate, bracket, indicators → marks → problem → …
/// Where the machine does not hold more it ends; the levels so far stand.
/// \param first makes the problem on the first mesh
/// \param engine as run() has it
template <int dim, class First>
Outcome<dim> run_from(const scene::Scene<dim>& scene, const First& first, const Observer<dim>& observer,
                      const primal::Engine<dim>& engine) {
  const Clock clock;
  const contact::BlasThreads threads(blas_threads<dim>());
  const scene::Refine& refine = scene.refine;
  Outcome<dim> outcome;
  std::vector<Asked<dim>> asked;
  std::string size = "the mesh", lacking = "memory";
  const auto end = [&](Outcome<dim> so_far, const std::string& why, bool early) {
    return ended(std::move(so_far), refine, asked, why, early);
  };
  // Whatever fails on the way, what is known stays.
  const auto compute = [&](const std::vector<std::size_t>& which, const Examined<dim>& examined, bool one_problem) {
    if (observer.stage && !which.empty()) observer.stage("quantities");
    for (const std::size_t i : which) {
      outcome.quantities[i] = on_last_level(outcome, scene, asked[i], outcome.quantities[i], examined, one_problem);
      const double seconds = outcome.quantities[i].levels.back().seconds;
      outcome.levels.back().seconds.quantities += seconds;
      outcome.levels.back().seconds.total += seconds;
    }
  };
  const auto complete = [&](const Examined<dim>& examined, bool one_problem) {
    compute(missing(outcome, asked), examined, one_problem);
    if constexpr (dim == 2)
      if (has_coulomb(outcome.problem)) outcome.friction = friction_forces(solved_level(outcome, examined));
  };
  const auto examined_on = [&](Meshed<dim>& on) {
    if constexpr (dim == 2)
      if (has_coulomb(on.problem)) on = with_friction_settled(std::move(on), scene.solve.degree, observer);
    return examine(scene, on, outcome.levels, clock, observer, engine);
  };
  try {
    Meshed<dim> meshed = first();
    size = fmt::format("{} cells", count_of_cells(meshed));
    meshed.problem = balanced(std::move(meshed.problem), scene.solve.degree);
    asked = bounds::asked(scene, meshed.problem);
    for (const Asked<dim>& one : asked) outcome.quantities.push_back(unknown(one));
    outcome.skipped = skipped_stages(scene, meshed.problem);
    meshed.seconds = clock.seconds();
    for (int meshes = 1;; ++meshes) {
      Examined<dim> examined = examined_on(meshed);
      while (outcome.levels.empty() && !observer.stop.stop_requested()) {
        auto finer_first = with_data_resolved(scene, meshed, examined, clock);
        if (!finer_first) break;
        meshed = std::move(*finer_first);
        examined = examined_on(meshed);
      }
      const bool bracketed = examined.unsolved.empty(), one_problem = is_one_problem(scene, meshed);
      if (bracketed) {
        const Objection objected = objection(outcome, meshed.problem, examined, one_problem);
        if (objected.reason.empty() || objected.reported) {
          outcome.levels.push_back(examined.level);  // first: what follows cannot fail
          outcome = narrowed(std::move(outcome), one_problem);
          if (examined.unstrained) outcome = unstrained(std::move(outcome));
          outcome.problem = std::move(meshed.problem);
          outcome.displacement = std::move(examined.primal.displacement);
          outcome.stress = std::move(examined.dual.stress);
          outcome.indicator = std::move(examined.indicator);
        }
        if (!objected.reason.empty())
          return end(objected.guaranteed ? std::move(outcome) : disowned(std::move(outcome)), objected.reason, true);
        outcome.guarantee = has_coulomb(outcome.problem) ? "tresca-step"
                            : outcome.problem.sampled    ? "discretisation"
                                                         : "rounding-safe";
        compute(due(outcome, refine, asked), examined, one_problem);
        const bool done = examined.unstrained || targets(outcome, refine, asked).met();
        if (done) complete(examined, one_problem);
        if (const std::string why = contradiction(outcome.quantities); !why.empty())
          return end(disowned(std::move(outcome)), why, true);
        if (observer.level) observer.level(outcome);
        if (done && !is_settled(outcome.levels.back())) return end(std::move(outcome), "the target is reached", true);
        if (done) return outcome;
      } else if (!finer_mesh_may_help(examined) || refine.strategy == scene::Strategy::none) {
        return end(std::move(outcome), examined.unsolved, true);
      }
      if (observer.stop.stop_requested()) return end(std::move(outcome), "stopped on request", true);
      const auto finished = [&](const std::string& why) {
        if (bracketed) complete(examined, one_problem);
        if (const std::string wrong = contradiction(outcome.quantities); !wrong.empty())
          return end(disowned(std::move(outcome)), wrong, true);
        return end(std::move(outcome), why, false);
      };
      const std::string budget = spent(refine, meshes, clock.seconds());
      if (!budget.empty()) return finished(bracketed ? budget : examined.unsolved + "; " + budget);

      if (observer.stage) observer.stage("refinement");
      const Clock refining;
      size = "more than " + size;
      const auto& last = bracketed ? outcome.problem : meshed.problem;
      std::vector<char> marked;
      if (bracketed && refine.strategy == scene::Strategy::adaptive)
        marked = mark(last, steering(outcome, refine, asked), refine.bulk);
      Meshed<dim> next = finer(scene, meshed, last, std::move(marked), examined, one_problem);
      next.seconds = refining.seconds();
      if (count_of_cells(next) > refine.max_cells) return finished(fmt::format("max_cells = {}", refine.max_cells));
      meshed = std::move(next);
      size = fmt::format("{} cells", count_of_cells(meshed));
    }
  } catch (const scene::Error& error) {
    if (error.status() != Status::budget) throw;
    return end(std::move(outcome), error.what(), true);  // cells at the resolution of the coordinates
  } catch (const std::bad_alloc&) {
  } catch (const std::length_error&) {
  } catch (const std::system_error& error) {
    if (error.code() != std::errc::resource_unavailable_try_again) throw;
    lacking = "memory or number of threads";
  }
  return end(std::move(outcome), fmt::format("the {} did not suffice for {}", lacking, size), true);
}

}  // namespace

template <int dim>
Outcome<dim> run(const scene::Scene<dim>& scene, const Observer<dim>& observer, const primal::Engine<dim>& engine) {
  if (engine && asks_for_quantities(scene))
    throw scene::Error(Status::input,
                       "quantities are not yet computed by several processes: run without --ranks, or leave "
                       "[[quantity]] and zones out");
  const auto first = [&] {
    if (observer.stage) observer.stage("mesh");
    scene::Mesh<dim> mesh = scene::build_mesh(scene);
    const std::vector<std::string> notes = mesh.notes;
    return Meshed<dim>{.problem = scene::fix_data(scene, std::move(mesh)), .notes = notes};
  };
  return run_from(scene, first, observer, engine);
}

template <int dim>
Outcome<dim> run(const scene::Scene<dim>& scene, scene::Problem<dim> problem, const Observer<dim>& observer) {
  scene::check_settings<dim>(scene.refine, scene.solve);
  if (has_coulomb(problem) && scene.refine.strategy != scene::Strategy::none)
    throw scene::Error(
        Status::input,
        "a problem with Coulomb's friction, whose bound is another on each mesh, cannot be refined without "
        "its scene; expected refine.strategy none");
  if (scene.solve.dual == scene::Dual::local && std::ranges::any_of(problem.contact, [](const auto& pair) {
        return has_springs(pair.law) || has_friction(pair.law);
      }))
    throw scene::Error(Status::input,
                       "a problem with springs or friction needs solve.dual = \"hybrid\": stresses built locally know "
                       "neither");
  const auto first = [&] { return Meshed<dim>{.problem = std::move(problem), .changed = true}; };
  return run_from(scene, first, observer, {});
}

#define INSTANTIATE(dim)                                                                                 \
  template struct Outcome<dim>;                                                                          \
  template struct Observer<dim>;                                                                         \
  template Outcome<dim> run(const scene::Scene<dim>&, const Observer<dim>&, const primal::Engine<dim>&); \
  template Outcome<dim> run(const scene::Scene<dim>&, scene::Problem<dim>, const Observer<dim>&);
INSTANTIATE(2)
INSTANTIATE(3)
#undef INSTANTIATE

}  // namespace bracket::bounds
