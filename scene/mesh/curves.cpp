// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// Planar: arcs of circles.
#include "scene/mesh/curves.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <set>

#include "scene/text.h"

namespace bracket::scene {

namespace {

std::vector<Vector<2>> vertices_of(const Mesh<2>& mesh, int part) {
  std::set<int> vertices;
  for (const auto& facet : mesh.boundary)
    if (facet.part == part) vertices.insert(facet.vertices.begin(), facet.vertices.end());
  std::vector<Vector<2>> points;
  for (const int vertex : vertices) points.push_back(mesh.vertices[vertex]);
  return points;
}

/// The circle |x|² = 2 c·x + (r² − |c|²) of least squares, about the points' mean; a radius that is not finite: none.
Circle through(const std::vector<Vector<2>>& points) {
  Vector<2> mean = Vector<2>::Zero();
  for (const Vector<2>& x : points) mean += x / static_cast<double>(points.size());
  Eigen::MatrixX3d matrix(points.size(), 3);
  Eigen::VectorXd right(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vector<2> x = points[i] - mean;
    matrix.row(static_cast<Eigen::Index>(i)) << 2 * x[0], 2 * x[1], 1;
    right[static_cast<Eigen::Index>(i)] = x.squaredNorm();
  }
  const Eigen::ColPivHouseholderQR<Eigen::MatrixX3d> qr(matrix);
  if (qr.rank() < 3) return {mean, std::numeric_limits<double>::infinity()};
  const Eigen::Vector3d solution = qr.solve(right);
  return {mean + solution.head<2>(), std::sqrt(solution[2] + solution.head<2>().squaredNorm())};
}

}  // namespace

Vector<2> onto(const Circle& circle, const Vector<2>& x) {
  return circle.center + circle.radius * (x - circle.center).normalized();
}

Arcs arcs_of(const Scene<2>& scene, const Mesh<2>& mesh) {
  Arcs arcs(mesh.parts.size());
  for (const auto& [name, curve] : scene.curves) {
    const auto found = std::find(mesh.parts.begin(), mesh.parts.end(), name);
    if (found == mesh.parts.end())
      fail(Status::input, curve.where,
           fmt::format("the mesh has no boundary part '{}': {}", name, suggestion(name, mesh.parts)));
    const int part = static_cast<int>(found - mesh.parts.begin());
    const std::vector<Vector<2>> points = vertices_of(mesh, part);
    const Circle circle = curve.circle ? *curve.circle : through(points);
    double off = std::isfinite(circle.radius) ? 0 : std::numeric_limits<double>::infinity(), size = 0;
    for (const Vector<2>& x : points) {
      off = std::max(off, std::abs((x - circle.center).norm() - circle.radius));
      size = std::max(size, x.lpNorm<Eigen::Infinity>());
    }
    if (!(off <= std::max(1e-5 * circle.radius, 16 * mesh.coordinate_rounding * size)))
      fail(Status::mesh, curve.where,
           fmt::format("'{}' does not lie on {}: vertices are up to {:.3g} off; expected at most a hundred-thousandth "
                       "of the radius",
                       name,
                       curve.circle
                           ? fmt::format("the circle about {} of radius {:.7g}", point(circle.center), circle.radius)
                           : "a circle",
                       off));
    arcs[part] = circle;
  }
  return arcs;
}

Mesh<2> with_new_vertices_on_arcs(Mesh<2> mesh, const Arcs& arcs, std::size_t old) {
  for (const auto& facet : mesh.boundary) {
    if (facet.part == -1 || !arcs[facet.part]) continue;
    for (const int vertex : facet.vertices)
      if (static_cast<std::size_t>(vertex) >= old)
        mesh.vertices[vertex] = onto(*arcs[facet.part], mesh.vertices[vertex]);
  }
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
    if (!(volume(mesh, static_cast<int>(cell)) > 0))
      fail(Status::mesh, "",
           fmt::format("putting vertices on an arc turns the cell at {} over; mesh the arc more finely",
                       point(mesh.vertices[mesh.cells[cell][0]])));
  return mesh;
}

}  // namespace bracket::scene
