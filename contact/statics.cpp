// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/statics.h"

#include <algorithm>
#include <cmath>

#include "contact/limits.h"

namespace bracket::contact {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Sparse = Eigen::SparseMatrix<double>;

constexpr double rounding = 1e-10;  // of motions and loads, relative: below it they count as zero

/// The largest entry of each row of [B_1 … B_b]; 1 for a row without entries.
VectorXd row_sizes(const std::vector<Sparse>& bodies) {
  VectorXd size = VectorXd::Zero(bodies.front().rows());
  for (const Sparse& rows : bodies)
    for (int j = 0; j < rows.outerSize(); ++j)
      for (Sparse::InnerIterator entry(rows, j); entry; ++entry)
        size[entry.row()] = std::max(size[entry.row()], std::abs(entry.value()));
  return (size.array() > 0).select(size, 1.0);
}

/// The orthonormal motions that the rows do not resist.
MatrixXd free_motions(const MatrixXd& rows) {
  const Index k = rows.cols();
  if (rows.rows() == 0 || k == 0) return MatrixXd::Identity(k, k);
  const Eigen::ColPivHouseholderQR<MatrixXd> qr(rows);
  MatrixXd square = MatrixXd::Zero(k, k);  // with the singular values and motions of the rows
  const Index n = std::min(k, rows.rows());
  square.topRows(n) = qr.matrixQR().topRows(n).triangularView<Eigen::Upper>();
  square *= qr.colsPermutation().transpose();
  const Eigen::JacobiSVD<MatrixXd, Eigen::NoQRPreconditioner> svd(square, Eigen::ComputeFullV);
  const VectorXd& singular = svd.singularValues();
  // Rows and motions are of size one each: what is left at rounding level resists nothing.
  const Index rank = (singular.array() > rounding * std::max(singular[0], 1.0)).count();
  return svd.matrixV().rightCols(k - rank);
}

/// Motions of the basis which, with the free ones, are all: those that are left when each free one has taken its place.
/// A choice among the basis, not a mixture: bodies that have nothing to do with each other stay apart.
std::vector<Index> complement(const MatrixXd& free) {
  const Index k = free.rows();
  std::vector<char> replaced(static_cast<std::size_t>(k), 0);
  if (free.cols() > 0) {
    const Eigen::ColPivHouseholderQR<MatrixXd> qr(free.transpose());
    for (Index j = 0; j < free.cols(); ++j) replaced[qr.colsPermutation().indices()[j]] = 1;
  }
  std::vector<Index> result;
  for (Index j = 0; j < k; ++j)
    if (!replaced[j]) result.push_back(j);
  return result;
}

Index count(const std::vector<Motions>& motions) {
  Index k = 0;
  for (const Motions& body : motions) k += body.basis.cols();
  return k;
}

}  // namespace

Motions motions(const MatrixXd& rigid) {
  const double size = std::sqrt(static_cast<double>(rigid.rows()));
  const auto [q, r] = orthonormal(rigid);
  return {q * size, r / size};
}

Orthonormal orthonormal(MatrixXd columns) {
  const Index k = columns.cols();
  MatrixXd r = MatrixXd::Zero(k, k);
  for (Index j = 0; j < k; ++j) {
    for (int pass = 0; pass < 2; ++pass)
      for (Index i = 0; i < j; ++i) {
        const double part = columns.col(i).dot(columns.col(j));
        columns.col(j) -= part * columns.col(i);
        r(i, j) += part;
      }
    r(j, j) = columns.col(j).norm();
    columns.col(j) /= r(j, j);
  }
  return {std::move(columns), std::move(r)};
}

std::vector<int> pins(const MatrixXd& basis, const std::vector<int>& contact) {
  if (basis.cols() == 0) return {};
  MatrixXd columns = basis.transpose();
  for (int i : contact) columns.col(i) *= 0.5;
  const Eigen::ColPivHouseholderQR<MatrixXd> qr(columns);
  const auto& order = qr.colsPermutation().indices();
  return {order.data(), order.data() + basis.cols()};
}

