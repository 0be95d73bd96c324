// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/mesh/raw_mesh.h"

#include <fmt/format.h>

#include <algorithm>

#include "scene/mesh/topology.h"
#include "scene/text.h"

namespace bracket::scene {

double rounding_of(const std::vector<RawMesh::Node>& nodes, int dimension) {
  std::size_t digits = 0;
  for (const RawMesh::Node& node : nodes)
    for (int c = 0; c < dimension; ++c) {
      const std::string text = fmt::format("{}", node.x[c]);  // the shortest that reads back
      std::string significant;
      for (const char sign : text.substr(0, text.find('e')))
        if (sign >= (significant.empty() ? '1' : '0') && sign <= '9') significant += sign;
      digits = std::max(digits, significant.find_last_not_of('0') + 1);
    }
  // Fewer than six are not taken for rounding, but for what is meant.
  if (digits < 6 || digits > 15) return std::numeric_limits<double>::epsilon() / 2;
  return 5 * std::pow(10.0, -static_cast<double>(digits));
}

namespace {

template <int dim> Mesh<dim> without_edges(Mesh<dim> mesh) {
  mesh.edges.clear();
  mesh.cell_edges.clear();
  mesh.facet_numbers.clear();
  mesh.facet_count = 0;
  mesh.boundary.clear();
  return mesh;
}

void append(std::vector<std::string>& notes, const std::vector<std::string>& more) {
  notes.insert(notes.end(), more.begin(), more.end());
}

}  // namespace

template <int dim> Mesh<dim> mesh_of(const RawMesh& raw, const Scene<dim>& scene, const std::string& where) {
  Simplices<dim> simplices = simplices_of<dim>(raw, scene.merge, where);
  Mesh<dim> mesh;
  mesh.vertices = std::move(simplices.vertices);
  mesh.cells = std::move(simplices.cells);
  mesh.coordinate_rounding = raw.coordinate_rounding;
  append(mesh.notes, raw.notes);
  append(mesh.notes, simplices.notes);
  mesh = with_edges(with_bodies(std::move(mesh), raw, simplices.origin, scene, where), where);

  PartSides parts = part_sides(mesh, raw, simplices.vertex, scene, where);
  append(mesh.notes, parts.notes);
  mesh.parts = std::move(parts.names);
  if (separate(mesh, parts.cut)) mesh = with_edges(without_edges(std::move(mesh)), where);
  std::vector<PartFacet<dim>> part_facets;
  for (const auto& [cell, local, part] : parts.sides) part_facets.push_back({facet_vertices(mesh, cell, local), part});
  mesh = completed(std::move(mesh), part_facets, where);
  if (!scene.bodies.empty()) append(mesh.notes, untied(mesh, scene));
  return mesh;
}

template Mesh<2> mesh_of(const RawMesh&, const Scene<2>&, const std::string&);
template Mesh<3> mesh_of(const RawMesh&, const Scene<3>&, const std::string&);

}  // namespace bracket::scene
