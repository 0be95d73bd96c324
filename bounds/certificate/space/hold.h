// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <set>

#include "bounds/certificate/linear_system.h"
#include "bounds/certificate/space/stress_loads.h"

/// What holds bodies without Γ_u as wholes: what their loads lack of balance is spread over Γ_0 and Γ_K.
namespace bracket::bounds::space {

/// The point about which moments of a body are counted, and the size of the body.
struct Reference {
  scene::Vector<3> point;
  double size;
};
/// Of each body.
std::vector<Reference> references(const scene::Mesh<3>& mesh);

/// Of each body its first row in what follows, six of those without Γ_u, −1 of the others; and their number.
struct Rows {
  std::vector<int> of_body;
  int count = 0;
};
Rows rows_of(const scene::Problem<3>& problem);

/// A load along the direction of a facet that may change: linear on it, not zero at one vertex only.
struct Spread {
  int facet;  ///< of Γ_K: the first side
  int vertex;
  int second;     ///< index into Problem::facets, −1: none
  int meets;      ///< the vertex of that
  double weight;  ///< how readily it changes
  bool may_pull;
};
/// A vertex of a facet.
using Corner = std::array<int, 2>;
/// Those on bodies without Γ_u. Γ_0 and two-sided contacts change by their area; one-sided ones by the square of their
/// load, so that those do that are far from zero.
/// \param least share of a pair's largest load that its other ones are taken for
/// \param barred first sides that are not to change
std::vector<Spread> spreads(const scene::Problem<3>& problem, const Rows& rows, const PlainLoads& loads, double least,
                            const std::set<Corner>& barred);

/// Takes all pressures off the pairs of which one that is not zero is barred. \return false where there are none
bool drop_barred_pairs(const scene::Problem<3>& problem, const std::set<Corner>& barred, PlainLoads& loads);

/// What a load does to the bodies at its two sides: force, and moment by the size of the body.
template <class Number> struct Effect {
  std::array<int, 2> row = {-1, -1};
  std::array<std::array<Number, 6>, 2> entry{};
};
template <class Number> std::array<Number, 6> entries(const Reference& about, const Wrench<Number>& wrench) {
  const Number size(about.size);
  return {wrench.force[0],         wrench.force[1],         wrench.force[2],
          wrench.moment[0] / size, wrench.moment[1] / size, wrench.moment[2] / size};
}
template <class Number>
std::array<Number, 6> entries_of_load(const scene::Problem<3>& problem, const std::vector<Reference>& about, int facet,
                                      const FacetVectors<Number>& load) {
  const Reference& own = about[problem.mesh.cell_component[problem.mesh.boundary[facet].cell]];
  return entries(own, resultant(load, arms<Number>(problem, own.point, facet)));
}
template <class Number>
Effect<Number> effect(const scene::Problem<3>& problem, const std::vector<Reference>& about, const Rows& rows,
                      const Spread& one) {
  Effect<Number> result;
  const auto add = [&](int side, int facet, int vertex, const Vector3<Number>& unit) {
    result.row[side] = rows.of_body[problem.mesh.cell_component[problem.mesh.boundary[facet].cell]];
    if (result.row[side] < 0) return;
    FacetVectors<Number> load{};
    load[vertex] = unit;
    result.entry[side] = entries_of_load(problem, about, facet, load);
  };
  const Vector3<Number> d = vector3<Number>(problem.facets[one.facet].normal);
  const bool presses = problem.facets[one.facet].support == scene::Support::contact;
  add(0, one.facet, one.vertex, presses ? -d : d);
  if (one.second >= 0) add(1, one.second, one.meets, d);
  return result;
}

/// All that acts on the bodies without Γ_u from outside, as entries: the sum of what their cells lack.
template <class Number, class Sum>
std::vector<Number> totals(const scene::Problem<3>& problem, const std::vector<Reference>& about, const Rows& rows,
                           const Loads<Number>& loads) {
  const auto& mesh = problem.mesh;
  std::vector<Sum> sums(rows.count);
  const auto add = [&](int row, const std::array<Number, 6>& part) {
    for (int i = 0; i < 6; ++i) sums[row + i].add(part[i]);
  };
  for (int f = 0; f < static_cast<int>(mesh.boundary.size()); ++f) {
    const int row = rows.of_body[mesh.cell_component[mesh.boundary[f].cell]];
    if (row >= 0) add(row, entries_of_load(problem, about, f, loads.face[face_of(mesh, f)]));
  }
  for (int cell = 0; cell < static_cast<int>(mesh.cells.size()); ++cell) {
    const int component = mesh.cell_component[cell], body = mesh.cell_body[cell], row = rows.of_body[component];
    if (row < 0 || !has_force(problem, body)) continue;
    const auto x = corners<Number>(problem, cell);
    const Vector3<Number> to_centroid =
        arm_of_cell<Number>(problem, about[component].point, cell) + (Number(1) / Number(4)) * (x[1] + x[2] + x[3]);
    const Vector3<Number> weight = (volume6(x) / Number(6)) * body_force<Number>(problem, body);
    add(row, entries<Number>(about[component], {weight, cross(to_centroid, weight)}));
  }
  std::vector<Number> result;
  for (const Sum& sum : sums) result.push_back(sum.value());
  return result;
}

/// Of the first mesh's corrections, `count` that with the spreads hold the bodies; of those that do not, whichever.
/// \pre count ≤ their number
std::vector<int> chosen_corrections(const scene::Problem<3>& problem, const std::vector<Reference>& about,
                                    const Rows& rows, const std::vector<Spread>& spreads, int count);

/// Multiples of the spreads (W Hᵀ y) and of the corrections that bring the bodies into balance.
template <class Number> struct Held { std::vector<Number> spread, correction; };
/// With H the effects of the spreads, C those of the corrections, W the weights and r the totals
///     H W Hᵀ y + C c = −r,     Cᵀ y = 0.
/// \param corrections which of the first mesh's   \return nothing where that may be singular
template <class Number, class Sum>
std::optional<Held<Number>> held(const scene::Problem<3>& problem, const std::vector<Reference>& about,
                                 const Rows& rows, const std::vector<Spread>& spreads,
                                 const std::vector<int>& corrections, const Loads<Number>& loads) {
  const scene::Problem<3>& first = scene::first_of(problem);
  const std::size_t own = rows.count, n = own + corrections.size();
  std::vector<std::vector<Number>> matrix(n, std::vector<Number>(n, Number(0)));
  std::vector<Effect<Number>> effects;
  for (const Spread& one : spreads) {
    const auto& [row, entry] = effects.emplace_back(effect<Number>(problem, about, rows, one));
    for (int a = 0; a < 2; ++a)
      for (int b = 0; b < 2; ++b)
        for (int i = 0; i < 6 && row[a] >= 0 && row[b] >= 0; ++i) {
          const Number weighted = Number(one.weight) * entry[a][i];
          for (int j = 0; j < 6; ++j) matrix[row[a] + i][row[b] + j] += weighted * entry[b][j];
        }
  }
  for (std::size_t k = 0; k < corrections.size(); ++k) {
    const auto& [facet, unit] = first.corrections[corrections[k]];
    const int row = rows.of_body[first.mesh.cell_component[first.mesh.boundary[facet].cell]];
    if (row < 0) return {};  // nothing is to be corrected there
    const auto column = entries_of_load<Number>(
        first, about, facet, {vector3<Number>(unit[0]), vector3<Number>(unit[1]), vector3<Number>(unit[2])});
    for (int i = 0; i < 6; ++i) matrix[row + i][own + k] = matrix[own + k][row + i] = column[i];
  }
  std::vector<Number> missing = totals<Number, Sum>(problem, about, rows, loads);
  for (Number& one : missing) one = -one;
  missing.resize(n, Number(0));
  const auto y = solution(std::move(matrix), std::move(missing));
  if (!y) return {};
  Held<Number> result;
  for (std::size_t s = 0; s < spreads.size(); ++s) {
    Number amount(0);
    for (int a = 0; a < 2; ++a)
      for (int i = 0; i < 6 && effects[s].row[a] >= 0; ++i)
        amount += effects[s].entry[a][i] * (*y)[effects[s].row[a] + i];
    result.spread.push_back(Number(spreads[s].weight) * amount);
  }
  for (std::size_t k = own; k < n; ++k) result.correction.push_back((*y)[k]);
  return result;
}

}  // namespace bracket::bounds::space
