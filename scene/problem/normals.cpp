// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// Planar: normals by their angle, facets in chains.
#include "scene/problem/normals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <span>

namespace bracket::scene {

namespace {

/// A boundary facet and the angle of its normal, modulo π.
struct Line {
  double angle;
  int facet;
  double rounding;  ///< by which the angle may be off, as coordinates are rounded
};

double rounding_of_angle(const Mesh<2>& mesh, int facet) {
  constexpr double of_doubles = 0.5e-6, most = 1e-3;
  double size = 0;
  for (const Vector<2>& x : positions(mesh, mesh.boundary[facet].vertices))
    size = std::max(size, x.lpNorm<Eigen::Infinity>());
  return std::clamp(3 * mesh.coordinate_rounding * size / length(mesh, facet), of_doubles, most);  // 2 √2 rounded up
}

Line line(const Mesh<2>& mesh, int facet) {
  const Vector<2> n = normal(mesh, facet);
  const bool upper = n[1] > 0 || (n[1] == 0 && n[0] > 0);
  return {upper ? std::atan2(n[1], n[0]) : std::atan2(-n[1], -n[0]), facet, rounding_of_angle(mesh, facet)};
}

/// All boundary facets by angle, which begins behind the widest gap on the circle of lines.
std::vector<Line> sorted_lines(const Mesh<2>& mesh) {
  std::vector<Line> lines;
  for (std::size_t facet = 0; facet < mesh.boundary.size(); ++facet)
    lines.push_back(line(mesh, static_cast<int>(facet)));
  std::sort(lines.begin(), lines.end(),
            [](const Line& a, const Line& b) { return std::pair(a.angle, a.facet) < std::pair(b.angle, b.facet); });
  std::size_t begin = 0;
  double widest = lines.front().angle + std::numbers::pi - lines.back().angle;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    if (lines[i].angle - lines[i - 1].angle <= widest) continue;
    widest = lines[i].angle - lines[i - 1].angle;
    begin = i;
  }
  for (std::size_t i = 0; i < begin; ++i) lines[i].angle += std::numbers::pi;
  std::rotate(lines.begin(), lines.begin() + static_cast<std::ptrdiff_t>(begin), lines.end());
  return lines;
}

/// Cuts where neighbours differ by more than `scale` times their rounding, and finer what hangs together over more than
/// ten of the largest such steps. It ends at the latest when only equal angles hang together.
std::vector<std::span<const Line>> clusters(std::span<const Line> lines, double scale = 1) {
  std::vector<std::span<const Line>> result;
  for (std::size_t from = 0, to = 1; from < lines.size(); from = to++) {
    double step = 0;
    for (; to < lines.size(); ++to) {
      const double own = scale * (lines[to].rounding + lines[to - 1].rounding);
      if (lines[to].angle - lines[to - 1].angle > own) break;
      step = std::max(step, own);
    }
    const auto cluster = lines.subspan(from, to - from);
    if (cluster.back().angle - cluster.front().angle <= 10 * step) {
      result.push_back(cluster);
    } else {
      const auto finer = clusters(cluster, scale / 10);
      result.insert(result.end(), finer.begin(), finer.end());
    }
  }
  return result;
}

/// The facets of a cluster that `counts` names, put together where one ends and the next begins with the same normal,
/// not its opposite (as at the tip of a crack), from end to end.
std::vector<std::array<int, 2>> chains(const Mesh<2>& mesh, std::span<const Line> cluster,
                                       const std::vector<char>& counts) {
  struct OtherEnds {
    std::map<int, int> to, from;  // the other end of the chain that begins, or ends, at a vertex
  };
  std::array<OtherEnds, 2> sides;
  const Vector<2> reference = normal(mesh, cluster.front().facet);
  for (const Line& line : cluster) {
    if (!counts.empty() && !counts[line.facet]) continue;
    auto& [to, from] = sides[normal(mesh, line.facet).dot(reference) > 0 ? 0 : 1];
    auto [begin, end] = mesh.boundary[line.facet].vertices;
    if (const auto before = from.find(begin); before != from.end()) {
      begin = before->second;
      from.erase(before);
    }
    if (const auto behind = to.find(end); behind != to.end()) {
      const int last = behind->second;
      to.erase(behind);
      end = last;
    }
    to[begin] = end;
    from[end] = begin;
  }
  std::vector<std::array<int, 2>> result;
  for (const OtherEnds& side : sides)
    for (const auto& [begin, end] : side.to) result.push_back({begin, end});
  return result;
}

/// The normal that stands for a cluster.
Vector<2> direction(const Mesh<2>& mesh, std::span<const Line> cluster, const std::vector<char>& counts) {
  auto lines = chains(mesh, cluster, counts);
  if (lines.empty()) lines = chains(mesh, cluster, {});
  const auto across = [&](const std::array<int, 2>& ends) { return area_vector<2>(positions(mesh, ends)); };
  const auto rank = [&](const std::array<int, 2>& ends) {
    return std::pair((across(ends).array() == 0).any(), across(ends).norm());
  };
  const auto best =
      std::max_element(lines.begin(), lines.end(), [&](const auto& a, const auto& b) { return rank(a) < rank(b); });
  return across(*best).normalized();
}

}  // namespace

std::vector<Vector<2>> shared_normals(const Mesh<2>& mesh, const std::vector<char>& counts) {
  std::vector<Vector<2>> normals(mesh.boundary.size());
  const std::vector<Line> lines = sorted_lines(mesh);
  for (const auto& cluster : clusters(lines)) {
    const Vector<2> shared = direction(mesh, cluster, counts);
    for (const Line& line : cluster)
      normals[line.facet] = shared.dot(normal(mesh, line.facet)) > 0 ? shared : Vector<2>(-shared);
  }
  return normals;
}

}  // namespace bracket::scene
