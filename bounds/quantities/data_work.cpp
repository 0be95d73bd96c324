// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/certificate/corrections.h"
#include "bounds/certificate/space/corrections.h"
#include "bounds/quantities/parts.h"

namespace bracket::bounds {

using scene::Problem;
using scene::Support;
using scene::TwofoldVector;

namespace {

/// The sum over a component. \param of_facet, of_cell what each has, of Γ_τ and of cells
template <int dim, class OfFacet, class OfCell>
Enclosure over_component(const Problem<dim>& first, int component, const OfFacet& of_facet, const OfCell& of_cell) {
  const auto& mesh = first.mesh;
  LongSum sum;
  const auto add = [&](const Enclosure& work) {
    if (!work.is_zero()) sum.add(work);
  };
  for (std::size_t f = 0; f < mesh.boundary.size(); ++f)
    if (mesh.cell_component[mesh.boundary[f].cell] == component && first.facets[f].support == Support::traction)
      add(of_facet(static_cast<int>(f)));
  for (std::size_t c = 0; c < mesh.cells.size(); ++c)
    if (mesh.cell_component[c] == component) add(of_cell(static_cast<int>(c)));
  return sum.value();
}

}  // namespace

DataWork work_of_data(const Problem<2>& first, int component, const std::function<TwofoldVector<2>(int vertex)>& u) {
  const auto& mesh = first.mesh;
  const auto [corrections, reason] = corrected<Enclosure, LongSum>(first);
  if (!reason.empty()) return {{}, reason};
  const auto of_facet = [&](int f) {
    if (!carries_load(first, corrections, f)) return Enclosure();
    const auto& [a, b] = mesh.boundary[f].vertices;
    return linear_product<Enclosure>(prescribed_load(first, corrections, f).linear,  // as u
                                     {vector2<Enclosure>(u(a)), vector2<Enclosure>(u(b))});
  };
  const auto of_cell = [&](int c) {
    const int body = mesh.cell_body[c];
    if (!has_force(first, body)) return Enclosure();
    Vector2<Enclosure> sum;  // three times u at the centroid
    for (const int v : mesh.cells[c]) sum = sum + vector2<Enclosure>(u(v));
    return doubled_area(corners<Enclosure>(first, c)) / Enclosure(6) * dot(body_force<Enclosure>(first, body), sum);
  };
  return {over_component(first, component, of_facet, of_cell), ""};
}

DataWork work_of_data(const Problem<3>& first, int component, const std::function<TwofoldVector<3>(int vertex)>& u) {
  using namespace space;
  const auto& mesh = first.mesh;
  const auto [corrections, reason] = space::corrected<Enclosure, LongSum>(first);
  if (!reason.empty()) return {{}, reason};
  const auto of_facet = [&](int f) {
    if (!space::carries_load(first, corrections, f)) return Enclosure();
    FacetVectors<Enclosure> at;
    for (int i = 0; i < 3; ++i) at[i] = vector3<Enclosure>(u(mesh.boundary[f].vertices[i]));
    return mean_product<Enclosure>(space::prescribed_load(first, corrections, f), at);
  };
  const auto of_cell = [&](int c) {
    const int body = mesh.cell_body[c];
    if (!space::has_force(first, body)) return Enclosure();
    Vector3<Enclosure> sum{};  // four times u at the centroid
    for (const int v : mesh.cells[c]) sum = sum + vector3<Enclosure>(u(v));
    return volume6(space::corners<Enclosure>(first, c)) / Enclosure(24) *
           dot(space::body_force<Enclosure>(first, body), sum);
  };
  return {over_component(first, component, of_facet, of_cell), ""};
}

}  // namespace bracket::bounds
