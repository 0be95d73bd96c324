// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/contact.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <memory>
#include <optional>

#include "contact/active_set.h"
#include "contact/clock.h"
#include "contact/condensed.h"
#include "contact/limits.h"
#include "contact/statics.h"

namespace bracket::contact {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// K⁺ (f − Bᵀ p)
VectorXd elastic_displacement(const System& body, const Condensed& condensed, const VectorXd& force,
                              const VectorXd& pressure) {
  return condensed.apply(force - body.rows.transpose() * pressure);
}

/// Σ B u
VectorXd approach(const std::vector<System>& bodies, const std::vector<VectorXd>& displacement) {
  VectorXd result = VectorXd::Zero(bodies.front().rows.rows());
  for (std::size_t b = 0; b < bodies.size(); ++b) result += bodies[b].rows * displacement[b];
  return result;
}

/// \param start p, limits those of the rows before they were scaled
Pressure minimise(const Scaled& interface, const VectorXd& start, const Limits& limits,
                  const std::vector<char>& guess) {
  if (start.size() == 0) return {};
  const std::vector<char> all(static_cast<std::size_t>(start.size()), 1);
  std::optional<Pressure> found = block_active_set(interface.problem, guess.empty() ? all : guess);
  if (found) return *found;
  try {
    return primal_active_set(interface.problem,
                             scaled(start, interface.row.cwiseInverse(), limits, interface.problem.limits));
  } catch (const HeldByRounding&) {
    Pressure none;
    none.termination = Termination::not_definite;
    return none;
  }
}

/// What Bodies::solve() looks for.
struct State {
  std::vector<VectorXd> elastic;  ///< K⁺ (f − Bᵀ p) of each body
  VectorXd pressure;              ///< p
  VectorXd motion;                ///< α, of the motions that contact resists
};

/// What is given to it.
struct Given {
  const std::vector<VectorXd>& loads;
  const VectorXd& gap;
  const Limits& limits;    ///< complete
  const Statics& statics;  ///< of the rows that are not fixed
  const VectorXd& load;    ///< e, what these balance
};

/// A motion given in the bodies' bases, in terms of their `rigid`, its largest entry one.
std::vector<VectorXd> in_terms_of_rigid(const std::vector<System>& bodies, const std::vector<Motions>& bases,
                                        const VectorXd& stacked) {
  std::vector<VectorXd> result;
  double largest = 0;
  Index first = 0;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const Index k = bases[b].basis.cols();
    VectorXd motion(k);
    if (k > 0) {
      motion = bases[b].change.triangularView<Eigen::Upper>().solve(stacked.segment(first, k));
      largest = std::max(largest, (bodies[b].rigid * motion).lpNorm<Eigen::Infinity>());
    }
    result.push_back(motion);
    first += k;
  }
  for (std::size_t b = 0; b < bodies.size(); ++b)
    for (Index j = 0; j < result[b].size(); ++j) {
      double& coefficient = result[b][j];
      coefficient /= largest;
      const double size = bodies[b].rigid.col(j).lpNorm<Eigen::Infinity>();
      if (std::abs(coefficient) * size < 1e-12) coefficient = 0;  // rounding of the change of basis
    }
  return result;
}

}  // namespace

struct Bodies::Factorised {
  std::vector<System> systems;
  std::vector<Motions> bases;
  Statics statics;
  std::vector<Condensed> condensed;  ///< up to the first that is not definite
  int not_definite = -1;
  MatrixXd compliance;  ///< F
  Phases seconds;

  Interface interface(const Given& given) const;
  State refined(const Given& given, const Scaled& interface, const std::vector<Index>& active, State state) const;
  std::vector<VectorXd> displacements(const Statics& of, const State& state) const;
};

Interface Bodies::Factorised::interface(const Given& given) const {
  std::vector<VectorXd> unhindered;
  for (std::size_t b = 0; b < systems.size(); ++b) unhindered.push_back(condensed[b].apply(given.loads[b]));
  const VectorXd free_approach = approach(systems, unhindered);
  return {compliance,
          free_approach - given.gap,
          free_approach.cwiseAbs() + given.gap.cwiseAbs(),
          given.statics.rows,
          given.load,
          given.limits};
}

