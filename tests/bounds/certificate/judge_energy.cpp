// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bounds/certificate/judge_parts.h"

namespace bracket::bounds {

using scene::Support;

namespace {

using Matrix = std::array<std::array<Exact, 3>, 3>;

StressField times(const Matrix& m, const StressField& a) {
  StressField result;
  for (int i = 0; i < 3; ++i) {
    result[i] = m[i][0] * a[0];
    for (int j = 1; j < 3; ++j) result[i] = result[i] + m[i][j] * a[j];
  }
  return result;
}

Polynomial product(const StressField& a, const StressField& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

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

/// ε(u) on a cell.
StressField strain(const scene::Mesh<2>& mesh, const ExactDisplacement& u, int cell) {
  const std::array<Point, 3> d = gradients(corners_of(mesh, cell));
  StressField result;
  for (int k = 0; k < 3; ++k) {
    const Polynomial x = u.cell[cell][0].derivative(k), y = u.cell[cell][1].derivative(k);
    result = {result[0] + d[k].x * x, result[1] + d[k].y * y, result[2] + d[k].y * x + d[k].x * y};
  }
  return result;
}

}  // namespace

Exact potential_energy(const scene::Problem<2>& problem, const ExactDisplacement& u,
                       const std::vector<Corrected<Exact>>& added) {
  const auto& mesh = problem.mesh;
  Exact result;
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    const scene::Body<2>& body = problem.bodies[mesh.cell_body[c]];
    const Matrix hooke = stiffness(body.material);
    const int cell = static_cast<int>(c);
    const StressField e = strain(mesh, u, cell);
    const Polynomial density = half * product(e, times(hooke, e)) - dot(u.cell[c], vector2<Exact>(body.force));
    result += area(corners_of(mesh, cell)) * density.mean();
  }
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    if (problem.facets[f].support != Support::traction && !scene::is_loaded(problem.facets[f])) continue;
    const int facet = static_cast<int>(f);
    result -= dot(traction_on(problem, added, facet), displacement_on(mesh, u, facet)).mean();
  }
  return result;
}

Exact strain_energy(const scene::Problem<2>& problem, const ExactDisplacement& u) {
  Exact result;
  for (std::size_t c = 0; c < problem.mesh.cells.size(); ++c) {
    const int cell = static_cast<int>(c);
    const StressField e = strain(problem.mesh, u, cell);
    result += area(corners_of(problem.mesh, cell)) *
              (half * product(e, times(stiffness(scene::body_of(problem, cell).material), e))).mean();
  }
  return result;
}

namespace {

/// ½ ‖λ − factor σ(u)‖²_{C⁻¹} on a cell, part by part.
Exact stress_norm(const scene::Problem<2>& problem, const ExactStress& stress, const ExactDisplacement& u,
                  const Exact& factor, int cell) {
  const auto& mesh = problem.mesh;
  const Matrix hooke = stiffness(scene::body_of(problem, cell).material), compliance = inverse(hooke);
  StressField sigma;
  if (!is_zero(factor)) sigma = times(hooke, strain(mesh, u, cell));
  Exact result;
  for (int i = 0; i < 3; ++i) {
    const auto coordinates = coordinates_on_part(i);
    StressField s = stress.cell[cell][i];
    if (!is_zero(factor))
      s = sum(s, {sigma[0].of(coordinates), sigma[1].of(coordinates), sigma[2].of(coordinates)}, -factor);
    result += third * area(corners_of(mesh, cell)) * half * product(s, times(compliance, s)).mean();
  }
  return result;
}

}  // namespace

Exact complementary_energy(const scene::Problem<2>& problem, const ExactStress& stress, const ExactDisplacement& u) {
  Exact result;
  for (std::size_t c = 0; c < problem.mesh.cells.size(); ++c)
    result += stress_norm(problem, stress, u, Exact(0), static_cast<int>(c));
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    const Support support = problem.facets[f].support;
    if (support != Support::fixed && support != Support::sliding) continue;
    const int facet = static_cast<int>(f);
    result -= dot(reaction_on(problem, stress, facet), displacement_on(problem.mesh, u, facet)).mean();
  }
  for (const auto& pair : problem.contact) {
    result += (pressure(problem, stress, pair) * gap(problem, pair)).mean();
    if (scene::has_friction(pair.law)) result += (shear(problem, stress, pair) * unseen(problem, pair)).mean();
  }
  return result;
}

std::vector<Exact> misfits(const scene::Problem<2>& problem, const ExactStress& stress, const ExactDisplacement& u) {
  std::vector<Exact> result;
  for (std::size_t c = 0; c < problem.mesh.cells.size(); ++c)
    result.push_back(stress_norm(problem, stress, u, Exact(1), static_cast<int>(c)));
  return result;
}

Exact contact_term(const scene::Problem<2>& problem, const ExactStress& stress, const ExactDisplacement& u) {
  Exact result;
  for (const auto& pair : problem.contact) {
    result += (pressure(problem, stress, pair) * (gap(problem, pair) - approach(problem, u, pair))).mean();
    if (scene::has_friction(pair.law)) result -= (shear(problem, stress, pair) * slip(problem, u, pair)).mean();
  }
  return result;
}

Exact distance(const scene::Problem<2>& problem, const ExactStress& stress, const ExactDisplacement& u) {
  Exact result = contact_term(problem, stress, u);
  for (const Exact& misfit : misfits(problem, stress, u)) result += misfit;
  return result;
}

}  // namespace bracket::bounds
