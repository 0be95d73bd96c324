// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// Planar but for the collection.
#include "apps/report/vtk.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>

#include "apps/report/deformed.h"
#include "apps/report/samples.h"
#include "apps/report/stresses.h"
#include "apps/report/vtk_about.h"
#include "scene/offsets.h"
#include "scene/parallel.h"

namespace bracket::apps {
namespace {

/// The points of VTK's triangle of an order, barycentric: corners, then those inside of its sides, then those inside.
std::vector<std::array<double, 3>> points_of(int order) {
  std::vector<std::array<double, 3>> points = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (int side = 0; side < 3; ++side)
    for (int k = 1; k < order; ++k) {
      std::array<double, 3> point = {0, 0, 0};
      point[(side + 1) % 3] = static_cast<double>(k) / order;
      point[side] = 1 - point[(side + 1) % 3];
      points.push_back(point);
    }
  for (const auto& i : scene::bernstein_indices(order))  // one of three, or the three of order 4
    if (i[0] > 0 && i[1] > 0 && i[2] > 0)
      points.push_back(
          {static_cast<double>(i[0]) / order, static_cast<double>(i[1]) / order, static_cast<double>(i[2]) / order});
  return points;
}

/// By which a cell's corners and coefficients count at a point of one of its parts.
struct Weights {
  std::array<double, 3> corner;
  std::vector<double> displacement, of_displacement, equilibrated;
  bool on_facet;  ///< the part's
  double along;   ///< from that one's vertex 0 to its vertex 1, if it is on it
};

/// Of the points of a part's lattice, for each part.
std::array<std::vector<Weights>, 3> weights_of(const std::vector<std::array<double, 3>>& lattice, int degree,
                                               int stress_degree) {
  std::array<std::vector<Weights>, 3> result;
  for (int part = 0; part < 3; ++part)
    for (const auto& of_part : lattice) {
      std::array<double, 3> point = {of_part[2] / 3, of_part[2] / 3, of_part[2] / 3};
      for (int corner = 0; corner < 2; ++corner) point[scene::Simplex<2>::facets[part][corner]] += of_part[corner];
      result[part].push_back({point, scene::bernstein_values(degree, point),
                              scene::bernstein_values(scene::stress_degree(degree), point),
                              scene::bernstein_values(stress_degree, of_part), of_part[2] == 0, of_part[1]});
    }
  return result;
}

template <class Factors, class Values> auto sum(const Factors& factors, const Values& values) {
  auto result = (factors[0] * values[0]).eval();
  for (std::size_t i = 1; i < values.size(); ++i) result += factors[i] * values[i];
  return result;
}

/// VTK's numbers for triangles: linear, quadratic, Lagrange's of the order that its points tell.
int cell_type(int order) { return order == 1 ? 5 : order == 2 ? 22 : 69; }

/// The stresses at points, both of them and what is told of their mean.
struct Stresses {
  LargeArray<double> of_displacement, equilibrated, von_mises, principal;

