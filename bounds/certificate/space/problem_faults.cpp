// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/certificate/space/problem_faults.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bounds/certificate/space/elastic_form.h"

namespace bracket::bounds::space {

using scene::Problem;
using scene::Vector;

namespace {

bool finite(double x) { return std::isfinite(x); }
bool finite(const Vector<3>& x) { return x.allFinite(); }
template <class Values> bool each_finite(const Values& values) {
  return std::ranges::all_of(values, [](const auto& x) { return finite(x); });
}

bool is_permutation(std::array<int, 3> meets) {
  std::ranges::sort(meets);
  return meets == std::array<int, 3>{0, 1, 2};
}

}  // namespace

std::string index_fault(const Problem<3>& problem) {
  const auto& mesh = problem.mesh;
  const std::size_t cells = mesh.cells.size(), facets = problem.facets.size();
  if (cells == 0 || mesh.bodies.empty() || mesh.components.empty()) return "the problem has no cells";
  if (facets != mesh.boundary.size() || problem.bodies.size() != mesh.bodies.size() || mesh.cell_body.size() != cells ||
      mesh.cell_component.size() != cells || mesh.cell_edges.size() != cells || mesh.facet_numbers.size() != cells)
    return "data and mesh of the problem differ in number";
  const auto vertex = [&](int v) { return in_range(v, mesh.vertices.size()); };
  const auto edge = [&](int e) { return in_range(e, mesh.edges.size()); };
  const auto face = [&](int f) { return mesh.facet_count > 0 && in_range(f, scene::n_facets(mesh)); };
  for (std::size_t c = 0; c < cells; ++c)
    if (!std::ranges::all_of(mesh.cells[c], vertex) || !std::ranges::all_of(mesh.cell_edges[c], edge) ||
        !std::ranges::all_of(mesh.facet_numbers[c], face) || !in_range(mesh.cell_body[c], mesh.bodies.size()) ||
        !in_range(mesh.cell_component[c], mesh.components.size()))
      return fmt::format("cell {} names a vertex, edge, facet, body or component that is not there", c);
  for (const auto& one : mesh.edges)
    if (!std::ranges::all_of(one, vertex)) return "an edge names a vertex that is not there";
  for (const auto& facet : mesh.boundary)
    if (!std::ranges::all_of(facet.vertices, vertex) || !in_range(facet.cell, cells) || !in_range(facet.local, 4))
      return "a boundary facet names a vertex or cell that is not there";
  for (const auto& pair : problem.contact)
    if (!in_range(pair.first, facets) || pair.second < -1 || pair.pair < 0 ||
        (pair.second >= 0 && (!in_range(pair.second, facets) || !is_permutation(pair.meets))))
      return "a contact names a facet or vertex that is not there";
  for (const auto& correction : problem.corrections)
    if (!in_range(correction.facet, facets) || !each_finite(correction.unit))
      return "a correction of the loads names a facet that is not there, or is not finite";
  for (const auto& pair : problem.contact)
    if (!problem.corrections.empty() && !in_range(pair.pair, problem.carries.size()))
      return "the corrections of the loads do not say which contacts carry";
  return "";
}

std::string number_fault(const Problem<3>& problem) {
  if (!each_finite(problem.mesh.vertices)) return "a coordinate is not finite";
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    const auto& data = problem.facets[f];
    if (!finite(data.normal) || !each_finite(data.traction) || !each_finite(data.displacement) ||
        !each_finite(data.correction) || !each_finite(data.pressure) || !each_finite(data.normal_displacement))
      return fmt::format("the data of boundary facet {} are not finite", f);
    if (scene::degree_of_load(data) > 1) return fmt::format("the load on boundary facet {} is not linear", f);
  }
  for (const auto& pair : problem.contact)
    if (!each_finite(pair.lower) || !each_finite(pair.upper)) return "a gap is not finite";
  for (std::size_t b = 0; b < problem.bodies.size(); ++b) {
    const auto form = elastic_form<Enclosure>(problem.bodies[b].material);
    const bool definite = std::ranges::all_of(form.d, [](const Enclosure& d) { return d.middle > d.radius; });
    if (!definite || !problem.bodies[b].force.allFinite())
      return fmt::format("the material of '{}' is not positive definite, or its weight not finite",
                         problem.mesh.bodies[b]);
  }
  return "";
}

std::string problem_fault(const Problem<3>& problem) {
  const Problem<3>& first = scene::first_of(problem);
  for (const Problem<3>* one : {&first, &problem}) {
    if (std::string fault = index_fault(*one); !fault.empty()) return fault;
    if (std::string fault = number_fault(*one); !fault.empty()) return fault;
    if (one == &problem)
      if (std::string fault = perturbation_fault(problem); !fault.empty()) return fault;
    if (one == &problem && problem.origin.first)
      if (std::string fault = piece_fault(problem); !fault.empty()) return fault;
    if (std::string fault = topology_fault(*one); !fault.empty()) return fault;
    if (std::string fault = contact_fault(*one); !fault.empty()) return fault;
    if (&first == &problem) break;
  }
  return support_fault(first);
}

}  // namespace bracket::bounds::space
