// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/plots/raster.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace bracket::apps::tests {
namespace {

using scene::Vector;

float linear(const Vector<2>& x) { return static_cast<float>(2 * x.x() - 3 * x.y()); }

Tile tile(const Vector<2>& a, const Vector<2>& b, const Vector<2>& c) {
  return {{a, b, c}, {linear(a), linear(b), linear(c)}};
}

TEST(Raster, ALinearFieldOnAnyTrianglesIsItselfAndLeavesNoHole) {
  // The unit square, divided at a random inner point of each of 8 × 8 squares.
  std::mt19937 random(7);
  std::uniform_real_distribution<double> inside(0.01, 0.99);
  std::vector<Tile> tiles;
  for (int i = 0; i < 8; ++i)
    for (int j = 0; j < 8; ++j) {
      const auto at = [&](double x, double y) { return Vector<2>((i + x) / 8, (j + y) / 8); };
      const Vector<2> middle = at(inside(random), inside(random));
      const std::array<Vector<2>, 4> corner = {at(0, 0), at(1, 0), at(1, 1), at(0, 1)};
      for (int k = 0; k < 4; ++k) tiles.push_back(tile(corner[k], corner[(k + 1) % 4], middle));
    }
  const Raster raster = rasterise(tiles, 101);
  ASSERT_EQ(raster.width, 101);
  ASSERT_EQ(raster.height, 101);
  for (int y = 0; y < raster.height; ++y)
    for (int x = 0; x < raster.width; ++x) {
      const Vector<2> centre((x + 0.5) / 101, (y + 0.5) / 101);
      ASSERT_NEAR(raster.value[y * raster.width + x], linear(centre), 1e-5);
    }
}

TEST(Raster, WhatNoTileCoversIsEmpty) {
  const Raster raster = rasterise({tile({0, 0}, {2, 0}, {0, 1})}, 200);
  ASSERT_EQ(raster.width, 200);
  ASSERT_EQ(raster.height, 100);
  int covered = 0;
  for (const float value : raster.value) covered += std::isfinite(value);
  EXPECT_NEAR(covered, 200 * 100 / 2, 200);  // half, but for pixels on the slope
  EXPECT_TRUE(std::isnan(raster.value.back()));
  EXPECT_TRUE(std::isfinite(raster.value.front()));
}

TEST(Raster, ATriangleTurnedRoundIsPaintedToo) {
  const Raster one = rasterise({tile({0, 0}, {1, 0}, {0, 1})}, 50),
               other = rasterise({tile({0, 0}, {0, 1}, {1, 0})}, 50);
  for (std::size_t i = 0; i < one.value.size(); ++i) EXPECT_EQ(std::isnan(one.value[i]), std::isnan(other.value[i]));
}

TEST(Raster, QuantilesCountPixels) {
  const Raster raster = rasterise({tile({0, 0}, {1, 0}, {1, 1}), tile({0, 0}, {1, 1}, {0, 1})}, 100);
  EXPECT_EQ(quantile(raster, 0), *std::ranges::min_element(raster.value));
  EXPECT_EQ(quantile(raster, 1), *std::ranges::max_element(raster.value));
  EXPECT_NEAR(quantile(raster, 0.5), -0.5, 0.05);  // 2x − 3y is as often above as below its mean
}

}  // namespace
}  // namespace bracket::apps::tests
