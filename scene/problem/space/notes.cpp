// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// In space: boundary faces that turn at their edges.
#include "scene/problem/notes.h"

#include <fmt/format.h>

#include <map>
#include <numbers>

#include "scene/text.h"

namespace bracket::scene {

namespace {

struct TurnAtEdge {
  double angle = 0;  ///< degrees, the largest
  int edge = -1;
};

}  // namespace

std::vector<std::string> notes_on_lines(const Scene<3>&, const Problem<3>& problem) {
  const Mesh<3>& mesh = problem.mesh;
  std::vector<char> acts(problem.facets.size(), 0);
  for (std::size_t f = 0; f < problem.facets.size(); ++f) acts[f] = problem.facets[f].support == Support::sliding;
  for (const ContactFacetOf<3>& pair : problem.contact) acts[pair.first] = 1;
  std::vector<int> beside(mesh.edges.size(), -1);
  std::map<int, TurnAtEdge> turns;  // of each part
  for (std::size_t f = 0; f < mesh.boundary.size(); ++f) {
    if (!acts[f] || mesh.boundary[f].part < 0) continue;
    for (const int edge : facet_edges(mesh, mesh.boundary[f])) {
      const int other = beside[edge];
      beside[edge] = static_cast<int>(f);
      if (other < 0 || mesh.boundary[other].part != mesh.boundary[f].part) continue;
      const Vector<3>&one = problem.facets[f].normal, &next = problem.facets[other].normal;
      const double angle = std::atan2(one.cross(next).norm(), one.dot(next)) * 180 / std::numbers::pi;
      TurnAtEdge& turn = turns[mesh.boundary[f].part];
      if (angle <= 20 && angle > turn.angle) turn = {angle, edge};
    }
  }
  std::vector<std::string> notes;
  for (const auto& [part, turn] : turns) {
    if (turn.edge < 0) continue;
    const auto [a, b] = positions(mesh, mesh.edges[turn.edge]);
    notes.push_back(
        fmt::format("'{}' slides or touches and turns at its edges, by up to {:.3g} degrees at {}: what is solved is "
                    "that polyhedron, "
                    "whose pressure peaks at the edges and grows with refinement",
                    mesh.parts[part], turn.angle, point(Vector<3>(0.5 * (a + b)))));
  }
  return notes;
}

}  // namespace bracket::scene
