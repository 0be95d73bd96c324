// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>

#include "apps/plots/space/pictures.h"
#include "apps/report/space/cell_values.h"
#include "apps/report/stresses.h"

namespace bracket::apps {

using scene::Vector;

namespace {

/// Where a plane cuts a tetrahedron, as barycentric points around the polygon: none, three or four. What lies in the
/// plane counts as above, so that a face in it belongs to the tetrahedron below alone.
std::vector<InCell> cut(const std::array<double, 4>& height) {
  std::vector<int> above, below;
  for (int i = 0; i < 4; ++i) (height[i] >= 0 ? above : below).push_back(i);
  const auto between = [&](int a, int b) {
    InCell point = {};
    point[b] = height[a] / (height[a] - height[b]);
    point[a] = 1 - point[b];
    return point;
  };
  if (above.empty() || below.empty()) return {};
  if (above.size() == 2)
    return {between(above[0], below[0]), between(above[0], below[1]), between(above[1], below[1]),
            between(above[1], below[0])};
  std::vector<InCell> polygon;
  for (const int a : above)
    for (const int b : below) polygon.push_back(between(a, b));
  return polygon;
}

/// \param side 1 or −1: which way is up
std::vector<Tessera> cut_cells(const bounds::Outcome<3>& run, const DrawnShapeOf<3>& shape, int axis, double at,
                               const std::array<int, 2>& plane, int side) {
  const scene::Mesh<3>& mesh = run.problem.mesh;
  std::vector<Tessera> pieces;
  for (int cell = 0; cell < static_cast<int>(mesh.cells.size()); ++cell) {
    const auto x = scene::positions(mesh, mesh.cells[cell]);
    std::array<double, 4> height;
    for (int i = 0; i < 4; ++i) height[i] = side * (x[i][axis] - at);
    if (cut(height).empty()) continue;
    const auto sigma = bounds::displacement_stress(run.problem, run.displacement, cell);
    const double centre = (height[0] + height[1] + height[2] + height[3]) / 4;
    for (int part = 0; part < 4; ++part) {
      const auto& [a, b, c] = scene::Simplex<3>::facets[part];
      const std::vector<InCell> polygon = cut({height[a], height[b], height[c], centre});
      if (polygon.empty()) continue;
      Tessera piece;
      InCell middle = {};
      for (const InCell& corner : polygon) {
        const InCell point = in_cell(part, corner);
        const Vector<3> drawn = value_in(point, x) + way_drawn(run.problem, run.displacement, shape, cell, point, -1);
        piece.corner.emplace_back(drawn[plane[0]], drawn[plane[1]]);
        for (int k = 0; k < 4; ++k) middle[k] += corner[k] / static_cast<double>(polygon.size());
      }
      for (std::size_t i = 0; i < polygon.size(); ++i)  // sides on the part's facet
        piece.outlined.push_back(polygon[i][3] == 0 && polygon[(i + 1) % polygon.size()][3] == 0);
      piece.value = von_mises(mean_stress(sigma, run.stress, cell, part, middle));
      pieces.push_back(std::move(piece));
    }
  }
  return pieces;
}

}  // namespace

std::vector<Tessera> slice(const bounds::Outcome<3>& run, const DrawnShapeOf<3>& shape, int axis, double at,
                           const std::array<int, 2>& plane) {
  const std::vector<Tessera> pieces = cut_cells(run, shape, axis, at, plane, 1);
  return pieces.empty() ? cut_cells(run, shape, axis, at, plane, -1) : pieces;  // where all lies above the plane
}

}  // namespace bracket::apps
