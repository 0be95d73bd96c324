// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bounds/certificate/space/faces.h"
#include "bounds/certificate/space/geometry.h"
#include "scene/fields.h"

/// The loads on all faces: those of a stress field as plain numbers, and real numbers that `Number` encloses or holds
/// exactly.
namespace bracket::bounds::space {

/// As plain numbers. On Γ_τ, where the data say what they are, they are left out.
struct PlainLoads {
  std::vector<std::array<scene::Vector<3>, 3>> face = {};  ///< zero on Γ_τ, Γ_0 and Γ_K
  /// Of each boundary facet, at its vertices: Γ_0: along FacetData::normal; Γ_K, first sides only: the pressure times
  /// the area, ≥ 0 but for two-sided ones.
  std::vector<std::array<double, 3>> along_normal = {};
};
PlainLoads plain_loads(const scene::Problem<3>& problem, const std::vector<Face>& faces,
                       const scene::Stress<3>& stress);
/// The loads of the data alone. \param pressure on all of Γ_K, times the area
PlainLoads no_loads(const scene::Problem<3>& problem, double pressure = 0);
/// Which contact pairs press anywhere, or may as well pull.
std::vector<char> carrying_pairs(const scene::Problem<3>& problem, const PlainLoads& loads);

/// The same loads with `Number`, those of the data included.
template <class Number> struct Loads {
  std::vector<FacetVectors<Number>> face = {};
  std::vector<std::array<Number, 3>> along_normal = {};
};

/// The face of a boundary facet, whose cell is its first.
inline int face_of(const scene::Mesh<3>& mesh, int facet) {
  const auto& at = mesh.boundary[facet];
  return scene::cell_facets(mesh, at.cell)[at.local];
}

/// What a perturbation has on a facet of Γ_0 or Γ_K beside what acts there.
template <class Number> FacetVectors<Number> beside(const scene::Problem<3>& problem, int facet) {
  FacetVectors<Number> load = perturbing_load<Number>(problem, facet);
  for (auto& corner : load) corner = Number(problem.perturbed.loads) * corner;
  return load;
}

/// Writes the loads of Γ_0 and Γ_K into the faces.
template <class Number> void spread_loads(const scene::Problem<3>& problem, Loads<Number>& loads) {
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    if (problem.facets[f].support != scene::Support::sliding) continue;
    const Vector3<Number> n = vector3<Number>(problem.facets[f].normal);
    auto& face = loads.face[face_of(problem.mesh, static_cast<int>(f))];
    for (int i = 0; i < 3; ++i) face[i] = loads.along_normal[f][i] * n;
  }
  for (const auto& pair : problem.contact) {
    const Vector3<Number> d = vector3<Number>(problem.facets[pair.first].normal);
    const auto opening = opening_load<Number>(problem, pair);
    for (int i = 0; i < 3; ++i) {
      Number pressure = loads.along_normal[pair.first][i];
      if (problem.perturbed.by) pressure -= Number(problem.perturbed.loads) * opening[i];
      const Vector3<Number> load = pressure * d;
      loads.face[face_of(problem.mesh, pair.first)][i] = -load;
      if (pair.second >= 0) loads.face[face_of(problem.mesh, pair.second)][pair.meets[i]] = load;
    }
  }
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    const int facet = static_cast<int>(f);
    if (problem.facets[f].support == scene::Support::traction || !has_perturbing_load(problem, facet)) continue;
    const FacetVectors<Number> added = beside<Number>(problem, facet);
    auto& face = loads.face[face_of(problem.mesh, facet)];
    for (int i = 0; i < 3; ++i) face[i] = face[i] + added[i];
  }
}

/// \param corrections as corrected() has them
template <class Number>
Loads<Number> loads_of(const scene::Problem<3>& problem, const PlainLoads& given,
                       const std::vector<Corrected<Number>>& corrections) {
  Loads<Number> loads;
  for (const auto& [a, b, c] : given.face)
    loads.face.push_back({vector3<Number>(a), vector3<Number>(b), vector3<Number>(c)});
  for (const auto& [a, b, c] : given.along_normal) loads.along_normal.push_back({Number(a), Number(b), Number(c)});
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    const int facet = static_cast<int>(f);
    if (carries_load(problem, corrections, facet))
      loads.face[face_of(problem.mesh, facet)] = prescribed_load(problem, corrections, facet);
  }
  spread_loads(problem, loads);
  return loads;
}

/// A cell's corners as seen from its first, and the loads on its facets.
template <class Number> struct LoadedCell {
  std::array<Vector3<Number>, 4> x;
  scene::FacetLoads<3, Number> load;
};
template <class Number>
LoadedCell<Number> loaded_cell(const scene::Problem<3>& problem, const std::vector<Face>& faces,
                               const Loads<Number>& loads, int cell) {
  LoadedCell<Number> result{corners<Number>(problem, cell), {}};
  for (int k = 0; k < 4; ++k) {
    const int number = scene::cell_facets(problem.mesh, cell)[k];
    result.load[k] = seen_from(loads.face[number], faces[number], faces[number].cell[0] != cell);
  }
  return result;
}
/// The corners of a facet of it.
template <class Number> FacetVectors<Number> corners_of_facet(const std::array<Vector3<Number>, 4>& x, int local) {
  const auto& [a, b, c] = scene::Simplex<3>::facets[local];
  return {x[a], x[b], x[c]};
}

/// What is left of a cell's loads and its body force, about its first corner.
template <class Number>
Wrench<Number> imbalance(const scene::Problem<3>& problem, const LoadedCell<Number>& cell, int body) {
  Wrench<Number> sum;
  for (int k = 0; k < 4; ++k) add(sum, resultant(cell.load[k], corners_of_facet(cell.x, k)));
  if (!has_force(problem, body)) return sum;
  const Vector3<Number> weight = (volume6(cell.x) / Number(6)) * body_force<Number>(problem, body);
  add(sum, {weight, (Number(1) / Number(4)) * cross(cell.x[1] + cell.x[2] + cell.x[3], weight)});
  return sum;
}

}  // namespace bracket::bounds::space
