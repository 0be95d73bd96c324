// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/results.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "bounds/estimate/on_mesh.h"
#include "scene/mesh/angles.h"

namespace bracket::bounds {

using scene::cross;
using scene::Vector;
using scene::Voigt;

namespace {

/// Adds what a traction, given at a facet's vertices and linear between, exerts there.
void add(Resultant<2>& sum, const scene::Mesh<2>& mesh, int facet, const std::array<Vector<2>, 2>& t) {
  const auto& [v, w] = mesh.boundary[facet].vertices;
  const Vector<2> a = mesh.vertices[v] - sum.about, b = mesh.vertices[w] - sum.about;
  const double length = scene::length(mesh, facet);
  sum.force += length / 2 * (t[0] + t[1]);
  sum.moment += length / 6 * (cross(2 * a + b, t[0]) + cross(a + 2 * b, t[1]));
}

}  // namespace

template <int dim>
Resultant<dim> resultant(const scene::Problem<dim>& problem, const scene::Stress<dim>& stress, const std::string& part,
                         const Vector<dim>& about) {
  const auto& mesh = problem.mesh;
  const auto found = std::find(mesh.parts.begin(), mesh.parts.end(), part);
  if (found == mesh.parts.end()) {
    throw scene::Error(scene::Status::input,
                       fmt::format("the mesh has no boundary part '{}'; it has {}", part, fmt::join(mesh.parts, ", ")));
  }
  Resultant<dim> sum{.about = about};
  for (std::size_t f = 0; f < mesh.boundary.size(); ++f) {
    if (mesh.boundary[f].part != found - mesh.parts.begin()) continue;
    const int facet = static_cast<int>(f);
    add(sum, mesh, facet, tractions(mesh, stress, facet));
  }
  return sum;
}

template <int dim>
ContactResult<dim> contact_result(const scene::Problem<dim>& problem, const scene::Stress<dim>& stress, int pair,
                                  const Vector<dim>& about) {
  const auto& mesh = problem.mesh;
  const auto pressure = contact_pressure(problem, stress);
  ContactResult<dim> result;
  result.resultant.about = about;
  for (std::size_t j = 0; j < problem.contact.size(); ++j) {
    if (problem.contact[j].pair != pair) continue;
    const int facet = problem.contact[j].first;
    const Vector<dim>& d = problem.facets[facet].normal;
    const double length = scene::length(mesh, facet);
    result.length += length;
    if (pressure[j][0] > 0 || pressure[j][1] > 0) result.pressed_length += length;
    add(result.resultant, mesh, facet, {Vector<dim>(-pressure[j][0] * d), Vector<dim>(-pressure[j][1] * d)});
    for (int end = 0; end < 2; ++end) {
      if (pressure[j][end] <= result.largest_pressure) continue;
      result.largest_pressure = pressure[j][end];
      result.at = mesh.vertices[mesh.boundary[facet].vertices[end]];
    }
  }
  if (result.length == 0)
    throw scene::Error(scene::Status::input, fmt::format("the problem has no contact pair {}", pair));
  return result;
}

template <int dim>
LargestDisplacement<dim> largest_displacement(const scene::Problem<dim>& problem,
                                              const scene::Displacement<dim>& displacement) {
  const auto& mesh = problem.mesh;
  LargestDisplacement<dim> largest;
  double size = -1;
  const auto include = [&](const Vector<dim>& u, const Vector<dim>& x) {
    if (const double own = u.norm(); own > size) {
      size = own;
      largest = {u, x};
    }
  };
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) include(displacement.vertex[v], mesh.vertices[v]);
  for (std::size_t e = 0; e < displacement.edge.size(); ++e) {
    const Vector<dim>&a = mesh.vertices[mesh.edges[e][0]], &b = mesh.vertices[mesh.edges[e][1]];
    include(displacement.edge[e], a + (b - a) / 2);
  }
  return largest;
}

namespace {

/// Barycentric coordinates of x in a cell, if it holds x within the rounding of coordinates.
std::optional<std::array<double, 3>> inside(const scene::Mesh<2>& mesh, int cell, const Vector<2>& x) {
  std::array<double, 3> twice_area;
  double size = x.cwiseAbs().maxCoeff();
  for (const int v : mesh.cells[cell]) size = std::max(size, mesh.vertices[v].cwiseAbs().maxCoeff());
  for (int k = 0; k < 3; ++k) {
    const Vector<2>& a = mesh.vertices[mesh.cells[cell][(k + 1) % 3]];
    const Vector<2> along = mesh.vertices[mesh.cells[cell][(k + 2) % 3]] - a;
    twice_area[k] = cross(along, x - a);
    // The distance from the edge, which moves by an ulp or two with x and the edge's ends.
    if (!(twice_area[k] >= -8 * std::numeric_limits<double>::epsilon() * size * along.norm())) return {};
  }
  const double sum = twice_area[0] + twice_area[1] + twice_area[2];
  for (double& coordinate : twice_area) coordinate /= sum;
  return twice_area;
}

Vector<2> displacement_at(const scene::Mesh<2>& mesh, const scene::Displacement<2>& displacement, int cell,
                          const std::array<double, 3>& l) {
  Vector<2> u = Vector<2>::Zero();
  for (int k = 0; k < 3; ++k) {
    const bool linear = displacement.degree == 1;
    u += (linear ? l[k] : l[k] * (2 * l[k] - 1)) * displacement.vertex[mesh.cells[cell][k]];
    if (!linear) u += 4 * l[(k + 1) % 3] * l[(k + 2) % 3] * displacement.edge[mesh.cell_edges[cell][k]];
  }
  return u;
}

/// Part k is where coordinate k is the least; there x = 3 l_k centroid + Σ (l_i − l_k) vertex i.
Voigt<2> stress_at(const std::array<Voigt<2>, 9>& corners, const std::array<double, 3>& l) {
  const int k = static_cast<int>(std::min_element(l.begin(), l.end()) - l.begin());
  return (l[(k + 1) % 3] - l[k]) * corners[3 * k] + (l[(k + 2) % 3] - l[k]) * corners[3 * k + 1] +
         3 * l[k] * corners[3 * k + 2];
}

}  // namespace

template <int dim>
std::optional<PointValues<dim>> values_at(const scene::Problem<dim>& problem,
                                          const scene::Displacement<dim>& displacement,
                                          const scene::Stress<dim>& stress, const Vector<dim>& x) {
  for (int cell = 0; cell < static_cast<int>(problem.mesh.cells.size()); ++cell) {
    const auto l = inside(problem.mesh, cell, x);
    if (!l) continue;
    const auto s = displacement_stress(problem, displacement, cell);
    return PointValues<dim>{cell, displacement_at(problem.mesh, displacement, cell, *l),
                            (*l)[0] * s[0] + (*l)[1] * s[1] + (*l)[2] * s[2], stress_at(stress.cell[cell], *l)};
  }
  return {};
}

template Resultant<2> resultant(const scene::Problem<2>&, const scene::Stress<2>&, const std::string&,
                                const Vector<2>&);
template ContactResult<2> contact_result(const scene::Problem<2>&, const scene::Stress<2>&, int, const Vector<2>&);
template LargestDisplacement<2> largest_displacement(const scene::Problem<2>&, const scene::Displacement<2>&);
template std::optional<PointValues<2>> values_at(const scene::Problem<2>&, const scene::Displacement<2>&,
                                                 const scene::Stress<2>&, const Vector<2>&);

}  // namespace bracket::bounds
