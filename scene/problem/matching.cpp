// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// Planar: facets that coincide run opposite to each other.
#include "scene/problem/matching.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/pending/disjoint_sets.hpp>
#include <cmath>
#include <limits>
#include <numeric>

#include "scene/problem/facing.h"
#include "scene/text.h"

namespace bracket::scene {

namespace {

const Vector<2>& end_of(const Mesh<2>& mesh, int facet, int end) {
  return mesh.vertices[mesh.boundary[facet].vertices[end]];
}

Vector<2> midpoint(const Mesh<2>& mesh, int facet) { return 0.5 * (end_of(mesh, facet, 0) + end_of(mesh, facet, 1)); }

/// A facet's place in a hierarchy of grids: its level is the binary order of its length, the grid of that level is as
/// wide. Only a few facets can have the same box, however the mesh is graded.
using Box = std::array<double, 3>;

Box box(double size, double x, double y) {
  const double level = std::ilogb(size);
  const double width = std::exp2(level);
  return {level, std::floor(x / width), std::floor(y / width)};
}

/// The boxes in which a facet coinciding with this one may be.
std::vector<Box> boxes_near(const Mesh<2>& mesh, int facet) {
  const Vector<2> middle = midpoint(mesh, facet);
  const double near = tolerance(mesh, facet);
  const double size = length(mesh, facet);
  std::vector<Box> boxes;
  for (const double candidate : {std::max(size - 2 * near, 0.5 * size), size + 2 * near}) {
    for (const double x : {middle[0] - near, middle[0] + near}) {
      for (const double y : {middle[1] - near, middle[1] + near}) boxes.push_back(box(candidate, x, y));
    }
  }
  std::sort(boxes.begin(), boxes.end());
  boxes.erase(std::unique(boxes.begin(), boxes.end()), boxes.end());
  return boxes;
}

bool coincide(const Mesh<2>& mesh, int first, int second) {
  const double near = tolerance(mesh, first);
  return (end_of(mesh, first, 0) - end_of(mesh, second, 1)).norm() <= near &&
         (end_of(mesh, first, 1) - end_of(mesh, second, 0)).norm() <= near;
}

struct Entry {
  Box box;
  int facet;
  bool taken = false;
};

bool before(const Entry& a, const Entry& b) { return a.box < b.box; }

std::vector<Entry> entries(const Mesh<2>& mesh, const std::vector<int>& facets) {
  std::vector<Entry> result;
  for (const int facet : facets) {
    const Vector<2> middle = midpoint(mesh, facet);
    result.push_back({box(length(mesh, facet), middle[0], middle[1]), facet});
  }
  std::sort(result.begin(), result.end(), before);
  return result;
}

}  // namespace

std::optional<std::vector<std::array<int, 2>>> match_sides(const Mesh<2>& mesh, const std::vector<int>& first,
                                                           const std::vector<int>& second_side) {
  if (first.size() != second_side.size()) return {};
  std::vector<Entry> second = entries(mesh, second_side);
  std::vector<std::array<int, 2>> pairs;
  for (const int facet : first) {
    const std::size_t found = pairs.size();
    for (const Box& near : boxes_near(mesh, facet)) {
      const auto [from, to] = std::equal_range(second.begin(), second.end(), Entry{near, -1}, before);
      const auto match = std::find_if(
          from, to, [&](const Entry& entry) { return !entry.taken && coincide(mesh, facet, entry.facet); });
      if (match == to) continue;
      match->taken = true;
      pairs.push_back({facet, match->facet});
      break;
    }
    if (pairs.size() == found) return {};
  }
  return pairs;
}

template <int dim> Mesh<dim> with_sides_joined(Mesh<dim> mesh, const std::vector<ContactFacetOf<dim>>& contact) {
  // A vertex may be in several pairs: all that lie on each other get the same point, that of a first side.
  std::vector<int> ranks(mesh.vertices.size()), parents(mesh.vertices.size());
  std::iota(parents.begin(), parents.end(), 0);
  boost::disjoint_sets<int*, int*> sets(ranks.data(), parents.data());
  std::vector<int> target = parents;  // of each set
  const auto join = [&](int onto, int vertex) {
    const int kept = target[sets.find_set(onto)];
    sets.union_set(onto, vertex);
    target[sets.find_set(onto)] = kept;
  };
  const auto touch = [&](int one, int other, int facet) {
    return (mesh.vertices[one] - mesh.vertices[other]).norm() <= tolerance(mesh, facet);
  };
  for (const ContactFacetOf<dim>& pair : contact) {
    if (pair.second == -1) continue;
    const auto& first = mesh.boundary[pair.first].vertices;
    const auto& second = mesh.boundary[pair.second].vertices;
    for (int i = 0; i < dim; ++i)
      if (touch(first[i], second[pair.meets[i]], pair.first)) join(first[i], second[pair.meets[i]]);
  }
  double moved = 0;
  for (std::size_t vertex = 0; vertex < mesh.vertices.size(); ++vertex) {
    const Vector<dim> x = mesh.vertices[target[sets.find_set(static_cast<int>(vertex))]];
    moved = std::max(moved, (x - mesh.vertices[vertex]).norm());
    mesh.vertices[vertex] = x;
  }
  if (moved == 0) return mesh;
  mesh.notes.push_back(fmt::format("vertices on contact sides moved by up to {:.2g} to coincide", moved));
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) {
    if (volume(mesh, static_cast<int>(cell)) > 0) continue;
    fail(Status::mesh, "",
         fmt::format("making contact sides coincide turns the cell at {} over: it is too thin",
                     point(mesh.vertices[mesh.cells[cell][0]])));
  }
  return mesh;
}

template Mesh<2> with_sides_joined(Mesh<2>, const std::vector<ContactFacetOf<2>>&);
template Mesh<3> with_sides_joined(Mesh<3>, const std::vector<ContactFacetOf<3>>&);

}  // namespace bracket::scene
