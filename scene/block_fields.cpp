// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/block_fields.h"

#include <stdexcept>

#include "scene/bernstein.h"

namespace bracket::scene {

namespace {

/// What belongs to the side from vertex 1 to vertex 2, and one field of each three that rotation turns into each other.
struct Generators {
  int load_scale;
  std::array<BlockField, 2> load;
  std::vector<BlockField> bubbles;
};

// tests/scene/block_fields_test.cpp has them satisfy their definition exactly.
const Generators quadratic = {
    6,
    {{{6, 0,  0,  -18, -6, 6,  -6, -12, 12, 5, 1, -3, 2, 4, -6, 0, 0, -1, 0, 12, 0,  0, 6, 0,  0, 0, 0,
       0, -4, -2, 0,   -1, -2, 0,  0,   -1, 0, 0, 0,  3, 0, 0,  6, 0, 0,  1, 0,  -1, 1, 0, -1, 0, 0, -1},
      {-12, -6, 12, -6, -18, 6,  0, 6, 0,  4, 2, -6, 1, 5, -3, 0,  0, -1, 0,  6, 0,  0,  3, 0,  0, 0, 0,
       0,   1,  -1, 0,  1,   -1, 0, 0, -1, 0, 0, 0,  6, 0, 0,  12, 0, 0,  -1, 0, -2, -4, 0, -2, 0, 0, -1}}},
    {{0, 0,  0, -9, -9, 9, 0, 0, 0, 9, 3, -6, 3, 9, -6, 0, 0, 1, 0, 0, 0, 0,  0, 0, 0, 0, 0,
      0, -3, 0, 0,  0,  0, 0, 0, 1, 0, 0, 0,  0, 0, 0,  0, 0, 0, 0, 0, 0, -3, 0, 0, 0, 0, 1}}};
const Generators cubic = {
    18,
    {{{-18, 0, 0,  72, 18, -18, -54, 0,  0,  -18, -36, 36,  -7, -1, 7,  23, -7, 1,  2, 8,  -20, 9,   3,
       -3,  3, -3, 0,  6,  -3,  0,   0,  36, 0,   0,   -12, 0,  0,  -6, 0,  0,  0,  0, 0,  0,   -16, 0,
       -6,  2, 0,  6,  2,  6,   9,   -6, 0,  3,   6,   6,   -3, 0,  0,  0,  0,  12, 0, 0,  -3,  0,   0,
       -18, 0, 0,  -6, 0,  -4,  -9,  0,  5,  -3,  0,   5,   -6, -3, 0,  -3, 0,  3,  6, -3, 0},
      {36,  18, -36, 0,  54, 0,  -27, -81, 27, 0,  18, 0,  -5, 1, 17, 4,  -32, 5, 1, 13, -10, 10, -5,
       -3,  4,  4,   -6, 3,  -3, 0,   0,   18, 0,  0,  -6, 0,  0, 6,  0,  0,   0, 0, 0,  9,   -8, 0,
       -9,  4,  0,   0,  -2, 4,  4,   -6,  -2, 4,  3,  3,  -3, 0, 0,  0,  0,   6, 0, 0,  21,  0,  0,
       -36, 0,  0,   0,  0,  -2, -9,  0,   -5, -9, 0,  19, -5, 1, 0,  -2, -8,  3, 3, -3, 0}}},
    {{0, 0, 0, -3, -3, 3, 3, 3,  -3, 0, 0, 0, 3,  1,  -2, -6, -2, 4,  0,  -2, 1, 4,  1, -2, -1, 2, -1, 1, 0, 0,
      0, 0, 0, 0,  3,  0, 0, -3, 0,  0, 0, 0, 0,  -2, 1,  0,  -2, -2, 0,  1,  1, -1, 2, -1, 1,  1, 1,  1, 0, 0,
      0, 0, 0, 0,  0,  0, 0, 0,  0,  0, 0, 0, -1, 0,  0,  -1, 0,  0,  -1, 0,  0, 0,  0, 0,  0,  0, 0,  1, 0, 0},
     {0, 0, 0, -3, -3, 3, -6, -6, 6, 0, 0, 0, 3,  1,  -2, 9,  7, -8, 3,  7, -5, -3, -1, 2, -2, -3, 3, 0, 0, 0,
      0, 0, 0, 0,  3,  0, 0,  -3, 0, 0, 0, 0, 0,  -5, 1,  0,  1, -2, 0,  1, 1,  -1, 1,  1, 1,  0,  0, 0, 0, 0,
      0, 0, 0, 0,  0,  0, 0,  0,  0, 0, 0, 0, -1, 0,  0,  -1, 0, 0,  -1, 0, 0,  1,  0,  0, 1,  0,  0, 0, 0, 0}}};

/// λ ↦ R λ Rᵀ on the next part, for the map of the triangle onto itself that takes each vertex to the next:
/// R = (−1 −1; 1 0), det R = 1.
BlockField rotated(const BlockField& field) {
  const std::size_t size = field.size(), part = size / 3;
  BlockField result(size);
  for (std::size_t i = 0; i < size; i += 3) {
    const int xx = field[i], yy = field[i + 1], xy = field[i + 2];
    const std::size_t to = (i + part) % size;
    result[to] = xx + 2 * xy + yy;
    result[to + 1] = xx;
    result[to + 2] = -xx - xy;
  }
  return result;
}

BlockField sum(int factor, const BlockField& a, int other, const BlockField& b) {
  BlockField result(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) result[i] = factor * a[i] + other * b[i];
  return result;
}

/// Of one degree less, times the degree.
BlockField raised(const BlockField& field, int degree) {
  const int below = n_bernstein(degree - 1);
  BlockField result;
  for (int part = 0; part < 3; ++part)
    for (const auto& i : bernstein_indices(degree))
      for (int c = 0; c < 3; ++c) {
        int sum = 0;
        for (int corner = 0; corner < 3; ++corner) {
          if (i[corner] == 0) continue;
          std::array<int, 3> less = i;
          --less[corner];
          sum += i[corner] * field[3 * (below * part + bernstein_place(less)) + c];
        }
        result.push_back(sum);
      }
  return result;
}

using OfSides = std::array<std::array<BlockField, 2>, 3>;

OfSides of_loads(std::array<BlockField, 2> load) {
  // After e rotations the loads are along Rᵉ (1, 0) and Rᵉ (0, 1); columns of R⁻ᵉ give those along the axes.
  constexpr std::array<std::array<std::array<int, 2>, 2>, 3> back = {{{{{1, 0}, {0, 1}}},  //
                                                                      {{{0, 1}, {-1, -1}}},
                                                                      {{{-1, -1}, {1, 0}}}}};
  OfSides sides;
  for (int side = 0; side < 3; ++side) {
    for (int c = 0; c < 2; ++c) sides[side][c] = sum(back[side][0][c], load[0], back[side][1][c], load[1]);
    for (BlockField& each : load) each = rotated(each);
  }
  return sides;
}

BlockFields make(const Generators& of) {
  BlockFields fields{of.load_scale, {of_loads(of.load)}, {}};
  for (const BlockField& generator : of.bubbles) {
    BlockField bubble = generator;
    for (int turn = 0; turn < 3; ++turn) {
      fields.bubbles.push_back(bubble);
      bubble = rotated(bubble);
    }
  }
  return fields;
}

/// What cubics have beside quadratics, after what these have.
BlockFields make_cubic(const BlockFields& of_quadratics) {
  const BlockFields own = make(cubic);
  BlockFields fields{own.load_divisor, {}, {}};
  for (const OfSides& sides : of_quadratics.load) {
    OfSides& all = fields.load.emplace_back();
    for (int side = 0; side < 3; ++side)
      for (int c = 0; c < 2; ++c) all[side][c] = raised(sides[side][c], 3);  // the divisor is three times theirs, too
  }
  fields.load.push_back(own.load.front());
  for (const BlockField& bubble : of_quadratics.bubbles) fields.bubbles.push_back(raised(bubble, 3));
  fields.bubbles.insert(fields.bubbles.end(), own.bubbles.begin(), own.bubbles.end());
  return fields;
}

}  // namespace

const BlockFields& block_fields(int degree) {
  static const BlockFields of_quadratics = make(quadratic), of_cubics = make_cubic(of_quadratics);
  if (degree != 2 && degree != 3) throw std::invalid_argument("block_fields: the degree is neither 2 nor 3");
  return degree == 2 ? of_quadratics : of_cubics;
}

}  // namespace bracket::scene
