// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#define BOOST_ALLOW_DEPRECATED_HEADERS  // which Boost itself includes
#include <algorithm>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <iterator>
#include <span>
#include <vector>

#include "scene/types.h"

namespace bracket::scene {

/// Things in the plane or in space, by the boxes around them: finds those near a point, in logarithmic time.
template <int dim> class Boxes {
 public:
  /// \param all the points of each thing
  explicit Boxes(const std::vector<std::vector<Vector<dim>>>& all) : tree_(entries(all)) {}

  /// The things whose boxes are at most `distance` away in each coordinate, in their order.
  std::vector<int> near(const Vector<dim>& x, double distance) const {
    const Box around(corner(x - Vector<dim>::Constant(distance)), corner(x + Vector<dim>::Constant(distance)));
    std::vector<Entry> found;
    tree_.query(boost::geometry::index::intersects(around), std::back_inserter(found));
    std::vector<int> things;
    for (const Entry& entry : found) things.push_back(entry.second);
    std::ranges::sort(things);
    return things;
  }

 private:
  using Point = boost::geometry::model::point<double, dim, boost::geometry::cs::cartesian>;
  using Box = boost::geometry::model::box<Point>;
  using Entry = std::pair<Box, int>;

  static Point corner(const Vector<dim>& x) {
    if constexpr (dim == 2) return Point(x[0], x[1]);
    if constexpr (dim == 3) return Point(x[0], x[1], x[2]);
  }
  static std::vector<Entry> entries(const std::vector<std::vector<Vector<dim>>>& all) {
    std::vector<Entry> result;
    for (const auto& points : all) {
      Vector<dim> low = points.front(), high = low;
      for (const Vector<dim>& x : points) {
        low = low.cwiseMin(x);
        high = high.cwiseMax(x);
      }
      result.emplace_back(Box(corner(low), corner(high)), static_cast<int>(result.size()));
    }
    return result;
  }

  boost::geometry::index::rtree<Entry, boost::geometry::index::quadratic<16>> tree_;
};

}  // namespace bracket::scene
