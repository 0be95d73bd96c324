// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// Planar: the stress across the plane.
#include "apps/report/von_mises.h"

#include <algorithm>
#include <array>
#include <tuple>

#include "apps/report/stresses.h"

namespace bracket::apps {
namespace {

using scene::Voigt;

/// A point of one of a cell's parts: its barycentric coordinates in the cell, and how the coefficients count there.
struct SamplePoint {
  std::array<double, 3> in_cell;
  std::vector<double> of_cell, of_part;
};

/// Corners of the parts, where linear stresses are largest; of higher degrees points between them, too.
std::array<std::vector<SamplePoint>, 3> sample_points(int cell_degree, int part_degree) {
  const int lattice = part_degree == 1 ? 1 : 2 * part_degree;
  std::array<std::vector<SamplePoint>, 3> result;
  for (int part = 0; part < 3; ++part)
    for (const auto& index : scene::bernstein_indices(lattice)) {
      std::array<double, 3> in_part, in_cell;
      for (int i = 0; i < 3; ++i) in_part[i] = static_cast<double>(index[i]) / lattice;
      in_cell.fill(in_part[2] / 3);
      for (int corner = 0; corner < 2; ++corner) in_cell[scene::Simplex<2>::facets[part][corner]] += in_part[corner];
      result[part].push_back(
          {in_cell, scene::bernstein_values(cell_degree, in_cell), scene::bernstein_values(part_degree, in_part)});
    }
  return result;
}

template <class Values> Voigt<2> weighted(const std::vector<double>& factors, const Values& values) {
  Voigt<2> result = Voigt<2>::Zero();
  for (std::size_t i = 0; i < factors.size(); ++i) result += factors[i] * values[i];
  return result;
}

}  // namespace

template <> LargestVonMises largest_von_mises(const bounds::Outcome<2>& outcome, scene::Plane plane) {
  const auto& [problem, displacement, stress] = std::tie(outcome.problem, outcome.displacement, outcome.stress);
  const auto points = sample_points(scene::stress_degree(displacement.degree), stress.degree);
  LargestVonMises largest;
  for (int cell = 0; cell < static_cast<int>(problem.mesh.cells.size()); ++cell) {
    const scene::Material<2>& material = scene::body_of(problem, cell).material;
    if (!stress_across(material, plane, Voigt<2>::Zero())) {
      largest.of_all = false;
      continue;
    }
    const auto sigma = bounds::displacement_stress(problem, displacement, cell);
    for (int part = 0; part < 3; ++part) {
      const auto lambda = scene::stress_of_part(stress, cell, part);
      for (const SamplePoint& point : points[part]) {
        const Voigt<2> mean = (weighted(point.of_cell, sigma) + weighted(point.of_part, lambda)) / 2;
        const double own = von_mises(mean, *stress_across(material, plane, mean));
        if (own <= largest.value) continue;
        largest.value = own;
        largest.at.setZero();
        for (int k = 0; k < 3; ++k) largest.at += point.in_cell[k] * problem.mesh.vertices[problem.mesh.cells[cell][k]];
      }
    }
  }
  return largest;
}

}  // namespace bracket::apps
