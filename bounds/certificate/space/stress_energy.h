// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bounds/certificate/arithmetic.h"
#include "bounds/certificate/space/approach.h"
#include "bounds/certificate/space/elastic_form.h"
#include "bounds/certificate/space/stress_loads.h"
#include "scene/parallel.h"

/// The energy of the stresses of face loads in balance: real numbers that `Number` encloses or holds exactly.
namespace bracket::bounds::space {

/// The stress of a cell in balance.
template <class Number>
scene::BalancedStress<3, Number> block_stress(const scene::Problem<3>& problem, const LoadedCell<Number>& cell,
                                              int body) {
  return scene::balanced_stress<3, Number>(cell_geometry(cell.x), cell.load, body_force<Number>(problem, body));
}

/// S of a cell in balance.
template <class Number>
Number block_energy(const scene::Problem<3>& problem, const ElasticForm<Number>& form, const LoadedCell<Number>& cell,
                    int body) {
  Number sum(0);
  for (const auto& part : block_stress(problem, cell, body))
    sum += mean_of_squares<Number>([&](const std::array<Number, 6>& s) { return form.stress_energy(s); }, part);
  return volume6(cell.x) / Number(24) * sum;
}

/// S(λ) [HH81 (1.11)] of the stresses of balanced loads. \tparam Sum with add() and value()
template <class Number, class Sum>
Number stress_energy(const scene::Problem<3>& problem, const std::vector<Face>& faces, const Supports& supports,
                     const Loads<Number>& loads) {
  const auto& mesh = problem.mesh;
  const auto forms = elastic_forms<Number>(problem);
  const auto of_cells = [&](int begin, int end) {
    check_arithmetic();
    Sum sum;
    for (int cell = begin; cell < end; ++cell) {
      const int body = mesh.cell_body[cell];
      sum.add(block_energy(problem, forms[body], loaded_cell(problem, faces, loads, cell), body));
    }
    return sum.value();
  };
  Sum energy;
  for (const Number& part : scene::of_chunks<Number>(static_cast<int>(mesh.cells.size()), of_cells)) energy.add(part);
  for (int f = 0; f < static_cast<int>(problem.facets.size()); ++f) {
    if (problem.facets[f].support == scene::Support::fixed) {
      energy.add(-mean_product(loads.face[face_of(mesh, f)], held_at<Number>(problem, f)));
    } else if (problem.facets[f].support == scene::Support::sliding) {
      const auto slides = slides_of(problem, supports.fixed, f);
      energy.add(-mean_product<Number>(loads.along_normal[f],
                                       {value<Number>(slides[0]), value<Number>(slides[1]), value<Number>(slides[2])}));
    }
  }
  for (const auto& pair : problem.contact)
    energy.add(bernstein_product(loads.along_normal[pair.first], gap_paid<Number>(problem, supports, pair)));
  return energy.value();
}

}  // namespace bracket::bounds::space