/// One step of iterative refinement on the whole: what K u + Bᵀ p = f, the closed rows and Gᵀ p = e still lack.
/// Rigid motions stay out of the residuals, so a large one does no harm. The rounding of all n rows of K adds up along
/// the rigid motions; that is spread over the body, else the pinned unknowns would have to bear it alone.
State Bodies::Factorised::refined(const Given& given, const Scaled& interface, const std::vector<Index>& active,
                                  State state) const {
  std::vector<VectorXd> residual;
  VectorXd misfit = given.statics.rows * state.motion - given.gap;
  for (std::size_t b = 0; b < systems.size(); ++b) {
    const System& body = systems[b];
    VectorXd carried = body.stiffness.selfadjointView<Eigen::Lower>() * state.elastic[b];
    const MatrixXd& basis = bases[b].basis;  // basisᵀ basis = n
    if (basis.cols() > 0) carried -= basis * (basis.transpose() * carried) / static_cast<double>(basis.rows());
    residual.push_back(given.loads[b] - body.rows.transpose() * state.pressure - carried);
    misfit += body.rows * (state.elastic[b] + condensed[b].apply(residual[b]));
  }
  const VectorXd none = VectorXd::Zero(given.gap.size());
  VectorXd change = none;
  if (!active.empty()) {
    const MatrixXd transposed = interface.motion.transpose();
    const auto closed = solve_closed(
        interface.problem, active, interface.row.cwiseProduct(misfit),
        transposed.triangularView<Eigen::Lower>().solve(given.load - given.statics.rows.transpose() * state.pressure),
        none);
    if (closed) {
      change = closed->pressure.cwiseProduct(interface.row);
      state.motion += interface.motion.triangularView<Eigen::Upper>().solve(closed->motion);
    }
  }
  for (std::size_t b = 0; b < systems.size(); ++b)
    state.elastic[b] += elastic_displacement(systems[b], condensed[b], residual[b], change);
  state.pressure = clamped(state.pressure + change, given.limits);
  return state;
}

/// u of each body: of all solutions the one that moves least.
std::vector<VectorXd> Bodies::Factorised::displacements(const Statics& of, const State& state) const {
  VectorXd motion = VectorXd::Zero(of.free.rows());
  motion(of.resisted) = state.motion;
  motion -= of.free * (of.free.transpose() * motion);
  std::vector<VectorXd> result;
  Index first = 0;
  for (std::size_t b = 0; b < systems.size(); ++b) {
    const Index k = bases[b].basis.cols();
    result.push_back(state.elastic[b] + bases[b].basis * motion.segment(first, k));
    first += k;
  }
  return result;
}

Bodies::Bodies(std::vector<System> systems) {
  assert(!systems.empty());
  Clock watch;
  Factorised made{std::move(systems), {}, {}, {}, -1, {}, {}};
  const Index m = made.systems.front().rows.rows();
  for (const System& body : made.systems) made.bases.push_back(motions(body.rigid));
  made.statics = statics(made.systems, made.bases);
  made.seconds.contact = watch.lap();

  for (std::size_t b = 0; b < made.systems.size() && made.not_definite < 0; ++b) {
    const System& body = made.systems[b];
    assert(body.stiffness.isCompressed() && body.rows.rows() == m);
    const std::vector<int> contact = contact_unknowns(body.rows);
    made.condensed.push_back(
        {pins(made.bases[b].basis, contact), Factor(body.stiffness, body.nodes, body.sequence, contact)});
    made.seconds.order += watch.lap();
    const std::vector<int>& pinned = made.condensed[b].pinned;
    Factor& factor = made.condensed[b].factor;
    const bool definite =
        pinned.empty() ? factor.factorise(body.stiffness) : factor.factorise(pinned_stiffness(body.stiffness, pinned));
    if (!definite) made.not_definite = static_cast<int>(b);
    made.seconds.factorise += watch.lap();
  }

  if (made.not_definite < 0) {
    made.compliance = MatrixXd::Zero(m, m);
    for (std::size_t b = 0; b < made.systems.size(); ++b)
      if (made.systems[b].rows.nonZeros() > 0) add_compliance(made.systems[b].rows, made.condensed[b], made.compliance);
  }
  made.seconds.contact += watch.lap();
  factorised_ = std::make_unique<const Factorised>(std::move(made));
}

