// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/problem/fix_gaps.h"

#include <optional>

#include "scene/problem/gap.h"
#include "scene/problem/given_gap.h"
#include "scene/problem/projection.h"
#include "scene/problem/sides.h"
#include "scene/problem/space/face_gap.h"
#include "scene/problem/space/face_values.h"
#include "scene/problem/support.h"

namespace bracket::scene {

namespace {

/// Of the values of a gap or slip at the ends and the midpoint: Bernstein coefficients.
std::array<double, 3> coefficients(const FacetValues<3>& values) {
  const auto& [start, end, middle] = values.value;
  return {start, middle + 0.5 * ((middle - start) + (middle - end)), end};
}

/// In space they are these already.
std::array<double, 6> coefficients(const FacetValues<6>& values) { return values.value; }

/// What friction does not see of the slip, where a jump is prescribed: a quadratic on the facet, by coefficients that
/// are the data from here on, as prescribed displacements are.
void fix_jump(const ContactPair<2>& pair, const Vector<2>& a, const Vector<2>& b, const Vector<2>& d,
              ContactFacet& facet, Extent& extent) {
  const std::optional<Function<2>> along = given_slip(pair, d);
  if (!along || !has_friction(facet.law)) return;
  if (const auto bounds = along->is_enclosed() ? quadratic_gap(*along, a, b) : std::nullopt) {
    for (int i = 0; i < 3; ++i) facet.slip[i] = 0.5 * bounds->lower[i] + 0.5 * bounds->upper[i];
    return;
  }
  const FacetValues<3> values = interpolate_quadratic(*along, a, b, pair.where);
  facet.slip = coefficients(values);
  extent.include(values);
}

/// Whether displacements are to have the gap, r = g, on the whole facet, and can have linear ones only.
template <int dim> bool is_kept_linear(const ContactFacetOf<dim>& facet, int degree) {
  return facet.law.two_sided && !has_springs(facet.law) && degree == 1;
}

/// Whether a function between these bounds of its coefficients may be linear.
bool may_be_linear(const GapBounds& bounds) {
  const auto& [lower, upper] = bounds;
  return 2 * lower[1] <= upper[0] + upper[2] && 2 * upper[1] >= lower[0] + lower[2];
}
bool may_be_linear(const FaceGapBounds& bounds) {
  const auto& [lower, upper] = bounds;
  for (int e = 0; e < 3; ++e) {
    const auto& [i, k] = Simplex<2>::edges[e];
    if (2 * lower[3 + e] > upper[i] + upper[k] || 2 * upper[3 + e] < lower[i] + lower[k]) return false;
  }
  return true;
}

/// The linear function with the values at the vertices, in place of a quadratic one.
FacetValues<3> interpolated_linear(const Function<2>& gap, const std::array<Vector<2>, 2>& x,
                                   const std::string& where) {
  const auto& [value, error, largest] = interpolate_linear(gap, x[0], x[1], where);
  return {{value[0], value[1], 0.5 * value[0] + 0.5 * value[1]}, error, largest};
}
FacetValues<6> interpolated_linear(const Function<3>& gap, const Face& x, const std::string& where) {
  const auto& [value, error, largest] = interpolate_linear(gap, x, where);
  FacetValues<6> result{{value[0], value[1], value[2]}, error, largest};
  for (int e = 0; e < 3; ++e) {
    const auto& [i, k] = Simplex<2>::edges[e];
    result.value[3 + e] = 0.5 * value[i] + 0.5 * value[k];
  }
  return result;
}

// On an edge and on a face alike.
std::optional<GapBounds> quadratic_on(const Function<2>& gap, const std::array<Vector<2>, 2>& x) {
  return quadratic_gap(gap, x[0], x[1]);
}
std::optional<FaceGapBounds> quadratic_on(const Function<3>& gap, const Face& x) { return quadratic_gap(gap, x); }
FacetValues<3> interpolated_quadratic(const Function<2>& gap, const std::array<Vector<2>, 2>& x,
                                      const std::string& where) {
  return interpolate_quadratic(gap, x[0], x[1], where);
}
FacetValues<6> interpolated_quadratic(const Function<3>& gap, const Face& x, const std::string& where) {
  return interpolate_quadratic(gap, x, where);
}

}  // namespace

template <int dim> Extent fix_gaps(const Scene<dim>& scene, Problem<dim>& problem) {
  Extent gap;
  problem.gaps.resize(problem.contact.size());
  for (std::size_t i = 0; i < problem.contact.size(); ++i) {
    ContactFacetOf<dim>& facet = problem.contact[i];
    const ContactPair<dim>& pair = scene.contact[facet.pair];
    const auto x = positions(problem.mesh, problem.mesh.boundary[facet.first].vertices);
    const Vector<dim>& d = problem.facets[facet.first].normal;
    if constexpr (dim == 2) fix_jump(pair, x[0], x[1], d, facet, gap);
    const std::optional<Function<dim>> given = given_gap(pair, d);
    const bool linear = is_kept_linear(facet, scene.solve.degree);
    const auto quadratic = given && given->is_enclosed() ? quadratic_on(*given, x) : std::nullopt;
    if (quadratic && !(linear && !may_be_linear(*quadratic))) {
      facet.lower = quadratic->lower;
      facet.upper = quadratic->upper;
    } else if (given && given->is_enclosed() && !facet.law.two_sided) {
      problem.gaps[i].function = *given;
      problem.gaps[i].where = pair.where;
    } else {
      const auto values = !given   ? drawn_gap(scene, problem, facet)
                          : linear ? interpolated_linear(*given, x, pair.where)
                                   : interpolated_quadratic(*given, x, pair.where);
      facet.lower = facet.upper = coefficients(values);
      gap.include(values);
    }
  }
  gap.error = std::max(gap.error, make_room(problem));
  for (std::size_t i = 0; i < problem.contact.size(); ++i) {
    ContactFacetOf<dim>& facet = problem.contact[i];
    if (problem.gaps[i].function)
      facet = on_piece(problem, static_cast<int>(i), facet.first, facet.second, whole<dim - 1>(0));
    for (const FacetQuadratic<dim>& c : {facet.lower, facet.upper})
      for (const double value : c) gap.largest = std::max(gap.largest, std::abs(value));
  }
  return gap;
}

template Extent fix_gaps(const Scene<2>&, Problem<2>&);
template Extent fix_gaps(const Scene<3>&, Problem<3>&);

}  // namespace bracket::scene
