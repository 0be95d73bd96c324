// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cmath>

/// Square blocks of some rows, known when compiled: plain loops over columns, which for so few are quicker than what
/// is made for large matrices.
namespace bracket::dual {

/// a b
template <class Block, class Vector> Vector times(const Block& a, const Vector& b) {
  constexpr int n = Block::RowsAtCompileTime;
  double sum[n] = {};
  for (int k = 0; k < n; ++k)
    for (int i = 0; i < n; ++i) sum[i] += a.data()[n * k + i] * b.data()[k];
  Vector result;
  for (int i = 0; i < n; ++i) result.data()[i] = sum[i];
  return result;
}
/// aᵀ b
template <class Block, class Vector> Vector transposed_times(const Block& a, const Vector& b) {
  constexpr int n = Block::RowsAtCompileTime;
  Vector result;
  for (int k = 0; k < n; ++k) {  // two sums, for they wait less for each other
    const double* column = a.data() + n * k;
    double even = 0, odd = 0;
    for (int i = 0; i + 1 < n; i += 2) {
      even += column[i] * b.data()[i];
      odd += column[i + 1] * b.data()[i + 1];
    }
    if (n % 2 == 1) even += column[n - 1] * b.data()[n - 1];
    result.data()[k] = even + odd;
  }
  return result;
}
/// to −= a bᵀ; a and b have as many rows as `to`, `depth` columns, which begin `stride` numbers from each other.
template <class Block> void subtract_product(Block& to, const double* a, const double* b, int depth, int stride) {
  constexpr int n = Block::RowsAtCompileTime;
  for (int j = 0; j < n; ++j) {
    double column[n];
    for (int i = 0; i < n; ++i) column[i] = to.data()[n * j + i];
    for (int k = 0; k < depth; ++k)
      for (int i = 0; i < n; ++i) column[i] -= a[stride * k + i] * b[stride * k + j];
    for (int i = 0; i < n; ++i) to.data()[n * j + i] = column[i];
  }
}
/// to −= a bᵀ; `to` is neither of the others.
template <class Block> void subtract_product(Block& to, const Block& a, const Block& b) {
  subtract_product(to, a.data(), b.data(), Block::RowsAtCompileTime, Block::RowsAtCompileTime);
}

/// Puts L, L Lᵀ = a, in the lower half of a symmetric block, whose upper half is not looked at.
/// \return whether it is positive definite
template <class Block> bool factorise(Block& a) {
  constexpr int n = Block::RowsAtCompileTime;
  double* x = a.data();
  for (int j = 0; j < n; ++j) {
    for (int k = 0; k < j; ++k)
      for (int i = j; i < n; ++i) x[n * j + i] -= x[n * k + i] * x[n * k + j];
    if (!(x[n * j + j] > 0)) return false;
    const double by = 1 / std::sqrt(x[n * j + j]);
    for (int i = j; i < n; ++i) x[n * j + i] *= by;
  }
  return true;
}
/// to L⁻ᵀ, row by row: solves x Lᵀ = to.
template <class Block> void divide(Block& to, const Block& l) {
  constexpr int n = Block::RowsAtCompileTime;
  for (int j = 0; j < n; ++j) {
    double column[n];
    for (int i = 0; i < n; ++i) column[i] = to.data()[n * j + i];
    for (int k = 0; k < j; ++k)
      for (int i = 0; i < n; ++i) column[i] -= to.data()[n * k + i] * l.data()[n * k + j];
    const double by = 1 / l.data()[n * j + j];
    for (int i = 0; i < n; ++i) to.data()[n * j + i] = column[i] * by;
  }
}
/// L⁻¹ b
template <class Block, class Vector> void solve_lower(const Block& l, Vector& b) {
  constexpr int n = Block::RowsAtCompileTime;
  for (int k = 0; k < n; ++k) {
    b[k] /= l.data()[n * k + k];
    for (int i = k + 1; i < n; ++i) b.data()[i] -= l.data()[n * k + i] * b[k];
  }
}
/// L⁻ᵀ b
template <class Block, class Vector> void solve_upper(const Block& l, Vector& b) {
  constexpr int n = Block::RowsAtCompileTime;
  for (int k = n; k-- > 0;) {
    double sum = b[k];
    for (int i = k + 1; i < n; ++i) sum -= l.data()[n * k + i] * b[i];
    b[k] = sum / l.data()[n * k + k];
  }
}

}  // namespace bracket::dual
