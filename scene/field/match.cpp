// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "scene/field/boxes.h"
#include "scene/field/raw_field.h"
#include "scene/mesh/topology.h"
#include "scene/text.h"

namespace bracket::scene {

namespace {

constexpr const char* way_out = "'bracket mesh' writes the mesh for the other program";

template <int dim> Vector<dim> at(const RawField<dim>& field, int node) {
  return Eigen::Map<const Vector<dim>>(field.nodes[node].x.data());
}

template <int dim> Vector<dim> midpoint(const Mesh<dim>& mesh, int edge) {
  return 0.5 * (mesh.vertices[mesh.edges[edge][0]] + mesh.vertices[mesh.edges[edge][1]]);
}

/// An edge whose nodes, which are half its length apart, the tolerance leaves indistinguishable; −1: there is none.
template <int dim> int indistinct(const Mesh<dim>& mesh, double tolerance) {
  const auto edge = std::ranges::find_if(mesh.edges, [&](const std::array<int, 2>& ends) {
    return (mesh.vertices[ends[1]] - mesh.vertices[ends[0]]).norm() <= 4 * tolerance;
  });
  return edge == mesh.edges.end() ? -1 : static_cast<int>(edge - mesh.edges.begin());
}

/// The points, each as a thing of its own.
template <int dim> Boxes<dim> points(const std::vector<Vector<dim>>& all) {
  std::vector<std::vector<Vector<dim>>> things;
  for (const Vector<dim>& x : all) things.push_back({x});
  return Boxes<dim>(things);
}

// ---- by place -------------------------------------------------------------------------------------------------------

/// Vertices and, behind them, midpoints of edges.
template <int dim> struct Nodes {
  std::vector<Vector<dim>> x;
  std::vector<std::set<int>> bodies;
};

template <int dim> Nodes<dim> nodes_of(const Mesh<dim>& mesh) {
  Nodes<dim> nodes;
  nodes.x = mesh.vertices;
  for (int edge = 0; edge < static_cast<int>(mesh.edges.size()); ++edge) nodes.x.push_back(midpoint(mesh, edge));
  nodes.bodies.resize(nodes.x.size());
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) {
    for (const int vertex : mesh.cells[cell]) nodes.bodies[vertex].insert(mesh.cell_body[cell]);
    for (const int edge : mesh.cell_edges[cell]) nodes.bodies[mesh.vertices.size() + edge].insert(mesh.cell_body[cell]);
  }
  return nodes;
}

/// The number of the body that a node of the file says that it belongs to; −1: it does not say.
template <int dim> int body_of(const RawField<dim>& field, const Mesh<dim>& mesh, int node) {
  if (field.bodies.empty()) return -1;
  const auto body = std::ranges::find(mesh.bodies, field.bodies[node]);
  if (body == mesh.bodies.end())
    refuse(field, node,
           fmt::format("belongs to '{}', which is no body: {}", field.bodies[node].substr(0, 40),
                       suggestion(field.bodies[node], mesh.bodies)));
  return static_cast<int>(body - mesh.bodies.begin());
}

/// Of each node of the mesh the node of the file at its place, −1: there is none.
template <int dim>
std::vector<int> nodes_at(const RawField<dim>& field, const Mesh<dim>& mesh, const Nodes<dim>& nodes,
                          double tolerance) {
  std::vector<int> given(nodes.x.size(), -1);
  const Boxes<dim> places = points(nodes.x);
  for (int i = 0; i < static_cast<int>(field.nodes.size()); ++i) {
    const int body = body_of(field, mesh, i);
    bool somewhere = false, of_body = false;
    for (const int node : places.near(at(field, i), tolerance)) {
      somewhere = true;
      if (body != -1 && !nodes.bodies[node].contains(body)) continue;
      of_body = true;
      if (given[node] == -1) given[node] = i;
      if (field.values[given[node]] == field.values[i]) continue;
      refuse(field, i,
             fmt::format("has another displacement than that of the {} {}{}", field.word, field.nodes[given[node]].tag,
                         field.bodies.empty() ? ", and bodies touch or a node is there twice: a column 'body' with the "
                                                "body's name tells which is whose"
                                              : fmt::format(", of the same body '{}'", field.bodies[i])));
    }
    if (!somewhere)
      refuse(field, i,
             fmt::format("is no vertex and no middle of an edge of the mesh, to {:.1e}; {}", tolerance, way_out));
    if (!of_body) refuse(field, i, fmt::format("is no node of the body '{}'", field.bodies[i]));
  }
  return given;
}

}  // namespace

