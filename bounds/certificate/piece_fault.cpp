// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "bounds/certificate/problem_faults.h"

namespace bracket::bounds {

using scene::Problem;

namespace {

/// A point of the first mesh: its vertices around it, by number, and their weights; those without are left out.
using Point = std::array<std::pair<int, double>, 3>;
constexpr std::pair<int, double> nothing = {std::numeric_limits<int>::max(), 0};

Point sorted(Point point) {
  for (auto& [vertex, weight] : point)
    if (weight == 0) vertex = nothing.first;
  std::ranges::sort(point);
  return point;
}

Point corner_of(const scene::Mesh<2>& first, const scene::Piece<2>& piece, int i) {
  const auto& [x, y] = piece.corner[i];
  const auto& v = first.cells[piece.of];
  return sorted({{{v[0], (1 - x) - y}, {v[1], x}, {v[2], y}}});
}

bool is_same(const scene::Material<2>& a, const scene::Material<2>& b) {
  const auto &one = a.constants(), &other = b.constants();
  if (one.has_value() != other.has_value() || a.stiffness() != b.stiffness()) return false;
  return !one || (one->young == other->young && one->poisson == other->poisson && one->plane == other->plane);
}

}  // namespace

std::string piece_fault(const Problem<2>& problem) {
  const Problem<2>& first = scene::first_of(problem);
  const auto& mesh = problem.mesh;
  const auto& origin = problem.origin;
  if (origin.cells.size() != mesh.cells.size() || origin.facets.size() != mesh.boundary.size())
    return "the pieces of the first mesh and the mesh differ in number";
  const auto dyadic = [](double x) { return x >= 0 && x <= 1 && (1 + x) - 1 == x; };
  std::vector<Point> points(mesh.vertices.size(), {nothing, nothing, nothing});
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    const auto& piece = origin.cells[c];
    if (!in_range(piece.of, first.mesh.cells.size()) || first.mesh.cell_body[piece.of] != mesh.cell_body[c] ||
        first.mesh.cell_component[piece.of] != mesh.cell_component[c])
      return fmt::format("cell {} is no piece of a cell of its body and component on the first mesh", c);
    for (int i = 0; i < 3; ++i) {
      const auto& [x, y] = piece.corner[i];
      if (!dyadic(x) || !dyadic(y) || x + y > 1) return fmt::format("cell {} lies outside of its first cell", c);
      Point& known = points[mesh.cells[c][i]];
      const Point own = corner_of(first.mesh, piece, i);
      if (known[0] == nothing) known = own;
      if (known != own) return fmt::format("the cells at vertex {} do not meet in one point", mesh.cells[c][i]);
    }
  }
  std::vector<double> covered(first.facets.size(), 0);
  for (std::size_t f = 0; f < mesh.boundary.size(); ++f) {
    const auto& [of, corner] = origin.facets[f];
    if (!in_range(of, first.facets.size()) || !(corner[0][0] < corner[1][0]))
      return fmt::format("boundary facet {} is no piece of a facet of the first mesh", f);
    const auto& ends = first.mesh.boundary[of].vertices;
    for (int i = 0; i < 2; ++i) {
      const double t = corner[i][0];
      if (!dyadic(t) || points[mesh.boundary[f].vertices[i]] != sorted({{{ends[0], 1 - t}, {ends[1], t}, nothing}}))
        return fmt::format("boundary facet {} does not lie on its facet of the first mesh", f);
    }
    covered[of] += corner[1][0] - corner[0][0];
    if (problem.facets[f].support != first.facets[of].support || problem.facets[f].normal != first.facets[of].normal)
      return fmt::format("boundary facet {} has another support or direction than on the first mesh", f);
  }
  for (const double width : covered)
    if (width != 1) return "a facet of the first mesh is not covered by its pieces";
  return "";
}

std::string body_fault(const Problem<2>& problem) {
  const Problem<2>& first = scene::first_of(problem);
  const auto& by = problem.perturbed.by;
  if (problem.bodies.size() != first.bodies.size()) return "there are other bodies than on the first mesh";
  for (std::size_t b = 0; b < problem.bodies.size(); ++b) {
    const auto &body = problem.bodies[b], &known = first.bodies[b];
    const bool is_perturbed = by && !by->force[b].isZero(0);  // then the sum is formed from what the first mesh has
    if (!is_same(body.material, known.material) || (!is_perturbed && body.force != known.force))
      return fmt::format("'{}' has another material or weight than on the first mesh", problem.mesh.bodies[b]);
  }
  return "";
}

}  // namespace bracket::bounds
