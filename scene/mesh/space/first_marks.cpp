// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cassert>
#include <functional>
#include <limits>
#include <map>
#include <numeric>

#include "scene/mesh/space/marks.h"
#include "scene/mesh/space/similar.h"
#include "scene/mesh/space/tetrahedron.h"
#include "scene/mesh/topology.h"

namespace bracket::scene {

namespace {

using Table = Simplex<3>;

/// An edge of the mesh as it is glued, and the cells at it.
struct GluedEdge {
  EdgeRank length;
  std::vector<int> cells;
};

/// Of each cell's edges a number, the larger the earlier they are cut: first edges of which no two have a cell in
/// common, so that cutting them needs no others, then the rest, the longer ones before the shorter.
std::vector<std::array<int, 6>> order_of_edges(const Mesh<3>& mesh, const std::vector<std::array<int, 4>>& glued) {
  std::vector<GluedEdge> all;
  std::vector<std::array<int, 6>> of_cell(glued.size());
  std::map<std::array<int, 2>, int> known;
  for (std::size_t c = 0; c < glued.size(); ++c)
    for (int e = 0; e < 6; ++e) {
      const auto [a, b] = std::minmax(glued[c][Table::edges[e][0]], glued[c][Table::edges[e][1]]);
      const auto [at, fresh] = known.try_emplace({a, b}, static_cast<int>(all.size()));
      if (fresh) all.push_back({edge_rank(mesh, mesh.cell_edges[c][e]), {}});
      all[at->second].cells.push_back(static_cast<int>(c));
      of_cell[c][e] = at->second;
    }
  std::vector<int> falling(all.size());
  std::iota(falling.begin(), falling.end(), 0);
  std::ranges::sort(falling, std::greater(), [&](int edge) { return all[edge].length; });
  std::vector<char> has_one(glued.size(), 0);
  const auto is_alone = [&](int edge) {
    if (std::ranges::any_of(all[edge].cells, [&](int cell) { return has_one[cell]; })) return false;
    for (const int cell : all[edge].cells) has_one[cell] = 1;
    return true;
  };
  std::ranges::stable_partition(falling, is_alone);
  std::vector<int> place(all.size());
  for (std::size_t i = 0; i < falling.size(); ++i) place[falling[i]] = static_cast<int>(falling.size() - i);
  for (auto& cell : of_cell)
    for (int& edge : cell) edge = place[edge];
  return of_cell;
}

/// Each facet's edge that comes first.
FacetMarks marks_by(const std::array<int, 6>& order) {
  FacetMarks marks;
  for (int k = 0; k < 4; ++k) {
    int first = -1;
    for (int edge = 0; edge < 6; ++edge)
      if (!has_end(edge, k) && (first < 0 || order[first] < order[edge])) first = edge;
    marks[k] = static_cast<char>(first);
  }
  return marks;
}

/// The marks of a mesh while they are chosen.
class Search {
 public:
  Search(const Mesh<3>& mesh, const std::vector<int>& glued) : mesh_(mesh), across_(mesh.cells.size()) {
    for (const auto& cell : mesh.cells) {
      glued_.emplace_back();
      for (int k = 0; k < 4; ++k) glued_.back()[k] = glued[cell[k]];
    }
    find_neighbours();
    const auto order = order_of_edges(mesh, glued_);
    for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
      marks_.push_back(marks_by(order[c]));
      shape_.push_back(least_below(static_cast<int>(c), marks_.back()));
      enough_ = std::min(enough_, 0.5 * shape(positions(mesh, mesh.cells[c])));
    }
  }

  /// Ends: each change raises the shapes below cells as they are when sorted, lowest first.
  void improve() {
    for (bool again = true; again;) {
      again = false;
      std::vector<int> poor;
      for (std::size_t c = 0; c < shape_.size(); ++c)
        if (shape_[c] < enough_) poor.push_back(static_cast<int>(c));
      std::ranges::stable_sort(poor, {}, [&](int cell) { return shape_[cell]; });
      for (const int cell : poor) again |= improve(cell);
    }
  }

