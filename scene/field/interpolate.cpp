// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "scene/field/boxes.h"
#include "scene/field/raw_field.h"
#include "scene/field/reference_cell.h"
#include "scene/text.h"

namespace bracket::scene {

namespace {

/// A cell of the file with the places of its nodes.
template <int dim> struct Cell {
  int corners;
  std::vector<int> nodes;
  std::vector<Vector<dim>> x;
};

/// In space edges are straight, to the tolerance.
template <int dim>
Cell<dim> cell_of(const RawField<dim>& field, const typename RawField<dim>::Cell& cell, double tolerance) {
  Cell<dim> result{cell.corners, cell.nodes, {}};
  for (const int node : cell.nodes) result.x.emplace_back(Eigen::Map<const Vector<dim>>(field.nodes[node].x.data()));
  for (std::size_t e = 0; dim == 3 && e + 4 < cell.nodes.size(); ++e) {
    const auto [a, b] = edges_in_files<dim>()[e];
    if ((result.x[4 + e] - 0.5 * (result.x[a] + result.x[b])).norm() > tolerance)
      refuse(field, cell.nodes[4 + e],
             "is not in the middle of its edge; expected straight edges, as the bodies of a scene in space have");
  }
  return result;
}

/// Points whose hull holds the cell: those of its sides' Bernstein polynomials.
template <int dim> std::vector<Vector<dim>> hull(const Cell<dim>& cell) {
  std::vector<Vector<dim>> points(cell.x.begin(), cell.x.begin() + cell.corners);
  for (int k = 0; dim == 2 && k < cell.corners && cell.x.size() > points.size(); ++k) {
    const Vector<dim>&a = cell.x[k], &b = cell.x[(k + 1) % cell.corners];
    points.push_back(2 * cell.x[cell.corners + k] - 0.5 * (a + b));
  }
  return points;
}

/// How far outside of a cell a point is; 0: it is not. \param reference the point of the reference cell there
template <int dim> double outside(const Cell<dim>& cell, const Vector<dim>& reference, const Vector<dim>& x) {
  return is_inside(cell.corners, reference) ? 0 : distance_from_sides(cell.corners, cell.x, x);
}

/// Finds cells of the mesh.
template <int dim> class MeshCells {
 public:
  explicit MeshCells(const Mesh<dim>& mesh) : mesh_(mesh), boxes_(all(mesh)) {}

  /// A cell with the point in it, to the tolerance; −1: there is none.
  int at(const Vector<dim>& x, double tolerance) const {
    for (const int cell : boxes_.near(x, tolerance)) {
      const Cell<dim> simplex{dim + 1, {}, points(mesh_, cell)};
      const auto reference = reference_point(dim + 1, simplex.x, x);
      if (reference && outside(simplex, *reference, x) <= tolerance) return cell;
    }
    return -1;
  }

 private:
  static std::vector<Vector<dim>> points(const Mesh<dim>& mesh, int cell) {
    const auto x = positions(mesh, mesh.cells[cell]);
    return {x.begin(), x.end()};
  }
  static std::vector<std::vector<Vector<dim>>> all(const Mesh<dim>& mesh) {
    std::vector<std::vector<Vector<dim>>> result;
    for (int cell = 0; cell < static_cast<int>(mesh.cells.size()); ++cell) result.push_back(points(mesh, cell));
    return result;
  }
  const Mesh<dim>& mesh_;
  Boxes<dim> boxes_;
};

/// The cells of the file that lie in one component of the mesh.
template <int dim> struct Part {
  std::vector<Cell<dim>> cells;
  std::optional<Boxes<dim>> boxes;
};

template <int dim>
std::vector<Part<dim>> parts_of(const RawField<dim>& field, const Mesh<dim>& mesh, double tolerance) {
  std::vector<Part<dim>> parts(mesh.components.size());
  const MeshCells<dim> mesh_cells(mesh);
  for (const auto& given : field.cells) {
    Cell<dim> cell = cell_of(field, given, tolerance);
    Vector<dim> middle = Vector<dim>::Zero();
    for (int k = 0; k < cell.corners; ++k) middle += cell.x[k] / cell.corners;
    const int there = mesh_cells.at(middle, tolerance);
    if (there == -1)
      refuse(field, given.nodes[0],
             fmt::format("belongs to a cell around {} that is outside of the mesh; expected the same bodies",
                         point(middle)));
    parts[mesh.cell_component[there]].cells.push_back(std::move(cell));
  }
  for (Part<dim>& part : parts) {
    std::vector<std::vector<Vector<dim>>> hulls;
    for (const Cell<dim>& cell : part.cells) hulls.push_back(hull(cell));
    part.boxes.emplace(hulls);
  }
  return parts;
}

/// The displacement on a cell, and by how much it changes where the point is off by the tolerance.
template <int dim> struct Value {
  Vector<dim> u;
  double change;
};

template <int dim>
Value<dim> value_on(const RawField<dim>& field, const Cell<dim>& cell, const Vector<dim>& reference, double tolerance) {
  const Basis<dim> basis = basis_at(cell.corners, cell.nodes.size(), reference);
  Vector<dim> u = Vector<dim>::Zero();
  using Matrix = Eigen::Matrix<double, dim, dim>;
  Matrix jacobian = Matrix::Zero(), slope = Matrix::Zero();
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
template <int dim>
Vector<dim> value_at(const RawField<dim>& field, const Mesh<dim>& mesh, const Part<dim>& part, int component,
                     const Vector<dim>& x, const Tolerances& tolerance) {
  std::optional<Value<dim>> best;
  double least = 0;
  for (const int number : part.boxes->near(x, tolerance.place)) {
    const Cell<dim>& cell = part.cells[number];
    const auto reference = reference_point(cell.corners, cell.x, x);
    if (!reference) continue;
    const double distance = outside(cell, *reference, x);
    if (distance > tolerance.place) continue;
    const Value<dim> value = value_on(field, cell, *reference, tolerance.place);
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

template <int dim> GivenDisplacementOf<dim> interpolated(const RawField<dim>& field, const Mesh<dim>& mesh) {
  const Tolerances tolerance = {place_tolerance(field, mesh), value_tolerance(field)};
  const std::vector<Part<dim>> parts = parts_of(field, mesh, tolerance.place);
  std::vector<int> of_vertex(mesh.vertices.size(), -1), of_edge(mesh.edges.size(), -1);  // components
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) {
    for (const int vertex : mesh.cells[cell]) of_vertex[vertex] = mesh.cell_component[cell];
    for (const int edge : mesh.cell_edges[cell]) of_edge[edge] = mesh.cell_component[cell];
  }
  GivenDisplacementOf<dim> result;
  result.interpolated = true;
  const auto value = [&](int component, const Vector<dim>& x) {
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

template GivenDisplacementOf<2> interpolated(const RawField<2>&, const Mesh<2>&);
template GivenDisplacementOf<3> interpolated(const RawField<3>&, const Mesh<3>&);

}  // namespace bracket::scene
