// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// Planar: boundary lines that turn at their vertices.
#include "scene/problem/notes.h"

#include <fmt/format.h>

#include <limits>
#include <map>

#include "scene/mesh/angles.h"
#include "scene/text.h"

namespace bracket::scene {

namespace {

/// Of each facet, whether it slides or is the first side of a contact.
std::vector<char> acting(const Problem<2>& problem) {
  std::vector<char> acts(problem.facets.size(), 0);
  for (std::size_t f = 0; f < problem.facets.size(); ++f) acts[f] = problem.facets[f].support == Support::sliding;
  for (const ContactFacet& pair : problem.contact) acts[pair.first] = 1;
  return acts;
}

std::string straightened(const Problem<2>& problem, const std::vector<char>& acts) {
  if (problem.mesh.coordinate_rounding <= std::numeric_limits<double>::epsilon()) return "";
  double most = 0;
  for (std::size_t f = 0; f < problem.facets.size(); ++f)
    if (acts[f])
      most = std::max(most, std::abs(cross(normal(problem.mesh, static_cast<int>(f)), problem.facets[f].normal)));
  if (most <= 1e-6) return "";
  return fmt::format(
      "sliding and contact act along straight lines: edges turned by up to {:.2g} rad, which the digits of the mesh's "
      "coordinates leave open, are taken for one line",
      most);
}

/// How a part turns at its vertices.
struct Turn {
  double angle = 0;   ///< radians, the largest
  double height = 0;  ///< of an arc above its chords, by these angles: length · angle / 8
  Vector<2> at = Vector<2>::Zero();
};

}  // namespace

std::vector<std::string> notes_on_lines(const Scene<2>& scene, const Problem<2>& problem) {
  const Mesh<2>& mesh = problem.mesh;
  const std::vector<char> acts = acting(problem);
  std::vector<std::string> notes;
  if (std::string note = straightened(problem, acts); !note.empty()) notes.push_back(std::move(note));

  std::vector<int> begins(mesh.vertices.size(), -1);
  for (std::size_t f = 0; f < mesh.boundary.size(); ++f) begins[mesh.boundary[f].vertices[0]] = static_cast<int>(f);
  std::map<int, Turn> turns;  // of each part
  for (std::size_t f = 0; f < mesh.boundary.size(); ++f) {
    const int facet = static_cast<int>(f), next = begins[mesh.boundary[f].vertices[1]], part = mesh.boundary[f].part;
    if (next < 0 || mesh.boundary[next].part != part || !acts[f] || !acts[next]) continue;
    const Vector<2>&one = problem.facets[f].normal, &other = problem.facets[next].normal;
    const double angle = std::abs(std::atan2(cross(one, other), one.dot(other)));
    if (angle == 0 || angle > radians(20)) continue;
    Turn& turn = turns[part];
    turn.height = std::max(turn.height, std::max(length(mesh, facet), length(mesh, next)) * angle / 8);
    if (angle > turn.angle) {
      turn.angle = angle;
      turn.at = mesh.vertices[mesh.boundary[f].vertices[1]];
    }
  }
  for (const auto& [part, turn] : turns) {
    if (scene.curves.contains(mesh.parts[part])) continue;
    notes.push_back(fmt::format(
        "'{}' slides or touches and turns at its vertices, by up to {:.3g} degrees at {}: what is solved is that "
        "polygon, whose pressure peaks at the vertices and grows with refinement; an arc would bulge by {:.2g}; "
        "if it is one, declare it in [curves]",
        mesh.parts[part], turn.angle * 180 / std::numbers::pi, point(turn.at), turn.height));
  }
  return notes;
}

}  // namespace bracket::scene
