// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/quantities/pair.h"

#include <algorithm>
#include <cmath>
#include <future>
#include <limits>

#include "bounds/estimate/on_mesh.h"
#include "contact/clock.h"
#include "scene/problem/law.h"

namespace bracket::bounds {

namespace {

/// ½ (a ± b)
template <int dim>
scene::Displacement<dim> combined(const scene::Displacement<dim>& a, const scene::Displacement<dim>& b, double sign) {
  scene::Displacement<dim> result = a;
  for (std::size_t i = 0; i < a.vertex.size(); ++i) result.vertex[i] = 0.5 * (a.vertex[i] + sign * b.vertex[i]);
  for (std::size_t i = 0; i < a.edge.size(); ++i) result.edge[i] = 0.5 * (a.edge[i] + sign * b.edge[i]);
  for (std::size_t i = 0; i < a.cell.size(); ++i) result.cell[i] = 0.5 * (a.cell[i] + sign * b.cell[i]);
  return result;
}
template <int dim> scene::Stress<dim> combined(const scene::Stress<dim>& a, const scene::Stress<dim>& b, double sign) {
  scene::Stress<dim> result = a;
  for (std::size_t c = 0; c < a.cell.size(); ++c)
    for (std::size_t i = 0; i < a.cell[c].size(); ++i) result.cell[c][i] = 0.5 * (a.cell[c][i] + sign * b.cell[c][i]);
  return result;
}

/// 0: there is nothing to compare with.
double ratio(double a, double b) { return b > 0 ? a / b : 0; }

using Coefficients = std::vector<double>;

Coefficients combined(Coefficients a, const Coefficients& b, double sign) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] = 0.5 * (a[i] + sign * b[i]);
  return a;
}

/// Planar: ½ ∫ (k s² + C p² − 2 p s) ≥ 0 over a contact facet: what springs shortened by s under p have of a width.
double springs_square(const scene::Problem<2>& problem, const scene::ContactFacet& pair, const Coefficients& s,
                      const Coefficients& p) {
  const auto& [k0, k1] = pair.law.modulus;
  const auto c = scene::compliance_on<double>(k0, k1);
  return scene::length(problem.mesh, pair.first) *
         (0.5 * scene::bernstein_product(scene::bernstein_times<double>(s, s), Coefficients{k0, k1}) +
          0.5 * scene::bernstein_product(scene::bernstein_times<double>(p, p), Coefficients(c.begin(), c.end())) -
          scene::bernstein_product(p, s));
}

/// Planar: ∫ g_T (|w₁| + |w₂|) − 2 ∫ g_T |½ (w₁ + w₂)| ≥ 0 over a contact facet, w what friction sees of the slip in
/// the two perturbed problems: of a slip that turns between them.
double what_friction_adds(const scene::Problem<2>& problem, const std::array<scene::Problem<2>, 2>& of,
                          std::size_t facet, const std::array<scene::Displacement<2>, 2>& displacement) {
  if (!scene::has_friction(problem.contact[facet].law)) return 0;
  std::array<Coefficients, 2> w;
  for (int i = 0; i < 2; ++i) w[i] = rubbing(of[i], displacement[i], of[i].contact[facet]);
  const auto& [first, law] = std::pair(problem.contact[facet].first, problem.contact[facet].law);
  return scene::length(problem.mesh, first) * (mean_of_size(w[0], law.friction) + mean_of_size(w[1], law.friction) -
                                               2 * mean_of_size(combined(w[0], w[1], 1), law.friction));
}

/// Adds the contact facets' shares of A and B. Springs are bodies: s of the means is the mean of the two, as s ≥ r − g
/// of both is that of the mean.   \param contact shares of κ of the means   \param of the two perturbed problems
void add_contact(const scene::Problem<2>& problem, const std::array<scene::Problem<2>, 2>& of,
                 const std::vector<double>& contact, PerturbedPair<2>& pair) {
  for (std::size_t j = 0; j < problem.contact.size(); ++j) {
    const scene::ContactFacet& facet = problem.contact[j];
    double of_difference = 0;
    if (scene::has_springs(facet.law)) {
      std::array<Coefficients, 2> s, p, left;
      for (int i = 0; i < 2; ++i) {
        s[i] = springs_shortened(of[i], pair.displacement[i], of[i].contact[j]);
        p[i] = plain_pressure(of[i], pair.stress[i], of[i].contact[j]);
        left[i] = gap_left(of[i], pair.displacement[i], of[i].contact[j]);
        for (std::size_t k = 0; k < s[i].size(); ++k) left[i][k] += s[i][k];
      }
      const Coefficients mean = combined(p[0], p[1], 1);
      pair.of_means +=
          springs_square(problem, facet, combined(s[0], s[1], 1), mean) +
          2 * scene::length(problem.mesh, facet.first) * scene::bernstein_product(mean, combined(left[0], left[1], 1));
      of_difference = springs_square(problem, facet, combined(s[0], s[1], -1), combined(p[0], p[1], -1));
    } else {
      pair.of_means += 2 * contact[j] + what_friction_adds(problem, of, j, pair.displacement);
    }
    pair.of_differences += of_difference;
    pair.of_contact_difference.push_back(of_difference);
  }
}

