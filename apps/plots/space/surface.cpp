// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "apps/plots/space/pictures.h"

namespace bracket::apps {

using scene::Vector;

namespace {

constexpr double largest_piece = 1.0 / 32;       ///< by the size of what is drawn
constexpr double shortest_outlined = 1.0 / 120;  ///< of edges; smaller faces are drawn without

/// A point of a facet, by barycentric coordinates in its cell and in the part of it.
struct OnFacet {
  InCell in_cell = {}, in_part = {};
};

OnFacet on_facet(int part, int n, int i, int j) {
  OnFacet point;
  point.in_part = {static_cast<double>(n - i - j) / n, static_cast<double>(i) / n, static_cast<double>(j) / n, 0};
  point.in_cell = in_cell(part, point.in_part);
  return point;
}

/// Darker where a face is turned away from a light that stands above the eye's left.
double shade_of(const Vector<3>& normal, const Eye& eye) {
  const Vector<3> light = (eye.to_eye + 0.6 * eye.up - 0.4 * eye.right).normalized();
  return 0.75 + 0.25 * std::max(0.0, normal.dot(light));
}

/// Draws facets into pieces.
class Surface {
 public:
  Surface(const scene::Problem<3>& problem, const scene::Displacement<3>& displacement, const DrawnShapeOf<3>& shape,
          const Eye& eye, const SurfaceColour& colour)
      : problem_(problem), displacement_(displacement), shape_(shape), eye_(eye), colour_(colour) {}

  Vector<3> drawn(int facet, const InCell& point) const {
    const int cell = problem_.mesh.boundary[facet].cell;
    return value_in(point, scene::positions(problem_.mesh, problem_.mesh.cells[cell])) +
           way_drawn(problem_, displacement_, shape_, cell, point, facet);
  }

  std::array<Vector<3>, 3> corners(int facet) const {
    std::array<Vector<3>, 3> x;
    for (int i = 0; i < 3; ++i) {
      InCell point = {};
      point[scene::Simplex<3>::facets[problem_.mesh.boundary[facet].local][i]] = 1;
      x[i] = drawn(facet, point);
    }
    return x;
  }

  /// Its n² triangles that are turned to the eye. \param outlined whether the facet's edges are drawn
  void add(std::vector<Tessera>& pieces, int facet, int n, bool outlined) const {
    const auto& face = problem_.mesh.boundary[facet];
    const FaceColour value = colour_(facet);
    const auto triangle = [&](const std::array<std::array<int, 2>, 3>& at) {
      std::array<Vector<3>, 3> x;
      InCell middle = {};
      for (int k = 0; k < 3; ++k) {
        const OnFacet point = on_facet(face.local, n, at[k][0], at[k][1]);
        x[k] = drawn(facet, point.in_cell);
        for (int c = 0; c < 4; ++c) middle[c] += point.in_part[c] / 3;
      }
      const Vector<3> normal = (x[1] - x[0]).cross(x[2] - x[0]).normalized();
      if (!(normal.dot(eye_.to_eye) > 0)) return;
      Tessera piece;
      for (const Vector<3>& corner : x) piece.corner.push_back(eye_.project(corner));
      piece.depth = (x[0] + x[1] + x[2]).dot(eye_.to_eye) / 3;
      piece.shade = shade_of(normal, eye_);
      piece.value = value(middle);
      const auto on_edge = [&](int k) {  // whether the side from corner k to the next lies on an edge of the facet
        const auto &a = at[k], &b = at[(k + 1) % 3];
        return (a[0] == 0 && b[0] == 0) || (a[1] == 0 && b[1] == 0) || (a[0] + a[1] == n && b[0] + b[1] == n);
      };
      if (outlined) piece.outlined = {on_edge(0), on_edge(1), on_edge(2)};
      pieces.push_back(std::move(piece));
    };
    for (int i = 0; i < n; ++i)
      for (int j = 0; i + j < n; ++j) {
        triangle({{{i, j}, {i + 1, j}, {i, j + 1}}});
        if (i + j + 1 < n) triangle({{{i + 1, j}, {i + 1, j + 1}, {i, j + 1}}});
      }
  }

 private:
  const scene::Problem<3>& problem_;
  const scene::Displacement<3>& displacement_;
  const DrawnShapeOf<3>& shape_;
  const Eye& eye_;
  const SurfaceColour& colour_;
};

/// Which facets lie on another body, so that nobody sees them.
std::vector<char> covered(const Surface& faces, const scene::Problem<3>& problem) {
  const double nothing = 1e-3 * problem.length_scale;
  std::vector<char> result(problem.mesh.boundary.size(), 0);
  for (const auto& contact : problem.contact) {
    if (contact.second < 0) continue;
    const auto first = faces.corners(contact.first), second = faces.corners(contact.second);
    bool apart = false;
    for (int i = 0; i < 3; ++i) apart = apart || (first[i] - second[contact.meets[i]]).norm() > nothing;
    result[contact.first] = result[contact.second] = !apart;
  }
  return result;
}

double longest_edge(const std::array<Vector<3>, 3>& x, const Eye& eye) {
  double longest = 0;
  for (int k = 0; k < 3; ++k) longest = std::max(longest, eye.project(x[k] - x[(k + 1) % 3]).norm());
  return longest;
}

}  // namespace

Eye::Eye(const Vector<3>& towards)
    : to_eye(towards.normalized()), right(Vector<3>::UnitY().cross(to_eye).normalized()), up(to_eye.cross(right)) {}

std::vector<Tessera> surface(const scene::Problem<3>& problem, const scene::Displacement<3>& displacement,
                             const DrawnShapeOf<3>& shape, const Eye& eye, const SurfaceColour& colour) {
  const Surface faces(problem, displacement, shape, eye, colour);
  const int n_faces = static_cast<int>(problem.mesh.boundary.size());
  const double size = problem.length_scale;
  const std::vector<char> hidden = covered(faces, problem);
  std::vector<Tessera> pieces;
  for (int facet = 0; facet < n_faces; ++facet) {
    if (hidden[facet]) continue;
    const double longest = longest_edge(faces.corners(facet), eye) / size;
    const bool outlined = longest > shortest_outlined;
    const int least = outlined ? displacement.degree : 1;  // smaller ones look flat
    faces.add(pieces, facet, std::max(least, static_cast<int>(std::ceil(longest / largest_piece))), outlined);
  }
  return pieces;
}

}  // namespace bracket::apps
