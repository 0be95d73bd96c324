// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/contact.h"

#include <cassert>
#include <cmath>
#include <memory>

#include "contact/active_set.h"
#include "contact/clock.h"
#include "contact/factor.h"
#include "contact/statics.h"

namespace bracket::contact {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Sparse = Eigen::SparseMatrix<double>;

/// K with the pinned unknowns cut off from the others (a diagonal entry is left to them).
Sparse pinned_stiffness(Sparse stiffness, const std::vector<int>& pinned) {
  std::vector<char> is_pinned(stiffness.rows(), 0);
  for (int i : pinned) is_pinned[i] = 1;
  for (int j = 0; j < stiffness.outerSize(); ++j)
    for (Sparse::InnerIterator entry(stiffness, j); entry; ++entry)
      if (entry.row() != j && (is_pinned[j] || is_pinned[entry.row()])) entry.valueRef() = 0;
  return stiffness;
}

/// A factorised body. K⁺ is the inverse of K without the pinned unknowns, zero on those.
struct Condensed {
  std::vector<int> pinned;
  Factor factor;

  VectorXd apply(VectorXd force) const {
    force(pinned).setZero();
    return factor.solve(force);
  }
};

/// The unknowns that contact rows touch, in increasing order.
std::vector<int> contact_unknowns(const Sparse& rows) {
  std::vector<int> result;
  for (int j = 0; j < rows.outerSize(); ++j)
    if (Sparse::InnerIterator(rows, j)) result.push_back(j);
  return result;
}

/// Adds B K⁺ Bᵀ to F: with S = L Lᵀ the Schur complement on the contact unknowns, B S⁻¹ Bᵀ = Xᵀ X, X = L⁻¹ Bᵀ.
void add_compliance(const Sparse& rows, const Condensed& body, MatrixXd& compliance) {
  const Trailing trailing = body.factor.trailing();
  const Sparse by_row = rows.transpose();  // column i: row i of B
  std::vector<int> place(rows.cols(), -1);
  for (std::size_t k = 0; k < trailing.unknowns.size(); ++k) place[trailing.unknowns[k]] = static_cast<int>(k);
  for (int i : body.pinned) place[i] = -1;

  std::vector<Index> touching;
  for (int i = 0; i < by_row.outerSize(); ++i)
    if (Sparse::InnerIterator(by_row, i)) touching.push_back(i);
  MatrixXd right = MatrixXd::Zero(static_cast<Index>(trailing.unknowns.size()), static_cast<Index>(touching.size()));
  for (std::size_t i = 0; i < touching.size(); ++i)
    for (Sparse::InnerIterator entry(by_row, touching[i]); entry; ++entry)
      if (place[entry.row()] >= 0) right(place[entry.row()], static_cast<Index>(i)) = entry.value();
  trailing.lower.triangularView<Eigen::Lower>().solveInPlace(right);
  compliance(touching, touching) += right.transpose() * right;
}

/// K⁺ (f − Bᵀ p)
VectorXd elastic_displacement(const Body& body, const Condensed& condensed, const VectorXd& force,
                              const VectorXd& pressure) {
  return condensed.apply(force - body.rows.transpose() * pressure);
}

/// Σ B u
VectorXd approach(const std::vector<Body>& bodies, const std::vector<VectorXd>& displacement) {
  VectorXd result = VectorXd::Zero(bodies.front().rows.rows());
  for (std::size_t b = 0; b < bodies.size(); ++b) result += bodies[b].rows * displacement[b];
  return result;
}

Interface condense(const std::vector<Body>& bodies, const std::vector<Condensed>& condensed, const Statics& statics,
                   const VectorXd& gap) {
  const Index m = gap.size();
  std::vector<VectorXd> unhindered;
  Interface result{MatrixXd::Zero(m, m), {}, {}, statics.rows, statics.load};
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    if (bodies[b].rows.nonZeros() > 0) add_compliance(bodies[b].rows, condensed[b], result.compliance);
    unhindered.push_back(condensed[b].apply(bodies[b].load));
  }
  const VectorXd free_approach = approach(bodies, unhindered);
  result.overlap = free_approach - gap;
  result.size = free_approach.cwiseAbs() + gap.cwiseAbs();
  return result;
}

Pressure minimise(const Scaled& interface, const VectorXd& start, const std::vector<char>& guess) {
  if (start.size() == 0) return {};
  const std::vector<char> all(static_cast<std::size_t>(start.size()), 1);
  std::optional<Pressure> found = block_active_set(interface.problem, guess.empty() ? all : guess);
  if (found) return *found;
  try {
    return primal_active_set(interface.problem, start.cwiseQuotient(interface.row));
  } catch (const HeldByRounding&) {
    Pressure none;
    none.outcome = Outcome::not_definite;
    return none;
  }
}

/// What solve() looks for.
struct State {
  std::vector<VectorXd> elastic;  ///< K⁺ (f − Bᵀ p) of each body
  VectorXd pressure;              ///< p
  VectorXd motion;                ///< α, of the motions that contact resists
};