template <int dim> GivenDisplacementOf<dim> matched_by_place(const RawField<dim>& field, const Mesh<dim>& mesh) {
  const double tolerance = place_tolerance(field, mesh);
  if (const int edge = indistinct(mesh, tolerance); edge != -1)
    fail(
        Status::input, field.file,
        fmt::format("has coordinates of too few digits to tell the nodes of the mesh apart near {}: they may be off by "
                    "{:.1e}",
                    point(midpoint(mesh, edge)), tolerance));
  const Nodes<dim> nodes = nodes_of(mesh);
  const std::vector<int> given = nodes_at(field, mesh, nodes, tolerance);
  const auto middles = given.begin() + static_cast<std::ptrdiff_t>(mesh.vertices.size());
  const bool linear = std::all_of(middles, given.end(), [](int i) { return i == -1; });
  const std::size_t count = linear ? mesh.vertices.size() : given.size();
  const auto missing = std::count(given.begin(), given.begin() + static_cast<std::ptrdiff_t>(count), -1);
  if (missing > 0) {
    const auto first = std::ranges::find(given, -1) - given.begin();
    fail(Status::input, field.file,
         fmt::format("has no displacement at {} of the {} {}, the first at {}; {}", missing, count,
                     linear ? "vertices of the mesh" : "vertices and midpoints of edges of the mesh",
                     point(nodes.x[first]), way_out));
  }
  GivenDisplacementOf<dim> result;
  result.displacement.degree = linear ? 1 : 2;
  for (std::size_t node = 0; node < count; ++node) {
    auto& values = node < mesh.vertices.size() ? result.displacement.vertex : result.displacement.edge;
    values.push_back(field.values[given[node]]);
    result.off = std::max(result.off, (nodes.x[node] - at(field, given[node])).norm());
  }
  return result;
}

// ---- by cells -------------------------------------------------------------------------------------------------------

namespace {

/// Vertices of the mesh that lie at one place are one place.
struct Places {
  std::vector<int> of_vertex;  ///< the first vertex there
  std::vector<int> of_node;    ///< likewise of the nodes of the file; −1: no vertex is there
};

template <int dim> Places places_of(const RawField<dim>& field, const Mesh<dim>& mesh, double tolerance) {
  Places places{merged(mesh.vertices, tolerance), {}};
  const Boxes<dim> vertices = points(mesh.vertices);
  for (int node = 0; node < static_cast<int>(field.nodes.size()); ++node) {
    const std::vector<int> near = vertices.near(at(field, node), tolerance);
    places.of_node.push_back(near.empty() ? -1 : places.of_vertex[near.front()]);
  }
  return places;
}

template <int dim> using Corners = std::array<int, std::size_t{dim} + 1>;

/// Of each cell of the file the cell of the mesh that it is; nothing: one of them is none.
template <int dim>
std::optional<std::vector<int>> cells_of(const RawField<dim>& field, const Mesh<dim>& mesh, const Places& places) {
  const auto places_at = [](const auto& nodes, const std::vector<int>& of) {
    Corners<dim> result;
    for (int k = 0; k <= dim; ++k) result[k] = of[nodes[k]];
    std::ranges::sort(result);
    return result;
  };
  std::map<Corners<dim>, int> by_places;
  for (int cell = 0; cell < static_cast<int>(mesh.cells.size()); ++cell)
    by_places[places_at(mesh.cells[cell], places.of_vertex)] = cell;
  std::vector<int> result;
  for (const auto& cell : field.cells) {
    if (cell.corners != dim + 1 || cell.nodes.size() != field.cells[0].nodes.size()) return {};
    const auto found = by_places.find(places_at(cell.nodes, places.of_node));
    if (found == by_places.end()) return {};
    result.push_back(found->second);
  }
  return result;
}

/// The file's nodes for those of the mesh, collected cell by cell.
struct Assigned {
  std::vector<int> vertex, edge;  ///< nodes of the file, −1: none yet
  double place_tolerance, value_tolerance;
};

/// \param to where the node is put; it may be there already, or another with the same displacement
template <int dim>
void assign(const RawField<dim>& field, const std::string& body, int node, double tolerance, int& to) {
  if (to == -1) to = node;
  if ((field.values[to] - field.values[node]).cwiseAbs().maxCoeff() <= tolerance) return;
  refuse(field, node,
         fmt::format("has another displacement than the {} {} at the same place of '{}'; expected a continuous one in "
                     "each body",
                     field.word, field.nodes[to].tag, body));
}

/// \return false: a node in the middle of a side is not at the midpoint
template <int dim>
bool assign(const RawField<dim>& field, const Mesh<dim>& mesh, const Places& places,
            const typename RawField<dim>::Cell& from, int cell, Assigned& assigned) {
  const std::string& body = mesh.bodies[mesh.cell_body[cell]];
  Corners<dim> local{};  // of each corner in the mesh's cell
  for (int k = 0; k <= dim; ++k) {
    while (places.of_vertex[mesh.cells[cell][local[k]]] != places.of_node[from.nodes[k]]) ++local[k];
    assign(field, body, from.nodes[k], assigned.value_tolerance, assigned.vertex[mesh.cells[cell][local[k]]]);
  }
  for (std::size_t k = 0; k + dim + 1 < from.nodes.size(); ++k) {
    const auto [a, b] = edges_in_files<dim>()[k];
    const int edge = mesh.cell_edges[cell][Simplex<dim>::edge_between(local[a], local[b])];
    const int node = from.nodes[dim + 1 + k];
    if ((at(field, node) - midpoint(mesh, edge)).norm() > assigned.place_tolerance) return false;
    assign(field, body, node, assigned.value_tolerance, assigned.edge[edge]);
  }
  return true;
}

}  // namespace

