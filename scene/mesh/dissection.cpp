// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/mesh/dissection.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <tuple>
#include <utility>

namespace bracket::scene {

namespace {

/// The directions that parts are cut across: the axes and, between any two, the diagonals.
template <int dim> std::vector<Vector<dim>> directions() {
  std::vector<Vector<dim>> result;
  for (int i = 0; i < dim; ++i) {
    result.push_back(Vector<dim>::Unit(i));
    for (int j = 0; j < i; ++j)
      for (const double sign : {1.0, -1.0}) result.push_back(Vector<dim>::Unit(i) + sign * Vector<dim>::Unit(j));
  }
  return result;
}

/// Across each facet of each cell the cell on the other side, −1: none.
template <int dim> std::vector<std::array<int, dim + 1>> neighbours(const Mesh<dim>& mesh) {
  constexpr int none = -1, taken = -2;
  std::vector<std::array<int, dim + 1>> result(mesh.cells.size());
  std::vector<std::pair<int, int>> first(n_facets(mesh), {none, none});  // a cell at each facet, and where in the cell
  for (std::size_t c = 0; c < mesh.cells.size(); ++c)
    for (int k = 0; k <= dim; ++k) {
      auto& [cell, local] = first[cell_facets(mesh, static_cast<int>(c))[k]];
      result[c][k] = none;
      if (cell == taken) continue;  // a third one: no mesh of build_mesh() has it
      if (cell == none) {
        cell = static_cast<int>(c);
        local = k;
        continue;
      }
      result[c][k] = cell;
      result[cell][local] = static_cast<int>(c);
      cell = taken;
    }
  return result;
}

/// The cells along one direction. Every part is a range of them, the same for all directions.
struct Line {
  std::vector<int> cells;
  std::vector<int> place;  ///< of each cell, in `cells`
};

template <int dim> Line line(const Mesh<dim>& mesh, const Vector<dim>& direction) {
  std::vector<double> along(mesh.cells.size(), 0);
  for (std::size_t c = 0; c < mesh.cells.size(); ++c)
    for (const int v : mesh.cells[c]) along[c] += direction.dot(mesh.vertices[v]);
  Line result{std::vector<int>(mesh.cells.size()), std::vector<int>(mesh.cells.size())};
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) result.cells[c] = static_cast<int>(c);
  std::sort(result.cells.begin(), result.cells.end(), [&](int a, int b) {
    return std::tuple(mesh.cell_component[a], along[a], a) < std::tuple(mesh.cell_component[b], along[b], b);
  });
  for (std::size_t i = 0; i < mesh.cells.size(); ++i) result.place[result.cells[i]] = static_cast<int>(i);
  return result;
}

struct Range {
  int begin, end;
  int size() const { return end - begin; }
  bool has(int place) const { return begin <= place && place < end; }
  /// What either part must have at least: then 63 bits lead to every cell of 7e7.
  int least() const { return (size() + 3) / 4; }
};

template <int dim> class Dissection {
 public:
  explicit Dissection(const Mesh<dim>& mesh)
      : neighbours_(neighbours(mesh)), path_(mesh.cells.size(), 0), in_first_(mesh.cells.size(), 0) {
    for (const auto& direction : directions<dim>()) lines_.push_back(line(mesh, direction));
    const auto& order = lines_.front().cells;
    for (Range part{0, 0}; part.begin < static_cast<int>(order.size()); part.begin = part.end) {
      while (part.end < static_cast<int>(order.size()) &&
             mesh.cell_component[order[part.end]] == mesh.cell_component[order[part.begin]])
        ++part.end;
      divide(part, 0);
    }
  }
  std::vector<std::uint64_t> take() { return std::move(path_); }

 private:
  struct Cut {
    double ratio;  ///< facets cut by the product of the parts' sizes
    int first;     ///< how many cells are in the first part
  };

  /// The best cut across one direction.
  Cut best_cut(const Line& line, const Range& part) {
    const int size = part.size();
    change_.assign(size + 1, 0);  // of the number of facets cut, from one place of the cut to the next
    for (int i = 0; i < size; ++i)
      for (const int other : neighbours_[line.cells[part.begin + i]]) {
        const int j = other < 0 ? -1 : line.place[other] - part.begin;
        if (j <= i || j >= size) continue;
        ++change_[i + 1];
        --change_[j + 1];
      }
    Cut best{std::numeric_limits<double>::infinity(), 0};
    for (int first = 1, facets = 0; first <= size - part.least(); ++first) {
      facets += change_[first];
      if (first < part.least()) continue;
      const double ratio = facets / (static_cast<double>(first) * (size - first));
      if (ratio < best.ratio) best = {ratio, first};
    }
    return best;
  }

  /// By how many the facets cut become fewer if the cell goes to the other part.
  int gain(int cell, const Range& part) const {
    int result = 0;
    for (const int other : neighbours_[cell])
      if (other >= 0 && part.has(lines_.front().place[other])) result += in_first_[other] == in_first_[cell] ? -1 : 1;
    return result;
  }

  /// Moves cells to the other part as long as that cuts fewer facets. \return the size of the first part
  int smooth(const Range& part, int first) {
    const auto& cells = lines_.front().cells;
    waiting_.clear();
    for (int i = part.begin; i < part.end; ++i)
      if (gain(cells[i], part) > 0) waiting_.push_back(cells[i]);
    while (!waiting_.empty()) {
      const int cell = waiting_.back();
      waiting_.pop_back();
      if (gain(cell, part) <= 0 || (in_first_[cell] ? first : part.size() - first) <= part.least()) continue;
      first += in_first_[cell] ? -1 : 1;
      in_first_[cell] = !in_first_[cell];
      for (const int other : neighbours_[cell])
        if (other >= 0 && part.has(lines_.front().place[other])) waiting_.push_back(other);
    }
    return first;
  }

  void divide(const Range& part, int depth) {
    if (part.size() < 2) return;
    assert(depth < 64);
    Cut best{std::numeric_limits<double>::infinity(), 0};
    const Line* across = nullptr;
    for (const Line& line : lines_)
      if (const Cut cut = best_cut(line, part); cut.ratio < best.ratio) {
        best = cut;
        across = &line;
      }
    for (int i = part.begin; i < part.end; ++i) in_first_[across->cells[i]] = i - part.begin < best.first;
    const int middle = part.begin + smooth(part, best.first);
    for (int i = part.begin; i < part.end; ++i)
      if (const int cell = lines_.front().cells[i]; !in_first_[cell]) path_[cell] |= std::uint64_t{1} << (63 - depth);
    for (Line& line : lines_) {
      const auto begin = line.cells.begin();
      std::stable_partition(begin + part.begin, begin + part.end, [&](int cell) { return in_first_[cell]; });
      for (int i = part.begin; i < part.end; ++i) line.place[line.cells[i]] = i;
    }
    divide({part.begin, middle}, depth + 1);
    divide({middle, part.end}, depth + 1);
  }

  std::vector<std::array<int, dim + 1>> neighbours_;
  std::vector<Line> lines_;
  std::vector<std::uint64_t> path_;
  std::vector<char> in_first_;
  std::vector<int> change_, waiting_;  // kept for their memory
};

}  // namespace

template <int dim> std::vector<std::uint64_t> dissect(const Mesh<dim>& mesh) { return Dissection<dim>(mesh).take(); }

template std::vector<std::uint64_t> dissect(const Mesh<2>&);
template std::vector<std::uint64_t> dissect(const Mesh<3>&);

}  // namespace bracket::scene
