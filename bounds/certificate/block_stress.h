// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bounds/certificate/vector2.h"
#include "scene/bernstein.h"
#include "scene/block_fields.h"

namespace bracket::bounds {

/// Loads on the side of a cell from corner i to corner i + 1, per unit of the parameter along it, at its two ends: what
/// is linear of them, which alone has a resultant. What they have beside it are Legendre's polynomials of higher
/// degrees.
template <class Number> using SideLoad = std::array<Vector2<Number>, 2>;

template <class Number> struct Wrench {
  Vector2<Number> force;
  Number moment = Number(0);
};

/// Force and moment of a load on the edge e, about a point from which the edge's first end is at `arm`.
template <class Number>
Wrench<Number> resultant(const SideLoad<Number>& load, const Vector2<Number>& arm, const Vector2<Number>& e) {
  const Vector2<Number> force = (Number(1) / Number(2)) * (load[0] + load[1]);
  return {force, cross(arm, force) + cross(e, load[0] + load[1] + load[1]) / Number(6)};
}

/// The load on the edge e that has a resultant, given about a point from which the edge's first end is at `arm`.
template <class Number>
SideLoad<Number> load_with(const Wrench<Number>& resultant, const Vector2<Number>& arm, const Vector2<Number>& e) {
  const Vector2<Number> to_middle = arm + (Number(1) / Number(2)) * e;
  const Number rest = resultant.moment - cross(to_middle, resultant.force);
  const Vector2<Number> linear = (Number(6) * rest / dot(e, e)) * turned(e);
  return {resultant.force - linear, resultant.force + linear};
}

/// The stress of a block element, xx, yy, xy by Bernstein coefficients on each of the three triangles at the sides i,
/// whose corners are i, i + 1 and the centroid.
template <class Number> using BlockStress = std::array<std::vector<std::array<Number, 3>>, 3>;

/// What is done to the coefficients of each component of a stress or strain.
template <class Number, class Do>
std::vector<std::array<Number, 3>> by_component(const std::vector<std::array<Number, 3>>& values, const Do& to_values) {
  std::vector<std::array<Number, 3>> result;
  for (int c = 0; c < 3; ++c) {
    std::vector<Number> component;
    for (const auto& value : values) component.push_back(value[c]);
    const std::vector<Number> done = to_values(component);
    result.resize(done.size());
    for (std::size_t i = 0; i < done.size(); ++i) result[i][c] = done[i];
  }
  return result;
}

/// The same polynomials on a triangle, of their own degree, by coefficients of another that is not lower.
template <class Number>
std::vector<std::array<Number, 3>> raised(std::vector<std::array<Number, 3>> values, int own, int degree) {
  for (; own < degree; ++own)
    values = by_component(values, [&](const auto& c) { return scene::raised_on_triangle<Number>(c, own); });
  return values;
}

/// The linear stress of a block element from its side loads, by HH81 Theorem 2.1 the only one: at the corners of each
/// part. Self-equilibrated side loads are integrated twice around the boundary to Airy's function and its gradient (t
/// ds = d(∂φ/∂y, −∂φ/∂x)); the block element's stresses are the second derivatives of the Hsieh–Clough–Tocher cubic
/// with these boundary values: C¹, so that tractions are continuous. Its Bernstein coefficients follow by means.
/// \param x corners, as seen from the first   \param load of the sides i → i + 1, self-equilibrated
template <class Number>
BlockStress<Number> stress_of_balanced(const std::array<Vector2<Number>, 3>& x,
                                       const std::array<SideLoad<Number>, 3>& load) {
  const Number half = Number(1) / Number(2), third = Number(1) / Number(3), six(6);
  const Vector2<Number> centroid = third * (x[0] + x[1] + x[2]);
  // φ and its gradient g at the corners (both zero at the first), b: the gradient's middle coefficient on each side.
  std::array<Number, 4> phi;
  std::array<Vector2<Number>, 4> g;
  std::array<Vector2<Number>, 3> b, side, inward;
  phi[0] = Number(0);
  for (int i = 0; i < 3; ++i) {
    side[i] = x[(i + 1) % 3] - x[i];
    inward[i] = centroid - x[i];
    b[i] = g[i] + half * turned(load[i][0]);
    g[i + 1] = b[i] + half * turned(load[i][1]);
    phi[i + 1] = phi[i] + third * dot(g[i] + b[i] + g[i + 1], side[i]);
  }
  phi[3] = Number(0);  // in balance both come back to where they began
  g[3] = {};
  std::array<Number, 3> a, m, h;  // next to corner i, in the middle of triangle i, next to the centroid
  for (int i = 0; i < 3; ++i) {
    a[i] = phi[i] + third * dot(g[i], inward[i]);
    m[i] = phi[i] + third * (dot(g[i], side[i]) + dot(b[i], inward[i]));
  }
  for (int i = 0; i < 3; ++i) h[i] = third * (a[i] + m[i] + m[(i + 2) % 3]);
  const Number centre = third * (h[0] + h[1] + h[2]);

  BlockStress<Number> stress;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const Number near = phi[i] + third * dot(g[i], side[i]), far = phi[i + 1] - third * dot(g[i + 1], side[i]);
    // Second differences along the side and inward (uu, uv, vv) at the corners i, j and the centroid.
    const std::array<std::array<Number, 3>, 3> second = {
        {{far - near - (near - phi[i]), m[i] - near - (a[i] - phi[i]), h[i] - a[i] - (a[i] - phi[i])},
         {phi[i + 1] - far - (far - near), a[j] - far - (m[i] - near), h[j] - m[i] - (m[i] - near)},
         {a[j] - m[i] - (m[i] - a[i]), h[j] - m[i] - (h[i] - a[i]), centre - h[i] - (h[i] - a[i])}}};
    // Gradients p, q of the coordinates along the side and inward, by the determinant.
    stress[i].resize(3);
    const Vector2<Number> p = -turned(inward[i]), q = turned(side[i]);
    const Number determinant = cross(side[i], inward[i]);
    const Number six_by_square = six / (determinant * determinant);
    const auto products = [&](const Number& px, const Number& py, const Number& qx, const Number& qy) {
      return std::array<Number, 3>{six_by_square * (px * py), six_by_square * (px * qy + py * qx),
                                   six_by_square * (qx * qy)};
    };
    const auto of_xx = products(p.y, p.y, q.y, q.y), of_yy = products(p.x, p.x, q.x, q.x);
    const auto of_xy = products(p.x, p.y, q.x, q.y);
    for (int k = 0; k < 3; ++k) {
      const auto sum = [&](const std::array<Number, 3>& factor) {
        return second[k][0] * factor[0] + second[k][1] * factor[1] + second[k][2] * factor[2];
      };
      stress[i][k] = {sum(of_xx), sum(of_yy), -sum(of_xy)};
    }
  }
  return stress;
}

