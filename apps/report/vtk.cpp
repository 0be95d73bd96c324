// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/report/vtk.h"

#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <cstring>
#include <span>
#include <utility>

#include "apps/report/assessment.h"
#include "apps/report/samples.h"
#include "scene/offsets.h"

namespace bracket::apps {
namespace {

static_assert(std::endian::native == std::endian::little, "the files say that they are little-endian");

struct Array {
  std::string name;
  std::string type;                     // as VTK calls it
  std::vector<std::string> components;  // their names; one without name: a scalar
  std::string bytes;
};

struct Grid {
  int cell_type;  // VTK's number
  int points_per_cell;
  std::vector<double> points;  // x, y, z of each; the points of a cell follow one another and are its own
  std::vector<Array> point_data;
  std::vector<Array> cell_data;
};

template <typename Number>
Array array(std::string name, const char* type, const std::vector<Number>& values,
            std::vector<std::string> components = {""}) {
  std::string bytes(values.size() * sizeof(Number), '\0');
  if (!values.empty()) std::memcpy(bytes.data(), values.data(), bytes.size());
  return {std::move(name), type, std::move(components), std::move(bytes)};
}

// The element that announces an array whose bytes begin at `offset` of the appended data.
std::string announce(const Array& data, std::size_t offset) {
  std::string components;
  if (data.components.size() > 1) {
    components = fmt::format(R"( NumberOfComponents="{}")", data.components.size());
    for (std::size_t i = 0; i < data.components.size(); ++i)
      components += fmt::format(R"( ComponentName{}="{}")", i, data.components[i]);
  }
  return fmt::format(R"(<DataArray type="{}" Name="{}"{} format="appended" offset="{}"/>)"
                     "\n",
                     data.type, data.name, components, offset);
}

// The arrays of VTK's three obligatory sections: where the points are, and which of them make a cell.
std::vector<Array> topology(const Grid& grid) {
  const std::size_t n_points = grid.points.size() / 3;
  const std::size_t n_cells = n_points / grid.points_per_cell;
  std::vector<std::int32_t> connectivity(n_points), offsets(n_cells);
  for (std::size_t i = 0; i < n_points; ++i) connectivity[i] = static_cast<std::int32_t>(i);
  for (std::size_t i = 0; i < n_cells; ++i) offsets[i] = static_cast<std::int32_t>((i + 1) * grid.points_per_cell);
  return {array("Points", "Float64", grid.points, {"x", "y", "z"}), array("connectivity", "Int32", connectivity),
          array("offsets", "Int32", offsets),
          array("types", "UInt8", std::vector<std::uint8_t>(n_cells, static_cast<std::uint8_t>(grid.cell_type)))};
}

std::string vtu(const Grid& grid) {
  const std::vector<Array> shape = topology(grid);
  const std::size_t n_points = grid.points.size() / 3;
  std::string header, data;
  std::vector<const Array*> order;  // of the appended data
  std::size_t offset = 0;
  const auto section = [&](const std::string& name, std::span<const Array> arrays) {
    header += fmt::format("<{}>\n", name);
    for (const Array& each : arrays) {
      header += announce(each, offset);
      offset += sizeof(std::uint64_t) + each.bytes.size();
      order.push_back(&each);
    }
    header += fmt::format("</{}>\n", name);
  };
  header = fmt::format(
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
      "<UnstructuredGrid>\n<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n",
      n_points, n_points / grid.points_per_cell);
  section("Points", std::span(shape).first(1));
  section("Cells", std::span(shape).subspan(1));
  section("PointData", grid.point_data);
  section("CellData", grid.cell_data);
  header += "</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_";

  const std::string end = "\n</AppendedData>\n</VTKFile>\n";
  std::string file;
  file.reserve(header.size() + offset + end.size());
  file += header;
  for (const Array* each : order) {
    const std::uint64_t size = each->bytes.size();
    file.append(reinterpret_cast<const char*>(&size), sizeof size);
    file += each->bytes;
  }
  return file += end;
}

void append(std::vector<float>& values, const scene::Voigt<2>& stress) {
  for (int i = 0; i < 3; ++i) values.push_back(static_cast<float>(stress[i]));
}

void append(std::vector<double>& points, const scene::Vector<2>& point) {
  points.insert(points.end(), {point.x(), point.y(), 0.0});
}

}  // namespace

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
                              scene::bernstein_values(stress_degree, of_part)});
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

}  // namespace

