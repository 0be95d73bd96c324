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

/// Adds what a traction, given by Bernstein coefficients along a facet, exerts there.
template <int dim>
void add(Resultant<dim>& sum, const scene::Mesh<dim>& mesh, int facet, const std::vector<Vector<dim>>& t) {
  const auto x = scene::positions(mesh, mesh.boundary[facet].vertices);
  const double length = scene::length(mesh, facet);
  const int degree = scene::degree_on_facet<dim>(t.size());
  for (std::size_t k = 0; k < t.size(); ++k)
    for (int i = 0; i < dim; ++i) {
      const double mass = length * scene::number<double>(scene::hat_mean<dim>(degree, static_cast<int>(k), i));
      sum.force += mass * t[k];
      const Vector<dim> arm = x[i] - sum.about;
      if constexpr (dim == 2) sum.moment += mass * cross(arm, t[k]);
      if constexpr (dim == 3) sum.moment += mass * arm.cross(t[k]);
    }
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
    const auto& own = pressure[j];
    if (std::ranges::any_of(own, [](double p) { return p > 0; })) result.pressed_length += length;
    std::vector<Vector<dim>> traction;
    for (const double p : own) traction.push_back(-p * d);
    add(result.resultant, mesh, facet, traction);
    const auto x = scene::positions(mesh, mesh.boundary[facet].vertices);
    const auto include = [&](double p, const Vector<dim>& at) {
      if (p <= result.largest_pressure) return;
      result.largest_pressure = p;
      result.at = at;
    };
    if constexpr (dim == 2) {
      const int points = 4 * (stress.degree - 1) + 1;  // linear ones are largest at an end
      for (int i = 0; i <= points; ++i) {
        const double t = static_cast<double>(i) / points;
        include(scene::value_on_segment(own, t), i == points ? x[1] : Vector<dim>(x[0] + t * (x[1] - x[0])));
      }
    } else {
      for (int i = 0; i < dim; ++i) include(own[i], x[i]);
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
  const int n = scene::n_inside_edge(displacement.degree);
  for (std::size_t i = 0; i < displacement.edge.size(); ++i) {
    const auto& [a, b] = scene::positions(mesh, mesh.edges[i / n]);
    include(displacement.edge[i], a + static_cast<double>(i % n + 1) / displacement.degree * (b - a));
  }
  return largest;
}

namespace {

/// Barycentric coordinates of x in a cell, if it holds x within the rounding of coordinates.
template <int dim>
std::optional<std::array<double, dim + 1>> inside(const scene::Mesh<dim>& mesh, int cell, const Vector<dim>& x) {
  std::array<double, dim + 1> volume;  // of the simplex that x makes with each facet, all by the same factor
  double size = x.cwiseAbs().maxCoeff();
  for (const int v : mesh.cells[cell]) size = std::max(size, mesh.vertices[v].cwiseAbs().maxCoeff());
  for (int k = 0; k <= dim; ++k) {
    const auto corners = scene::positions(mesh, scene::facet_vertices(mesh, cell, k));
    volume[k] = -scene::area_vector<dim>(corners).dot(x - corners[0]);
    // The distance from the facet, which moves by an ulp or two with x and the facet's vertices.
    double reach = dim == 2 ? 1 : 0.5;
    for (int i = 1; i < dim; ++i) reach *= (corners[i] - corners[0]).norm();
    if (!(volume[k] >= -8 * std::numeric_limits<double>::epsilon() * size * reach)) return {};
  }
  double sum = 0;
  for (const double part : volume) sum += part;
  for (double& coordinate : volume) coordinate /= sum;
  return volume;
}

template <int dim, class Values>
auto value_at(const Values& coefficients, int degree, const std::array<double, std::size_t{dim} + 1>& l) {
  if constexpr (dim == 2) return scene::value_on_triangle(coefficients, degree, l);
  if constexpr (dim == 3)
    return Voigt<3>(l[0] * coefficients[0] + l[1] * coefficients[1] + l[2] * coefficients[2] + l[3] * coefficients[3]);
}

/// Part k is where coordinate k is the least; there x = (dim + 1) l_k centroid + Σ (l_i − l_k) vertex i.
template <int dim>
Voigt<dim> stress_at(const scene::Stress<dim>& stress, int cell, const std::array<double, std::size_t{dim} + 1>& l) {
  const int k = static_cast<int>(std::min_element(l.begin(), l.end()) - l.begin());
  std::array<double, dim + 1> in_part;
  for (int i = 0; i < dim; ++i) in_part[i] = l[scene::Simplex<dim>::facets[k][i]] - l[k];
  in_part[dim] = (dim + 1) * l[k];
  const auto part = scene::stress_of_part(stress, cell, k);
  return value_at<dim>(std::vector<Voigt<dim>>(part.begin(), part.end()), stress.degree, in_part);
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
    return PointValues<dim>{cell, scene::displacement_at(problem.mesh, displacement, cell, *l),
                            value_at<dim>(s, scene::stress_degree(displacement.degree), *l),
                            stress_at(stress, cell, *l)};
  }
  return {};
}

template Resultant<2> resultant(const scene::Problem<2>&, const scene::Stress<2>&, const std::string&,
                                const Vector<2>&);
template Resultant<3> resultant(const scene::Problem<3>&, const scene::Stress<3>&, const std::string&,
                                const Vector<3>&);
template ContactResult<2> contact_result(const scene::Problem<2>&, const scene::Stress<2>&, int, const Vector<2>&);
template ContactResult<3> contact_result(const scene::Problem<3>&, const scene::Stress<3>&, int, const Vector<3>&);
template LargestDisplacement<2> largest_displacement(const scene::Problem<2>&, const scene::Displacement<2>&);
template LargestDisplacement<3> largest_displacement(const scene::Problem<3>&, const scene::Displacement<3>&);
template std::optional<PointValues<2>> values_at(const scene::Problem<2>&, const scene::Displacement<2>&,
                                                 const scene::Stress<2>&, const Vector<2>&);
template std::optional<PointValues<3>> values_at(const scene::Problem<3>&, const scene::Displacement<3>&,
                                                 const scene::Stress<3>&, const Vector<3>&);

}  // namespace bracket::bounds
