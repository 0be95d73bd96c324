// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <iostream>

#include "apps/commands/commands.h"
#include "apps/commands/say.h"
#include "apps/report/json.h"
#include "apps/report/lines.h"
#include "apps/report/pairs.h"
#include "apps/report/units.h"
#include "bounds/asked.h"
#include "bounds/bounds.h"

namespace bracket::apps {
namespace {

using Json = nlohmann::ordered_json;

void print_notes(const scene::Mesh<2>& mesh) {
  for (const std::string& note : mesh.notes) say_note(note);
}

/// What is told of a body or boundary part of a mesh.
struct Body {
  std::string name;
  int cells = 0;
  double area = 0;
};
struct Part {
  std::string name;  ///< empty: of what belongs to none
  int edges = 0;
  double length = 0;
};

std::vector<Body> bodies_of(const scene::Mesh<2>& mesh) {
  std::vector<Body> bodies;
  for (const std::string& name : mesh.bodies) bodies.push_back({.name = name});
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) {
    Body& body = bodies[mesh.cell_body[cell]];
    ++body.cells;
    body.area += scene::volume(mesh, static_cast<int>(cell));
  }
  return bodies;
}

/// The last is what belongs to none, if there is any.
std::vector<Part> parts_of(const scene::Mesh<2>& mesh) {
  std::vector<Part> parts;
  for (const std::string& name : mesh.parts) parts.push_back({.name = name});
  parts.emplace_back();
  for (std::size_t facet = 0; facet < mesh.boundary.size(); ++facet) {
    const int of = mesh.boundary[facet].part;
    Part& part = of == -1 ? parts.back() : parts[of];
    ++part.edges;
    part.length += scene::length(mesh, static_cast<int>(facet));
  }
  if (parts.back().edges == 0) parts.pop_back();
  return parts;
}

std::string mesh_text(const scene::Mesh<2>& mesh, const Units& units) {
  const scene::Quality quality = scene::quality(mesh);
  return fmt::format(
      "mesh: {} cells, {} vertices, {} edges\n  angles {:.1f} to {:.1f} degrees, areas {:.3g} to {:.3g}{}\n",
      mesh.cells.size(), mesh.vertices.size(), mesh.edges.size(), quality.smallest_angle, quality.largest_angle,
      quality.smallest_area, quality.largest_area, units.area);
}

Json mesh_json(const scene::Mesh<2>& mesh) {
  return {{"cells", mesh.cells.size()},
          {"vertices", mesh.vertices.size()},
          {"edges", mesh.edges.size()},
          {"components", mesh.components},
          {"quality", quality_json(mesh)}};
}

std::string text(const Body& body, const Units& units) {
  return fmt::format("  body {}: {} cells, area {:.6g}{}", body.name, body.cells, body.area, units.area);
}
Json json(const Body& body) { return {{"name", body.name}, {"cells", body.cells}, {"area", body.area}}; }

std::string text(const Part& part, const Units& units) {
  return fmt::format("  {}: {} edges, length {:.6g}{}", part.name.empty() ? "without a name" : part.name, part.edges,
                     part.length, units.length);
}
Json json(const Part& part) {
  return {{"name", part.name.empty() ? Json() : Json(part.name)}, {"edges", part.edges}, {"length", part.length}};
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
    if (contains(pair.first, part)) return "contact with " + name(pair.second);
    if (contains(pair.second, part)) return "contact with " + name(pair.first);
  }
  for (const scene::Bond& bond : scene.bonds) {
    if (contains(bond.first, part)) return "bonded to " + name(bond.second) + ", inside of one piece";
    if (contains(bond.second, part)) return "bonded to " + name(bond.first) + ", inside of one piece";
  }
  const auto condition = scene.boundary.find(part);
  return condition == scene.boundary.end() ? "free" : name(condition->second.kind);
}

/// What is told of a contact pair.
struct Pair {
  const scene::ContactPair<2>& sides;
  int facets = 0;
  double smallest = 0, largest = 0;  ///< gap
};

Pair pair_of(const scene::Scene<2>& scene, const scene::Problem<2>& problem, int number) {
  Pair pair{scene.contact[number]};
  for (const scene::ContactFacet& facet : problem.contact) {
    if (facet.pair != number) continue;
    const auto [low, high] = std::minmax({facet.lower[0], scene::at_middle(facet.lower), facet.lower[2]});
    pair.smallest = pair.facets == 0 ? low : std::min(pair.smallest, low);
    pair.largest = pair.facets == 0 ? high : std::max(pair.largest, high);
    ++pair.facets;
  }
  return pair;
}

std::string text(const Pair& pair, const Units& units) {
  return fmt::format("  {} on {}, {}: {} edges; gap {:.4g} to {:.4g}{}\n", name(pair.sides.first),
                     name(pair.sides.second), law_text(pair.sides), pair.facets, pair.smallest, pair.largest,
                     units.length);
}
Json json(const Pair& pair) {
  return {{"first", pair.sides.first.parts},
          {"second", pair.sides.second.parts},
          {"law", name(pair.sides.law)},
          {"edges", pair.facets},
          {"gap", {{"smallest", pair.smallest}, {"largest", pair.largest}}}};
}

