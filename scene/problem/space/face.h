// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// In space: functions and polynomials on a face, a facet of a tetrahedron, by barycentric coordinates.
#pragma once

#include "scene/function.h"
#include "scene/mesh/simplex.h"

namespace bracket::scene {

/// The corners of a face.
using Face = std::array<Vector<3>, 3>;
/// A point of a face, or a direction in it, by the coordinates 1 and 2; a point has 1 less their sum at corner 0.
using OnFace = std::array<double, 2>;
/// The corners of a triangle on a face, multiples of a power of two: see Piece.
using FacePart = std::array<OnFace, 3>;
inline constexpr FacePart whole_face = {{{0, 0}, {1, 0}, {0, 1}}};

inline Vector<3> place(const Face& face, const OnFace& at) {
  return face[0] + at[0] * (face[1] - face[0]) + at[1] * (face[2] - face[0]);
}

/// The share that a part is of its face. \pre it was cut by bisection: then it is a power of two, without rounding
inline double share_of_face(const FacePart& part) {
  const double determinant =
      (part[1][0] - part[0][0]) * (part[2][1] - part[0][1]) - (part[2][0] - part[0][0]) * (part[1][1] - part[0][1]);
  return std::exp2(std::round(std::log2(determinant)));
}

/// What is linear on a face, by its values at the corners. Exact at these and where they are equal; on a side the same
/// to the last bit for both faces that it belongs to, whatever their order of corners. \pre the side is one of theirs
template <class Value> Value linear_at(const std::array<Value, 3>& corner, const OnFace& at) {
  const std::array<double, 3> weight = {1 - at[0] - at[1], at[0], at[1]};
  int zeros = 0, zero = 0;
  for (int i = 0; i < 3; ++i)
    if (weight[i] == 0) {
      ++zeros;
      zero = i;
    }
  for (int i = 0; i < 3; ++i)
    if (weight[i] == 1) return corner[i];
  if (zeros == 0) return corner[0] + at[0] * (corner[1] - corner[0]) + at[1] * (corner[2] - corner[0]);
  const int i = (zero + 1) % 3, k = (zero + 2) % 3;
  const auto between = [&](double a, double b) {  // from the lower to the higher value
    return a <= b ? a + weight[k] * (b - a) : b + weight[i] * (a - b);
  };
  if constexpr (std::is_same_v<Value, double>) {
    return between(corner[i], corner[k]);
  } else {
    Value result;
    for (Eigen::Index c = 0; c < result.size(); ++c) result[c] = between(corner[i][c], corner[k][c]);
    return result;
  }
}

/// The Bernstein coefficients of a quadratic, as FacetQuadratic<3> has them, on a part of its face: its blossom. Exact
/// where it is constant.
template <class Number> std::array<Number, 6> on_part(const std::array<Number, 6>& whole, const FacePart& part) {
  const auto linear = [](const std::array<Number, 3>& c, const OnFace& at) {
    if (at[0] == 1) return c[1];
    if (at[1] == 1) return c[2];
    Number result = c[0];
    for (int i = 0; i < 2; ++i)
      if (at[i] != 0) result = result + Number(at[i]) * (c[i + 1] - c[0]);
    return result;
  };
  const auto blossom = [&](const OnFace& p, const OnFace& q) {
    return linear({linear({whole[0], whole[5], whole[4]}, p), linear({whole[5], whole[1], whole[3]}, p),
                   linear({whole[4], whole[3], whole[2]}, p)},
                  q);
  };
  std::array<Number, 6> result;
  for (int i = 0; i < 3; ++i) result[i] = blossom(part[i], part[i]);
  for (int e = 0; e < 3; ++e) {
    const auto& [i, k] = Simplex<2>::edges[e];
    result[3 + e] = blossom(part[i], part[k]);
  }
  return result;
}

/// Two directions in which conditions on sides of the mesh change, so that they are decided beside them: of a face
/// whose corners lie on lines of a grid neither runs along one. Any direction (s, t) is along the first by (2 s − t) /
/// 3 and along the second by (2 t − s) / 3.
inline constexpr std::array<OnFace, 2> across_face = {{{2, 1}, {1, 2}}};

/// An enclosed function along a direction, over a box around a part of a face: what holds of the jet holds at each of
/// its points.
Jet over_part(const Function<3>& f, const Face& face, const FacePart& part, const OnFace& direction);
/// The same at a point: at a corner of the face just beside it, in the direction.
Jet at_point(const Function<3>& f, const Face& face, const OnFace& at, const OnFace& direction);

/// Whether the function is a polynomial of a degree, at most 2, on the face for sure.
bool is_polynomial(const Function<3>& f, const Face& face, int degree);

}  // namespace bracket::scene
