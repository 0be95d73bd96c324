// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// Planar: cells of files become triangles.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scene/mesh/raw_nodes.h"
#include "scene/text.h"

namespace bracket::scene {

namespace {

using Element = RawMesh::Element;

/// Refuses a mesh whose nodes do not lie in a plane z = constant, to rounding of its size.
/// \return a note unless it is z = 0
std::vector<std::string> check_plane(const RawMesh& raw, const UsedNodes& used, const std::string& where) {
  double size = 0;
  const RawMesh::Node* first = nullptr;
  for (std::size_t i = 0; i < raw.nodes.size(); ++i) {
    if (!used.by_cells[i]) continue;
    if (first == nullptr) first = &raw.nodes[i];
    for (const double x : raw.nodes[i].x) size = std::max(size, std::abs(x));
  }
  const double z = first->x[2];
  for (std::size_t i = 0; i < raw.nodes.size(); ++i) {
    if (!used.by_cells[i] || std::abs(raw.nodes[i].x[2] - z) <= 1e-9 * size) continue;
    fail(Status::mesh, where,
         fmt::format("the node {} has z = {}, the node {} z = {}: the mesh is 3D; only meshes in a plane of constant z "
                     "are read",
                     raw.nodes[i].tag, raw.nodes[i].x[2], first->tag, z));
  }
  if (std::abs(z) <= 1e-9 * size) return {};
  return {fmt::format("the mesh lies in the plane z = {:.6g}, which is taken for z = 0", z)};
}

void check_size(const RawMesh& raw, const std::string& where) {
  if (raw.dimension == 3)
    fail(Status::mesh, where, "the mesh is 3D: it has tetrahedra; in a scene, write dim = 3 for it");
  if (raw.cells.empty()) {
    fail(Status::mesh, where,
         "the mesh has no triangles or quadrilaterals; Gmsh makes them of a .geo by 'gmsh -2' and, where there are "
         "physical groups, saves only those in physical surfaces");
  }
  if (raw.cells.size() + raw.nodes.size() > std::numeric_limits<int>::max() / 16)
    fail(Status::mesh, where, "the mesh is too large");
}

/// The smallest angle of a triangle by its sine, negative where it turns clockwise.
double shape(const Vector<2>& a, const Vector<2>& b, const Vector<2>& c) {
  const Vector<2> u = b - a, v = c - b, w = a - c;
  const double twice_area = u[0] * v[1] - u[1] * v[0];
  const double longest = std::max({u.norm() * v.norm(), v.norm() * w.norm(), w.norm() * u.norm()});
  return twice_area / longest;
}

/// The diagonal that leaves the larger smallest angle; of two that leave the same, to rounding, that from corner 0.
bool cut_from_first(const std::array<Vector<2>, 4>& x) {
  const double turned = (x[2] - x[0])[0] * (x[3] - x[1])[1] - (x[2] - x[0])[1] * (x[3] - x[1])[0] < 0 ? -1 : 1;
  const double first = std::min(turned * shape(x[0], x[1], x[2]), turned * shape(x[0], x[2], x[3]));
  const double second = std::min(turned * shape(x[0], x[1], x[3]), turned * shape(x[1], x[2], x[3]));
  return first >= second - 1e-9;
}

std::string plural(std::size_t count, const std::string& word) {
  return fmt::format("{} {}{}", count, word, count == 1 ? "" : "s");
}

}  // namespace

template <> Simplices<2> simplices_of<2>(const RawMesh& raw, double merge, const std::string& where) {
  check_size(raw, where);
  const UsedNodes used = used_nodes(raw);
  Simplices<2> result;
  result.notes = check_plane(raw, used, where);
  number_vertices(result, raw, used, representatives<2>(raw, used, merge, where, result.notes));

  result.cells.reserve(raw.cells.size());
  result.origin.reserve(raw.cells.size());
  std::size_t quadrilaterals = 0;
  const auto add = [&](int origin, int a, int b, int c) {
    result.cells.push_back({a, b, c});
    result.origin.push_back(origin);
  };
  for (std::size_t i = 0; i < raw.cells.size(); ++i) {
    const int origin = static_cast<int>(i);
    std::vector<int> v;  // a quadrilateral of which two neighbours are one node is a triangle
    for (int k = 0; k < n_corners(raw.cells[i]); ++k) {
      const int vertex = result.vertex[raw.cells[i].corners[k]];
      if (n_corners(raw.cells[i]) == 3 || v.empty() || (vertex != v.back() && (k < 3 || vertex != v.front())))
        v.push_back(vertex);
    }
    if (v.size() < 3) v.resize(3, v.back());  // refused later on, as degenerate
    if (v.size() == 3) {
      add(origin, v[0], v[1], v[2]);
      continue;
    }
    ++quadrilaterals;
    const bool first =
        cut_from_first({result.vertices[v[0]], result.vertices[v[1]], result.vertices[v[2]], result.vertices[v[3]]});
    if (first) {
      add(origin, v[0], v[1], v[2]);
      add(origin, v[0], v[2], v[3]);
    } else {
      add(origin, v[0], v[1], v[3]);
      add(origin, v[1], v[2], v[3]);
    }
  }
  if (quadrilaterals > 0) result.notes.push_back(plural(quadrilaterals, "quadrilateral") + " cut in two");
  if (auto note = straightened<2>(raw)) result.notes.push_back(std::move(*note));
  return result;
}

}  // namespace bracket::scene