/// The stresses beside the linear ones of a block element of degree 2 or 3 (scene/block_fields.h).
/// \param x corners, as seen from the first
/// \param higher of the sides i → i + 1, per unit of their parameter: the coefficients of Legendre's polynomials of
///     degree 2 (and 3)
/// \param bubbles amplitudes of those without tractions
template <class Number>
BlockStress<Number> stress_of_higher(int degree, const std::array<Vector2<Number>, 3>& x,
                                     const std::array<std::vector<Vector2<Number>>, 3>& higher,
                                     const std::vector<double>& bubbles) {
  const scene::BlockFields& fields = scene::block_fields(degree);
  const Vector2<Number> u = x[1] - x[0], v = x[2] - x[0];
  const Number determinant = cross(u, v);
  const std::size_t n = scene::n_bernstein(degree);
  std::vector<std::array<Number, 3>> reference(3 * n, {Number(0), Number(0), Number(0)});
  const auto add = [&](const Number& amplitude, const scene::BlockField& field) {
    for (std::size_t i = 0; i < 3 * n; ++i)
      for (std::size_t c = 0; c < 3; ++c)
        if (field[3 * i + c] != 0) reference[i][c] += Number(field[3 * i + c]) * amplitude;
  };
  for (int i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < higher[i].size(); ++k) {
      // By B⁻¹ = (v_y −v_x; −u_y u_x) / det B, on the side opposite to corner i + 2.
      const Vector2<Number>& load = higher[i][k];
      const std::array<Number, 2> pulled_back = {cross(load, v) / determinant, cross(u, load) / determinant};
      for (int c = 0; c < 2; ++c) add(pulled_back[c] / Number(fields.load_divisor), fields.load[k][(i + 2) % 3][c]);
    }
  for (std::size_t m = 0; m < bubbles.size(); ++m)
    if (bubbles[m] != 0) add(Number(bubbles[m]), fields.bubbles[m]);
  BlockStress<Number> stress;
  for (int i = 0; i < 3; ++i)
    for (std::size_t place = 0; place < n; ++place) {
      const auto& [xx, yy, xy] = reference[n * ((i + 2) % 3) + place];
      const Vector2<Number> first = xx * u + xy * v, second = xy * u + yy * v;  // B τ̂, column by column
      stress[i].push_back({(first.x * u.x + second.x * v.x) / determinant,
                           (first.y * u.y + second.y * v.y) / determinant,
                           (first.x * u.y + second.x * v.y) / determinant});
    }
  return stress;
}

}  // namespace bracket::bounds
