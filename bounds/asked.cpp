// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/asked.h"

#include <fmt/format.h>

#include <cmath>

#include "bounds/certificate/open_contact.h"
#include "bounds/certificate/perturbation_alone.h"
#include "bounds/free_motions.h"
#include "bounds/quantities/line.h"
#include "scene/text.h"

namespace bracket::bounds {

namespace {

using scene::QuantityKind;

std::string name_of(const scene::ContactPair<2>& pair) {
  return pair.name.empty() ? pair.first.parts.front() : pair.name;
}

/// One of the stretches of equal length of a contact. \param first on its first mesh: of an arc each polygon has
/// another length
scene::LineStretch zone_stretch(const scene::ContactPair<2>& pair, const scene::Problem<2>& first, int contact,
                                int zone) {
  const double length = open_line(first, contact, name_of(pair), "zones need", pair.where).arc.back();
  return {length * zone / pair.zones, length * (zone + 1) / pair.zones};
}

/// The forces of a contact's zones.
std::vector<Asked<2>> zones(const scene::Scene<2>& scene, const scene::Problem<2>& problem, int contact) {
  const auto& pair = scene.contact[contact];
  std::vector<Asked<2>> result;
  for (int zone = 0; zone < pair.zones; ++zone) {
    scene::Quantity<2> force;
    force.name = fmt::format("zone {} of {}", zone + 1, name_of(pair));
    force.kind = QuantityKind::force;
    force.of = name_of(pair);
    force.stretch = zone_stretch(pair, problem, contact, zone);
    force.where = pair.where;
    result.push_back({std::move(force), contact, zone});
  }
  return result;
}

/// In space no lines, and no stretches of them.
std::vector<Asked<3>> zones(const scene::Scene<3>&, const scene::Problem<3>&, int) { return {}; }

/// One of the motions alone that does it, for people to see. \param rows, limits as for contact::balance()
std::optional<Eigen::VectorXd> simplest(const Eigen::MatrixXd& rows, const contact::Limits& limits,
                                        const Eigen::VectorXd& work, double rounding) {
  for (Eigen::Index m = 0; m < work.size(); ++m) {
    Eigen::VectorXd y = Eigen::VectorXd::Zero(work.size());
    y[m] = work[m] > 0 ? 1 : -1;
    const Eigen::VectorXd along = rows * y;
    const Eigen::VectorXd against = (limits.lower.array() < 0).select(along.cwiseAbs(), along);
    if (std::abs(work[m]) > rounding && against.maxCoeff() <= 1e-12) return y;
  }
  return {};
}

/// Motions y that the supports leave, that open contacts or leave them, G y ≤ 0, and are free of work, eᵀy = 0: the
/// solution may be moved by them, and with it Q by Q(y). By Farkas' lemma there is none with Q(y) > 0 if and only if
/// Gᵀp − τ e = q for some p ≥ 0, τ ≥ 0; with friction, if and only if e + q/τ can be held for some τ.
template <int dim>
Undetermined undetermined(const scene::Problem<dim>& problem,
                          const std::shared_ptr<const scene::Perturbation<dim>>& by) {
  const FreeMotions<dim> all = all_free_motions(problem);
  Undetermined result;
  if (all.motion.empty()) return result;
  const LoadWork own = load_work(problem, all),
                 added = load_work(perturbation_alone(problem, by, problem.carries), all);
  if (added.size == 0) return result;
  const auto [contact, limits, friction] = holding(problem, all);
  Eigen::MatrixXd rows(contact.rows() + 1, contact.cols());
  rows << contact, -own.work.transpose() / std::max(own.size, std::numeric_limits<double>::min());
  contact::Limits all_limits{Eigen::VectorXd(rows.rows()), Eigen::VectorXd(rows.rows())};
  all_limits.lower << limits.lower, 0;
  all_limits.upper << limits.upper, std::numeric_limits<double>::infinity();
  const double terms = std::numeric_limits<double>::epsilon() *
                       (static_cast<double>(problem.mesh.boundary.size() + problem.mesh.cells.size()) + 64);
  const double rounding = terms * added.size;
  // Friction costs energy: a motion free of it is one that loads changed by however little set off.
  const double held = friction ? limits.upper.tail(contact.rows() - dim * problem.contact.size()).sum() : 0;
  const double little = std::max(own.size, held) / added.size * 0x1p-20;
  for (const double sign : {-1.0, 1.0}) {
    const contact::Balance balance = friction ? contact::balance(contact, own.work + sign * little * added.work,
                                                                 terms * (own.size + little * added.size), limits)
                                              : contact::balance(rows, sign * added.work, rounding, all_limits);
    if (balance.possible) continue;
    (sign < 0 ? result.below : result.above) = true;
    const auto [body, motion] =
        most_moved(all, simplest(rows, all_limits, sign * added.work, rounding).value_or(balance.motion));
    result.motion = fmt::format("nothing resists a motion of body '{}', {}, that changes it",
                                problem.mesh.components[body], scene::describe(motion));
  }
  return result;
}

}  // namespace

template <int dim> std::vector<Asked<dim>> asked(const scene::Scene<dim>& scene, const scene::Problem<dim>& problem) {
  std::vector<Asked<dim>> result;
  for (const auto& quantity : scene.quantities) {
    result.push_back({quantity, is_of_contact(quantity) ? pair_named(scene, quantity.of, quantity.where) : -1, -1});
  }
  for (std::size_t i = 0; i < scene.contact.size(); ++i)
    for (auto& zone : zones(scene, problem, static_cast<int>(i))) result.push_back(std::move(zone));
  for (auto& one : result) {
    const bool stores = std::ranges::any_of(
        problem.contact, [](const auto& pair) { return has_springs(pair.law) || has_friction(pair.law); });
    if (one.quantity.kind == QuantityKind::energy && stores)
      scene::fail(scene::Status::input, one.quantity.where,
                  fmt::format("quantity '{}': springs and friction in the contact take energy, too; the strain energy "
                              "of the bodies alone has no bounds here",
                              one.quantity.name));
    if (one.quantity.kind == QuantityKind::energy && free_energy(problem) != FreeEnergy::none) continue;
    const Functionals<dim> functional = functionals(scene, problem, one.quantity);
    if (one.quantity.kind == QuantityKind::energy) continue;  // of no motion
    const Undetermined below = undetermined(problem, functional.below);
    const Undetermined above = functional.above == functional.below ? below : undetermined(problem, functional.above);
    one.undetermined = {below.below, above.above, below.below ? below.motion : above.motion};
    if (one.undetermined.below && one.undetermined.above)
      scene::fail(scene::Status::ill_posed, one.quantity.where,
                  fmt::format("quantity '{}' is not determined: {}", one.quantity.name, one.undetermined.motion));
  }
  return result;
}

template <int dim> QuantityInterval unknown(const Asked<dim>& asked) {
  QuantityInterval interval;
  interval.name = asked.quantity.name;
  interval.kind = asked.quantity.kind;
  interval.contact = asked.contact;
  interval.zone = asked.zone;
  interval.reason = asked.undetermined.motion;
  interval.target_reached = !is_wanting(asked, interval);
  return interval;
}

template <int dim> SolvedLevel<dim> solved_level(const Outcome<dim>& outcome, const Examined<dim>& examined) {
  const Certificate& last = outcome.levels.back().certificate;
  return {outcome.problem, examined.solvers, {examined.primal.closed, examined.dual.closed},
          last.lower,      last.upper,       outcome.indicator};
}

template <int dim>
QuantityInterval on_last_level(const Outcome<dim>& outcome, const scene::Scene<dim>& scene, Asked<dim>& one,
                               QuantityInterval interval, const Examined<dim>& examined, bool one_problem) {
  const Level& last = outcome.levels.back();
  const SolvedLevel<dim> solved = solved_level(outcome, examined);
  if constexpr (dim == 2)
    if (one.zone >= 0)
      one.quantity.stretch =
          zone_stretch(scene.contact[one.contact], scene::first_of(outcome.problem), one.contact, one.zone);
  auto found = evaluate(scene, one.quantity, solved, one.undetermined, one.learned);
  if constexpr (dim == 2)
    if (one.quantity.kind == QuantityKind::force && one.quantity.stretch) {
      // What is open for sure carries little, whatever its weight's ramps reach.
      const auto line = contact_lines(scene::first_of(outcome.problem), one.contact).at(0);
      const auto chosen = on_stretch(outcome.problem, line, *one.quantity.stretch);
      found.level.upper =
          std::min(found.level.upper, force_at_most(outcome.problem, outcome.displacement, last.certificate, chosen));
    }
  one.learned = std::move(found.learned);
  one.indicator = std::move(found.indicator);
  if (!one_problem || interval.levels.empty()) {
    interval.lower = -std::numeric_limits<double>::infinity();
    interval.upper = -interval.lower;
  }
  interval.weighted = found.weighted;
  interval.lower = std::max(interval.lower, found.level.lower);
  interval.upper = std::min(interval.upper, found.level.upper);
  const double width = interval.upper - interval.lower;
  const bool has_zero = interval.lower <= 0 && interval.upper >= 0;
  interval.relative_width = !has_zero && std::isfinite(width)
                                ? width / std::max(std::abs(interval.lower), std::abs(interval.upper))
                                : std::numeric_limits<double>::quiet_NaN();
  interval.reason = one.undetermined.motion.empty() ? found.level.reason : one.undetermined.motion;
  interval.levels.push_back(std::move(found.level));
  interval.target_reached = !is_wanting(one, interval);
  return interval;
}

template <int dim> bool is_wanting(const Asked<dim>& asked, const QuantityInterval& interval) {
  const auto& [target, absolute] = std::pair(asked.quantity.target, asked.quantity.absolute);
  const double width = interval.upper - interval.lower;
  if (interval.levels.empty()) return target > 0 || absolute > 0;
  if (width == 0) return false;
  return (target > 0 && !(interval.relative_width <= target)) || (absolute > 0 && !(width <= absolute));
}

template <int dim>
Targets targets(const Outcome<dim>& outcome, const scene::Refine& refine, const std::vector<Asked<dim>>& asked) {
  Targets result;
  result.any = refine.target > 0;
  result.energy = refine.target == 0 || outcome.relative_error_bound <= refine.target;
  for (std::size_t i = 0; i < asked.size(); ++i) {
    const auto& quantity = asked[i].quantity;
    result.any = result.any || quantity.target > 0 || quantity.absolute > 0;
    result.quantities = result.quantities && !is_wanting(asked[i], outcome.quantities[i]);
  }
  return result;
}

namespace {

/// Whether a quantity was computed on the last level.
template <int dim> bool is_known(const Outcome<dim>& outcome, std::size_t which) {
  return !outcome.quantities[which].levels.empty() &&
         outcome.quantities[which].levels.back().cells == outcome.levels.back().cells;
}

}  // namespace

template <int dim>
std::vector<std::size_t> due(const Outcome<dim>& outcome, const scene::Refine& refine,
                             const std::vector<Asked<dim>>& asked) {
  const bool all = refine.all_levels || outcome.unstrained;
  const bool energy_met = targets(outcome, refine, asked).energy;
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < asked.size(); ++i) {
    if (is_known(outcome, i)) continue;
    const bool never = outcome.quantities[i].levels.empty();
    const double grown =
        never ? 4.0 : static_cast<double>(outcome.levels.back().cells) / outcome.quantities[i].levels.back().cells;
    const bool awaited = energy_met && !never && is_wanting(asked[i], outcome.quantities[i]);
    if (all || asked[i].quantity.name == refine.goal || grown >= (awaited ? 2 : 4)) result.push_back(i);
  }
  return result;
}

