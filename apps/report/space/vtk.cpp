// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// In space: tetrahedra and contact faces.
#include "apps/report/vtk.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "apps/report/deformed.h"
#include "apps/report/samples.h"
#include "apps/report/space/cell_values.h"
#include "apps/report/stresses.h"
#include "apps/report/vtk_about.h"
#include "scene/offsets.h"
#include "scene/parallel.h"
#include "scene/voigt.h"

namespace bracket::apps {
namespace {

using scene::Simplex;
using scene::Vector;
using scene::Voigt;

/// VTK's nodes of a part. Seen from the centroid the facet's vertices run the wrong way round, so that two change
/// places.
constexpr std::array<int, 4> corner_order = {0, 2, 1, 3};
/// The edges at whose middles it has nodes behind the corners, and those of a triangle, as Simplex has them.
constexpr std::array<int, 6> edge_order_of_part = {1, 0, 2, 3, 5, 4};
constexpr std::array<int, 3> edge_order_of_face = {2, 0, 1};

/// The nodes of one part of a cell: its corners and, of degree 2, the middles of its edges, in VTK's order.
struct Node {
  InCell in_cell, in_part;
  bool on_facet;  ///< the part's
};

std::array<std::vector<Node>, 4> nodes_of_parts(int degree) {
  std::array<std::vector<Node>, 4> result;
  for (int part = 0; part < 4; ++part) {
    const auto add = [&](const InCell& in_part, bool on_facet) {
      result[part].push_back({in_cell(part, in_part), in_part, on_facet});
    };
    for (const int i : corner_order) {
      InCell corner = {};
      corner[i] = 1;
      add(corner, i < 3);
    }
    for (const int edge : edge_order_of_part) {
      if (degree == 1) break;
      const auto& [a, b] = Simplex<3>::edges[edge];
      InCell middle = {};
      middle[a] = middle[b] = 0.5;
      add(middle, a < 3 && b < 3);
    }
  }
  return result;
}

template <class Number> void store(LargeArray<Number>& values, std::size_t point, const Vector<3>& vector) {
  for (int k = 0; k < 3; ++k) values[3 * point + k] = static_cast<Number>(vector[k]);
}

void store(LargeArray<double>& values, std::size_t point, const Voigt<3>& s) {
  const std::array<double, 6> own = {s[0], s[1], s[2], s[5], s[3], s[4]};  // Simplex::voigt ends yz, xz, xy
  std::ranges::copy(own, values.begin() + static_cast<std::ptrdiff_t>(6 * point));
}

DrawnShapeOf<3> shape_in_space(const ReportOf<3>& report) {
  return drawn_shape(report.outcome.problem, magnification(report.outcome.problem, report.outcome.displacement));
}

}  // namespace

template <> std::string solution_vtu(const ReportOf<3>& report) {
  const scene::Problem<3>& problem = report.outcome.problem;
  const scene::Displacement<3>& displacement = report.outcome.displacement;
  const scene::Stress<3>& stress = report.outcome.stress;
  const scene::Mesh<3>& mesh = problem.mesh;
  const auto nodes = nodes_of_parts(displacement.degree);
  const std::size_t per_part = nodes[0].size(), n_parts = 4 * mesh.cells.size(), n_points = n_parts * per_part;
  VtkGrid grid{.cell_type = displacement.degree == 1 ? 10 : 24, .points_per_cell = static_cast<int>(per_part)};
  grid.points.resize(3 * n_points);
  LargeArray<double> displacements(3 * n_points), of_displacement(6 * n_points), equilibrated(6 * n_points);
  LargeArray<double> mises(n_points), principal(3 * n_points), share(n_parts), density(n_parts);
  LargeArray<float> drawn(3 * n_points);
  LargeArray<std::int32_t> body(n_parts);
  const DrawnShapeOf<3> shape = shape_in_space(report);
  const auto facets = facets_of_cells(mesh);
  scene::for_each_index(static_cast<int>(mesh.cells.size()), [&](int cell) {
    const auto sigma = bounds::displacement_stress(problem, displacement, cell);
    const auto x = scene::positions(mesh, mesh.cells[cell]);
    for (int part = 0; part < 4; ++part) {
      const auto lambda = scene::stress_of_part(stress, cell, part);
      const std::size_t own = 4 * static_cast<std::size_t>(cell) + static_cast<std::size_t>(part);
      std::size_t point = own * per_part;
      for (const Node& node : nodes[part]) {
        store(grid.points, point, value_in(node.in_cell, x));
        store(displacements, point, scene::displacement_at(mesh, displacement, cell, node.in_cell));
        store(drawn, point,
              way_drawn(problem, displacement, shape, cell, node.in_cell, node.on_facet ? facets[cell][part] : -1));
        const Voigt<3> first = value_in(node.in_cell, sigma), second = value_in(node.in_part, lambda),
                       mean = (first + second) / 2;
        store(of_displacement, point, first);
        store(equilibrated, point, second);
        mises[point] = von_mises(mean);
        std::ranges::copy(principal_stresses(mean), principal.begin() + static_cast<std::ptrdiff_t>(3 * point));
        ++point;
      }
      body[own] = mesh.cell_body[cell];
      share[own] = report.outcome.indicator.cell[cell];
      density[own] = share[own] / scene::volume(mesh, cell);
    }
  });
  grid.point_data.push_back(vtk_array("displacement", "Float64", std::move(displacements), {"x", "y", "z"}));
  grid.point_data.push_back(vtk_array("drawn", "Float32", std::move(drawn), {"x", "y", "z"}));
  grid.point_data.push_back(vtk_array("stress_displacement", "Float64", std::move(of_displacement), vtk_tensor));
  grid.point_data.push_back(vtk_array("stress_equilibrated", "Float64", std::move(equilibrated), vtk_tensor));
  grid.point_data.push_back(vtk_array("von_mises", "Float64", std::move(mises)));
  grid.point_data.push_back(vtk_array("principal", "Float64", std::move(principal), {"largest", "middle", "smallest"}));
  grid.cell_data.push_back(vtk_array("body", "Int32", std::move(body)));
  grid.cell_data.push_back(vtk_array("indicator", "Float64", std::move(share)));
  grid.cell_data.push_back(vtk_array("indicator_density", "Float64", std::move(density)));
  grid.field_data = about(report, shape.factor);
  return vtu(std::move(grid));
}

template <> std::string contact_vtu(const ReportOf<3>& report) {
  const scene::Problem<3>& problem = report.outcome.problem;
  const scene::Mesh<3>& mesh = problem.mesh;
  const std::size_t n_points = 6 * problem.contact.size();
  VtkGrid grid{.cell_type = 22, .points_per_cell = 6};
  grid.points.resize(3 * n_points);
  LargeArray<double> displacements(3 * n_points), pressure, of_displacement, gap, share;
  LargeArray<float> drawn(3 * n_points);
  LargeArray<std::int32_t> pair;
  const DrawnShapeOf<3> shape = shape_in_space(report);
  const auto on_face = [](const std::array<double, 3>& point, const auto& at_vertices) {
    using Value = std::remove_cvref_t<decltype(at_vertices[0])>;
    return Value(point[0] * at_vertices[0] + point[1] * at_vertices[1] + point[2] * at_vertices[2]);
  };
  for (std::size_t i = 0; i < problem.contact.size(); ++i) {
    const int facet = problem.contact[i].first;
    const auto& face = mesh.boundary[facet];
    const auto& corners = Simplex<3>::facets[face.local];
    const Vector<3>& d = problem.facets[facet].normal;
    const auto x = scene::positions(mesh, face.vertices);
    const auto stress = bounds::displacement_stress(problem, report.outcome.displacement, face.cell);
    std::array<double, 3> pushed;
    for (int k = 0; k < 3; ++k) pushed[k] = -scene::traction<3>(stress[corners[k]], d).dot(d);
    scene::FacetQuadratic<3> left;
    std::ranges::copy(report.contact[i].gap_left, left.begin());
    const auto gaps = quadratic_at_nodes<3>(left);
    for (int k = 0; k < 6; ++k) {
      const int node = k < 3 ? k : 3 + edge_order_of_face[k - 3];
      std::array<double, 3> point = {};
      if (k < 3)
        point[k] = 1;
      else
        for (const int end : Simplex<2>::edges[node - 3]) point[end] = 0.5;
      InCell in_cell = {};
      for (int c = 0; c < 3; ++c) in_cell[corners[c]] = point[c];
      const std::size_t own = 6 * i + static_cast<std::size_t>(k);
      store(grid.points, own, on_face(point, x));
      store(displacements, own, scene::displacement_at(mesh, report.outcome.displacement, face.cell, in_cell));
      store(drawn, own, way_drawn(problem, report.outcome.displacement, shape, face.cell, in_cell, facet));
      pressure.push_back(on_face(point, report.contact[i].pressure));
      of_displacement.push_back(on_face(point, pushed));
      gap.push_back(gaps[node]);
    }
    pair.push_back(problem.contact[i].pair);
    share.push_back(report.outcome.indicator.contact[i]);
  }
  grid.point_data = {vtk_array("displacement", "Float64", std::move(displacements), {"x", "y", "z"}),
                     vtk_array("drawn", "Float32", std::move(drawn), {"x", "y", "z"}),
                     vtk_array("pressure", "Float64", std::move(pressure)),
                     vtk_array("pressure_displacement", "Float64", std::move(of_displacement)),
                     vtk_array("gap", "Float64", std::move(gap))};
  grid.cell_data = {vtk_array("pair", "Int32", std::move(pair)), vtk_array("indicator", "Float64", std::move(share))};
  grid.field_data = about(report, shape.factor);
  return vtu(std::move(grid));
}

}  // namespace bracket::apps
