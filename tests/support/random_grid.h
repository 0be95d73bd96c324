// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "scene/scene.h"

/// Where the bodies of a random scene are.
namespace bracket::tests {

using scene::Vector;

/// Numbers that the standard does fix, unlike its distributions. Draws in one expression would have no order: each is
/// a statement, or an element of a braced list.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  double uniform(double from, double to) {
    return from + (to - from) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
  }
  bool chance(double p) { return uniform(0, 1) < p; }
  template <class T> T pick(const std::vector<T>& from) { return from[engine_() % from.size()]; }

 private:
  std::mt19937_64 engine_;
};

/// Straight lines of the grid stay straight under it: x + shift, then sheared and bent, then turned.
struct Map {
  double bend_x = 0, bend_y = 0, shear = 0, cosine = 1, sine = 0;
  Vector<2> shift = Vector<2>::Zero();
  double size = 1;

  Vector<2> operator()(const Vector<2>& grid) const {
    const double x = grid[0] / size, y = grid[1] / size;
    const double u = x + shear * y + bend_x * x * y, v = y + bend_y * x * y;
    return size * Vector<2>(cosine * u - sine * v, sine * u + cosine * v) + shift;
  }
};

struct Side {
  std::string name;
  std::array<int, 2> step;                    // to the neighbour
  std::array<std::array<int, 2>, 2> corners;  // of the slot, counter-clockwise
};
inline const std::array<Side, 4> sides = {{{"left", {-1, 0}, {{{0, 1}, {0, 0}}}},
                                           {"right", {1, 0}, {{{1, 0}, {1, 1}}}},
                                           {"bottom", {0, -1}, {{{0, 0}, {1, 0}}}},
                                           {"top", {0, 1}, {{{1, 1}, {0, 1}}}}}};

/// A grid of places for bodies, some of them empty.
struct Grid {
  std::array<std::vector<double>, 2> lines;
  std::array<std::vector<int>, 2> cells;
  std::vector<std::vector<char>> taken;  // [i][j]
  Map map;

  bool has(int i, int j) const {
    return i >= 0 && j >= 0 && i < static_cast<int>(taken.size()) && j < static_cast<int>(taken[0].size()) &&
           taken[i][j] != 0;
  }
  std::string body(int i, int j) const { return fmt::format("b{}{}", i, j); }
  Vector<2> corner(int i, int j) const { return map({lines[0][i], lines[1][j]}); }
};

/// One to six places, some left empty; squares or of different widths; four in ten of the grids are mapped.
/// \param size of a square
inline Grid random_grid(Random& random, double size) {
  using Counts = std::array<int, 2>;
  const auto counts =
      random.pick<Counts>({{1, 1}, {1, 1}, {1, 2}, {1, 2}, {1, 3}, {2, 1}, {2, 2}, {3, 1}, {2, 3}, {1, 4}});
  const bool uneven = random.chance(0.3);
  Grid grid;
  for (int axis = 0; axis < 2; ++axis) {
    grid.lines[axis] = {0};
    for (int i = 0; i < counts[axis]; ++i) {
      const double width = uneven ? random.pick<double>({0.1, 0.5, 2, 5}) : 1;
      grid.lines[axis].push_back(grid.lines[axis].back() + size * width);
      grid.cells[axis].push_back(random.pick<int>({1, 1, 2, 3}));
    }
  }
  grid.taken.assign(counts[0], std::vector<char>(counts[1], 0));
  for (auto& column : grid.taken)
    for (char& place : column) place = random.chance(0.9) ? 1 : 0;
  const bool none = std::ranges::all_of(grid.taken, [](const auto& c) { return std::ranges::count(c, 1) == 0; });
  if (none) grid.taken[0][0] = 1;
  grid.map.size = size;
  if (random.chance(0.4)) {
    grid.map.shear = random.pick<double>({0, 0.3, -0.7});
    grid.map.bend_x = random.pick<double>({0, 0.05, -0.03});
    grid.map.bend_y = random.pick<double>({0, 0.04, -0.05});
    const double tangent = random.pick<double>({0, 0.01, 0.25, -0.6});  // of half the angle
    grid.map.cosine = (1 - tangent * tangent) / (1 + tangent * tangent);
    grid.map.sine = 2 * tangent / (1 + tangent * tangent);
  }
  const double far = random.pick<double>({0, 0, 0, 100, 1e5});
  grid.map.shift = {far * size, -far * size};
  return grid;
}

}  // namespace bracket::tests
