// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "dual/local/lanes.h"

/// Square blocks of some rows, known when compiled: plain loops over columns, which for so few are quicker than what
/// is made for large matrices. Of a factor the diagonal is kept as its reciprocals.
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
  constexpr int n = Block::RowsAtCompileTime, lanes = 2, vectors = n / lanes;
  using Pair = typename Lanes<lanes>::Type;
  Pair right[vectors];
  BRACKET_UNROLL for (int v = 0; v < vectors; ++v) load<lanes>(right[v], b.data() + lanes * v);
  Vector result;
  BRACKET_UNROLL for (int k = 0; k < n; ++k) {
    const double* column = a.data() + n * k;
    Pair sum, left;
    load<lanes>(left, column);
    sum = left * right[0];
    BRACKET_UNROLL for (int v = 1; v < vectors; ++v) {
      load<lanes>(left, column + lanes * v);
      sum += left * right[v];
    }
    result.data()[k] = sum[0] + sum[1];
    for (int i = lanes * vectors; i < n; ++i) result.data()[k] += column[i] * b.data()[i];
  }
  return result;
}

/// Of `columns` columns of to −= a bᵀ the rows from `first` on; all matrices as for subtract_product(), `to` and b from
/// the first of these columns on.
template <int lanes, int n, int columns, int first>
[[gnu::always_inline]] inline void subtract_columns(double* to, const double* a, const double* b, int depth,
                                                    int stride) {
  constexpr int vectors = (n - first) / lanes, done = first + lanes * vectors, rest = n - done;
  typename Lanes<lanes>::Type sum[columns][std::max(vectors, 1)];
  double last[columns][std::max(rest, 1)];
  BRACKET_UNROLL for (int j = 0; j < columns; ++j) {
    BRACKET_UNROLL for (int v = 0; v < vectors; ++v) load<lanes>(sum[j][v], to + n * j + first + lanes * v);
    BRACKET_UNROLL for (int i = 0; i < rest; ++i) last[j][i] = to[n * j + done + i];
  }
  BRACKET_KEEP_ROLLED for (int k = 0; k < depth; ++k) {
    typename Lanes<lanes>::Type left[std::max(vectors, 1)];
    BRACKET_UNROLL for (int v = 0; v < vectors; ++v) load<lanes>(left[v], a + stride * k + first + lanes * v);
    BRACKET_UNROLL for (int j = 0; j < columns; ++j) {
      const double right = b[stride * k + j];
      BRACKET_UNROLL for (int v = 0; v < vectors; ++v) sum[j][v] -= left[v] * right;
      BRACKET_UNROLL for (int i = 0; i < rest; ++i) last[j][i] -= a[stride * k + done + i] * right;
    }
  }
  BRACKET_UNROLL for (int j = 0; j < columns; ++j) {
    BRACKET_UNROLL for (int v = 0; v < vectors; ++v) store<lanes>(to + n * j + first + lanes * v, sum[j][v]);
    BRACKET_UNROLL for (int i = 0; i < rest; ++i) to[n * j + done + i] = last[j][i];
  }
}
/// to −= a bᵀ; a and b have as many rows as `to`, `depth` columns, which begin `stride` numbers from each other.
template <int lanes, class Block, int from = 0>
[[gnu::always_inline]] inline void subtract_product(Block& to, const double* a, const double* b, int depth,
                                                    int stride) {
  constexpr int n = Block::RowsAtCompileTime;
  constexpr int columns = std::min(lanes == 4 ? 3 : 2, n - from);  // as many as there are registers for
  subtract_columns<lanes, n, columns, 0>(to.data() + n * from, a, b + from, depth, stride);
  if constexpr (from + columns < n) subtract_product<lanes, Block, from + columns>(to, a, b, depth, stride);
}
/// to −= a bᵀ; `to` is neither of the others.
template <int lanes, class Block>
[[gnu::always_inline]] inline void subtract_product(Block& to, const Block& a, const Block& b) {
  subtract_product<lanes>(to, a.data(), b.data(), Block::RowsAtCompileTime, Block::RowsAtCompileTime);
}
/// The lower half of to −= a aᵀ, with some of what is above it.
template <int lanes, class Block, int from = 0>
[[gnu::always_inline]] inline void subtract_square(Block& to, const Block& a) {
  constexpr int n = Block::RowsAtCompileTime, columns = std::min(lanes, n - from);
  subtract_columns<lanes, n, columns, from>(to.data() + n * from, a.data(), a.data() + from, n, n);
  if constexpr (from + columns < n) subtract_square<lanes, Block, from + columns>(to, a);
}

