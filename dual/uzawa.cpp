// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "dual/uzawa.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "contact/clock.h"

namespace bracket::dual {

namespace {

constexpr double tolerance = 1e-9;  // of the stress, by its own size
constexpr int most_iterations = 1000000;
constexpr int interval = 50;  // of iterations between stopping tests

double norm(const Parameters& parameters) {
  double sum = 0;
  for (const ModeVector<1>& s : parameters) sum += s.squaredNorm();
  return std::sqrt(sum);
}

double distance(const Parameters& a, const Parameters& b) {
  double sum = 0;
  for (std::size_t c = 0; c < a.size(); ++c) sum += (a[c] - b[c]).squaredNorm();
  return std::sqrt(sum);
}

/// The size of the stress λ̄ + τ, as far as block elements see it.
double stress_size(const UzawaSystem& system, Parameters parameters) {
  for (std::size_t c = 0; c < parameters.size(); ++c) parameters[c] += system.cells[c].linear;
  return norm(parameters);
}

/// The iteration converges by a factor q < 1 a step in the end: what is left of the way is the last change times
/// q / (1 − q). \param change in one step   \param before the same, `interval` steps ago
double error_estimate(double change, double before) {
  if (change == 0) return 0;
  const double q = std::pow(change / before, 1.0 / interval);
  return q < 1 ? change * q / (1 - q) : std::numeric_limits<double>::infinity();
}

struct Iterated {
  Eigen::VectorXd multipliers;
  Parameters parameters;
  int iterations = 0;
  bool out_of_time = false;
  double error = std::numeric_limits<double>::infinity();  ///< estimated, by the size of the stress
};

/// Iterates until the stress is known, and the constraints met, to `tolerance` or as well as rounding lets it. Where no
/// stress meets them the parameters converge and the multipliers do not.
Iterated iterate(const UzawaSystem& system, const std::function<bool()>& time_is_spent) {
  const double step = uzawa_step(system);
  Iterated state;
  state.multipliers = Eigen::VectorXd::Zero(system.scale.size());
  state.parameters = parameters(system, state.multipliers);
  const double rounding = 1e-14 * norm(state.parameters);
  double before = 0;  // none: no estimate yet
  while (state.error > tolerance && state.iterations < most_iterations && !state.out_of_time) {
    const Eigen::VectorXd next = next_multipliers(system, state.multipliers, state.parameters, step);
    const Eigen::VectorXd last = std::exchange(state.multipliers, next);
    const Parameters old = std::exchange(state.parameters, parameters(system, next));
    ++state.iterations;
    if (state.iterations % interval != 0) continue;
    const double change = distance(state.parameters, old), violation = (next - last).norm() / step;
    const double error = std::max(error_estimate(change, before), violation);
    state.error = error > rounding ? error / stress_size(system, state.parameters) : 0;
    before = change;
    state.out_of_time = time_is_spent && time_is_spent();
  }
  return state;
}

template <int dim>
scene::Stress<dim> recover(const std::vector<Cell<1>>& cells, scene::Stress<dim> stress, const Parameters& parameters) {
  for (std::size_t c = 0; c < parameters.size(); ++c) {
    const Corners own = block_stress<1>(cells[c].piola, cells[c].compliance.matrixU().solve(parameters[c]));
    for (int i = 0; i < 9; ++i) stress.cell[c][i] += own[i];
  }
  return stress;
}

}  // namespace

template <int dim>
Result<dim> uzawa(const scene::Problem<dim>& problem, const scene::Stress<dim>& particular,
                  const std::function<bool()>& time_is_spent) {
  const Clock assembling;
  Result<dim> result;
  contact::Statistics& statistics = result.statistics;
  if (std::ranges::any_of(problem.contact, [](const scene::ContactFacet& pair) {
        return pair.law.two_sided || has_springs(pair.law) || has_friction(pair.law);
      }))
    throw std::invalid_argument("dual::uzawa: it knows frictionless contact only");
  const Layout layout = lay_out(problem, 1);
  const std::vector<Cell<1>> cells = make_cells<1>(problem, layout);
  const UzawaSystem system = uzawa_system(problem, layout, cells, particular);
  statistics.seconds.assemble = assembling.seconds();
  const Clock iterating;
  const Iterated state = iterate(system, time_is_spent);
  statistics.seconds.contact = iterating.seconds();
  statistics.unknowns = static_cast<int>(system.scale.size());
  statistics.rows = static_cast<int>(system.openings.size());
  statistics.iterations = state.iterations;
  result.closed.assign(problem.contact.size(), 0);
  for (int i = 0; i < statistics.rows; ++i)
    if (state.multipliers[system.openings[i].first] == 0) {
      result.closed[i / 2] = 1;
      ++statistics.active_rows;
    }
  if (state.error > tolerance) {
    result.termination = contact::Termination::not_converged;
    result.reason = state.out_of_time
                        ? fmt::format(
                              "stresses: the time is spent after {} iterations of Uzawa's method; write solve.dual = "
                              "\"hybrid\", raise refine.max_seconds, or take a coarser mesh",
                              state.iterations)
                        : fmt::format(
                              "stresses: after {} iterations of Uzawa's method the estimated error is {:.1g} of the "
                              "stress, not {:g}; write solve.dual = \"hybrid\", or take a coarser mesh",
                              most_iterations, state.error, tolerance);
    return result;
  }
  const Clock recovering;
  result.stress = recover(cells, particular, state.parameters);
  statistics.seconds.recover = recovering.seconds();
  return result;
}

template Result<2> uzawa(const scene::Problem<2>&, const scene::Stress<2>&, const std::function<bool()>&);

}  // namespace bracket::dual
