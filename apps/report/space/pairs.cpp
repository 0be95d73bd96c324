// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// In space: contact faces in place of lines.
#include "apps/report/pairs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "apps/report/samples.h"

namespace bracket::apps {
namespace {

using scene::Vector;

using Edge = std::array<int, 2>;  // by its vertices, the lower one first

std::array<Edge, 3> edges_of(const scene::Mesh<3>& mesh, int facet) {
  const auto& v = mesh.boundary[facet].vertices;
  std::array<Edge, 3> edges;
  for (int e = 0; e < 3; ++e) {
    const auto& [a, b] = scene::Simplex<2>::edges[e];
    edges[e] = {std::min(v[a], v[b]), std::max(v[a], v[b])};
  }
  return edges;
}

/// Why the pressure grows with refinement at a vertex of a pair's first side; empty: it does not. The rim of that side
/// is none where it lies in a plane of symmetry, on faces that slide along the contact's direction: there the contact
/// goes on beyond it.
std::string growth_at(const scene::Problem<3>& problem, int pair, int vertex) {
  std::map<Edge, std::vector<int>> faces_at;  // those of the side
  for (const auto& contact : problem.contact)
    if (contact.pair == pair)
      for (const Edge& edge : edges_of(problem.mesh, contact.first))
        if (edge[0] == vertex || edge[1] == vertex) faces_at[edge].push_back(contact.first);
  const auto on_symmetry = [&](const Edge& edge, const Vector<3>& d) {
    for (std::size_t f = 0; f < problem.facets.size(); ++f) {
      const auto& data = problem.facets[f];
      if (data.support != scene::Support::sliding || std::abs(data.normal.dot(d)) >= 0.1) continue;
      const auto edges = edges_of(problem.mesh, static_cast<int>(f));
      if (std::ranges::find(edges, edge) != edges.end()) return true;
    }
    return false;
  };
  std::string turns;
  for (const auto& [edge, faces] : faces_at) {
    const Vector<3>& d = problem.facets[faces[0]].normal;
    if (faces.size() == 1 && !on_symmetry(edge, d)) return "an end of the contact face";
    if (faces.size() == 2 && problem.facets[faces[1]].normal != d) turns = "an edge at which the contact face turns";
  }
  return turns;
}

}  // namespace

template <> PairSummary<3> summary(const ReportOf<3>& report, int pair) {
  const scene::Problem<3>& problem = report.outcome.problem;
  const double rounding = rounding_of_pressure(problem, report.outcome.stress, report.contact, pair);
  PairSummary<3> result;
  int most_pressed = -1;  // a vertex
  for (std::size_t i = 0; i < problem.contact.size(); ++i) {
    if (problem.contact[i].pair != pair) continue;
    const int first = problem.contact[i].first;
    const auto& vertices = problem.mesh.boundary[first].vertices;
    const double area = scene::length(problem.mesh, first);
    const std::vector<double>& pressure = report.contact[i].pressure;  // linear: at the vertices
    for (int k = 0; k < 3; ++k) {
      result.force += area * pressure[k] / 3;
      result.largest_tension = std::max(result.largest_tension, -pressure[k]);
      if (pressure[k] <= std::max(result.largest_pressure, rounding)) continue;
      result.largest_pressure = pressure[k];
      most_pressed = vertices[k];
    }
    result.length += area;
    if (presses(report.contact[i], rounding)) result.pressed_length += area;
    scene::FacetQuadratic<3> left;
    std::ranges::copy(report.contact[i].gap_left, left.begin());
    const auto gaps = quadratic_at_nodes<3>(left);
    for (int k = 0; k < 6; ++k) {
      if (gaps[k] <= result.largest_gap) continue;
      result.largest_gap = gaps[k];
      const auto at = [&](int vertex) { return problem.mesh.vertices[vertices[vertex]]; };
      if (k < 3) {
        result.gap_at = at(k);
      } else {
        const auto& [a, b] = scene::Simplex<2>::edges[k - 3];
        result.gap_at = (at(a) + at(b)) / 2;
      }
    }
  }
  if (most_pressed < 0) return result;
  result.at = problem.mesh.vertices[most_pressed];
  result.grows = growth_at(problem, pair, most_pressed);
  return result;
}

}  // namespace bracket::apps