/// Puts L, L Lᵀ = a, in the lower half of a symmetric block, whose upper half is not looked at.
/// \return whether it is positive definite
template <class Block> [[gnu::always_inline]] inline bool factorise(Block& a) {
  constexpr int n = Block::RowsAtCompileTime;
  double* x = a.data();
  BRACKET_UNROLL for (int j = 0; j < n; ++j) {
    if (!(x[n * j + j] > 0)) return false;
    const double by = x[n * j + j] = 1 / std::sqrt(x[n * j + j]);
    BRACKET_UNROLL for (int i = j + 1; i < n; ++i) x[n * j + i] *= by;
    BRACKET_UNROLL for (int k = j + 1; k < n; ++k) BRACKET_UNROLL for (int i = k; i < n; ++i) x[n * k + i] -=
        x[n * j + i] * x[n * j + k];
  }
  return true;
}
/// to L⁻ᵀ, row by row: solves x Lᵀ = to.
template <int lanes, class Block> [[gnu::always_inline]] inline void divide(Block& to, const Block& l) {
  constexpr int n = Block::RowsAtCompileTime, vectors = n / lanes, done = lanes * vectors, rest = n - done;
  BRACKET_UNROLL for (int j = 0; j < n; ++j) {
    double* column = to.data() + n * j;
    typename Lanes<lanes>::Type sum[vectors];
    double last[std::max(rest, 1)];
    BRACKET_UNROLL for (int v = 0; v < vectors; ++v) load<lanes>(sum[v], column + lanes * v);
    BRACKET_UNROLL for (int i = 0; i < rest; ++i) last[i] = column[done + i];
    BRACKET_UNROLL for (int k = 0; k < j; ++k) {
      const double* before = to.data() + n * k;
      const double by = l.data()[n * k + j];
      BRACKET_UNROLL for (int v = 0; v < vectors; ++v) {
        typename Lanes<lanes>::Type left;
        load<lanes>(left, before + lanes * v);
        sum[v] -= left * by;
      }
      BRACKET_UNROLL for (int i = 0; i < rest; ++i) last[i] -= before[done + i] * by;
    }
    const double by = l.data()[n * j + j];
    BRACKET_UNROLL for (int v = 0; v < vectors; ++v) store<lanes>(column + lanes * v, sum[v] * by);
    BRACKET_UNROLL for (int i = 0; i < rest; ++i) column[done + i] = last[i] * by;
  }
}
/// L⁻¹ b
template <class Block, class Vector> void solve_lower(const Block& l, Vector& b) {
  constexpr int n = Block::RowsAtCompileTime;
  double x[n];
  BRACKET_UNROLL for (int i = 0; i < n; ++i) x[i] = b.data()[i];
  BRACKET_UNROLL for (int k = 0; k < n; ++k) {
    x[k] *= l.data()[n * k + k];
    BRACKET_UNROLL for (int i = k + 1; i < n; ++i) x[i] -= l.data()[n * k + i] * x[k];
  }
  BRACKET_UNROLL for (int i = 0; i < n; ++i) b.data()[i] = x[i];
}
/// L⁻ᵀ b
template <class Block, class Vector> void solve_upper(const Block& l, Vector& b) {
  constexpr int n = Block::RowsAtCompileTime;
  double x[n];
  BRACKET_UNROLL for (int i = 0; i < n; ++i) x[i] = b.data()[i];
  BRACKET_UNROLL for (int k = n - 1; k >= 0; --k) {
    x[k] *= l.data()[n * k + k];
    BRACKET_UNROLL for (int i = 0; i < k; ++i) x[i] -= l.data()[n * i + k] * x[k];
  }
  BRACKET_UNROLL for (int i = 0; i < n; ++i) b.data()[i] = x[i];
}

}  // namespace bracket::dual
