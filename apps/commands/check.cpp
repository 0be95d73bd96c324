// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <iostream>

#include "apps/commands/commands.h"
#include "apps/commands/dimension.h"
#include "apps/commands/say.h"
#include "apps/report/json.h"
#include "apps/report/lines.h"
#include "apps/report/pairs.h"
#include "apps/report/samples.h"
#include "apps/report/units.h"
#include "apps/report/words.h"
#include "bounds/asked.h"
#include "bounds/bounds.h"

namespace bracket::apps {
namespace {

using Json = nlohmann::ordered_json;

template <int dim> void print_notes(const scene::Mesh<dim>& mesh) {
  for (const std::string& note : mesh.notes) say_note(note);
}

/// What is told of a body or boundary part of a mesh.
struct Body {
  std::string name;
  int cells = 0;
  double size = 0;  ///< area, in space volume
};
struct Part {
  std::string name;  ///< empty: of what belongs to none
  int facets = 0;
  double measure = 0;  ///< length, in space area
};

template <int dim> std::vector<Body> bodies_of(const scene::Mesh<dim>& mesh) {
  std::vector<Body> bodies;
  for (const std::string& name : mesh.bodies) bodies.push_back({.name = name});
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) {
    Body& body = bodies[mesh.cell_body[cell]];
    ++body.cells;
    body.size += scene::volume(mesh, static_cast<int>(cell));
  }
  return bodies;
}

/// The last is what belongs to none, if there is any.
template <int dim> std::vector<Part> parts_of(const scene::Mesh<dim>& mesh) {
  std::vector<Part> parts;
  for (const std::string& name : mesh.parts) parts.push_back({.name = name});
  parts.emplace_back();
  for (std::size_t facet = 0; facet < mesh.boundary.size(); ++facet) {
    const int of = mesh.boundary[facet].part;
    Part& part = of == -1 ? parts.back() : parts[of];
    ++part.facets;
    part.measure += scene::length(mesh, static_cast<int>(facet));
  }
  if (parts.back().facets == 0) parts.pop_back();
  return parts;
}

template <int dim> const std::string& size_unit(const Units& units) { return dim == 2 ? units.area : units.volume; }

template <int dim> std::string mesh_text(const scene::Mesh<dim>& mesh, const Units& units) {
  const scene::Quality quality = scene::quality(mesh);
  return fmt::format(
      "mesh: {} cells, {} vertices, {} edges\n  angles {}{:.1f} to {:.1f} degrees, {}s {:.3g} to {:.3g}{}{}\n",
      mesh.cells.size(), mesh.vertices.size(), mesh.edges.size(), dim == 3 ? "between faces " : "",
      quality.smallest_angle, quality.largest_angle, Words<dim>::size, quality.smallest_area, quality.largest_area,
      size_unit<dim>(units), dim == 3 ? fmt::format(", worst shape {:.3f} (1: regular)", quality.smallest_shape) : "");
}

template <int dim> Json mesh_json(const scene::Mesh<dim>& mesh) {
  return {{"cells", mesh.cells.size()},
          {"vertices", mesh.vertices.size()},
          {"edges", mesh.edges.size()},
          {"components", mesh.components},
          {"quality", quality_json(mesh)}};
}

template <int dim> std::string text(const Body& body, const Units& units) {
  return fmt::format("  body {}: {} cells, {} {:.6g}{}", body.name, body.cells, Words<dim>::size, body.size,
                     size_unit<dim>(units));
}
template <int dim> Json json(const Body& body) {
  return {{"name", body.name}, {"cells", body.cells}, {Words<dim>::size, body.size}};
}

template <int dim> std::string text(const Part& part, const Units& units) {
  return fmt::format("  {}: {} {}, {} {:.6g}{}", part.name.empty() ? "without a name" : part.name, part.facets,
                     Words<dim>::facets, Words<dim>::measure, part.measure, dim == 2 ? units.length : units.area);
}
template <int dim> Json json(const Part& part) {
  return {{"name", part.name.empty() ? Json() : Json(part.name)},
          {Words<dim>::facets, part.facets},
          {Words<dim>::measure, part.measure}};
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

template <int dim> std::string condition_text(const scene::Scene<dim>& scene, const std::string& part) {
  for (const scene::ContactPair<dim>& pair : scene.contact) {
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
template <int dim> struct Pair {
  const scene::ContactPair<dim>& sides;
  int facets = 0;
  double smallest = 0, largest = 0;  ///< gap
};

template <int dim> Pair<dim> pair_of(const scene::Scene<dim>& scene, const scene::Problem<dim>& problem, int number) {
  Pair<dim> pair{scene.contact[number]};
  for (const scene::ContactFacetOf<dim>& facet : problem.contact) {
    if (facet.pair != number) continue;
    const auto gap = quadratic_at_nodes<dim>(facet.lower);
    const auto [low, high] = std::ranges::minmax(gap);
    pair.smallest = pair.facets == 0 ? low : std::min(pair.smallest, low);
    pair.largest = pair.facets == 0 ? high : std::max(pair.largest, high);
    ++pair.facets;
  }
  return pair;
}

template <int dim> std::string text(const Pair<dim>& pair, const Units& units) {
  return fmt::format("  {} on {}, {}: {} {}; gap {:.4g} to {:.4g}{}\n", name(pair.sides.first), name(pair.sides.second),
                     law_text(pair.sides), pair.facets, Words<dim>::facets, pair.smallest, pair.largest, units.length);
}
template <int dim> Json json(const Pair<dim>& pair) {
  return {{"first", pair.sides.first.parts},
          {"second", pair.sides.second.parts},
          {"law", name(pair.sides.law)},
          {Words<dim>::facets, pair.facets},
          {"gap", {{"smallest", pair.smallest}, {"largest", pair.largest}}}};
}

template <int dim> std::string vector_text(const scene::Vector<dim>& vector) {
  std::string text;
  for (int k = 0; k < dim; ++k) text += fmt::format("{}{:.4g}", k == 0 ? "(" : ", ", vector[k]);
  return text + ")";
}

/// In space: which of the six motions of each piece supports leave free; contact may hold it all the same.
std::string motions_text(const scene::Problem<3>& problem) {
  std::string text = "motions that supports leave free:\n";
  for (std::size_t i = 0; i < problem.mesh.components.size(); ++i) {
    const auto free = scene::free_motions(problem, static_cast<int>(i));
    text += fmt::format("  {}: {} of 6", problem.mesh.components[i], free.size());
    for (std::size_t k = 0; k < free.size(); ++k) text += (k == 0 ? ": " : "; ") + scene::describe(free[k]);
    text += "\n";
  }
  return text;
}
Json motions_json(const scene::Problem<3>& problem) {
  Json result = Json::array();
  for (std::size_t i = 0; i < problem.mesh.components.size(); ++i) {
    Json free = Json::array();
    for (const auto& motion : scene::free_motions(problem, static_cast<int>(i)))
      free.push_back(scene::describe(motion));
    result.push_back({{"bodies", problem.mesh.components[i]}, {"free", free}});
  }
  return result;
}

template <int dim> std::string problem_text(const scene::Scene<dim>& scene, const scene::Problem<dim>& problem) {
  std::string result =
      fmt::format("{} ({}{})\n", scene.title, setting_of(scene), scene.units.empty() ? "" : "; units " + scene.units);
  const Units units = units_of(scene.units, dim);
  result += mesh_text(problem.mesh, units);
  for (std::size_t i = 0; const Body& body : bodies_of(problem.mesh)) {
    const scene::Vector<dim>& force = problem.bodies[i++].force;
    result += text<dim>(body, units);
    if (!force.isZero(0)) result += fmt::format(", body force {}{}", vector_text<dim>(force), units.body_force);
    result += "\n";
  }
  result += "boundary:\n";
  for (const Part& part : parts_of(problem.mesh))
    result += fmt::format("{}: {}\n", text<dim>(part, units), condition_text(scene, part.name));
  result += scene.contact.empty() ? "contact: none\n" : "contact:\n";
  for (std::size_t i = 0; i < scene.contact.size(); ++i)
    result += text(pair_of(scene, problem, static_cast<int>(i)), units);
  if constexpr (dim == 3) result += motions_text(problem);
  return result +
         fmt::format("data oscillation: traction {:.1e}, displacement {:.1e}, gap {:.1e} of the largest value\n",
                     problem.oscillation.traction, problem.oscillation.displacement, problem.oscillation.gap);
}

template <int dim> Json problem_json(const scene::Scene<dim>& scene, const scene::Problem<dim>& problem) {
  Json result = heading(scene);
  result["units"] = scene.units;
  if (dim == 2) result["plane"] = name(scene.plane);
  result["mesh"] = mesh_json(problem.mesh);
  for (std::size_t i = 0; const Body& body : bodies_of(problem.mesh)) {
    const scene::Vector<dim>& force = problem.bodies[i++].force;
    result["bodies"].push_back(json<dim>(body));
    result["bodies"].back()["body_force"] = std::vector<double>(force.begin(), force.end());
  }
  for (const Part& part : parts_of(problem.mesh)) {
    result["boundary"].push_back(json<dim>(part));
    result["boundary"].back()["condition"] = condition_text(scene, part.name);
  }
  result["contact"] = Json::array();
  for (std::size_t i = 0; i < scene.contact.size(); ++i)
    result["contact"].push_back(json(pair_of(scene, problem, static_cast<int>(i))));
  if constexpr (dim == 3) result["motions"] = motions_json(problem);
  result["data_oscillation"] = oscillation_json(problem.oscillation);
  return result;
}

template <int dim>
void check_in(const std::filesystem::path& file, const std::vector<std::string>& overrides, bool as_json) {
  const scene::Scene<dim> scene = scene::read_scene<dim>(file, overrides);
  const scene::Problem<dim> problem = scene::fix_data(scene, scene::build_mesh(scene));
  if (as_json) {
    Json result = problem_json(scene, problem);
    const scene::Problem<dim> balanced = bounds::balanced(problem, scene.solve.degree);
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
  const scene::Problem<dim> balanced = bounds::balanced(problem, scene.solve.degree);
  std::cout << within_columns(fmt::format(
      "solvable: supports and contact can balance the loads (imbalance removed: {:.1e})\n", balanced.imbalance));
  for (const auto& one : bounds::asked(scene, balanced))
    std::cout << within_columns(
        fmt::format("quantity: {}{}\n", one.quantity.name,
                    one.undetermined.motion.empty() ? "" : "; one end only: " + one.undetermined.motion));
}

template <int dim> void info_in(const std::filesystem::path& file, bool as_json) {
  const scene::Mesh<dim> mesh = scene::read_mesh<dim>(file);
  if (as_json) {
    Json result = heading();
    if (dim == 3) result["dim"] = dim;
    result["file"] = file.string();
    result["mesh"] = mesh_json(mesh);
    for (const Body& body : bodies_of(mesh)) result["bodies"].push_back(json<dim>(body));
    for (const Part& part : parts_of(mesh)) result["boundary"].push_back(json<dim>(part));
    result["status"] = "done";
    result["notes"] = mesh.notes;
    std::cout << dump(result);
    return;
  }
  print_notes(mesh);
  std::cout << within_columns(mesh_text(mesh, {}));
  for (const Body& body : bodies_of(mesh)) std::cout << text<dim>(body, {}) << "\n";
  std::cout << "boundary:\n";
  for (const Part& part : parts_of(mesh)) std::cout << text<dim>(part, {}) << "\n";
}

}  // namespace

void check(const std::filesystem::path& file, const std::vector<std::string>& overrides, bool as_json) {
  is_in_space(file, overrides) ? check_in<3>(file, overrides, as_json) : check_in<2>(file, overrides, as_json);
}

void info(const std::filesystem::path& file, bool as_json) {
  scene::dimension_of_mesh(file) == 3 ? info_in<3>(file, as_json) : info_in<2>(file, as_json);
}

}  // namespace bracket::apps