template <int dim> std::vector<std::size_t> missing(const Outcome<dim>& outcome, const std::vector<Asked<dim>>& asked) {
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < asked.size(); ++i)
    if (!is_known(outcome, i)) result.push_back(i);
  return result;
}

template <int dim>
const Indicator& steering(const Outcome<dim>& outcome, const scene::Refine& refine,
                          const std::vector<Asked<dim>>& asked) {
  for (const auto& one : asked)
    if (!refine.goal.empty() && one.quantity.name == refine.goal && one.indicator.sum > 0 &&
        one.indicator.cell.size() == outcome.indicator.cell.size())
      return one.indicator;
  return outcome.indicator;
}

std::string contradiction(const std::vector<QuantityInterval>& quantities) {
  for (const QuantityInterval& one : quantities)
    if (one.lower > one.upper)
      return fmt::format(
          "the bounds of quantity '{}' exclude each other: a fault of this program; please report it with "
          "the scene",
          one.name);
  return "";
}

#define INSTANTIATE(dim)                                                                                            \
  template struct Asked<dim>;                                                                                       \
  template std::vector<Asked<dim>> asked(const scene::Scene<dim>&, const scene::Problem<dim>&);                     \
  template QuantityInterval unknown(const Asked<dim>&);                                                             \
  template SolvedLevel<dim> solved_level(const Outcome<dim>&, const Examined<dim>&);                                \
  template QuantityInterval on_last_level(const Outcome<dim>&, const scene::Scene<dim>&, Asked<dim>&,               \
                                          QuantityInterval, const Examined<dim>&, bool);                            \
  template Targets targets(const Outcome<dim>&, const scene::Refine&, const std::vector<Asked<dim>>&);              \
  template std::vector<std::size_t> due(const Outcome<dim>&, const scene::Refine&, const std::vector<Asked<dim>>&); \
  template std::vector<std::size_t> missing(const Outcome<dim>&, const std::vector<Asked<dim>>&);                   \
  template const Indicator& steering(const Outcome<dim>&, const scene::Refine&, const std::vector<Asked<dim>>&);    \
  template bool is_wanting(const Asked<dim>&, const QuantityInterval&);
INSTANTIATE(2)
INSTANTIATE(3)
#undef INSTANTIATE

}  // namespace bracket::bounds
