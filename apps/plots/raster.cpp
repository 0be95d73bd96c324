// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/plots/raster.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace bracket::apps {
namespace {

static_assert(std::endian::native == std::endian::little, "gnuplot is told nothing else");

// Paints the pixels whose centres lie in the tile; on its edges too, so that none is left out between two tiles.
void paint(Raster& raster, const Tile& tile) {
  std::array<scene::Vector<2>, 3> p;  // in pixels, centres at integers
  for (int i = 0; i < 3; ++i) p[i] = ((tile.corner[i] - raster.low) / raster.pixel).array() - 0.5;
  const auto [left, right] = std::minmax({p[0].x(), p[1].x(), p[2].x()});
  const auto [bottom, top] = std::minmax({p[0].y(), p[1].y(), p[2].y()});
  const int x0 = std::max(0, static_cast<int>(std::ceil(left))), y0 = std::max(0, static_cast<int>(std::ceil(bottom)));
  const int x1 = std::min(raster.width - 1, static_cast<int>(std::floor(right)));
  const int y1 = std::min(raster.height - 1, static_cast<int>(std::floor(top)));
  const auto cross = [](const scene::Vector<2>& a, const scene::Vector<2>& b) { return a.x() * b.y() - a.y() * b.x(); };
  const double twice_area = cross(p[1] - p[0], p[2] - p[0]);
  if (twice_area == 0) return;
  for (int y = y0; y <= y1; ++y)
    for (int x = x0; x <= x1; ++x) {
      const scene::Vector<2> centre(x, y);
      std::array<double, 3> share;
      for (int i = 0; i < 3; ++i) share[i] = cross(p[(i + 1) % 3] - centre, p[(i + 2) % 3] - centre) / twice_area;
      if (std::ranges::min(share) < -1e-9) continue;
      raster.value[static_cast<std::size_t>(y) * raster.width + x] =
          static_cast<float>(share[0] * tile.value[0] + share[1] * tile.value[1] + share[2] * tile.value[2]);
    }
}

}  // namespace

Raster rasterise(const std::vector<Tile>& tiles, int longest) {
  Eigen::AlignedBox2d box;
  for (const Tile& tile : tiles)
    for (const scene::Vector<2>& corner : tile.corner) box.extend(corner);
  const scene::Vector<2> size = box.diagonal();
  Raster raster;
  raster.low = box.min();
  raster.pixel = size.maxCoeff() / longest;
  raster.width = std::max(1, static_cast<int>(std::ceil(size.x() / raster.pixel - 1e-9)));
  raster.height = std::max(1, static_cast<int>(std::ceil(size.y() / raster.pixel - 1e-9)));
  raster.value.assign(static_cast<std::size_t>(raster.width) * raster.height, std::numeric_limits<float>::quiet_NaN());
  for (const Tile& tile : tiles) paint(raster, tile);
  return raster;
}

float quantile(const Raster& raster, double part) {
  std::vector<float> values;
  for (const float value : raster.value)
    if (std::isfinite(value)) values.push_back(value);
  if (values.empty()) return 0;
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(part * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

std::string image_item(const Raster& raster) {
  return fmt::format("'-' binary array=({},{}) origin=({},{}) dx={} dy={} format='%float' with image notitle",
                     raster.width, raster.height, raster.low.x() + raster.pixel / 2, raster.low.y() + raster.pixel / 2,
                     raster.pixel, raster.pixel);
}

std::string image_bytes(const Raster& raster) {
  return {reinterpret_cast<const char*>(raster.value.data()), raster.value.size() * sizeof(float)};
}

}  // namespace bracket::apps
