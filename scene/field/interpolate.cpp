// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// Planar: cells are triangles and quadrilaterals.
#include <fmt/format.h>

#include <algorithm>

#include "scene/field/boxes.h"
#include "scene/field/raw_field.h"
#include "scene/field/reference_cell.h"
#include "scene/text.h"

namespace bracket::scene {

namespace {

/// A cell of the file with the places of its nodes.
struct Cell {
  int corners;
  std::vector<int> nodes;
  std::vector<Vector<2>> x;
};

Cell cell_of(const RawField& field, const RawField::Cell& cell) {
  Cell result{cell.corners, cell.nodes, {}};
  for (const int node : cell.nodes) result.x.emplace_back(field.nodes[node].x[0], field.nodes[node].x[1]);
  return result;
}

/// Points whose hull holds the cell: those of its sides' Bernstein polynomials.
std::vector<Vector<2>> hull(const Cell& cell) {
  std::vector<Vector<2>> points(cell.x.begin(), cell.x.begin() + cell.corners);
  for (int k = 0; k < cell.corners && cell.x.size() > points.size(); ++k) {
    const Vector<2>&a = cell.x[k], &b = cell.x[(k + 1) % cell.corners];
    points.push_back(2 * cell.x[cell.corners + k] - 0.5 * (a + b));
  }
  return points;
}

/// How far outside of a cell a point is; 0: it is not. \param reference the point of the reference cell there
double outside(const Cell& cell, const Vector<2>& reference, const Vector<2>& x) {
  return is_inside(cell.corners, reference) ? 0 : distance_from_sides(cell.corners, cell.x, x);
}

/// Finds cells of the mesh.
class MeshCells {
 public:
  explicit MeshCells(const Mesh<2>& mesh) : mesh_(mesh), boxes_(all(mesh)) {}

  /// A cell with the point in it, to the tolerance; −1: there is none.
  int at(const Vector<2>& x, double tolerance) const {
    for (const int cell : boxes_.near(x, tolerance)) {
      const Cell triangle{3, {}, points(mesh_, cell)};
      const auto reference = reference_point(3, triangle.x, x);
      if (reference && outside(triangle, *reference, x) <= tolerance) return cell;
    }
    return -1;
  }

 private:
  static std::vector<Vector<2>> points(const Mesh<2>& mesh, int cell) {
    const auto x = positions(mesh, mesh.cells[cell]);
    return {x.begin(), x.end()};
  }
  static std::vector<std::vector<Vector<2>>> all(const Mesh<2>& mesh) {
    std::vector<std::vector<Vector<2>>> result;
    for (int cell = 0; cell < static_cast<int>(mesh.cells.size()); ++cell) result.push_back(points(mesh, cell));
    return result;
  }
  const Mesh<2>& mesh_;
  Boxes boxes_;
};

/// The cells of the file that lie in one component of the mesh.
struct Part {
  std::vector<Cell> cells;
  std::optional<Boxes> boxes;
};

std::vector<Part> parts_of(const RawField& field, const Mesh<2>& mesh, double tolerance) {
  std::vector<Part> parts(mesh.components.size());
  const MeshCells mesh_cells(mesh);
  for (const RawField::Cell& given : field.cells) {
    Cell cell = cell_of(field, given);
    Vector<2> middle = Vector<2>::Zero();
    for (int k = 0; k < cell.corners; ++k) middle += cell.x[k] / cell.corners;
    const int there = mesh_cells.at(middle, tolerance);
    if (there == -1)
      refuse(field, given.nodes[0],
             fmt::format("belongs to a cell around {} that is outside of the mesh; expected the same bodies",
                         point(middle)));
    parts[mesh.cell_component[there]].cells.push_back(std::move(cell));
  }
  for (Part& part : parts) {
    std::vector<std::vector<Vector<2>>> hulls;
    for (const Cell& cell : part.cells) hulls.push_back(hull(cell));
    part.boxes.emplace(hulls);
  }
  return parts;
}

/// The displacement on a cell, and by how much it changes where the point is off by the tolerance.
struct Value {
  Vector<2> u;
  double change;
};

Value value_on(const RawField& field, const Cell& cell, const Vector<2>& reference, double tolerance) {
  const Basis basis = basis_at(cell.corners, cell.nodes.size(), reference);
  Vector<2> u = Vector<2>::Zero();
  Eigen::Matrix2d jacobian = Eigen::Matrix2d::Zero(), slope = Eigen::Matrix2d::Zero();
  for (std::size_t k = 0; k < cell.nodes.size(); ++k) {
    u += basis.value[k] * field.values[cell.nodes[k]];
    jacobian += cell.x[k] * basis.gradient[k].transpose();
    slope += field.values[cell.nodes[k]] * basis.gradient[k].transpose();
  }
  return {u, (slope * jacobian.inverse()).norm() * tolerance};
}

/// Of places and of values.
struct Tolerances {
  double place, value;
};

/// Of the cells that the point is in, to the tolerance, the one that it is least outside of; they must agree.
Vector<2> value_at(const RawField& field, const Mesh<2>& mesh, const Part& part, int component, const Vector<2>& x,
                   const Tolerances& tolerance) {
  std::optional<Value> best;
  double least = 0;
  for (const int number : part.boxes->near(x, tolerance.place)) {
    const Cell& cell = part.cells[number];
    const auto reference = reference_point(cell.corners, cell.x, x);
    if (!reference) continue;
    const double distance = outside(cell, *reference, x);
    if (distance > tolerance.place) continue;
    const Value value = value_on(field, cell, *reference, tolerance.place);
    if (best && (best->u - value.u).norm() > best->change + value.change + 2 * tolerance.value)
      fail(Status::input, field.file,
           fmt::format("the displacement jumps at {} in '{}'; expected a continuous one in each body", point(x),
                       mesh.components[component]));
    if (best && distance >= least) continue;
    best = value;
    least = distance;
  }
  if (best) return best->u;
  fail(Status::input, field.file,
       fmt::format("no cell of '{}' holds the node of the mesh at {}, to {:.1e}; expected the same bodies, each with "
                   "cells of its own",
                   mesh.components[component], point(x), tolerance.place));
}

}  // namespace

GivenDisplacement interpolated(const RawField& field, const Mesh<2>& mesh) {
  const Tolerances tolerance = {place_tolerance(field, mesh), value_tolerance(field)};
  const std::vector<Part> parts = parts_of(field, mesh, tolerance.place);
  std::vector<int> of_vertex(mesh.vertices.size(), -1), of_edge(mesh.edges.size(), -1);  // components
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) {
    for (const int vertex : mesh.cells[cell]) of_vertex[vertex] = mesh.cell_component[cell];
    for (const int edge : mesh.cell_edges[cell]) of_edge[edge] = mesh.cell_component[cell];
  }
  GivenDisplacement result;
  result.interpolated = true;
  const auto value = [&](int component, const Vector<2>& x) {
    return value_at(field, mesh, parts[component], component, x, tolerance);
  };
  for (std::size_t vertex = 0; vertex < mesh.vertices.size(); ++vertex)
    result.displacement.vertex.push_back(value(of_vertex[vertex], mesh.vertices[vertex]));
  for (std::size_t edge = 0; edge < mesh.edges.size(); ++edge) {
    const auto& [a, b] = mesh.edges[edge];
    result.displacement.edge.push_back(value(of_edge[edge], 0.5 * (mesh.vertices[a] + mesh.vertices[b])));
  }
  return result;
}

}  // namespace bracket::scene
