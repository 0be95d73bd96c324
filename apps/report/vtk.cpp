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

std::string solution_vtu(const scene::Problem<2>& problem, const scene::Displacement<2>& displacement,
                         const scene::Stress<2>& stress, const bounds::Indicator& indicator) {
  const scene::Mesh<2>& mesh = problem.mesh;
  Grid grid{.cell_type = 5, .points_per_cell = 3, .points = {}, .point_data = {}, .cell_data = {}};
  std::vector<float> displacements, of_displacement, equilibrated, share, density;
  std::vector<std::int32_t> body;
  grid.points.reserve(27 * mesh.cells.size());
  for (auto* each : {&displacements, &of_displacement, &equilibrated}) each->reserve(27 * mesh.cells.size());
  for (int cell = 0; cell < static_cast<int>(mesh.cells.size()); ++cell) {
    // The vertices and, last, the centroid, where linear fields have the mean of the vertices.
    const auto of_vertices = bounds::displacement_stress(problem, displacement, cell);
    std::array<scene::Vector<2>, 4> point, moved;
    std::array<scene::Voigt<2>, 4> sigma;
    for (int k = 0; k < 3; ++k) {
      point[k] = mesh.vertices[mesh.cells[cell][k]];
      moved[k] = displacement.vertex[mesh.cells[cell][k]];
      sigma[k] = of_vertices[k];
    }
    point[3] = (point[0] + point[1] + point[2]) / 3;
    sigma[3] = (sigma[0] + sigma[1] + sigma[2]) / 3;
    moved[3] = at_centroid(mesh, displacement, cell);
    for (int part = 0; part < 3; ++part) {
      const std::array<int, 3> corners = {(part + 1) % 3, (part + 2) % 3, 3};
      for (int i = 0; i < 3; ++i) {
        const int corner = corners[i];
        append(grid.points, point[corner]);
        append(displacements, {moved[corner].x(), moved[corner].y(), 0.0});
        append(of_displacement, sigma[corner]);
        append(equilibrated, stress.cell[cell][3 * part + i]);
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
  Grid grid{.cell_type = 3, .points_per_cell = 2, .points = {}, .point_data = {}, .cell_data = {}};
  std::vector<float> pressure, gap, share;
  std::vector<std::int32_t> pair;
  for (std::size_t facet = 0; facet < problem.contact.size(); ++facet) {
    for (int end = 0; end < 2; ++end) {
      append(grid.points, mesh.vertices[mesh.boundary[problem.contact[facet].first].vertices[end]]);
      pressure.push_back(static_cast<float>(contact[facet].pressure[end]));
      gap.push_back(static_cast<float>(contact[facet].gap_left[end]));
    }
    pair.push_back(problem.contact[facet].pair);
    share.push_back(static_cast<float>(indicator.contact[facet]));
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

std::string collection_pvd(int levels, bool contact) {
  std::string text =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
      "<Collection>\n";
  const auto add = [&text](int level, int part, const char* name) {
    text += fmt::format("<DataSet timestep=\"{0}\" part=\"{1}\" file=\"{2}_{0}.vtu\"/>\n", level, part, name);
  };
  for (int level = 0; level < levels; ++level) {
    add(level, 0, "solution");
    if (contact) add(level, 1, "contact");
  }
  return text + "</Collection>\n</VTKFile>\n";
}

}  // namespace bracket::apps
