// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <iostream>

#include "apps/commands/commands.h"
#include "apps/commands/say.h"
#include "bounds/bounds.h"

namespace bracket::apps {
namespace {

void print_notes(const scene::Mesh<2>& mesh) {
  for (const std::string& note : mesh.notes) say_note(note);
}

std::string mesh_text(const scene::Mesh<2>& mesh) {
  const scene::Quality quality = scene::quality(mesh);
  return fmt::format("mesh: {} cells, {} vertices, {} edges; angles {:.1f} to {:.1f} degrees, areas {:.3g} to {:.3g}\n",
                     mesh.cells.size(), mesh.vertices.size(), mesh.edges.size(), quality.smallest_angle,
                     quality.largest_angle, quality.smallest_area, quality.largest_area);
}

std::string body_text(const scene::Mesh<2>& mesh, int body) {
  int cells = 0;
  double area = 0;
  for (int cell = 0; cell < static_cast<int>(mesh.cells.size()); ++cell) {
    if (mesh.cell_body[cell] != body) continue;
    ++cells;
    area += scene::volume(mesh, cell);
  }
  return fmt::format("  body {}: {} cells, area {:.6g}", mesh.bodies[body], cells, area);
}

// Edges and length of a boundary part; -1: of what belongs to no part. Empty if there are none.
std::string part_text(const scene::Mesh<2>& mesh, int part) {
  int edges = 0;
  double length = 0;
  for (int facet = 0; facet < static_cast<int>(mesh.boundary.size()); ++facet) {
    if (mesh.boundary[facet].part != part) continue;
    ++edges;
    length += scene::length(mesh, facet);
  }
  if (edges == 0 && part < 0) return "";
  return fmt::format("  {}: {} edges, length {:.6g}", part < 0 ? "without a name" : mesh.parts[part], edges, length);
}

const char* name(scene::ConditionKind kind) {
  switch (kind) {
    case scene::ConditionKind::fixed: return "fixed";
    case scene::ConditionKind::sliding: return "sliding";
    case scene::ConditionKind::traction: return "traction";
    case scene::ConditionKind::pressure: return "pressure";
  }
  return "";
}

std::string condition_text(const scene::Scene<2>& scene, const std::string& part) {
  for (const scene::ContactPair<2>& pair : scene.contact) {
    if (contains(pair.first, part))
      return "contact with " + (is_rigid(pair.second) ? "a rigid wall" : name(pair.second));
    if (contains(pair.second, part)) return "contact with " + name(pair.first);
  }
  const auto condition = scene.boundary.find(part);
  return condition == scene.boundary.end() ? "free" : name(condition->second.kind);
}

std::string pair_text(const scene::Scene<2>& scene, const scene::Problem<2>& problem, int pair) {
  int facets = 0;
  double smallest = 0, largest = 0;
  for (const scene::ContactFacet& facet : problem.contact) {
    if (facet.pair != pair) continue;
    const auto [low, high] = std::minmax({facet.lower[0], scene::at_middle(facet.lower), facet.lower[2]});
    smallest = facets == 0 ? low : std::min(smallest, low);
    largest = facets == 0 ? high : std::max(largest, high);
    ++facets;
  }
  return fmt::format("  {} on {}: {} edges; gap {:.4g} to {:.4g}\n", name(scene.contact[pair].first),
                     name(scene.contact[pair].second), facets, smallest, largest);
}

std::string problem_text(const scene::Scene<2>& scene, const scene::Problem<2>& problem) {
  const scene::Mesh<2>& mesh = problem.mesh;
  std::string text = fmt::format("{} (plane {}{})\n", scene.title, name(scene.plane),
                                 scene.units.empty() ? "" : "; units " + scene.units);
  text += mesh_text(mesh);
  for (int body = 0; body < static_cast<int>(mesh.bodies.size()); ++body) {
    const scene::Vector<2>& force = problem.bodies[body].force;
    text += body_text(mesh, body);
    if (!force.isZero(0)) text += fmt::format(", body force ({:.4g}, {:.4g})", force.x(), force.y());
    text += "\n";
  }
  text += "boundary:\n";
  for (int part = 0; part < static_cast<int>(mesh.parts.size()); ++part)
    text += fmt::format("{}: {}\n", part_text(mesh, part), condition_text(scene, mesh.parts[part]));
  if (const std::string unnamed = part_text(mesh, -1); !unnamed.empty()) text += unnamed + ": free\n";
  text += scene.contact.empty() ? "contact: none\n" : "contact:\n";
  for (int pair = 0; pair < static_cast<int>(scene.contact.size()); ++pair) text += pair_text(scene, problem, pair);
  return text + fmt::format("data oscillation: traction {:.1e}, displacement {:.1e}, gap {:.1e} of the largest value\n",
                            problem.oscillation.traction, problem.oscillation.displacement, problem.oscillation.gap);
}

}  // namespace

void check(const std::filesystem::path& file, const std::vector<std::string>& overrides) {
  const scene::Scene<2> scene = scene::read_scene<2>(file, overrides);
  const scene::Problem<2> problem = scene::fix_data(scene, scene::build_mesh(scene));
  print_notes(problem.mesh);
  std::cout << problem_text(scene, problem) << std::flush;
  const double imbalance = bounds::balanced(problem, scene.solve.degree).imbalance;
  std::cout << fmt::format("solvable: supports and contact can balance the loads (imbalance removed: {:.1e})\n",
                           imbalance);
}

void info(const std::filesystem::path& file) {
  const scene::Mesh<2> mesh = scene::read_mesh<2>(file);
  print_notes(mesh);
  std::cout << mesh_text(mesh);
  for (int body = 0; body < static_cast<int>(mesh.bodies.size()); ++body) std::cout << body_text(mesh, body) << "\n";
  std::cout << "boundary:\n";
  for (int part = 0; part < static_cast<int>(mesh.parts.size()); ++part) std::cout << part_text(mesh, part) << "\n";
  if (const std::string unnamed = part_text(mesh, -1); !unnamed.empty()) std::cout << unnamed << "\n";
}

}  // namespace bracket::apps
