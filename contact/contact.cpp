// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/contact.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <memory>
#include <new>
#include <optional>
#include <stdexcept>

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

using Sparse = Eigen::SparseMatrix<double>;

/// K⁺ (f − Bᵀ p) \param half Condensed::forward() of f
VectorXd elastic_displacement(const Sparse& rows, const Condensed& condensed, VectorXd half, const VectorXd& pressure) {
  if (rows.nonZeros() == 0) return condensed.factor.backward(half);
  return condensed.apply_with(std::move(half), -(rows.transpose() * pressure));
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

/// The bodies without their contact.
struct Bodies::Elastic {
  std::vector<System> systems;
  std::vector<Motions> bases;
  std::vector<Condensed> condensed;  ///< factorised up to the first that is not definite
  int not_definite = -1;
};

/// With rows of contact.
struct Bodies::WithRows {
  std::shared_ptr<const Elastic> elastic;
  std::vector<Sparse> rows;  ///< B of each body
  bool may_depend;
  Sparse added;  ///< A; empty: none
  Statics statics;
  MatrixXd compliance;  ///< F + A
  Phases seconds;

  const std::vector<System>& systems() const { return elastic->systems; }
  const std::vector<Motions>& bases() const { return elastic->bases; }
  const Condensed& condensed(std::size_t body) const { return elastic->condensed[body]; }
  std::vector<VectorXd> halves(const std::vector<VectorXd>& loads) const;
  VectorXd approach(const std::vector<VectorXd>& halves) const;
  Interface interface(const Given& given, const std::vector<VectorXd>& halves) const;
  State refined(const Given& given, const Scaled& interface, const std::vector<Index>& active, State state) const;
  std::vector<VectorXd> displacements(const Statics& of, const State& state) const;
};

/// Condensed::forward() of each body.
std::vector<VectorXd> Bodies::WithRows::halves(const std::vector<VectorXd>& loads) const {
  std::vector<VectorXd> result;
  for (std::size_t b = 0; b < rows.size(); ++b) result.push_back(condensed(b).forward(loads[b]));
  return result;
}

/// Σ B K⁺ f
VectorXd Bodies::WithRows::approach(const std::vector<VectorXd>& halves) const {
  VectorXd result = VectorXd::Zero(rows.front().rows());
  for (std::size_t b = 0; b < rows.size(); ++b)
    if (rows[b].nonZeros() > 0) result += rows[b] * condensed(b).factor.backward_to_last(halves[b]);
  return result;
}

Interface Bodies::WithRows::interface(const Given& given, const std::vector<VectorXd>& halves) const {
  const VectorXd free_approach = approach(halves);
  return {compliance,
          free_approach - given.gap,
          free_approach.cwiseAbs() + given.gap.cwiseAbs(),
          given.statics.rows,
          given.load,
          given.limits,
          may_depend};
}

/// One step of iterative refinement on the whole: what K u + Bᵀ p = f, the closed rows and Gᵀ p = e still lack.
/// Rigid motions stay out of the residuals, so a large one does no harm. The rounding of all n rows of K adds up along
/// the rigid motions; that is spread over the body, else the pinned unknowns would have to bear it alone.
State Bodies::WithRows::refined(const Given& given, const Scaled& interface, const std::vector<Index>& active,
                                State state) const {
  std::vector<VectorXd> residual;  // by halves
  VectorXd misfit = given.statics.rows * state.motion - given.gap;
  if (added.size() > 0) misfit -= added * state.pressure;
  for (std::size_t b = 0; b < rows.size(); ++b) {
    VectorXd carried = systems()[b].stiffness.selfadjointView<Eigen::Lower>() * state.elastic[b];
    const MatrixXd& basis = bases()[b].basis;  // basisᵀ basis = n
    if (basis.cols() > 0) carried -= basis * (basis.transpose() * carried) / static_cast<double>(basis.rows());
    residual.push_back(condensed(b).forward(given.loads[b] - rows[b].transpose() * state.pressure - carried));
    if (rows[b].nonZeros() > 0)
      misfit += rows[b] * (state.elastic[b] + condensed(b).factor.backward_to_last(residual[b]));
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
  for (std::size_t b = 0; b < rows.size(); ++b)
    state.elastic[b] += elastic_displacement(rows[b], condensed(b), std::move(residual[b]), change);
  state.pressure = clamped(state.pressure + change, given.limits);
  return state;
}

/// u of each body: of all solutions the one that moves least.
std::vector<VectorXd> Bodies::WithRows::displacements(const Statics& of, const State& state) const {
  VectorXd motion = VectorXd::Zero(of.free.rows());
  motion(of.resisted) = state.motion;
  motion -= of.free * (of.free.transpose() * motion);
  std::vector<VectorXd> result;
  Index first = 0;
  for (std::size_t b = 0; b < rows.size(); ++b) {
    const Index k = bases()[b].basis.cols();
    result.push_back(state.elastic[b] + bases()[b].basis * motion.segment(first, k));
    first += k;
  }
  return result;
}

namespace {

/// \return F   \param added A, empty: none
MatrixXd compliance_of(const std::vector<Sparse>& rows, const std::vector<Condensed>& bodies, const Sparse& added) {
  MatrixXd result = MatrixXd::Zero(rows.front().rows(), rows.front().rows());
  for (std::size_t b = 0; b < rows.size(); ++b)
    if (rows[b].nonZeros() > 0) add_compliance(rows[b], bodies[b], result);
  if (added.size() > 0) result += added;
  return result;
}

/// The factors, and at the worst moments of the contact: F beside what it is made of, and beside two scaled copies.
double memory(const std::vector<Sparse>& rows, const std::vector<Condensed>& bodies) {
  double doubles = 0, making = 0;
  const auto m = static_cast<double>(rows.front().rows());
  for (std::size_t b = 0; b < rows.size(); ++b) {
    doubles += bodies[b].factor.entries();
    const auto last = static_cast<double>(contact_unknowns(rows[b]).size());
    making = std::max(making, last * (last + m) + m * m);
  }
  return sizeof(double) * (doubles + m * m + std::max(making, 2 * m * m));
}

}  // namespace

Bodies::Bodies(std::vector<System> systems, bool rows_may_depend) {
  assert(!systems.empty());
  Clock watch;
  auto elastic = std::make_shared<Elastic>();
  elastic->systems = std::move(systems);
  WithRows made{elastic, {}, rows_may_depend, {}, {}, {}, {}};
  for (const System& body : elastic->systems) {
    assert(body.stiffness.isCompressed() && body.rows.rows() == elastic->systems.front().rows.rows());
    made.rows.push_back(body.rows);
    elastic->bases.push_back(motions(body.rigid));
  }
  made.statics = statics(made.rows, elastic->bases);
  made.seconds.contact = watch.lap();

  for (std::size_t b = 0; b < elastic->systems.size(); ++b) {
    const System& body = elastic->systems[b];
    const std::vector<int> contact = contact_unknowns(body.rows);
    elastic->condensed.push_back(
        {pins(elastic->bases[b].basis, contact), Factor(body.stiffness, body.nodes, body.sequence, contact)});
  }
  if (memory(made.rows, elastic->condensed) > physical_memory()) throw std::bad_alloc();
  made.seconds.order = watch.lap();

  for (std::size_t b = 0; b < elastic->systems.size() && elastic->not_definite < 0; ++b) {
    auto& [pinned, factor] = elastic->condensed[b];
    if (!factor.factorise(elastic->systems[b].stiffness, pinned)) elastic->not_definite = static_cast<int>(b);
  }
  made.seconds.factorise = watch.lap();

  if (elastic->not_definite < 0) made.compliance = compliance_of(made.rows, elastic->condensed, {});
  made.seconds.contact += watch.lap();
  with_rows_ = std::make_unique<const WithRows>(std::move(made));
}

Bodies::Bodies(std::unique_ptr<const WithRows> with_rows) : with_rows_(std::move(with_rows)) {}
Bodies::Bodies(Bodies&&) noexcept = default;
Bodies& Bodies::operator=(Bodies&&) noexcept = default;
Bodies::~Bodies() = default;

Bodies Bodies::with_rows(std::vector<Sparse> rows, Sparse added) const {
  Clock watch;
  const auto& elastic = with_rows_->elastic;
  assert(rows.size() == elastic->systems.size());
  for (std::size_t b = 0; b < rows.size(); ++b) {
    const std::vector<int> last = contact_unknowns(elastic->systems[b].rows), touched = contact_unknowns(rows[b]);
    if (!std::includes(last.begin(), last.end(), touched.begin(), touched.end()))
      throw std::invalid_argument("contact::Bodies::with_rows: a row touches an unknown that no row touched before");
  }
  WithRows made{elastic, std::move(rows), true, added, {}, {}, with_rows_->seconds};
  made.statics = statics(made.rows, elastic->bases);
  if (elastic->not_definite < 0) made.compliance = compliance_of(made.rows, elastic->condensed, made.added);
  made.seconds.contact = watch.lap();
  return Bodies(std::make_unique<const WithRows>(std::move(made)));
}

const std::vector<System>& Bodies::systems() const { return with_rows_->systems(); }

const std::vector<Sparse>& Bodies::rows() const { return with_rows_->rows; }

VectorXd Bodies::respond(int body, const VectorXd& force) const { return with_rows_->condensed(body).apply(force); }

Solution Bodies::solve(const std::vector<VectorXd>& loads, const VectorXd& gap, const std::vector<char>& guess,
                       const Limits& given_limits) const {
  const WithRows& bodies = *with_rows_;
  assert(loads.size() == bodies.rows.size() && gap.size() == bodies.rows.front().rows() &&
         (guess.empty() || static_cast<Index>(guess.size()) == gap.size()));
  Solution solution;
  Clock watch;
  solution.seconds = bodies.seconds;
  const Limits limits = complete(given_limits, gap.size());
  const std::vector<char> fixed = fixed_rows(limits);
  const std::optional<Statics> without_fixed =
      fixed.empty() ? std::nullopt : std::optional(statics(bodies.rows, bodies.bases(), fixed));
  const Statics& of_rows = without_fixed ? *without_fixed : bodies.statics;
  const BalancedLoad balanced =
      balanced_load(of_rows, bodies.bases(), left_by_fixed(loads, bodies.rows, limits, fixed), limits);
  solution.imbalance = balanced.imbalance;
  if (!balanced.possible) {
    solution.termination = Termination::no_equilibrium;
    solution.motion = in_terms_of_rigid(bodies.systems(), bodies.bases(), balanced.motion);
    return solution;
  }
  if (bodies.elastic->not_definite >= 0) {
    solution.termination = Termination::not_definite;
    solution.body = bodies.elastic->not_definite;
    return solution;
  }

  const Given given{loads, gap, limits, of_rows, balanced.load};
  std::vector<VectorXd> halves = bodies.halves(loads);
  const Scaled interface = scaled(bodies.interface(given, halves));
  const Pressure found = minimise(interface, balanced.pressure, limits, guess);
  solution.iterations = found.iterations;
  solution.termination = found.termination;
  solution.seconds.contact += watch.lap();
  if (found.termination != Termination::solved) return solution;

  State state{{},
              scaled(found.pressure, interface.row, interface.problem.limits, limits),
              interface.motion.triangularView<Eigen::Upper>().solve(found.motion)};
  for (std::size_t b = 0; b < loads.size(); ++b)
    state.elastic.push_back(
        elastic_displacement(bodies.rows[b], bodies.condensed(b), std::move(halves[b]), state.pressure));
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
  result.rows = static_cast<int>(bodies.rows().front().rows());
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
