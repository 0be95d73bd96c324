// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "apps/report/html.h"
#include "apps/report/pairs.h"

namespace bracket::apps {
namespace {

using Rows = std::vector<std::vector<std::string>>;

/// The values that occur, as "a" or "a … b".
class Range {
 public:
  void add(double value) {
    low_ = std::min(low_, value);
    high_ = std::max(high_, value);
  }
  std::string text() const {
    return low_ == high_ ? fmt::format("{:.6g}", low_) : fmt::format("{:.6g} … {:.6g}", low_, high_);
  }

 private:
  double low_ = INFINITY, high_ = -INFINITY;
};

std::string material_text(const scene::Material<2>& material) {
  if (const auto& constants = material.constants())
    return fmt::format("E = {:.10g}, ν = {:.10g}", constants->young, constants->poisson);
  const auto& c = material.stiffness();
  return fmt::format("c₁₁ = {:.6g}, c₂₂ = {:.6g}, c₁₂ = {:.6g}, c₁₆ = {:.6g}, c₂₆ = {:.6g}, c₆₆ = {:.6g}", c(0, 0),
                     c(1, 1), c(0, 1), c(0, 2), c(1, 2), c(2, 2));
}

std::string bodies(const Report& report) {
  const scene::Problem<2>& problem = report.outcome.problem;
  Rows rows;
  for (int body = 0; body < static_cast<int>(problem.bodies.size()); ++body) {
    int cells = 0;
    double area = 0;
    for (int cell = 0; cell < static_cast<int>(problem.mesh.cells.size()); ++cell) {
      if (problem.mesh.cell_body[cell] != body) continue;
      ++cells;
      area += scene::volume(problem.mesh, cell);
    }
    const scene::Vector<2>& force = problem.bodies[body].force;
    rows.push_back({escaped(problem.mesh.bodies[body]), material_text(problem.bodies[body].material),
                    fmt::format("({:.6g}, {:.6g})", force.x(), force.y()), fmt::format("{:.6g}", area),
                    fmt::to_string(cells)});
  }
  return html_table({"body", "material", "body force", "area", "cells"}, rows, 2, "Bodies");
}

// What is prescribed on a facet, by the support that it is.
std::string condition(const scene::Problem<2>& problem, int part) {
  std::array<Range, 2> traction, displacement;
  Range normal, pressure;
  scene::Support support = scene::Support::traction;
  for (std::size_t i = 0; i < problem.facets.size(); ++i) {
    if (problem.mesh.boundary[i].part != part) continue;
    const scene::FacetData<2>& data = problem.facets[i];
    support = data.support;
    for (int end = 0; end < 2; ++end) {
      normal.add(data.normal_displacement[end]);
      for (int k = 0; k < 2; ++k) displacement[k].add(data.displacement[end][k]);
    }
    const int places = degree_of_load(data) > 1 ? 8 : 1;
    for (int place = 0; place <= places; ++place) {
      const double t = static_cast<double>(place) / places;
      pressure.add(scene::pressure_at(data, t));
      for (int k = 0; k < 2; ++k) traction[k].add(scene::traction_at(data, t)[k]);
    }
  }
  switch (support) {
    case scene::Support::fixed:
      return fmt::format("fixed: displacement ({}, {})", displacement[0].text(), displacement[1].text());
    case scene::Support::sliding: return fmt::format("sliding: normal displacement {}", normal.text());
    case scene::Support::contact: return "contact";
    case scene::Support::traction: break;
  }
  if (pressure.text() != "0") return "pressure " + pressure.text();
  if (traction[0].text() == "0" && traction[1].text() == "0") return "free";
  return fmt::format("traction ({}, {})", traction[0].text(), traction[1].text());
}

std::string boundary(const scene::Problem<2>& problem) {
  Rows rows;
  for (int part = 0; part < static_cast<int>(problem.mesh.parts.size()); ++part) {
    int edges = 0;
    double length = 0;
    for (int i = 0; i < static_cast<int>(problem.mesh.boundary.size()); ++i) {
      if (problem.mesh.boundary[i].part != part) continue;
      ++edges;
      length += scene::length(problem.mesh, i);
    }
    rows.push_back({escaped(problem.mesh.parts[part]), condition(problem, part), fmt::format("{:.6g}", length),
                    fmt::to_string(edges)});
  }
  return html_table({"boundary part", "condition, as the mesh carries it", "length", "edges"}, rows, 2,
                    "Parts of the boundary");
}

std::string contact(const Report& report) {
  Rows rows;
  for (int pair = 0; pair < static_cast<int>(report.scene.contact.size()); ++pair) {
    Range gap;
    int edges = 0;
    for (const scene::ContactFacet& facet : report.outcome.problem.contact) {
      if (facet.pair != pair) continue;
      ++edges;
      for (const double value : {facet.lower[0], scene::at_middle(facet.lower), facet.lower[2]}) gap.add(value);
    }
    const auto& names = report.scene.contact[pair];
    rows.push_back(
        {escaped(name(names.first)), escaped(name(names.second)), law_text(names), gap.text(), fmt::to_string(edges)});
  }
  return html_table({"first side", "second side", "law", "initial gap", "edges"}, rows, 3, "Contact pairs");
}

std::string settings(const scene::Scene<2>& scene) {
  const scene::Refine& refine = scene.refine;
  return html_table({"setting", "value"},
                    {{"plane", name(scene.plane)},
                     {"solve.degree", fmt::to_string(scene.solve.degree)},
                     {"solve.dual", name(scene.solve.dual)},
                     {"refine.strategy", name(refine.strategy)},
                     {"refine.target", fmt::to_string(refine.target)},
                     {"refine.bulk", fmt::to_string(refine.bulk)},
                     {"refine.max_levels", fmt::to_string(refine.max_levels)},
                     {"refine.max_cells", fmt::to_string(refine.max_cells)},
                     {"refine.max_seconds", fmt::to_string(refine.max_seconds)}},
                    1, "Settings, defaults filled in");
}

}  // namespace

std::string html_scene(const Report& report) {
  std::string html = bodies(report) + "<h3>Boundary</h3>\n" + boundary(report.outcome.problem);
  if (!report.scene.contact.empty()) html += "<h3>Contact</h3>\n" + contact(report);
  return html + "<h3>Settings</h3>\n" + settings(report.scene);
}

}  // namespace bracket::apps
