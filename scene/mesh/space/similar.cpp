// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/mesh/space/similar.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <set>
#include <tuple>

namespace bracket::scene {

namespace {

using Table = Simplex<3>;
using Corner = std::array<int, 3>;  // in the coordinates of the first cell, times a power of two

/// A cell up to translation and scaling by two, and how it is cut.
struct Shape {
  std::array<Corner, 4> corners;
  Mesh<3>::Marks marks;
  auto key() const { return std::tie(corners, marks.facet, marks.flagged); }
  bool operator<(const Shape& other) const { return key() < other.key(); }
};

/// With corner 0 at the origin, as small as integers allow.
Shape reduced(Shape shape) {
  const Corner origin = shape.corners[0];
  int bits = 0;
  for (Corner& corner : shape.corners)
    for (int i = 0; i < 3; ++i) bits |= corner[i] -= origin[i];
  for (; bits % 2 == 0; bits /= 2)
    for (Corner& corner : shape.corners)
      for (int& x : corner) x /= 2;
  return shape;
}

Shape child(const Shape& parent, int kept, int moved) {
  Shape child{parent.corners, marks_of_child(parent.marks, kept, moved)};
  for (Corner& corner : child.corners)
    for (int& x : corner) x *= 2;
  for (int i = 0; i < 3; ++i) child.corners[moved][i] = parent.corners[moved][i] + parent.corners[kept][i];
  return reduced(child);
}

SimilarCells form(const std::array<Corner, 4>& x) {
  Eigen::Matrix3d edge, q = Eigen::Matrix3d::Zero();
  for (int k = 0; k < 3; ++k)
    for (int i = 0; i < 3; ++i) edge(i, k) = x[k + 1][i] - x[0][i];
  for (const auto& [a, b] : Table::edges) {
    const Eigen::Vector3d e(x[b][0] - x[a][0], x[b][1] - x[a][1], x[b][2] - x[a][2]);
    q += e * e.transpose();
  }
  const double root = std::cbrt(std::abs(edge.determinant()));
  q /= root * root;
  return {q(0, 0), q(1, 1), q(2, 2), q(0, 1), q(0, 2), q(1, 2)};
}

std::vector<SimilarCells> made_of(const FacetMarks& marks) {
  std::set<Shape> known;
  std::vector<Shape> left = {{{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {marks, false}}};
  std::set<std::array<double, 6>> forms;
  while (!left.empty()) {
    const Shape shape = left.back();
    left.pop_back();
    if (!known.insert(shape).second) continue;
    const auto [q00, q11, q22, q01, q02, q12] = form(shape.corners);
    forms.insert({q00, q11, q22, q01, q02, q12});
    const auto& [i, j] = Table::edges[refinement_edge(shape.marks.facet)];
    left.push_back(child(shape, i, j));
    left.push_back(child(shape, j, i));
  }
  std::vector<SimilarCells> all;
  for (const auto& [q00, q11, q22, q01, q02, q12] : forms) all.push_back({q00, q11, q22, q01, q02, q12});
  return all;
}

/// A number of a cell's marks.
int place(const FacetMarks& marks) { return marks[0] + 6 * (marks[1] + 6 * (marks[2] + 6 * marks[3])); }

struct Known {
  std::vector<FacetMarks> marks;
  std::vector<std::vector<SimilarCells>> cells;  ///< by place()
};

Known everything() {
  Known all;
  all.cells.resize(6 * 6 * 6 * 6);
  const auto edge = [](int facet, int i) {
    const auto& [a, b, c] = Table::facets[facet];
    return static_cast<char>(i == 0 ? Table::edge_between(a, b) : Table::edge_between(i == 1 ? b : a, c));
  };
  for (int i = 0; i < 81; ++i) {
    const FacetMarks marks = {edge(0, i % 3), edge(1, i / 3 % 3), edge(2, i / 9 % 3), edge(3, i / 27)};
    if (refinement_edge(marks) < 0) continue;
    all.marks.push_back(marks);
    all.cells[place(marks)] = made_of(marks);
  }
  return all;
}

const Known& known() {
  static const Known all = everything();
  return all;
}

}  // namespace

std::span<const SimilarCells> similar_cells(const FacetMarks& marks) {
  const auto& cells = known().cells[place(marks)];
  assert(!cells.empty());
  return cells;
}

std::span<const FacetMarks> all_marks() { return known().marks; }

double least_shape_below(const FacetMarks& marks, const std::array<Vector<3>, 4>& corners) {
  const Vector<3> a = corners[1] - corners[0], b = corners[2] - corners[0], c = corners[3] - corners[0];
  const double aa = a.dot(a), bb = b.dot(b), cc = c.dot(c), ab = a.dot(b), ac = a.dot(c), bc = b.dot(c);
  double largest = 0;
  for (const auto& [q00, q11, q22, q01, q02, q12] : similar_cells(marks))
    largest = std::max(largest, q00 * aa + q11 * bb + q22 * cc + 2 * (q01 * ab + q02 * ac + q12 * bc));
  const double root = std::cbrt(3 * volume<3>(corners));
  return 12 * root * root / largest;
}

}  // namespace bracket::scene