std::string problem_text(const scene::Scene<2>& scene, const scene::Problem<2>& problem) {
  std::string result = fmt::format("{} (plane {}{})\n", scene.title, name(scene.plane),
                                   scene.units.empty() ? "" : "; units " + scene.units);
  const Units units = units_of(scene.units);
  result += mesh_text(problem.mesh, units);
  for (std::size_t i = 0; const Body& body : bodies_of(problem.mesh)) {
    const scene::Vector<2>& force = problem.bodies[i++].force;
    result += text(body, units);
    if (!force.isZero(0))
      result += fmt::format(", body force ({:.4g}, {:.4g}){}", force.x(), force.y(), units.body_force);
    result += "\n";
  }
  result += "boundary:\n";
  for (const Part& part : parts_of(problem.mesh))
    result += fmt::format("{}: {}\n", text(part, units), condition_text(scene, part.name));
  result += scene.contact.empty() ? "contact: none\n" : "contact:\n";
  for (std::size_t i = 0; i < scene.contact.size(); ++i)
    result += text(pair_of(scene, problem, static_cast<int>(i)), units);
  return result +
         fmt::format("data oscillation: traction {:.1e}, displacement {:.1e}, gap {:.1e} of the largest value\n",
                     problem.oscillation.traction, problem.oscillation.displacement, problem.oscillation.gap);
}

Json problem_json(const scene::Scene<2>& scene, const scene::Problem<2>& problem) {
  Json result = heading(scene);
  result["units"] = scene.units;
  result["plane"] = name(scene.plane);
  result["mesh"] = mesh_json(problem.mesh);
  for (std::size_t i = 0; const Body& body : bodies_of(problem.mesh)) {
    const scene::Vector<2>& force = problem.bodies[i++].force;
    result["bodies"].push_back(json(body));
    result["bodies"].back()["body_force"] = {force.x(), force.y()};
  }
  for (const Part& part : parts_of(problem.mesh)) {
    result["boundary"].push_back(json(part));
    result["boundary"].back()["condition"] = condition_text(scene, part.name);
  }
  result["contact"] = Json::array();
  for (std::size_t i = 0; i < scene.contact.size(); ++i)
    result["contact"].push_back(json(pair_of(scene, problem, static_cast<int>(i))));
  result["data_oscillation"] = oscillation_json(problem.oscillation);
  return result;
}

}  // namespace

void check(const std::filesystem::path& file, const std::vector<std::string>& overrides, bool as_json) {
  const scene::Scene<2> scene = scene::read_scene<2>(file, overrides);
  const scene::Problem<2> problem = scene::fix_data(scene, scene::build_mesh(scene));
  if (as_json) {
    Json result = problem_json(scene, problem);
    const scene::Problem<2> balanced = bounds::balanced(problem, scene.solve.degree);
    result["loads_changed"] = balanced.imbalance;
    result["quantities"] = Json::array();
    for (const auto& one : bounds::asked(scene, balanced))
      result["quantities"].push_back({{"name", one.quantity.name}, {"undetermined", one.undetermined.motion}});
    result["status"] = "done";
    result["notes"] = problem.mesh.notes;
    std::cout << dump(result);
    return;
  }
  print_notes(problem.mesh);
  std::cout << within_columns(problem_text(scene, problem)) << std::flush;
  const scene::Problem<2> balanced = bounds::balanced(problem, scene.solve.degree);
  std::cout << within_columns(fmt::format(
      "solvable: supports and contact can balance the loads (imbalance removed: {:.1e})\n", balanced.imbalance));
  for (const auto& one : bounds::asked(scene, balanced))
    std::cout << within_columns(
        fmt::format("quantity: {}{}\n", one.quantity.name,
                    one.undetermined.motion.empty() ? "" : "; one end only: " + one.undetermined.motion));
}

void info(const std::filesystem::path& file, bool as_json) {
  const scene::Mesh<2> mesh = scene::read_mesh<2>(file);
  if (as_json) {
    Json result = heading();
    result["file"] = file.string();
    result["mesh"] = mesh_json(mesh);
    for (const Body& body : bodies_of(mesh)) result["bodies"].push_back(json(body));
    for (const Part& part : parts_of(mesh)) result["boundary"].push_back(json(part));
    result["status"] = "done";
    result["notes"] = mesh.notes;
    std::cout << dump(result);
    return;
  }
  print_notes(mesh);
  std::cout << within_columns(mesh_text(mesh, {}));
  for (const Body& body : bodies_of(mesh)) std::cout << text(body, {}) << "\n";
  std::cout << "boundary:\n";
  for (const Part& part : parts_of(mesh)) std::cout << text(part, {}) << "\n";
}

}  // namespace bracket::apps
