// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bounds/certificate/arithmetic.h"
#include "bounds/certificate/space/corrections.h"
#include "bounds/certificate/space/tree.h"
#include "scene/parallel.h"

/// Exact balance of face loads: what computed loads lack is carried to where the bodies are held.
namespace bracket::bounds::space {

/// Balances every cell of bodies that are held: each, from the leaves on, hands what it lacks to its parent through
/// their common face; what comes to a root on Γ_u goes there, other roots lack nothing.
template <class Number>
Loads<Number> handed_on(const scene::Problem<3>& problem, const std::vector<Face>& faces, const Loads<Number>& loads) {
  const auto& mesh = problem.mesh;
  // What a cell lacks with all that hangs on it, about its first corner. It is handed on as a resultant: taken again
  // from the loads that carry it, its enclosure would grow from cell to cell.
  std::vector<Wrench<Number>> lacks(mesh.cells.size());
  scene::in_chunks(static_cast<int>(lacks.size()), [&](int, int begin, int end) {
    check_arithmetic();
    for (int c = begin; c < end; ++c)
      lacks[c] = imbalance(problem, loaded_cell(problem, faces, loads, c), mesh.cell_body[c]);
  });
  const std::vector<Branch> branches = trees(problem, faces);
  Loads<Number> result = loads;
  for (auto branch = branches.rbegin(); branch != branches.rend(); ++branch) {
    const auto& [cell, parent, side] = *branch;
    if (side < 0) continue;
    const auto x = corners<Number>(problem, cell);
    const Wrench<Number>& own = lacks[cell];
    const int number = scene::cell_facets(mesh, cell)[side];
    const FacetVectors<Number> carried = as_of_face(load_with({-own.force, -own.moment}, corners_of_facet(x, side)),
                                                    faces[number], faces[number].cell[0] != cell);
    for (int i = 0; i < 3; ++i) result.face[number][i] = result.face[number][i] + carried[i];
    if (parent < 0) continue;
    // From the parent's first corner to that of the cell, by way of a corner that they share.
    const int corner = scene::Simplex<3>::facets[side][0];
    const auto& of_parent = mesh.cells[parent];
    const auto shared = std::find(of_parent.begin(), of_parent.end(), mesh.cells[cell][corner]) - of_parent.begin();
    const Vector3<Number> to_cell = corners<Number>(problem, parent)[shared] - x[corner];
    add(lacks[parent], {own.force, own.moment + cross(to_cell, own.force)});
  }
  return result;
}

template <class Number> struct Balanced {
  std::optional<Loads<Number>> loads;  ///< every cell in balance
  std::string reason;                  ///< if there are none
};

/// The pressures that would have to be tension where that cannot be.
template <class Number> std::set<Corner> pulling(const std::vector<Spread>& changed, const Loads<Number>& loads) {
  std::set<Corner> result;
  for (const Spread& one : changed)
    if (!one.may_pull && !certainly_non_negative(loads.along_normal[one.facet][one.vertex]))
      result.insert({one.facet, one.vertex});
  return result;
}

/// Loads that balance every cell exactly: Γ_0 and Γ_K hold the bodies without Γ_u as wholes, then cells hand on what
/// they lack. \param corrections as corrected() has them
template <class Number, class Sum>
Balanced<Number> balanced(const scene::Problem<3>& problem, const std::vector<Face>& faces,
                          const std::vector<Corrected<Number>>& corrections, PlainLoads given) {
  const std::vector<Reference> about = references(scene::first_of(problem).mesh);
  const Rows rows = rows_of(problem);
  if (rows.count == 0) return {handed_on(problem, faces, loads_of<Number>(problem, given, corrections)), ""};
  // A pressure that is rounding itself may be too small to take what is missing. Then another has to; where none can,
  // all of its pair are rounding.
  constexpr int most = 20;
  std::set<Corner> barred;
  for (int round = 0;; ++round) {
    Loads<Number> loads = loads_of<Number>(problem, given, corrections);
    std::vector<Spread> changed;
    std::optional<Held<Number>> found;
    if (const auto count = vanishing_corrections(problem, carrying_pairs(problem, given)); round < most && count)
      for (const double least : {0.0, 1e-4}) {
        changed = spreads(problem, rows, given, least, barred);
        const std::vector<int> taken = chosen_corrections(problem, about, rows, changed, *count);
        found = held<Number, Sum>(problem, about, rows, changed, taken, loads);
        if (found) break;
      }
    if (!found) {
      if (!drop_barred_pairs(problem, barred, given))
        return {{}, "no supports or contacts were found that take what rounding leaves of the loads"};
      barred.clear();
      round = -1;
      continue;
    }
    for (std::size_t k = 0; k < changed.size(); ++k)
      loads.along_normal[changed[k].facet][changed[k].vertex] += found->spread[k];
    const std::set<Corner> beyond = pulling(changed, loads);
    if (beyond.empty()) {
      spread_loads(problem, loads);
      return {handed_on(problem, faces, loads), ""};
    }
    barred.insert(beyond.begin(), beyond.end());
  }
}

}  // namespace bracket::bounds::space