  std::vector<Mesh<3>::Marks> marks() const {
    std::vector<Mesh<3>::Marks> all;
    for (const FacetMarks& one : marks_) all.push_back({one, false});
    return all;
  }

 private:
  struct Neighbour {
    int cell = -1, facet = -1;
  };
  struct Change {
    int cell;
    FacetMarks marks;
    double shape;
  };

  double least_below(int cell, const FacetMarks& marks) const {
    return least_shape_below(marks, positions(mesh_, mesh_.cells[cell]));
  }

  void find_neighbours() {
    struct Slot {
      std::array<int, 3> vertices;
      Neighbour of;
    };
    std::vector<Slot> slots;
    for (std::size_t c = 0; c < glued_.size(); ++c)
      for (int k = 0; k < 4; ++k) {
        const auto& [i, j, l] = Table::facets[k];
        std::array<int, 3> vertices = {glued_[c][i], glued_[c][j], glued_[c][l]};
        std::ranges::sort(vertices);
        slots.push_back({vertices, {static_cast<int>(c), k}});
      }
    std::ranges::stable_sort(slots, {}, &Slot::vertices);
    for (std::size_t i = 1; i < slots.size(); ++i) {
      if (slots[i].vertices != slots[i - 1].vertices) continue;
      const Neighbour &one = slots[i - 1].of, &other = slots[i].of;
      across_[one.cell][one.facet] = other;
      across_[other.cell][other.facet] = one;
    }
  }

  /// An edge of one cell as one of another that has it, too.
  int edge_in(int cell, int edge, int other) const {
    std::array<int, 2> ends;
    for (int i = 0; i < 2; ++i) {
      const auto& vertices = glued_[other];
      const auto at = std::ranges::find(vertices, glued_[cell][Table::edges[edge][i]]);
      assert(at != vertices.end());
      ends[i] = static_cast<int>(at - vertices.begin());
    }
    return Table::edge_between(ends[0], ends[1]);
  }

  /// What marking a cell so changes, the cell first; nothing where a neighbour would have no refinement edge.
  std::vector<Change> changes(int cell, const FacetMarks& marks) const {
    std::vector<Change> all = {{cell, marks, least_below(cell, marks)}};
    for (int k = 0; k < 4; ++k) {
      const auto& [beside, facet] = across_[cell][k];
      if (beside < 0 || marks[k] == marks_[cell][k]) continue;
      FacetMarks next = marks_[beside];
      next[facet] = static_cast<char>(edge_in(cell, marks[k], beside));
      if (refinement_edge(next) < 0) return {};
      all.push_back({beside, next, least_below(beside, next)});
    }
    return all;
  }

  bool improve(int cell) {
    double best = shape_[cell];
    std::vector<Change> found;
    for (const FacetMarks& marks : all_marks()) {
      std::vector<Change> tried = changes(cell, marks);
      if (tried.empty()) continue;
      const double least = std::ranges::min(tried, {}, &Change::shape).shape;
      if (!(least > best)) continue;
      best = least;
      found = std::move(tried);
    }
    for (const Change& change : found) {
      marks_[change.cell] = change.marks;
      shape_[change.cell] = change.shape;
    }
    return !found.empty();
  }

  const Mesh<3>& mesh_;
  std::vector<std::array<int, 4>> glued_;  ///< of each cell's vertices, what stands for them
  std::vector<std::array<Neighbour, 4>> across_;
  std::vector<FacetMarks> marks_;
  std::vector<double> shape_;  ///< below each cell, the least
  double enough_ = std::numeric_limits<double>::infinity();
};

}  // namespace

std::vector<Mesh<3>::Marks> first_marks(const Mesh<3>& mesh, const std::vector<int>& glued) {
  Search search(mesh, glued);
  search.improve();
  return search.marks();
}

}  // namespace bracket::scene
