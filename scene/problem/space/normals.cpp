// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// In space: normals of faces.
#include "scene/problem/normals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <unordered_map>

namespace bracket::scene {

namespace {

constexpr double of_doubles = 0.5e-6, most = 1e-3;

/// By which a normal may be off, as coordinates are rounded, in radians.
double rounding_of_normal(const Mesh<3>& mesh, int facet) {
  const auto x = positions(mesh, mesh.boundary[facet].vertices);
  double size = 0, longest = 0;
  for (const Vector<3>& vertex : x) size = std::max(size, vertex.lpNorm<Eigen::Infinity>());
  for (const auto& [i, k] : Simplex<2>::edges) longest = std::max(longest, (x[k] - x[i]).norm());
  const double height = 2 * length(mesh, facet) / longest;
  return std::clamp(3.5 * mesh.coordinate_rounding * size / height, of_doubles, most);  // 2 √3 rounded up
}

/// Facets whose normals, up to sign, are those of one of them, and what they make up together.
struct Cluster {
  Vector<3> normal;
  double rounding;
  bool axis;
  Vector<3> area = Vector<3>::Zero(), area_that_counts = Vector<3>::Zero();
};

using Box = std::array<int, 3>;
struct BoxHash {
  std::size_t operator()(const Box& box) const {
    return static_cast<std::size_t>(box[0]) * 73856093U ^ static_cast<std::size_t>(box[1]) * 19349663U ^
           static_cast<std::size_t>(box[2]) * 83492791U;
  }
};

/// Clusters by their normals, in boxes as wide as what may be taken for one.
class Clusters {
 public:
  explicit Clusters(double widest) : width_(2 * widest) {}

  /// The one whose normal is, up to sign, nearest to n within both roundings; −1: none.
  int find(const std::vector<Cluster>& clusters, const Vector<3>& n, double rounding) const {
    int nearest = -1;
    double distance = 0;
    for (const double sign : {1.0, -1.0}) {
      const Box box = box_of(sign * n);
      for (int i = 0; i < 27; ++i) {
        const auto found = boxes_.find({box[0] + i % 3 - 1, box[1] + i / 3 % 3 - 1, box[2] + i / 9 - 1});
        if (found == boxes_.end()) continue;
        for (const int cluster : found->second) {
          const double apart = (clusters[cluster].normal - sign * n).norm();
          if (apart > rounding + clusters[cluster].rounding || (nearest >= 0 && apart >= distance)) continue;
          nearest = cluster;
          distance = apart;
        }
      }
    }
    return nearest;
  }
  void add(int cluster, const Vector<3>& n) { boxes_[box_of(n)].push_back(cluster); }

 private:
  Box box_of(const Vector<3>& n) const {
    return {static_cast<int>(std::floor(n[0] / width_)), static_cast<int>(std::floor(n[1] / width_)),
            static_cast<int>(std::floor(n[2] / width_))};
  }
  double width_;
  std::unordered_map<Box, std::vector<int>, BoxHash> boxes_;
};

bool is_axis(const Vector<3>& v) { return (v.array() != 0).count() == 1; }

}  // namespace

// The largest facets, of these first the ones along an axis, name a direction: theirs is the least rounded.
std::vector<Vector<3>> shared_normals(const Mesh<3>& mesh, const std::vector<char>& counts) {
  const int n_facets = static_cast<int>(mesh.boundary.size());
  std::vector<Vector<3>> area(n_facets);
  std::vector<double> rounding(n_facets);
  double widest = of_doubles;
  for (int f = 0; f < n_facets; ++f) {
    area[f] = area_vector<3>(positions(mesh, mesh.boundary[f].vertices));
    rounding[f] = rounding_of_normal(mesh, f);
    widest = std::max(widest, rounding[f]);
  }
  std::vector<int> order(n_facets), cluster_of(n_facets);
  std::iota(order.begin(), order.end(), 0);
  std::ranges::sort(order, {}, [&](int f) { return std::tuple(!is_axis(area[f]), -area[f].squaredNorm(), f); });

  std::vector<Cluster> clusters;
  Clusters found(widest);
  for (const int f : order) {
    const Vector<3> n = area[f].normalized();
    int& cluster = cluster_of[f] = found.find(clusters, n, rounding[f]);
    if (cluster < 0) {
      cluster = static_cast<int>(clusters.size());
      clusters.push_back({n, rounding[f], is_axis(area[f])});
      found.add(cluster, n);
    }
    Cluster& of = clusters[cluster];
    const Vector<3> turned = of.normal.dot(n) > 0 ? area[f] : Vector<3>(-area[f]);
    of.area += turned;
    if (!counts.empty() && counts[f]) of.area_that_counts += turned;
  }
  std::vector<Vector<3>> normals(n_facets);
  for (int f = 0; f < n_facets; ++f) {
    const Cluster& of = clusters[cluster_of[f]];
    const Vector<3> sum = of.area_that_counts.isZero(0) ? of.area : of.area_that_counts;
    const Vector<3> shared = of.axis ? of.normal : Vector<3>(sum.normalized());
    normals[f] = shared.dot(area[f]) > 0 ? shared : Vector<3>(-shared);
  }
  return normals;
}

}  // namespace bracket::scene