  explicit Stresses(std::size_t points)
      : of_displacement(6 * points), equilibrated(6 * points), von_mises(points), principal(2 * points) {}
};

void set_stresses(Stresses& stresses, std::size_t point, const scene::Material<2>& material, scene::Plane plane,
                  const scene::Voigt<2>& of_displacement, const scene::Voigt<2>& equilibrated) {
  const auto across = [&](const scene::Voigt<2>& s) {
    return stress_across(material, plane, s).value_or(std::numeric_limits<double>::quiet_NaN());
  };
  const auto set = [&](LargeArray<double>& values, const scene::Voigt<2>& s) {
    const std::array<double, 6> all = {s[0], s[1], across(s), s[2], 0, 0};
    std::ranges::copy(all, values.begin() + static_cast<std::ptrdiff_t>(6 * point));
  };
  set(stresses.of_displacement, of_displacement);
  set(stresses.equilibrated, equilibrated);
  const scene::Voigt<2> mean = (of_displacement + equilibrated) / 2;
  stresses.von_mises[point] = von_mises(mean, across(mean));
  const auto [larger, smaller] = principal_stresses(mean);
  stresses.principal[2 * point] = larger;
  stresses.principal[2 * point + 1] = smaller;
}

DrawnShape shape_of(const Report& report) {
  return drawn_shape(report.outcome.problem, magnification(report.outcome.problem, report.outcome.displacement));
}

void append(LargeArray<float>& values, const scene::Vector<2>& vector) {
  values.insert(values.end(), {static_cast<float>(vector.x()), static_cast<float>(vector.y()), 0.0F});
}

/// With a third coordinate 0.
template <class Number> void set(LargeArray<Number>& values, std::size_t point, const scene::Vector<2>& vector) {
  values[3 * point] = static_cast<Number>(vector.x());
  values[3 * point + 1] = static_cast<Number>(vector.y());
  values[3 * point + 2] = 0;
}

}  // namespace

template <> std::string solution_vtu(const Report& report) {
  const scene::Problem<2>& problem = report.outcome.problem;
  const scene::Displacement<2>& displacement = report.outcome.displacement;
  const scene::Stress<2>& stress = report.outcome.stress;
  const scene::Mesh<2>& mesh = problem.mesh;
  const auto lattice = points_of(displacement.degree);
  VtkGrid grid{.cell_type = cell_type(displacement.degree), .points_per_cell = static_cast<int>(lattice.size())};
  const std::size_t n_parts = 3 * mesh.cells.size(), n_points = n_parts * lattice.size();
  grid.points.resize(3 * n_points);
  LargeArray<double> displacements(3 * n_points), share(n_parts), density(n_parts);
  LargeArray<float> drawn(3 * n_points);
  Stresses stresses(n_points);
  LargeArray<std::int32_t> body(n_parts);
  const DrawnShape shape = shape_of(report);
  const auto facets = facets_of_cells(mesh);
  const auto weights = weights_of(lattice, displacement.degree, stress.degree);
  scene::for_each_index(static_cast<int>(mesh.cells.size()), [&](int cell) {
    const auto sigma = bounds::displacement_stress(problem, displacement, cell);
    const auto offset = scene::offsets_on_cell(mesh, displacement, cell);
    const auto x = scene::positions(mesh, mesh.cells[cell]);
    const scene::Material<2>& material = scene::body_of(problem, cell).material;
    std::array<scene::Vector<2>, 3> moved, shifted;
    for (int k = 0; k < 3; ++k) {
      moved[k] = displacement.vertex[mesh.cells[cell][k]];
      shifted[k] = shape.shift[mesh.cells[cell][k]];
    }
    for (int part = 0; part < 3; ++part) {
      const auto lambda = scene::stress_of_part(stress, cell, part);
      const std::size_t own = 3 * static_cast<std::size_t>(cell) + static_cast<std::size_t>(part);
      std::size_t point = own * lattice.size();
      for (const Weights& weight : weights[part]) {
        const scene::Vector<2> u = sum(weight.corner, moved) + sum(weight.displacement, offset);
        set(grid.points, point, sum(weight.corner, x));
        set(displacements, point, u);
        scene::Vector<2> to = shape.factor * u + sum(weight.corner, shifted);
        if (const int facet = facets[cell][part]; facet >= 0 && weight.on_facet)
          to += beside(problem, shape, facet, weight.along);
        set(drawn, point, to);
        set_stresses(stresses, point, material, report.scene.plane, sum(weight.of_displacement, sigma),
                     sum(weight.equilibrated, lambda));
        ++point;
      }
      body[own] = mesh.cell_body[cell];
      share[own] = report.outcome.indicator.cell[cell];
      density[own] = share[own] / scene::volume(mesh, cell);
    }
  });
  grid.point_data.push_back(vtk_array("displacement", "Float64", std::move(displacements), {"x", "y", "z"}));
  grid.point_data.push_back(vtk_array("drawn", "Float32", std::move(drawn), {"x", "y", "z"}));
  grid.point_data.push_back(
      vtk_array("stress_displacement", "Float64", std::move(stresses.of_displacement), vtk_tensor));
  grid.point_data.push_back(vtk_array("stress_equilibrated", "Float64", std::move(stresses.equilibrated), vtk_tensor));
  grid.point_data.push_back(vtk_array("von_mises", "Float64", std::move(stresses.von_mises)));
  grid.point_data.push_back(vtk_array("principal", "Float64", std::move(stresses.principal), {"larger", "smaller"}));
  grid.cell_data.push_back(vtk_array("body", "Int32", std::move(body)));
  grid.cell_data.push_back(vtk_array("indicator", "Float64", std::move(share)));
  grid.cell_data.push_back(vtk_array("indicator_density", "Float64", std::move(density)));
  grid.field_data = about(report, shape.factor);
  return vtu(std::move(grid));
}

template <> std::string contact_vtu(const Report& report) {
  const scene::Problem<2>& problem = report.outcome.problem;
  const scene::Mesh<2>& mesh = problem.mesh;
  VtkGrid grid{.cell_type = 3, .points_per_cell = 2};  // ParaView 5.11 does not survive quadratic lines
  std::size_t pieces = 1;                              // of a facet: as fine as gaps and pressures need
  for (const auto& state : report.contact)
    pieces = std::max({pieces, samples(state.gap_left).size() - 1, samples(state.pressure).size() - 1});
  LargeArray<double> displacements, pressure, of_displacement, gap, share;
  LargeArray<float> drawn;
  LargeArray<std::int32_t> pair;
  const DrawnShape shape = shape_of(report);
  for (std::size_t i = 0; i < problem.contact.size(); ++i) {
    const int facet = problem.contact[i].first;
    const auto& [a, b] = scene::positions(mesh, mesh.boundary[facet].vertices);
    const std::vector<double> pushed = displacement_pressure(problem, report.outcome.displacement, facet);
    const auto& [from, to] = scene::Simplex<2>::facets[mesh.boundary[facet].local];
    for (std::size_t k = 0; k < 2 * pieces; ++k) {  // both ends of each piece
      const double t = static_cast<double>((k + 1) / 2) / static_cast<double>(pieces);
      const scene::Vector<2> x = (1 - t) * a + t * b;
      append(grid.points, x);
      append(drawn, drawn_on_facet(problem, &report.outcome.displacement, shape, facet, t) - x);
      std::array<double, 3> point = {0, 0, 0};
      point[from] = 1 - t;
      point[to] = t;
      append(displacements,
             scene::displacement_at(mesh, report.outcome.displacement, mesh.boundary[facet].cell, point));
      pressure.push_back(scene::value_on_segment(report.contact[i].pressure, t));
      of_displacement.push_back(scene::value_on_segment(pushed, t));
      gap.push_back(scene::value_on_segment(report.contact[i].gap_left, t));
    }
    pair.insert(pair.end(), pieces, problem.contact[i].pair);
    share.insert(share.end(), pieces, report.outcome.indicator.contact[i] / static_cast<double>(pieces));
  }
  grid.point_data = {vtk_array("displacement", "Float64", displacements, {"x", "y", "z"}),
                     vtk_array("drawn", "Float32", drawn, {"x", "y", "z"}), vtk_array("pressure", "Float64", pressure),
                     vtk_array("pressure_displacement", "Float64", of_displacement), vtk_array("gap", "Float64", gap)};
  grid.cell_data = {vtk_array("pair", "Int32", pair), vtk_array("indicator", "Float64", share)};
  grid.field_data = about(report, shape.factor);
  return vtu(std::move(grid));
}

std::string collection_pvd(int first, int levels, bool contact) {
  std::string text =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
      "<Collection>\n";
  const auto add = [&text](int level, int part, const char* name) {
    text += fmt::format("<DataSet timestep=\"{0}\" part=\"{1}\" file=\"{2}_{0}.vtu\"/>\n", level, part, name);
  };
  for (int level = first; level < levels; ++level) {
    add(level, 0, "solution");
    if (contact) add(level, 1, "contact");
  }
  return text + "</Collection>\n</VTKFile>\n";
}

}  // namespace bracket::apps