Bodies::Bodies(Bodies&&) noexcept = default;
Bodies& Bodies::operator=(Bodies&&) noexcept = default;
Bodies::~Bodies() = default;

const std::vector<System>& Bodies::systems() const { return factorised_->systems; }

VectorXd Bodies::respond(int body, const VectorXd& force) const { return factorised_->condensed[body].apply(force); }

Solution Bodies::solve(const std::vector<VectorXd>& loads, const VectorXd& gap, const std::vector<char>& guess,
                       const Limits& given_limits) const {
  const Factorised& bodies = *factorised_;
  assert(loads.size() == bodies.systems.size() && gap.size() == bodies.systems.front().rows.rows() &&
         (guess.empty() || static_cast<Index>(guess.size()) == gap.size()));
  Solution solution;
  Clock watch;
  solution.seconds = bodies.seconds;
  const Limits limits = complete(given_limits, gap.size());
  const std::vector<char> fixed = fixed_rows(limits);
  const std::optional<Statics> without_fixed =
      fixed.empty() ? std::nullopt : std::optional(statics(bodies.systems, bodies.bases, fixed));
  const Statics& of_rows = without_fixed ? *without_fixed : bodies.statics;
  const BalancedLoad balanced =
      balanced_load(of_rows, bodies.bases, left_by_fixed(loads, bodies.systems, limits, fixed), limits);
  solution.imbalance = balanced.imbalance;
  if (!balanced.possible) {
    solution.termination = Termination::no_equilibrium;
    solution.motion = in_terms_of_rigid(bodies.systems, bodies.bases, balanced.motion);
    return solution;
  }
  if (bodies.not_definite >= 0) {
    solution.termination = Termination::not_definite;
    solution.body = bodies.not_definite;
    return solution;
  }

  const Given given{loads, gap, limits, of_rows, balanced.load};
  const Scaled interface = scaled(bodies.interface(given));
  const Pressure found = minimise(interface, balanced.pressure, limits, guess);
  solution.iterations = found.iterations;
  solution.termination = found.termination;
  solution.seconds.contact += watch.lap();
  if (found.termination != Termination::solved) return solution;

  State state{{},
              scaled(found.pressure, interface.row, interface.problem.limits, limits),
              interface.motion.triangularView<Eigen::Upper>().solve(found.motion)};
  for (std::size_t b = 0; b < loads.size(); ++b)
    state.elastic.push_back(elastic_displacement(bodies.systems[b], bodies.condensed[b], loads[b], state.pressure));
  state = bodies.refined(given, interface, found.active, std::move(state));

  solution.displacement = bodies.displacements(of_rows, state);
  solution.elastic = std::move(state.elastic);
  solution.pressure = std::move(state.pressure);
  solution.active.assign(gap.size(), 0);
  for (Index i : found.active) solution.active[i] = 1;
  solution.seconds.recover = watch.lap();
  return solution;
}

Statistics statistics(const Bodies& bodies, const Solution& solution) {
  Statistics result{0, 0, 0, solution.iterations, solution.imbalance, solution.seconds};
  for (const System& body : bodies.systems()) result.unknowns += static_cast<int>(body.stiffness.cols());
  result.rows = static_cast<int>(bodies.systems().front().rows.rows());
  result.active_rows = static_cast<int>(std::count(solution.active.begin(), solution.active.end(), 1));
  return result;
}

std::string reason(const Solution& solution, const std::string& unknown, const std::vector<std::string>& bodies,
                   const std::string& no_equilibrium, const std::string& contradiction) {
  switch (solution.termination) {
    case Termination::solved:
    case Termination::not_converged: return "";
    case Termination::no_equilibrium: return unknown + ": " + no_equilibrium;
    case Termination::contradiction: return unknown + ": " + contradiction;
    case Termination::not_definite: break;
  }
  return unknown + ": in floating point " +
         (solution.body < 0 ? "the contact holds a body by rounding only"
                            : "the body '" + bodies[solution.body] + "' is not held") +
         "; moduli are too unlike or cells too thin";
}

}  // namespace bracket::contact