template <int dim>
std::optional<GivenDisplacementOf<dim>> matched_by_cells(const RawField<dim>& field, const Mesh<dim>& mesh) {
  const double tolerance = place_tolerance(field, mesh);
  if (indistinct(mesh, tolerance) != -1) return {};
  const Places places = places_of(field, mesh, tolerance);
  const auto cells = cells_of(field, mesh, places);
  if (!cells) return {};
  const std::set<int> there(cells->begin(), cells->end());
  if (there.size() < mesh.cells.size())
    fail(Status::input, field.file,
         fmt::format("has {} of the {} cells of the mesh; {}", there.size(), mesh.cells.size(), way_out));
  Assigned assigned{std::vector<int>(mesh.vertices.size(), -1), std::vector<int>(mesh.edges.size(), -1), tolerance,
                    value_tolerance(field)};
  for (std::size_t i = 0; i < cells->size(); ++i)
    if (!assign(field, mesh, places, field.cells[i], (*cells)[i], assigned)) return {};
  GivenDisplacementOf<dim> result;
  result.displacement.degree = field.cells[0].nodes.size() == dim + 1 ? 1 : 2;
  for (std::size_t vertex = 0; vertex < assigned.vertex.size(); ++vertex) {
    result.displacement.vertex.push_back(field.values[assigned.vertex[vertex]]);
    result.off = std::max(result.off, (mesh.vertices[vertex] - at(field, assigned.vertex[vertex])).norm());
  }
  if (result.displacement.degree == 1) return result;
  for (std::size_t edge = 0; edge < assigned.edge.size(); ++edge) {
    result.displacement.edge.push_back(field.values[assigned.edge[edge]]);
    result.off = std::max(result.off, (midpoint(mesh, static_cast<int>(edge)) - at(field, assigned.edge[edge])).norm());
  }
  return result;
}

template GivenDisplacementOf<2> matched_by_place(const RawField<2>&, const Mesh<2>&);
template GivenDisplacementOf<3> matched_by_place(const RawField<3>&, const Mesh<3>&);
template std::optional<GivenDisplacementOf<2>> matched_by_cells(const RawField<2>&, const Mesh<2>&);
template std::optional<GivenDisplacementOf<3>> matched_by_cells(const RawField<3>&, const Mesh<3>&);

}  // namespace bracket::scene
