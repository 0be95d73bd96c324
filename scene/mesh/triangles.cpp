// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// Planar: cells of files become triangles.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "scene/mesh/raw_mesh.h"
#include "scene/mesh/topology.h"
#include "scene/text.h"

namespace bracket::scene {

namespace {

using Element = RawMesh::Element;

int n_corners(const Element& cell) { return cell.corners[3] == -1 ? 3 : 4; }

Vector<2> plane_point(const RawMesh::Node& node) { return {node.x[0], node.x[1]}; }

/// Nodes that cells have, and those of lines.
struct Used {
  std::vector<char> by_cells, at_all;
};

Used used_nodes(const RawMesh& raw) {
  Used used{std::vector<char>(raw.nodes.size(), 0), std::vector<char>(raw.nodes.size(), 0)};
  for (const Element& cell : raw.cells)
    for (const int node : cell.corners)
      if (node != -1) used.by_cells[node] = used.at_all[node] = 1;
  for (const Element& line : raw.lines)
    for (const int node : line.corners)
      if (node != -1) used.at_all[node] = 1;
  return used;
}

/// Refuses a mesh whose nodes do not lie in a plane z = constant, to rounding of its size.
/// \return a note unless it is z = 0
std::vector<std::string> check_plane(const RawMesh& raw, const Used& used, const std::string& where) {
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
  if (raw.cells.empty()) {
    fail(Status::mesh, where,
         "the mesh has no triangles or quadrilaterals; Gmsh makes them of a .geo by 'gmsh -2' and, where there are "
         "physical groups, saves only those in physical surfaces");
  }
  if (raw.cells.size() + raw.nodes.size() > std::numeric_limits<int>::max() / 16)
    fail(Status::mesh, where, "the mesh is too large");
}

/// The node that stands for each, by the scene's wish that close ones become one.
std::vector<int> representatives(const RawMesh& raw, const Used& used, double merge, const std::string& where,
                                 std::vector<std::string>& notes) {
  std::vector<int> representative(raw.nodes.size());
  std::iota(representative.begin(), representative.end(), 0);
  if (merge <= 0) return representative;
  for (const Element& cell : raw.cells) {
    for (int k = 0; k < n_corners(cell); ++k) {
      const RawMesh::Node &a = raw.nodes[cell.corners[k]], &b = raw.nodes[cell.corners[(k + 1) % n_corners(cell)]];
      const double side = (plane_point(a) - plane_point(b)).norm();
      if (&a == &b || side > merge) continue;
      fail(Status::mesh, where,
           fmt::format("mesh.merge = {} makes one of the nodes {} and {} of the cell {}, which are {:.3g} apart; write "
                       "a smaller one",
                       merge, a.tag, b.tag, cell.tag, side));
    }
  }
  std::vector<int> nodes;
  std::vector<Vector<2>> points;
  for (std::size_t i = 0; i < raw.nodes.size(); ++i) {
    if (!used.at_all[i]) continue;
    nodes.push_back(static_cast<int>(i));
    points.push_back(plane_point(raw.nodes[i]));
  }
  const std::vector<int> of = merged(points, merge);
  int count = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    representative[nodes[i]] = nodes[of[i]];
    count += of[i] == static_cast<int>(i) ? 0 : 1;
  }
  notes.push_back(fmt::format("mesh.merge = {}: {} node{} merged with others", merge, count, count == 1 ? "" : "s"));
  return representative;
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

/// A side of second order farthest from its chord.
struct Chord {
  std::size_t curved_cells = 0;
  double height = 0;
  Vector<2> at = {0, 0};
};

Chord largest_chord(const RawMesh& raw) {
  Chord largest;
  for (const Element& cell : raw.cells) {
    const int n = n_corners(cell);
    bool second_order = false;
    for (int k = 0; k < n; ++k) {
      if (cell.middles[k] == -1) continue;
      second_order = true;
      const Vector<2> a = plane_point(raw.nodes[cell.corners[k]]), m = plane_point(raw.nodes[cell.middles[k]]);
      const Vector<2> along = plane_point(raw.nodes[cell.corners[(k + 1) % n]]) - a;
      const double height = std::abs(along[0] * (m - a)[1] - along[1] * (m - a)[0]) / along.norm();
      if (height > largest.height) largest = {largest.curved_cells, height, m};
    }
    largest.curved_cells += second_order ? 1 : 0;
  }
  return largest;
}

std::string plural(std::size_t count, const std::string& word) {
  return fmt::format("{} {}{}", count, word, count == 1 ? "" : "s");
}

}  // namespace

Triangles triangles_of(const RawMesh& raw, double merge, const std::string& where) {
  check_size(raw, where);
  const Used used = used_nodes(raw);
  Triangles result;
  result.notes = check_plane(raw, used, where);
  const std::vector<int> representative = representatives(raw, used, merge, where, result.notes);

  result.vertex.assign(raw.nodes.size(), -1);
  for (std::size_t node = 0; node < raw.nodes.size(); ++node)
    if (used.by_cells[node]) result.vertex[representative[node]] = 0;
  for (std::size_t node = 0; node < raw.nodes.size(); ++node) {
    if (result.vertex[node] == -1) continue;
    result.vertex[node] = static_cast<int>(result.vertices.size());
    result.vertices.push_back(plane_point(raw.nodes[node]));
  }
  for (std::size_t node = 0; node < raw.nodes.size(); ++node) result.vertex[node] = result.vertex[representative[node]];

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
  if (const Chord chord = largest_chord(raw); chord.curved_cells > 0) {
    result.notes.push_back(fmt::format(
        "{} of second order straightened: {}", plural(chord.curved_cells, "cell"),
        chord.height == 0
            ? "all sides are straight"
            : fmt::format("the largest height above a chord is {:.3g}, at {}", chord.height, point(chord.at))));
  }
  return result;
}

}  // namespace bracket::scene