Statics statics(const std::vector<Sparse>& bodies, const std::vector<Motions>& motions,
                const std::vector<char>& fixed) {
  const Index m = bodies.front().rows();
  MatrixXd rows(m, count(motions));
  Index first = 0;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const MatrixXd& basis = motions[b].basis;
    rows.middleCols(first, basis.cols()) = bodies[b] * basis;
    first += basis.cols();
  }
  const VectorXd row_size = row_sizes(bodies);
  for (Index i = 0; i < m; ++i)  // a row must not seem to resist where it is the rounding of zero
    rows.row(i) = (rows.row(i).array().abs() < 1e-12 * row_size[i]).select(0, rows.row(i));
  for (std::size_t i = 0; i < fixed.size(); ++i)
    if (fixed[i]) rows.row(static_cast<Index>(i)).setZero();
  const MatrixXd free = free_motions(row_size.cwiseInverse().asDiagonal() * rows);
  const std::vector<Index> resisted = complement(free);
  return {resisted, free, rows(Eigen::all, resisted), row_size};
}

std::vector<char> fixed_rows(const Limits& limits) {
  std::vector<char> result(static_cast<std::size_t>(limits.lower.size()));
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = is_fixed(limits, static_cast<Index>(i));
  return std::count(result.begin(), result.end(), 1) > 0 ? result : std::vector<char>();
}

std::vector<VectorXd> left_by_fixed(std::vector<VectorXd> loads, const std::vector<Sparse>& bodies,
                                    const Limits& limits, const std::vector<char>& fixed) {
  VectorXd pressure = VectorXd::Zero(limits.lower.size());
  for (std::size_t i = 0; i < fixed.size(); ++i)
    if (fixed[i]) pressure[static_cast<Index>(i)] = limits.lower[static_cast<Index>(i)];
  if (!pressure.isZero(0))
    for (std::size_t b = 0; b < loads.size(); ++b) loads[b] -= bodies[b].transpose() * pressure;
  return loads;
}

BalancedLoad balanced_load(const Statics& statics, const std::vector<Motions>& motions,
                           const std::vector<VectorXd>& loads, const Limits& limits) {
  VectorXd load(count(motions));
  double size_of_loads = 0;
  Index first = 0;
  for (std::size_t b = 0; b < motions.size(); ++b) {
    const MatrixXd& basis = motions[b].basis;
    load.segment(first, basis.cols()) = basis.transpose() * loads[b];
    if (basis.cols() > 0) size_of_loads += loads[b].lpNorm<1>();
    first += basis.cols();
  }

  BalancedLoad result;
  const VectorXd motion = statics.free * (statics.free.transpose() * load);
  double distance = 0;  // of the point that it moves most
  first = 0;
  for (const Motions& body : motions) {
    const Index n_motions = body.basis.cols();
    if (n_motions > 0)
      distance = std::max(distance, (body.basis * motion.segment(first, n_motions)).lpNorm<Eigen::Infinity>());
    first += n_motions;
  }
  if (distance > 0) result.imbalance = load.dot(motion) / (distance * size_of_loads);
  if (result.imbalance > rounding) {
    result.possible = false;
    result.motion = motion;
    return result;
  }

  const MatrixXd resisting = statics.row_size.cwiseInverse().asDiagonal() * statics.rows;
  const VectorXd resisted_load = (load - motion)(statics.resisted);
  const Limits forces = scaled(limits, statics.row_size);
  // What limits beyond zero press is a load, too.
  const double size = size_of_loads + (resisting.cwiseAbs().transpose() * at_rest(forces).cwiseAbs()).lpNorm<1>();
  const Balance found = balance(resisting, resisted_load, rounding * size, forces);
  if (!found.possible) {
    result.possible = false;
    result.motion = VectorXd::Zero(load.size());
    result.motion(statics.resisted) = found.motion;
    return result;
  }
  result.load = resisting.transpose() * found.pressure;
  if (size > 0) result.imbalance = std::max(result.imbalance, (resisted_load - result.load).norm() / size);
  result.pressure = scaled(found.pressure, statics.row_size.cwiseInverse(), forces, limits);
  return result;
}

}  // namespace bracket::contact
