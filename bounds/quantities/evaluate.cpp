// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/quantities/evaluate.h"

#include <cmath>

#include "contact/clock.h"

namespace bracket::bounds {

namespace {

using scene::Enclosure;

/// s from the level before, by the law of its optimum: where the contact moves it falls like the cube root of the
/// width, else it stays.
Guess carried_over(Guess guess, const Closed& closed, double energy_width, double before) {
  if (before > 0 && energy_width > 0 && guess.moves) guess.s *= std::cbrt(energy_width / before);
  guess.closed = {closed, closed};
  return guess;
}

/// As the guess was made of a real number, and pairs of powers of two, it stays as long as it is the nearest.
double kept(double guess, double found) { return guess / found > 0.7 && guess / found < 1.5 ? guess : found; }

/// The terms of the width that a finer mesh makes smaller, by the quantity's scale: those of the unperturbed fields and
/// of the differences. What the contact's own motion adds to the means only a smaller s does.
template <int dim>
void add_terms(Indicator& sum, const Indicator& energy, const PerturbedPair<dim>& pair, double factor) {
  sum.cell.resize(energy.cell.size(), 0);
  sum.contact.resize(energy.contact.size(), 0);
  const auto add = [&](double& place, double share) {
    place += factor / pair.s * share;
    sum.sum += factor / pair.s * share;
  };
  for (std::size_t c = 0; c < energy.cell.size(); ++c) add(sum.cell[c], energy.cell[c] + pair.of_difference[c]);
  for (std::size_t j = 0; j < energy.contact.size(); ++j)
    add(sum.contact[j], 2 * energy.contact[j] + pair.of_contact_difference[j]);
}

/// Takes a bound of J from above (`sign` 1) or of −J (−1) as an end of the quantity's interval.
template <int dim>
void take(const FunctionalBound& bound, double sign, const Functionals<dim>& asked, QuantityLevel& level) {
  if (!bound.valid) {
    if (level.reason.empty()) level.reason = bound.reason;
    return;
  }
  const Enclosure offset = sign > 0 ? asked.offset_above : asked.offset_below;
  const Enclosure end = (Enclosure(sign) * Enclosure(bound.above) + offset) / asked.scale;
  if (!std::isfinite(magnitude(end))) {
    if (level.reason.empty()) level.reason = "the interval could not be enclosed: numbers too large or too small";
    return;
  }
  (sign > 0 ? level.upper : level.lower) = sign > 0 ? upper(end) : lower(end);
}

/// The best of the bounds of one side, from the first power of two that is solvable down to where they get worse.
template <int dim>
FunctionalBound best_one_sided(const SolvedLevel<dim>& level, const std::shared_ptr<const scene::Perturbation<dim>>& by,
                               double sign, Guess& guess) {
  FunctionalBound best;
  for (double s = guess.s > 0 ? 8 * guess.s : 1; s > smallest_factor; s /= 2) {
    const double f = sign * power_of_two(s);
    const FunctionalBound bound = one_sided_bound(level.problem, level.solvers, by, f);
    if (!bound.valid) {
      if (best.valid) break;
      best.reason = bound.reason;
      continue;
    }
    if (best.valid && !(bound.above < best.above)) break;
    best = bound;
    guess.s = s;
  }
  return best;
}

/// The energy's own sums, or the bracket of L(u) turned.
template <int dim> EvaluatedQuantity<dim> of_free_energy(const SolvedLevel<dim>& level, FreeEnergy how) {
  EvaluatedQuantity<dim> result;
  const bool loads = how == FreeEnergy::of_loads;
  result.level.lower = std::max(0.0, loads ? -level.upper : level.lower);
  result.level.upper = loads ? -level.lower : level.upper;
  result.indicator = level.indicator;
  return result;
}

/// One end alone, as nothing bounds the other.
template <int dim>
EvaluatedQuantity<dim> one_sided(const SolvedLevel<dim>& level, const Functionals<dim>& asked,
                                 const Undetermined& undetermined, Learned learned) {
  EvaluatedQuantity<dim> result;
  for (const int side : {0, 1}) {
    if (side == 0 ? undetermined.below : undetermined.above) continue;
    const double sign = side == 0 ? -1 : 1;
    Guess& guess = learned.guess[side];
    take(best_one_sided(level, side == 0 ? asked.below : asked.above, sign, guess), sign, asked, result.level);
    result.level.s = guess.s;
  }
  result.learned = std::move(learned);
  return result;
}

/// The bounds of J (place 1) and −J (place 0) by a pair. Where s takes just off what there is of a load, nothing may be
/// left to hold what rounding leaves of it; then half of s does.
template <int dim>
std::array<FunctionalBound, 2> bounds_by(const SolvedLevel<dim>& level,
                                         const std::shared_ptr<const scene::Perturbation<dim>>& by,
                                         const PerturbedPair<dim>& pair, const std::vector<int>& signs) {
  std::array<FunctionalBound, 2> bounds;
  const auto fill = [&](const PerturbedPair<dim>& with) {
    bool all = true;
    for (const int sign : signs) {
      FunctionalBound& bound = bounds[sign > 0];
      if (!bound.valid) bound = functional_bound(level.problem, by, with, sign);
      all = all && bound.valid;
    }
    return all;
  };
  if (fill(pair)) return bounds;
  const Attempt<dim> half = solve_pair(level.problem, level.solvers, by, pair.s / 2, pair.closed);
  if (half.pair) fill(*half.pair);
  return bounds;
}

/// Both ends, from the pairs with the least width.
template <int dim>
EvaluatedQuantity<dim> two_sided(const SolvedLevel<dim>& level, const Functionals<dim>& asked, Learned learned) {
  constexpr int pairs_at_first = 12, pairs_later = 2;
  EvaluatedQuantity<dim> result;
  double of_means = level.indicator.sum;  // of the unperturbed fields
  for (const double share : level.indicator.contact) of_means += share;
  of_means = std::max(of_means, level.upper - level.lower);
  const bool one = asked.below == asked.above;
  const double share = (one ? 1 : 0.5) / static_cast<double>(asked.scale.middle);
  for (int side = 0; side < (one ? 1 : 2); ++side) {
    const auto& by = side == 0 ? asked.below : asked.above;
    Guess& guess = learned.guess[side];
    const Attempt<dim> best = best_pair(level.problem, level.solvers, by, guess, of_means,
                                        learned.energy_width > 0 ? pairs_later : pairs_at_first);
    if (!best.pair) {
      if (result.level.reason.empty()) result.level.reason = best.reason;
      continue;
    }
    guess.s = guess.s > 0 ? kept(guess.s, best.pair->s) : best.pair->s;
    guess.moves = best.pair->of_means > 1.05 * of_means;
    result.level.s = best.pair->s;
    add_terms(result.indicator, level.indicator, *best.pair, share);
    result.plain_width += share * best.pair->width;
    const std::vector<int> signs = one ? std::vector<int>{-1, 1} : std::vector<int>{side == 0 ? -1 : 1};
    const auto bounds = bounds_by(level, by, *best.pair, signs);
    for (const int sign : signs) take(bounds[sign > 0], sign, asked, result.level);
  }
  result.learned = std::move(learned);
  return result;
}

template <int dim>
EvaluatedQuantity<dim> finished(EvaluatedQuantity<dim> result, const SolvedLevel<dim>& level, const Clock& clock) {
  result.learned.energy_width = level.upper - level.lower;
  result.level.cells = static_cast<int>(level.problem.mesh.cells.size());
  result.level.seconds = clock.seconds();
  return result;
}

}  // namespace

template <int dim>
EvaluatedQuantity<dim> evaluate(const Functionals<dim>& asked, const SolvedLevel<dim>& level,
                                const Undetermined& undetermined, Learned learned) {
  const Clock clock;
  const double energy_width = level.upper - level.lower;
  for (Guess& guess : learned.guess) guess = carried_over(guess, level.closed, energy_width, learned.energy_width);
  EvaluatedQuantity<dim> result = undetermined.below || undetermined.above
                                      ? one_sided(level, asked, undetermined, std::move(learned))
                                      : two_sided(level, asked, std::move(learned));
  result.weighted = asked.weighted;
  if (asked.non_negative && result.level.lower < 0) result.level.lower = 0;
  return finished(std::move(result), level, clock);
}

template <int dim>
EvaluatedQuantity<dim> evaluate(const scene::Scene<dim>& scene, const scene::Quantity<dim>& quantity,
                                const SolvedLevel<dim>& level, const Undetermined& undetermined, Learned learned) {
  const Clock clock;
  const FreeEnergy free = quantity.kind == scene::QuantityKind::energy ? free_energy(level.problem) : FreeEnergy::none;
  if (free != FreeEnergy::none) return finished(of_free_energy(level, free), level, clock);
  return evaluate(functionals(scene, level.problem, quantity), level, undetermined, std::move(learned));
}

#define INSTANTIATE(dim)                                                                                          \
  template EvaluatedQuantity<dim> evaluate(const scene::Scene<dim>&, const scene::Quantity<dim>&,                 \
                                           const SolvedLevel<dim>&, const Undetermined&, Learned);                \
  template EvaluatedQuantity<dim> evaluate(const Functionals<dim>&, const SolvedLevel<dim>&, const Undetermined&, \
                                           Learned);
INSTANTIATE(2)
INSTANTIATE(3)
#undef INSTANTIATE

}  // namespace bracket::bounds
