// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#define BOOST_ALLOW_DEPRECATED_HEADERS  // which Boost itself includes
#include <algorithm>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <iterator>
#include <span>
#include <vector>

#include "scene/types.h"

namespace bracket::scene {

/// Things in the plane, by the boxes around them: finds those near a point, in logarithmic time.
class Boxes {
 public:
  /// \param all the points of each thing
  explicit Boxes(const std::vector<std::vector<Vector<2>>>& all) : tree_(entries(all)) {}

  /// The things whose boxes are at most `distance` away in each coordinate, in their order.
  std::vector<int> near(const Vector<2>& x, double distance) const {
    const Box around({x[0] - distance, x[1] - distance}, {x[0] + distance, x[1] + distance});
    std::vector<Entry> found;
    tree_.query(boost::geometry::index::intersects(around), std::back_inserter(found));
    std::vector<int> things;
    for (const Entry& entry : found) things.push_back(entry.second);
    std::ranges::sort(things);
    return things;
  }

 private:
  using Point = boost::geometry::model::d2::point_xy<double>;
  using Box = boost::geometry::model::box<Point>;
  using Entry = std::pair<Box, int>;

  static std::vector<Entry> entries(const std::vector<std::vector<Vector<2>>>& all) {
    std::vector<Entry> result;
    for (const auto& points : all) {
      Vector<2> low = points.front(), high = low;
      for (const Vector<2>& x : points) {
        low = low.cwiseMin(x);
        high = high.cwiseMax(x);
      }
      result.emplace_back(Box({low[0], low[1]}, {high[0], high[1]}), static_cast<int>(result.size()));
    }
    return result;
  }

  boost::geometry::index::rtree<Entry, boost::geometry::index::quadratic<16>> tree_;
};

}  // namespace bracket::scene