/// In space contact but presses.
void add_contact(const scene::Problem<3>&, const std::array<scene::Problem<3>, 2>&, const std::vector<double>& contact,
                 PerturbedPair<3>& pair) {
  for (const double share : contact) pair.of_means += 2 * share;
  pair.of_contact_difference.assign(contact.size(), 0);
}

template <int dim>
PerturbedPair<dim> with_width(const scene::Problem<dim>& problem, const std::array<scene::Problem<dim>, 2>& perturbed,
                              PerturbedPair<dim> pair) {
  const auto& [v1, v2] = pair.displacement;
  const auto& [l1, l2] = pair.stress;
  struct Sized {
    Indicator indicator;
    double displacement, stress, rounding;
  };
  // Enclosures of energies are about as wide as some units in the last place of a double.
  const auto combine = [&](double sign) -> Sized {
    const scene::Displacement<dim> v = combined(v1, v2, sign);
    const scene::Stress<dim> l = combined(l1, l2, sign);
    constexpr double units = 8 * std::numeric_limits<double>::epsilon();
    return {indicator(problem, v, l), largest_at_vertices(v), largest_stress(l),
            units * potential_energy(problem, v).strain};
  };
  auto other = std::async(std::launch::async, combine, 1.0);
  const Sized half = combine(-1);
  const Sized mean = other.get();
  const Indicator &means = mean.indicator, &differences = half.indicator;
  pair.strength = std::max(ratio(half.displacement, mean.displacement), ratio(half.stress, mean.stress));
  pair.rounding = half.rounding;
  for (std::size_t c = 0; c < means.cell.size(); ++c) {
    pair.of_means += means.cell[c];
    pair.of_differences += differences.cell[c];
  }
  add_contact(problem, perturbed, means.contact, pair);
  pair.of_difference = differences.cell;
  pair.width = (pair.of_means + pair.of_differences) / pair.s;
  return pair;
}

template <int dim>
dual::Result<dim> stresses_of(const Solvers<dim>& solvers, const scene::Problem<dim>& problem,
                              const Closed& closed = {}) {
  if constexpr (dim == 2)
    return solvers.stresses->solve(problem, closed.dual);
  else
    return solvers.local_stresses->solve(problem);
}

}  // namespace

template <int dim>
LocalStresses<dim>::LocalStresses(const primal::Solver<dim>& displacements, const scene::Problem<dim>& problem,
                                  int sweeps, bool again, const Clock& clock)
    : pressures_(displacements, problem), of_pressures_(clock.seconds()), stars_(problem, again), sweeps_(sweeps) {}

template <int dim>
std::vector<dual::Result<dim>> LocalStresses<dim>::solve(std::span<const scene::Problem<dim>> problems,
                                                         std::span<const primal::Result<dim>> displacements) const {
  std::vector<dual::Result<dim>> results(problems.size());
  std::vector<primal::PressureResult<dim>> pressed(problems.size());
  std::vector<typename dual::LocalSolver<dim>::Start> starts;
  std::vector<std::size_t> started;
  double of_pressures = of_pressures_;
  for (std::size_t i = 0; i < problems.size(); ++i) {
    const bool known = problems[i].contact.empty() && !displacements[i].displacement.vertex.empty();
    if (!known) {
      const Clock clock;
      pressed[i] = pressures_.solve(problems[i], displacements[i].closed);
      of_pressures += clock.seconds();
    }
    if (pressed[i].termination == contact::Termination::solved) {
      starts.push_back(
          {problems[i], pressed[i].pressure, known ? displacements[i].displacement : pressed[i].displacement});
      started.push_back(i);
    } else {
      results[i].termination = pressed[i].termination;
      results[i].reason = std::move(pressed[i].reason);
    }
  }
  std::vector<dual::Result<dim>> solved = stars_.solve(starts, sweeps_);
  for (std::size_t k = 0; k < solved.size(); ++k) {
    solved[k].statistics.seconds.contact += of_pressures;
    results[started[k]] = std::move(solved[k]);
  }
  return results;
}

template <int dim>
dual::Result<dim> LocalStresses<dim>::solve(const scene::Problem<dim>& problem,
                                            const primal::Result<dim>& displacements) const {
  return std::move(solve({&problem, 1}, {&displacements, 1}).front());
}

