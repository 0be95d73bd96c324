// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bounds/bounds.h"
#include "tests/bounds/certificate/rational.h"
#include "tests/support/scenes.h"

/// Problems whose data are what they are meant to be to the last bit, with their energies L(u) as rational numbers:
/// of moduli, Poisson's ratios and loads as the doubles that they are.
namespace bracket::tests {

struct ExactProblem {
  scene::Problem<2> problem;
  bounds::Rational energy;
};

/// t / E', E' = E / (1 − ν²)
inline bounds::Rational softness(double thickness, double young, double poisson) {
  const bounds::Rational nu(poisson);
  return bounds::Rational(thickness) * (1 - nu * nu) / bounds::Rational(young);
}

/// docs/theory.md §9.1: ½ E' Δ².   \pre n is a power of two
inline ExactProblem exact_patch(double young, double poisson, double lowering, int n) {
  const bounds::Rational by(lowering);
  return {bounds::balanced(problem(patch(young, poisson, lowering, n)), 2),
          by * by / (2 * softness(1, young, poisson))};
}

/// docs/theory.md §9.3: −p₀² (1 + c²/3) (t₁/E₁' + t₂/E₂').
/// \pre nx is a power of two, p₀ and c are so short that p₀ (1 − c x) is exact at the vertices
inline ExactProblem exact_linear_pressure(const LinearPressure& p, int nx, int ny) {
  ExactProblem result{problem(linear_pressure(p, nx, ny)), {}};
  const auto& mesh = result.problem.mesh;
  for (std::size_t f = 0; f < mesh.boundary.size(); ++f)
    for (int i = 0; i < 2; ++i) {
      double& pressure = result.problem.facets[f].pressure[i];
      const double x = mesh.vertices[mesh.boundary[f].vertices[i]][0];
      if (pressure != 0) pressure = p.p0 * (1 - p.c * x);  // for its projection, which rounds
    }
  result.problem = bounds::balanced(std::move(result.problem), 2);
  const bounds::Rational p0(p.p0), c(p.c);
  result.energy = -p0 * p0 * (1 + c * c / 3) *
                  (softness(p.t_lower, p.young_lower, p.poisson) + softness(p.t_upper, p.young_upper, p.poisson));
  return result;
}

}  // namespace bracket::tests
