// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/block_fields.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <stdexcept>

#include "scene/bernstein.h"

/// In integers: nothing is rounded.
namespace bracket::scene {
namespace {

using Point = std::array<int, 2>;
using Row = std::vector<std::int64_t>;

/// Three times the corners of part k of the triangle (0,0), (1,0), (0,1).
std::array<Point, 3> part(int k) {
  constexpr std::array<Point, 3> vertex = {{{0, 0}, {3, 0}, {0, 3}}};
  return {vertex[(k + 1) % 3], vertex[(k + 2) % 3], Point{1, 1}};
}
/// Outward normal of the side from a to b of what lies to its left.
Point normal(const Point& a, const Point& b) { return {b[1] - a[1], a[0] - b[0]}; }

/// A linear condition on the coefficients of a field: Σ factor · (component `row` of σ n at a place) = 0.
struct Condition {
  int degree;
  Row factors;
  explicit Condition(int of) : degree(of), factors(9 * n_bernstein(of), 0) {}
  void add(int on, const std::array<int, 3>& i, const Point& n, int row, int factor) {
    const std::size_t at = 3 * (n_bernstein(degree) * on + bernstein_place(i));
    factors[at + (row == 0 ? 0 : 2)] += factor * n[0];
    factors[at + (row == 0 ? 2 : 1)] += factor * n[1];
  }
  std::int64_t on(const BlockField& field) const {
    std::int64_t sum = 0;
    for (std::size_t k = 0; k < field.size(); ++k) sum += factors[k] * field[k];
    return sum;
  }
};

/// No divergence, and tractions continuous between the parts.
std::vector<Condition> inner_conditions(int degree) {
  std::vector<Condition> conditions;
  for (int k = 0; k < 3; ++k) {
    const auto x = part(k);
    for (const auto& i : bernstein_indices(degree - 1))
      for (int row = 0; row < 2; ++row) {
        Condition& divergence = conditions.emplace_back(degree);
        for (int corner = 0; corner < 3; ++corner) {  // the gradient of a corner: against the side opposite to it
          std::array<int, 3> above = i;
          ++above[corner];
          divergence.add(k, above, normal(x[(corner + 1) % 3], x[(corner + 2) % 3]), row, 1);
        }
      }
    const int next = (k + 1) % 3;  // it begins where part k ends
    for (int m = 0; m <= degree; ++m)
      for (int row = 0; row < 2; ++row) {
        Condition& jump = conditions.emplace_back(degree);
        jump.add(k, {0, degree - m, m}, normal(x[1], x[2]), row, 1);
        jump.add(next, {degree - m, 0, m}, normal(x[1], x[2]), row, -1);
      }
  }
  return conditions;
}

/// Component `row` of the traction on side e, by the coefficient j: three times that on the unit triangle.
Condition side_condition(int degree, int e, int j, int row) {
  Condition traction(degree);
  traction.add(e, {degree - j, j, 0}, normal(part(e)[0], part(e)[1]), row, 1);
  return traction;
}

constexpr std::int64_t prime = 2147483629;

/// Rank modulo a prime: not more than that of the integers.
int rank(std::vector<Row> rows) {
  const auto inverse = [](std::int64_t a) {
    std::int64_t result = 1;
    for (std::int64_t power = prime - 2; power > 0; power /= 2, a = a * a % prime)
      if (power % 2 == 1) result = result * a % prime;
    return result;
  };
  for (Row& row : rows)
    for (auto& x : row) x = ((x % prime) + prime) % prime;
  int found = 0;
  for (std::size_t column = 0; !rows.empty() && column < rows[0].size(); ++column) {
    std::size_t pivot = found;
    while (pivot < rows.size() && rows[pivot][column] == 0) ++pivot;
    if (pivot == rows.size()) continue;
    std::swap(rows[found], rows[pivot]);
    const std::int64_t scale = inverse(rows[found][column]);
    for (std::size_t i = found + 1; i < rows.size(); ++i) {
      const std::int64_t factor = rows[i][column] * scale % prime;
      for (std::size_t k = column; factor != 0 && k < rows[i].size(); ++k)
        rows[i][k] = (rows[i][k] + (prime - factor) * rows[found][k]) % prime;
    }
    ++found;
  }
  return found;
}

std::vector<Row> rows(const std::vector<Condition>& conditions) {
  std::vector<Row> result;
  for (const Condition& condition : conditions) result.push_back(condition.factors);
  return result;
}

/// The Bernstein coefficients of Legendre's P_k(2t − 1): (−1)^(k+j) binomial(k, j), times an integer where raised.
Row legendre(int k, int degree) {
  std::vector<double> c;
  for (int j = 0; j <= k; ++j) c.push_back(((k + j) % 2 == 0 ? 1 : -1) * binomial(k, j));
  Row result;
  for (const double x : raised_to<double>(degree, c)) result.push_back(std::llround(3 * x));
  return result;
}

TEST(BlockFields, satisfy_their_definition) {
  for (const int degree : {2, 3}) {
    const BlockFields& fields = block_fields(degree);
    std::vector<BlockField> all = fields.bubbles;
    for (const auto& sides : fields.load)
      for (const auto& side : sides) all.insert(all.end(), side.begin(), side.end());
    for (const Condition& condition : inner_conditions(degree))
      for (const BlockField& field : all) ASSERT_EQ(condition.on(field), 0);
    for (int e = 0; e < 3; ++e)
      for (int j = 0; j <= degree; ++j)
        for (int row = 0; row < 2; ++row) {
          const Condition traction = side_condition(degree, e, j, row);
          for (const BlockField& bubble : fields.bubbles) ASSERT_EQ(traction.on(bubble), 0);
          for (int k = 2; k <= degree; ++k)
            for (int side = 0; side < 3; ++side)
              for (int c = 0; c < 2; ++c)
                ASSERT_EQ(traction.on(fields.load[k - 2][side][c]),
                          side == e && c == row ? fields.load_divisor * legendre(k, degree)[j] : 0)
                    << "degree " << degree << ", P_" << k << " on side " << side;
        }
  }
  EXPECT_THROW(block_fields(1), std::invalid_argument);
  EXPECT_THROW(block_fields(4), std::invalid_argument);
}

TEST(BlockFields, there_are_no_others) {
  for (const auto& [degree, modes, bubbles] : {std::array{1, 9, 0}, {2, 18, 3}, {3, 30, 9}}) {
    std::vector<Condition> conditions = inner_conditions(degree);
    const int unknowns = 9 * n_bernstein(degree);
    EXPECT_EQ(unknowns - rank(rows(conditions)), modes);
    for (int e = 0; e < 3; ++e)
      for (int j = 0; j <= degree; ++j)
        for (int row = 0; row < 2; ++row) conditions.push_back(side_condition(degree, e, j, row));
    EXPECT_EQ(unknowns - rank(rows(conditions)), bubbles);
    // So tractions on the sides have modes − bubbles dimensions: all that are in equilibrium.
    EXPECT_EQ(modes - bubbles, 6 * (degree + 1) - 3);
    if (degree == 1) continue;
    const BlockFields& fields = block_fields(degree);
    std::vector<Row> basis;
    for (const BlockField& field : fields.bubbles) basis.emplace_back(field.begin(), field.end());
    EXPECT_EQ(rank(basis), bubbles);
  }
}

}  // namespace
}  // namespace bracket::scene