template <int dim>
Attempt<dim> solve_pair(const scene::Problem<dim>& problem, const Solvers<dim>& solvers,
                        const std::shared_ptr<const scene::Perturbation<dim>>& by, double s,
                        const std::array<Closed, 2>& closed) {
  std::array<primal::Result<dim>, 2> displacements;
  std::array<dual::Result<dim>, 2> stresses;
  const std::array<scene::Problem<dim>, 2> perturbed = {scene::perturbed(problem, by, s, -s),
                                                        scene::perturbed(problem, by, -s, s)};
  const auto displace = [&](int i) {
    try {
      displacements[i] = solvers.displacements->solve(perturbed[i], closed[i].primal);
    } catch (const scene::Error& error) {  // prescribed displacements that close the gap
      displacements[i].reason = error.what();
    }
    return displacements[i].reason.empty();
  };
  if constexpr (dim == 2) {
    const auto solve = [&](int i) {
      if (displace(i)) stresses[i] = stresses_of(solvers, perturbed[i], closed[i]);
    };
    auto other = std::async(std::launch::async, solve, 1);
    solve(0);
    other.get();
  } else if (displace(0) && displace(1)) {
    std::ranges::move(solvers.local_stresses->solve(perturbed, displacements), stresses.begin());
  }
  Attempt<dim> attempt;
  for (int i = 0; i < 2; ++i)
    for (const std::string& reason : {displacements[i].reason, stresses[i].reason})
      if (attempt.reason.empty()) attempt.reason = reason;
  if (!attempt.reason.empty()) return attempt;
  PerturbedPair<dim> pair{.s = s};
  for (int i = 0; i < 2; ++i) {
    pair.displacement[i] = std::move(displacements[i].displacement);
    pair.stress[i] = std::move(stresses[i].stress);
    pair.closed[i] = {std::move(displacements[i].closed), std::move(stresses[i].closed)};
  }
  attempt.pair = with_width(problem, perturbed, std::move(pair));
  return attempt;
}

namespace {

/// As certify_functional(), by |f|.
template <int dim>
FunctionalBound bound_by(const scene::Problem<dim>& problem, const std::shared_ptr<const scene::Perturbation<dim>>& by,
                         double f, const scene::Displacement<dim>& displacement, const scene::Stress<dim>& stress) {
  FunctionalBound bound = certify_functional(scene::perturbed(problem, by, f, f), displacement, stress);
  bound.above /= std::abs(f);
  return bound;
}

}  // namespace

template <int dim>
FunctionalBound functional_bound(const scene::Problem<dim>& problem,
                                 const std::shared_ptr<const scene::Perturbation<dim>>& by,
                                 const PerturbedPair<dim>& pair, int sign) {
  const int loads = sign > 0 ? 0 : 1;  // whose loads are sign · s; the kinematics of the other are
  return bound_by(problem, by, sign * pair.s, pair.displacement[1 - loads], pair.stress[loads]);
}

template <int dim>
FunctionalBound one_sided_bound(const scene::Problem<dim>& problem, const Solvers<dim>& solvers,
                                const std::shared_ptr<const scene::Perturbation<dim>>& by, double f) try {
  const auto stresses = stresses_of(solvers, scene::perturbed(problem, by, f, -f));
  const auto displacements = solvers.displacements->solve(scene::perturbed(problem, by, 0, f));
  for (const std::string& reason : {displacements.reason, stresses.reason})
    if (!reason.empty()) return {.reason = reason};
  return bound_by(problem, by, f, displacements.displacement, stresses.stress);
} catch (const scene::Error& error) {
  return {.reason = error.what()};
}

#define INSTANTIATE(dim)                                                                                    \
  template struct PerturbedPair<dim>;                                                                       \
  template class LocalStresses<dim>;                                                                        \
  template Attempt<dim> solve_pair(const scene::Problem<dim>&, const Solvers<dim>&,                         \
                                   const std::shared_ptr<const scene::Perturbation<dim>>&, double,          \
                                   const std::array<Closed, 2>&);                                           \
  template FunctionalBound one_sided_bound(const scene::Problem<dim>&, const Solvers<dim>&,                 \
                                           const std::shared_ptr<const scene::Perturbation<dim>>&, double); \
  template FunctionalBound functional_bound(const scene::Problem<dim>&,                                     \
                                            const std::shared_ptr<const scene::Perturbation<dim>>&,         \
                                            const PerturbedPair<dim>&, int);
INSTANTIATE(2)
INSTANTIATE(3)
#undef INSTANTIATE

}  // namespace bracket::bounds