/// One step of iterative refinement on the whole: what K u + Bᵀ p = f, the closed rows and Gᵀ p = e still lack.
/// Rigid motions stay out of the residuals, so a large one does no harm. The rounding of all n rows of K adds up along
/// the rigid motions; that is spread over the body, else the pinned unknowns would have to bear it alone.
State refined(const std::vector<Body>& bodies, const std::vector<Motions>& bases,
              const std::vector<Condensed>& condensed, const Statics& statics, const VectorXd& gap,
              const Scaled& interface, const std::vector<Index>& active, State state) {
  std::vector<VectorXd> residual;
  VectorXd misfit = statics.rows * state.motion - gap;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const Body& body = bodies[b];
    VectorXd carried = body.stiffness.selfadjointView<Eigen::Lower>() * state.elastic[b];
    const MatrixXd& basis = bases[b].basis;  // basisᵀ basis = n
    if (basis.cols() > 0) carried -= basis * (basis.transpose() * carried) / static_cast<double>(basis.rows());
    residual.push_back(body.load - body.rows.transpose() * state.pressure - carried);
    misfit += body.rows * (state.elastic[b] + condensed[b].apply(residual[b]));
  }
  VectorXd change = VectorXd::Zero(gap.size());
  if (!active.empty()) {
    const MatrixXd transposed = interface.motion.transpose();
    const auto closed = solve_closed(
        interface.problem, active, interface.row.cwiseProduct(misfit),
        transposed.triangularView<Eigen::Lower>().solve(statics.load - statics.rows.transpose() * state.pressure));
    if (closed) {
      change = closed->pressure.cwiseProduct(interface.row);
      state.motion += interface.motion.triangularView<Eigen::Upper>().solve(closed->motion);
    }
  }
  for (std::size_t b = 0; b < bodies.size(); ++b)
    state.elastic[b] += elastic_displacement(bodies[b], condensed[b], residual[b], change);
  state.pressure = (state.pressure + change).cwiseMax(0);
  return state;
}

/// A motion given in the bodies' bases, in terms of their `rigid`, its largest entry one.
std::vector<VectorXd> in_terms_of_rigid(const std::vector<Body>& bodies, const std::vector<Motions>& bases,
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

Solution solve(const std::vector<Body>& bodies, const VectorXd& gap, const std::vector<char>& guess) {
  assert(!bodies.empty() && (guess.empty() || static_cast<Index>(guess.size()) == gap.size()));
  Solution solution;
  Clock watch;
  std::vector<Motions> bases;
  for (const Body& body : bodies) bases.push_back(motions(body.rigid));
  const Statics balanced = statics(bodies, bases);
  solution.imbalance = balanced.imbalance;
  if (!balanced.possible) {
    solution.outcome = Outcome::no_equilibrium;
    solution.motion = in_terms_of_rigid(bodies, bases, balanced.motion);
    return solution;
  }
  solution.seconds.contact = watch.lap();

  const auto factorised = std::make_shared<std::vector<Condensed>>();
  std::vector<Condensed>& condensed = *factorised;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const Body& body = bodies[b];
    assert(body.stiffness.isCompressed() && body.rows.rows() == gap.size());
    const std::vector<int> contact = contact_unknowns(body.rows);
    condensed.push_back({pins(bases[b].basis, contact), Factor(body.stiffness, body.nodes, contact)});
    solution.seconds.order += watch.lap();
    const std::vector<int>& pinned = condensed[b].pinned;
    Factor& factor = condensed[b].factor;
    const bool definite =
        pinned.empty() ? factor.factorise(body.stiffness) : factor.factorise(pinned_stiffness(body.stiffness, pinned));
    solution.seconds.factorise += watch.lap();
    if (!definite) {
      solution.outcome = Outcome::not_definite;
      solution.body = static_cast<int>(b);
      return solution;
    }
  }

  const Scaled interface = scaled(condense(bodies, condensed, balanced, gap));
  const Pressure found = minimise(interface, balanced.pressure, guess);
  solution.iterations = found.iterations;
  solution.outcome = found.outcome;
  solution.seconds.contact += watch.lap();
  if (found.outcome != Outcome::solved) return solution;

  State state{{},
              interface.row.cwiseProduct(found.pressure),
              interface.motion.triangularView<Eigen::Upper>().solve(found.motion)};
  for (std::size_t b = 0; b < bodies.size(); ++b)
    state.elastic.push_back(elastic_displacement(bodies[b], condensed[b], bodies[b].load, state.pressure));
  state = refined(bodies, bases, condensed, balanced, gap, interface, found.active, std::move(state));

  VectorXd motion = VectorXd::Zero(balanced.free.rows());
  motion(balanced.resisted) = state.motion;
  motion -= balanced.free * (balanced.free.transpose() * motion);  // of all solutions the one that moves least
  Index first = 0;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const Index k = bases[b].basis.cols();
    solution.displacement.push_back(state.elastic[b] + bases[b].basis * motion.segment(first, k));
    first += k;
  }
  solution.elastic = std::move(state.elastic);
  solution.pressure = std::move(state.pressure);
  solution.active.assign(gap.size(), 0);
  for (Index i : found.active) solution.active[i] = 1;
  solution.respond = [factorised](int b, const VectorXd& force) { return (*factorised)[b].apply(force); };
  solution.seconds.recover = watch.lap();
  return solution;
}

std::string reason(const Solution& solution, const std::string& unknown, const std::vector<std::string>& bodies,
                   const std::string& no_equilibrium, const std::string& contradiction) {
  switch (solution.outcome) {
    case Outcome::solved:
    case Outcome::not_converged: return "";
    case Outcome::no_equilibrium: return unknown + ": " + no_equilibrium;
    case Outcome::contradiction: return unknown + ": " + contradiction;
    case Outcome::not_definite: break;
  }
  return unknown + ": in floating point " +
         (solution.body < 0 ? "the contact holds a body by rounding only"
                            : "the body '" + bodies[solution.body] + "' is not held") +
         "; moduli are too unlike or cells too thin";
}

}  // namespace bracket::contact
