// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bounds/certificate/judge_parts.h"

namespace bracket::bounds {

using scene::Support;

namespace {

using Matrix = std::array<std::array<Exact, 3>, 3>;

ExactVoigt times(const Matrix& m, const ExactVoigt& a) {
  ExactVoigt result;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) result[i] += m[i][j] * a[j];
  return result;
}

ExactVoigt mean(const ExactVoigt& a, const ExactVoigt& b) {
  return {half * (a[0] + b[0]), half * (a[1] + b[1]), half * (a[2] + b[2])};
}

Exact dot(const ExactVoigt& a, const ExactVoigt& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// Hooke's law by Lamé's constants, or the given matrix.
Matrix stiffness(const scene::Material<2>& material) {
  Matrix c;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) c[i][j] = Exact(material.stiffness()(i, j));
  const auto& constants = material.constants();
  if (!constants) return c;
  const Exact young(constants->young), poisson(constants->poisson), one(1), two(2);
  const Exact mu = young / (two * (one + poisson));
  const Exact lambda = constants->plane == scene::Plane::stress
                           ? young * poisson / (one - poisson * poisson)
                           : young * poisson / ((one + poisson) * (one - two * poisson));
  return {{{lambda + two * mu, lambda, Exact(0)}, {lambda, lambda + two * mu, Exact(0)}, {Exact(0), Exact(0), mu}}};
}

/// By cofactors.
Matrix inverse(const Matrix& m) {
  Matrix result;
  const auto cofactor = [&](int i, int j) {
    return m[(i + 1) % 3][(j + 1) % 3] * m[(i + 2) % 3][(j + 2) % 3] -
           m[(i + 1) % 3][(j + 2) % 3] * m[(i + 2) % 3][(j + 1) % 3];
  };
  const Exact determinant = m[0][0] * cofactor(0, 0) + m[0][1] * cofactor(0, 1) + m[0][2] * cofactor(0, 2);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) result[j][i] = cofactor(i, j) / determinant;
  return result;
}

/// ε(u) at a point of a cell, from the derivatives of the quadratic shape functions.
ExactVoigt strain(const scene::Mesh<2>& mesh, const ExactDisplacement& u, int cell, const ExactVoigt& barycentric) {
  const std::array<Point, 3> d = gradients(corners_of(mesh, cell));
  ExactVoigt result;
  const auto add = [&](const Point& value, const Point& gradient) {
    result = {result[0] + value.x * gradient.x, result[1] + value.y * gradient.y,
              result[2] + value.x * gradient.y + value.y * gradient.x};
  };
  for (int k = 0; k < 3; ++k) {
    const int a = (k + 1) % 3, b = (k + 2) % 3;
    add(u.vertex[mesh.cells[cell][k]], (Exact(4) * barycentric[k] - Exact(1)) * d[k]);
    add(u.edge[mesh.cell_edges[cell][k]], Exact(4) * (barycentric[a] * d[b] + barycentric[b] * d[a]));
  }
  return result;
}

/// ∫ a·b along a facet: Simpson's rule, for products up to cubics.
Exact work(const OnFacet& a, const OnFacet& b) {
  return (dot(a[0], b[0]) + dot(a[1], b[1]) + Exact(4) * dot(a[2], b[2])) / Exact(6);
}

}  // namespace

Exact potential_energy(const scene::Problem<2>& problem, const ExactDisplacement& u,
                       const std::vector<Corrected<Exact>>& added) {
  const auto& mesh = problem.mesh;
  Exact result;
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    const scene::Body<2>& body = problem.bodies[mesh.cell_body[c]];
    const Matrix hooke = stiffness(body.material);
    Exact density;  // three times its mean: by the middles of the sides
    for (int k = 0; k < 3; ++k) {
      ExactVoigt middle = {half, half, half};
      middle[k] = Exact(0);
      const ExactVoigt e = strain(mesh, u, static_cast<int>(c), middle);
      density += half * dot(e, times(hooke, e)) - dot(vector2<Exact>(body.force), u.edge[mesh.cell_edges[c][k]]);
    }
    result += third * area(corners_of(mesh, static_cast<int>(c))) * density;
  }
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    if (problem.facets[f].support != Support::traction && !scene::is_loaded(problem.facets[f])) continue;
    const int facet = static_cast<int>(f);
    result -= work(traction_on(problem, added, facet), displacement_on(mesh, u, facet));
  }
  return result;
}

namespace {

/// ½ ‖λ − factor σ(u)‖²_{C⁻¹}: part by part, by the middles of their sides.
Exact stress_norm(const scene::Problem<2>& problem, const ExactStress& stress, const ExactDisplacement& u,
                  const Exact& factor) {
  const auto& mesh = problem.mesh;
  Exact result;
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    const int cell = static_cast<int>(c);
    const Matrix hooke = stiffness(problem.bodies[mesh.cell_body[c]].material), compliance = inverse(hooke);
    Exact density;
    for (int i = 0; i < 3; ++i) {
      const auto corners = part_corners(i);
      for (int k = 0; k < 3; ++k) {
        ExactVoigt s = mean(stress.cell[c][i][k], stress.cell[c][i][(k + 1) % 3]);
        if (!is_zero(factor))
          s = sum(s, times(hooke, strain(mesh, u, cell, mean(corners[k], corners[(k + 1) % 3]))), -factor);
        density += half * dot(s, times(compliance, s));
      }
    }
    result += area(corners_of(mesh, cell)) / Exact(9) * density;
  }
  return result;
}

/// ∫ of a product of functions on a facet, at its ends and in the middle.
Exact product(const ExactVoigt& a, const ExactVoigt& b) {
  return (a[0] * b[0] + a[1] * b[1] + Exact(4) * a[2] * b[2]) / Exact(6);
}

}  // namespace

Exact complementary_energy(const scene::Problem<2>& problem, const ExactStress& stress, const ExactDisplacement& u) {
  Exact result = stress_norm(problem, stress, u, Exact(0));
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    const Support support = problem.facets[f].support;
    if (support != Support::fixed && support != Support::sliding) continue;
    const int facet = static_cast<int>(f);
    result -= work(load_on(problem.mesh, stress, facet), displacement_on(problem.mesh, u, facet));
  }
  for (const auto& pair : problem.contact) result += product(pressure(problem, stress, pair), gap(pair));
  return result;
}

Exact distance(const scene::Problem<2>& problem, const ExactStress& stress, const ExactDisplacement& u) {
  Exact result = stress_norm(problem, stress, u, Exact(1));
  for (const auto& pair : problem.contact)
    result += product(pressure(problem, stress, pair), sum(gap(pair), approach(problem, u, pair), Exact(-1)));
  return result;
}

}  // namespace bracket::bounds
