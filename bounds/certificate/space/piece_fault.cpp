// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "bounds/certificate/space/exact_rank.h"
#include "bounds/certificate/space/geometry.h"
#include "bounds/certificate/space/problem_faults.h"

namespace bracket::bounds::space {

using scene::Problem;

namespace {

/// A point of the first mesh: its vertices around it, by number, and their weights; those without are left out.
using Point = std::array<std::pair<int, double>, 4>;
constexpr std::pair<int, double> nothing = {std::numeric_limits<int>::max(), 0};

/// \param at coordinates 1 … d of it   \param v the vertices of the simplex
template <std::size_t d> Point point(const std::array<double, d>& at, const std::array<int, d + 1>& v) {
  Point result = {nothing, nothing, nothing, nothing};
  double first = 1;
  for (std::size_t k = 0; k < d; ++k) {
    first -= at[k];
    if (at[k] != 0) result[k + 1] = {v[k + 1], at[k]};
  }
  if (first != 0) result[0] = {v[0], first};
  std::ranges::sort(result);
  return result;
}

/// Whether it lies in the simplex and its coordinates have at most 52 places, so that they and their sums are exact.
template <std::size_t d> bool is_dyadic(const std::array<double, d>& at) {
  double sum = 0;
  for (const double x : at) {
    if (!(x >= 0 && x <= 1 && (1 + x) - 1 == x)) return false;
    sum += x;
  }
  return sum <= 1;
}

bool is_same(const scene::Material<3>& a, const scene::Material<3>& b) {
  const auto &one = a.constants(), &other = b.constants();
  if (one.has_value() != other.has_value() || a.stiffness() != b.stiffness()) return false;
  return !one || (one->young == other->young && one->poisson == other->poisson);
}

std::string body_fault(const Problem<3>& problem) {
  const Problem<3>& first = scene::first_of(problem);
  if (problem.bodies.size() != first.bodies.size()) return "there are other bodies than on the first mesh";
  const auto& by = problem.perturbed.by;
  for (std::size_t b = 0; b < problem.bodies.size(); ++b)
    if (const bool is_perturbed = by && !by->force[b].isZero(0);  // then the sum is formed from what the first mesh has
        !is_same(problem.bodies[b].material, first.bodies[b].material) ||
        (!is_perturbed && problem.bodies[b].force != first.bodies[b].force))
      return fmt::format("'{}' has another material or weight than on the first mesh", problem.mesh.bodies[b]);
  return "";
}

std::string cell_fault(const Problem<3>& problem, std::vector<Point>& points) {
  const Problem<3>& first = scene::first_of(problem);
  const auto& mesh = problem.mesh;
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    const auto& piece = problem.origin.cells[c];
    if (!in_range(piece.of, first.mesh.cells.size()) || first.mesh.cell_body[piece.of] != mesh.cell_body[c] ||
        first.mesh.cell_component[piece.of] != mesh.cell_component[c])
      return fmt::format("cell {} is no piece of a cell of its body and component on the first mesh", c);
    for (int i = 0; i < 4; ++i) {
      if (!is_dyadic(piece.corner[i])) return fmt::format("cell {} lies outside of its first cell", c);
      Point& known = points[mesh.cells[c][i]];
      const Point own = point(piece.corner[i], first.mesh.cells[piece.of]);
      if (known[0] == nothing) known = own;
      if (known != own) return fmt::format("the cells at vertex {} do not meet in one point", mesh.cells[c][i]);
    }
  }
  return "";
}

}  // namespace

std::string piece_fault(const Problem<3>& problem) {
  const Problem<3>& first = scene::first_of(problem);
  const auto& mesh = problem.mesh;
  if (std::string fault = body_fault(problem); !fault.empty()) return fault;
  if (problem.origin.cells.size() != mesh.cells.size() || problem.origin.facets.size() != mesh.boundary.size())
    return "the pieces of the first mesh and the mesh differ in number";
  std::vector<Point> points(mesh.vertices.size(), {nothing, nothing, nothing, nothing});
  if (std::string fault = cell_fault(problem, points); !fault.empty()) return fault;
  std::vector<Rational> covered(first.facets.size(), Rational(0));
  for (std::size_t f = 0; f < mesh.boundary.size(); ++f) {
    const auto& piece = problem.origin.facets[f];
    if (!in_range(piece.of, first.facets.size()) || !std::ranges::all_of(piece.corner, is_dyadic<2>))
      return fmt::format("boundary facet {} is no piece of a facet of the first mesh", f);
    for (int i = 0; i < 3; ++i)
      if (points[mesh.boundary[f].vertices[i]] != point(piece.corner[i], first.mesh.boundary[piece.of].vertices))
        return fmt::format("boundary facet {} does not lie on its facet of the first mesh", f);
    const auto part = fraction<Rational>(piece);
    if (part <= 0) return fmt::format("boundary facet {} lies the other way round than on the first mesh", f);
    covered[piece.of] += part;
    if (problem.facets[f].support != first.facets[piece.of].support ||
        problem.facets[f].normal != first.facets[piece.of].normal)
      return fmt::format("boundary facet {} has another support or direction than on the first mesh", f);
  }
  for (const Rational& part : covered)
    if (part != 1) return "a facet of the first mesh is not covered by its pieces";
  return "";
}

}  // namespace bracket::bounds::space