std::string solution_vtu(const scene::Problem<2>& problem, const scene::Displacement<2>& displacement,
                         const scene::Stress<2>& stress, const bounds::Indicator& indicator) {
  const scene::Mesh<2>& mesh = problem.mesh;
  const auto lattice = points_of(displacement.degree);
  Grid grid{.cell_type = cell_type(displacement.degree),
            .points_per_cell = static_cast<int>(lattice.size()),
            .points = {},
            .point_data = {},
            .cell_data = {}};
  std::vector<float> displacements, of_displacement, equilibrated, share, density;
  std::vector<std::int32_t> body;
  grid.points.reserve(9 * lattice.size() * mesh.cells.size());
  for (auto* each : {&displacements, &of_displacement, &equilibrated})
    each->reserve(9 * lattice.size() * mesh.cells.size());
  const auto weights = weights_of(lattice, displacement.degree, stress.degree);
  for (int cell = 0; cell < static_cast<int>(mesh.cells.size()); ++cell) {
    const auto sigma = bounds::displacement_stress(problem, displacement, cell);
    const auto offset = scene::offsets_on_cell(mesh, displacement, cell);
    const auto x = scene::positions(mesh, mesh.cells[cell]);
    std::array<scene::Vector<2>, 3> moved;
    for (int k = 0; k < 3; ++k) moved[k] = displacement.vertex[mesh.cells[cell][k]];
    for (int part = 0; part < 3; ++part) {
      const auto lambda = scene::stress_of_part(stress, cell, part);
      for (const Weights& weight : weights[part]) {
        const scene::Vector<2> u = sum(weight.corner, moved) + sum(weight.displacement, offset);
        append(grid.points, sum(weight.corner, x));
        append(displacements, {u.x(), u.y(), 0.0});
        append(of_displacement, sum(weight.of_displacement, sigma));
        append(equilibrated, sum(weight.equilibrated, lambda));
      }
      body.push_back(mesh.cell_body[cell]);
      share.push_back(static_cast<float>(indicator.cell[cell]));
      density.push_back(static_cast<float>(indicator.cell[cell] / scene::volume(mesh, cell)));
    }
  }
  const std::vector<std::string> voigt = {"xx", "yy", "xy"};
  grid.point_data = {array("displacement", "Float32", displacements, {"x", "y", "z"}),
                     array("stress_displacement", "Float32", of_displacement, voigt),
                     array("stress_equilibrated", "Float32", equilibrated, voigt)};
  grid.cell_data = {array("body", "Int32", body), array("indicator", "Float32", share),
                    array("indicator_density", "Float32", density)};
  return vtu(grid);
}

std::string contact_vtu(const scene::Problem<2>& problem, const std::vector<bounds::ContactState>& contact,
                        const bounds::Indicator& indicator) {
  const scene::Mesh<2>& mesh = problem.mesh;
  std::size_t pieces = 1;  // of a facet: as fine as the pressures need
  for (const auto& state : contact) pieces = std::max(pieces, samples(state.pressure).size() - 1);
  Grid grid{.cell_type = 3, .points_per_cell = 2, .points = {}, .point_data = {}, .cell_data = {}};
  std::vector<float> pressure, gap, share;
  std::vector<std::int32_t> pair;
  for (std::size_t facet = 0; facet < problem.contact.size(); ++facet) {
    const auto& [a, b] = scene::positions(mesh, mesh.boundary[problem.contact[facet].first].vertices);
    for (std::size_t piece = 0; piece < pieces; ++piece)
      for (std::size_t end = 0; end < 2; ++end) {
        const double t = static_cast<double>(piece + end) / static_cast<double>(pieces);
        append(grid.points, (1 - t) * a + t * b);
        pressure.push_back(static_cast<float>(scene::value_on_segment(contact[facet].pressure, t)));
        gap.push_back(static_cast<float>(scene::value_on_segment(contact[facet].gap_left, t)));
      }
    pair.insert(pair.end(), pieces, problem.contact[facet].pair);
    share.insert(share.end(), pieces, static_cast<float>(indicator.contact[facet]));
  }
  grid.point_data = {array("pressure", "Float32", pressure), array("gap", "Float32", gap)};
  grid.cell_data = {array("pair", "Int32", pair), array("indicator", "Float32", share)};
  return vtu(grid);
}

std::string assessment_vtu(const bounds::Assessment& assessment) {
  const scene::Mesh<2>& mesh = assessment.field.problem.mesh;
  const scene::Displacement<2>& u = assessment.field.given.displacement;
  const bool quadratic = u.degree == 2;
  Grid grid{.cell_type = quadratic ? 22 : 5,
            .points_per_cell = quadratic ? 6 : 3,
            .points = {},
            .point_data = {},
            .cell_data = {}};
  std::vector<double> displacements, share, density;
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) {
    const auto& vertices = mesh.cells[cell];
    for (const int vertex : vertices) {
      append(grid.points, mesh.vertices[vertex]);
      append(displacements, u.vertex[vertex]);
    }
    for (int k = 0; quadratic && k < 3; ++k) {
      const int edge = mesh.cell_edges[cell][scene::Simplex<2>::edge_between(k, (k + 1) % 3)];
      append(grid.points, (mesh.vertices[vertices[k]] + mesh.vertices[vertices[(k + 1) % 3]]) / 2);
      append(displacements, u.edge[edge]);
    }
    share.push_back(assessment.cell[cell]);
    density.push_back(assessment.cell[cell] / scene::volume(mesh, static_cast<int>(cell)));
  }
  grid.point_data = {array("displacement", "Float64", displacements, {"x", "y", "z"})};
  grid.cell_data = {array("body", "Int32", std::vector<std::int32_t>(mesh.cell_body.begin(), mesh.cell_body.end())),
                    array("error_squared", "Float64", share), array("error_density", "Float64", density)};
  return vtu(grid);
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
