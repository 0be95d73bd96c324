// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "apps/report/html.h"
#include "apps/report/pairs.h"
#include "apps/report/samples.h"
#include "apps/report/words.h"

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

/// The components of a vector: "(1, 2)". \param component as a text
template <int dim, class Component> std::string in_parentheses(const Component& component) {
  std::string text;
  for (int k = 0; k < dim; ++k) text += (k == 0 ? "(" : ", ") + component(k);
  return text + ")";
}

template <int dim> std::string material_text(const scene::Material<dim>& material) {
  if (const auto& constants = material.constants())
    return fmt::format("E = {:.10g}, ν = {:.10g}", constants->young, constants->poisson);
  const auto& c = material.stiffness();
  if constexpr (dim == 3) {
    std::string text = "stiffness";
    for (int i = 0; i < 6; ++i)
      for (int j = i; j < 6; ++j)
        if (c(i, j) != 0) text += fmt::format("{} c{}{} = {:.6g}", i + j == 0 ? "" : ",", i + 1, j + 1, c(i, j));
    return text;
  }
  return fmt::format("c₁₁ = {:.6g}, c₂₂ = {:.6g}, c₁₂ = {:.6g}, c₁₆ = {:.6g}, c₂₆ = {:.6g}, c₆₆ = {:.6g}", c(0, 0),
                     c(1, 1), c(0, 1), c(0, 2), c(1, 2), c(2, 2));
}

template <int dim> std::string bodies(const ReportOf<dim>& report) {
  const scene::Problem<dim>& problem = report.outcome.problem;
  Rows rows;
  for (int body = 0; body < static_cast<int>(problem.bodies.size()); ++body) {
    int cells = 0;
    double area = 0;
    for (int cell = 0; cell < static_cast<int>(problem.mesh.cells.size()); ++cell) {
      if (problem.mesh.cell_body[cell] != body) continue;
      ++cells;
      area += scene::volume(problem.mesh, cell);
    }
    const scene::Vector<dim>& force = problem.bodies[body].force;
    rows.push_back({escaped(problem.mesh.bodies[body]), material_text(problem.bodies[body].material),
                    in_parentheses<dim>([&](int k) { return fmt::format("{:.6g}", force[k]); }),
                    fmt::format("{:.6g}", area), fmt::to_string(cells)});
  }
  return html_table({"body", "material", "body force", Words<dim>::size, "cells"}, rows, 2, "Bodies");
}

// What is prescribed on a facet, by the support that it is.
template <int dim> std::string condition(const scene::Problem<dim>& problem, int part) {
  std::array<Range, dim> traction, displacement;
  Range normal, pressure;
  scene::Support support = scene::Support::traction;
  for (std::size_t i = 0; i < problem.facets.size(); ++i) {
    if (problem.mesh.boundary[i].part != part) continue;
    const scene::FacetData<dim>& data = problem.facets[i];
    support = data.support;
    for (int end = 0; end < dim; ++end) {
      normal.add(data.normal_displacement[end]);
      for (int k = 0; k < dim; ++k) displacement[k].add(data.displacement[end][k]);
      if constexpr (dim == 3) {
        pressure.add(data.pressure[end]);
        for (int k = 0; k < dim; ++k) traction[k].add(data.traction[end][k]);
      }
    }
    if constexpr (dim == 2) {
      const int places = degree_of_load(data) > 1 ? 8 : 1;
      for (int place = 0; place <= places; ++place) {
        const double t = static_cast<double>(place) / places;
        pressure.add(scene::pressure_at(data, t));
        for (int k = 0; k < dim; ++k) traction[k].add(scene::traction_at(data, t)[k]);
      }
    }
  }
  switch (support) {
    case scene::Support::fixed:
      return "fixed: displacement " + in_parentheses<dim>([&](int k) { return displacement[k].text(); });
    case scene::Support::sliding: return fmt::format("sliding: normal displacement {}", normal.text());
    case scene::Support::contact: return "contact";
    case scene::Support::traction: break;
  }
  if (pressure.text() != "0") return "pressure " + pressure.text();
  if (std::ranges::all_of(traction, [](const Range& range) { return range.text() == "0"; })) return "free";
  return "traction " + in_parentheses<dim>([&](int k) { return traction[k].text(); });
}

template <int dim> std::string boundary(const scene::Problem<dim>& problem) {
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
  return html_table({"boundary part", "condition, as the mesh carries it", Words<dim>::measure, Words<dim>::facets},
                    rows, 2, "Parts of the boundary");
}

template <int dim> std::string contact(const ReportOf<dim>& report) {
  Rows rows;
  for (int pair = 0; pair < static_cast<int>(report.scene.contact.size()); ++pair) {
    Range gap;
    int edges = 0;
    for (const auto& facet : report.outcome.problem.contact) {
      if (facet.pair != pair) continue;
      ++edges;
      for (const double value : quadratic_at_nodes<dim>(facet.lower)) gap.add(value);
    }
    const auto& names = report.scene.contact[pair];
    rows.push_back(
        {escaped(name(names.first)), escaped(name(names.second)), law_text(names), gap.text(), fmt::to_string(edges)});
  }
  return html_table({"first side", "second side", "law", "initial gap", Words<dim>::facets}, rows, 3, "Contact pairs");
}

template <int dim> std::string settings(const scene::Scene<dim>& scene) {
  const scene::Refine& refine = scene.refine;
  Rows rows = dim == 2 ? Rows{{"plane", name(scene.plane)}} : Rows{{"dim", "3"}};
  const Rows more = {{"solve.degree", fmt::to_string(scene.solve.degree)},
                     {"solve.dual", name(scene.solve.dual)},
                     {"refine.strategy", name(refine.strategy)},
                     {"refine.target", fmt::to_string(refine.target)},
                     {"refine.bulk", fmt::to_string(refine.bulk)},
                     {"refine.max_levels", fmt::to_string(refine.max_levels)},
                     {"refine.max_cells", fmt::to_string(refine.max_cells)},
                     {"refine.max_seconds", fmt::to_string(refine.max_seconds)}};
  rows.insert(rows.end(), more.begin(), more.end());
  if (scene.solve.sweeps) rows.push_back({"solve.sweeps", fmt::to_string(*scene.solve.sweeps)});
  return html_table({"setting", "value"}, rows, 1, "Settings, defaults filled in");
}

}  // namespace

template <int dim> std::string html_scene(const ReportOf<dim>& report) {
  std::string html = bodies(report) + "<h3>Boundary</h3>\n" + boundary(report.outcome.problem);
  if (!report.scene.contact.empty()) html += "<h3>Contact</h3>\n" + contact(report);
  return html + "<h3>Settings</h3>\n" + settings(report.scene);
}

template std::string html_scene(const ReportOf<2>&);
template std::string html_scene(const ReportOf<3>&);

}  // namespace bracket::apps
