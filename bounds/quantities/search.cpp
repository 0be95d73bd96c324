// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/quantities/search.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bracket::bounds {

namespace {

/// Where (a + b s² + c s³)/s is least: the a of the unperturbed fields, what the differences add, and what a moving
/// contact adds to the means, both by what they are at s.
double predicted(double a, double of_means, double of_differences, double s) {
  const double b = of_differences / (s * s), c = std::max(0.0, of_means - a) / (s * s * s);
  if (!(a > 0)) return s;
  double low = 0, high = std::numeric_limits<double>::infinity();  // of −a/s² + b + 2 c s, which grows
  double at = s;
  for (int step = 0; step < 100; ++step) {
    const double slope = -a / (at * at) + b + 2 * c * at;
    (slope < 0 ? low : high) = at;
    const double next = std::isinf(high) ? 2 * at : low == 0 ? at / 2 : std::sqrt(low * high);
    if (high / low < 1.01) break;
    at = next;
  }
  return at;
}

}  // namespace

double power_of_two(double x) { return std::exp2(std::round(std::log2(x))); }

template <int dim>
Attempt<dim> best_pair(const scene::Problem<dim>& problem, const Solvers<dim>& solvers,
                       const std::shared_ptr<const scene::Perturbation<dim>>& by, const Guess& guess, double a,
                       int most) {
  double next = guess.s == 0 ? 1 : power_of_two(guess.s), too_large = std::numeric_limits<double>::infinity();
  std::array<Closed, 2> closed = guess.closed;
  // What the energies' certificate shows of rounding is in the interval, too. Perturbations that dwarf the problem
  // leave nothing of it in double precision.
  constexpr double strongest = 1024;
  const auto expected = [a](const PerturbedPair<dim>& pair) {
    if (pair.strength > 2 * strongest) return std::numeric_limits<double>::infinity();
    return (std::max(a, pair.of_means) + pair.of_differences + pair.rounding) / pair.s;
  };
  std::vector<double> seen;
  Attempt<dim> best;
  for (int tried = 0; tried < most;) {
    if (next < smallest_factor) break;
    Attempt<dim> attempt = solve_pair(problem, solvers, by, next, closed);
    if (!attempt.pair) {
      too_large = next;
      next /= best.pair ? 2 : 8;
      if (!best.pair) best.reason = attempt.reason;
      if (best.pair && next <= best.pair->s) break;
      continue;
    }
    ++tried;
    const PerturbedPair<dim>& pair = *attempt.pair;
    const double most_of_s = pair.strength > 0 ? next * strongest / pair.strength : next * strongest;
    const double better =
        power_of_two(std::min(most_of_s, predicted(a, pair.of_means, pair.of_differences + pair.rounding, next)));
    if (!best.pair || expected(pair) < expected(*best.pair)) best = std::move(attempt);
    seen.push_back(next);
    closed = best.pair->closed;
    next = std::min(better, too_large / 2);
    if (std::ranges::count(seen, next) > 0) break;
  }
  return best;
}

template Attempt<2> best_pair(const scene::Problem<2>&, const Solvers<2>&,
                              const std::shared_ptr<const scene::Perturbation<2>>&, const Guess&, double, int);
template Attempt<3> best_pair(const scene::Problem<3>&, const Solvers<3>&,
                              const std::shared_ptr<const scene::Perturbation<3>>&, const Guess&, double, int);

}  // namespace bracket::bounds
