// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "bounds/certificate/supports.h"
#include "scene/bernstein.h"
#include "scene/problem/psi.h"

/// What contact facets with a law of their own take from the first mesh: the law, and the gap of sides that keep
/// together, which both bounds have to take for one and the same function.
namespace bracket::bounds {

/// Whether the sides move with r = g: they keep together, and no spring is between them.
inline bool keeps_together(const scene::FacetLaw& law) { return law.two_sided && !scene::has_springs(law); }
inline bool has_law(const scene::FacetLaw& law) {
  return law.two_sided || scene::has_springs(law) || scene::has_friction(law);
}

/// A real number between two doubles that differ by rounding: an enclosure holds all, other numbers are the middle.
template <class Number> Number between_bounds(double lower, double upper) {
  if (lower == upper) return Number(lower);
  if constexpr (std::is_same_v<Number, Enclosure>) {
    const scene::Real middle = (scene::Real(lower) + scene::Real(upper)) / 2;
    return {middle, scene::rounding::up(std::max(scene::Real(upper) - middle, middle - scene::Real(lower)))};
  } else {
    return (Number(lower) + Number(upper)) / Number(2);
  }
}

/// Two vertices, or a vertex and a wall (−1), that face each other along d.
struct Facing {
  int first, second;
  std::array<double, 2> d;
  auto operator<=>(const Facing&) const = default;
};
/// At an end of a contact facet. Seen from either side it is the same: r does not change.
Facing facing(const scene::Problem<2>& problem, const scene::ContactFacet& pair, int end);

/// The end of a contact facet of the first mesh at which neither side can move along d.
struct HeldEnd {
  VertexSupport first;
  std::optional<VertexSupport> second;  ///< nothing: a wall
};

/// The gap of a two-sided facet of the first mesh. Its bounds differ by rounding only, and neighbours agree by rounding
/// only; what is meant is a function between them, up to that rounding, which
/// - is what the supports prescribe where they do,
/// - is linear where it may be, but for rounding,
/// - has one value at a vertex for each direction.
struct KeptGap {
  std::array<double, 3> lower, upper;
  std::array<std::optional<HeldEnd>, 2> held = {};
  bool is_linear = false;
  scene::Vector<2> d = scene::Vector<2>::Zero();
  scene::Perturbation<2>::Contact added = {};  ///< ψ
  double factor = 0;                           ///< times ψ; 0: nothing
  bool is_psi_linear = false;
};

/// Of the problem's contact facets.
struct FirstContacts {
  std::vector<int> of_facet = {};  ///< of each facet of the first mesh, its contact; empty: no facet has a law
  std::vector<KeptGap> kept = {};  ///< of each contact of the first mesh; empty: none is two-sided
  std::string fault = {};          ///< why r = g cannot be: one line
};
/// \param supports of the vertices of the problem's mesh
FirstContacts first_contacts(const scene::Problem<2>& problem, const std::vector<VertexSupport>& supports);
FirstContacts first_contacts(const scene::Problem<2>& problem);

/// What the supports make of u′·d − u″·d at such an end.
template <class Number, class Part>
Number prescribed_approach(const HeldEnd& end, const scene::Vector<2>& d, const Part& part) {
  const auto along = [&](const VertexSupport& support) {
    return component<Number>(part(support), scene::Vector<2>::Zero(), d);
  };
  return end.second ? Number(along(end.first) - along(*end.second)) : along(end.first);
}

/// A quadratic on the first mesh's facet with what is prescribed at its ends.
template <class Number, class Part>
std::array<Number, 3> with_held_ends(const KeptGap& gap, std::array<Number, 3> c, bool is_linear, const Part& part) {
  for (int end = 0; end < 2; ++end)
    if (gap.held[end]) c[2 * end] = prescribed_approach<Number>(*gap.held[end], gap.d, part);
  if (is_linear) c[1] = (c[0] + c[2]) / Number(2);
  return c;
}

/// ψ of a two-sided facet of the first mesh.
template <class Number> std::array<Number, 3> kept_psi(const KeptGap& gap) {
  return with_held_ends(gap, scene::psi<Number>(gap.added, gap.d, scene::whole<1>(0)), gap.is_psi_linear, added_part);
}

/// Its gap, as Bernstein coefficients from vertex 0 to vertex 1.
template <class Number> std::array<Number, 3> kept_gap(const KeptGap& gap) {
  std::array<Number, 3> c;
  for (int i = 0; i < 3; ++i) c[i] = between_bounds<Number>(gap.lower[i], gap.upper[i]);
  c = with_held_ends(gap, c, gap.is_linear, own_part);
  if (gap.factor == 0) return c;
  const std::array<Number, 3> psi = kept_psi<Number>(gap);
  for (int i = 0; i < 3; ++i) c[i] += Number(gap.factor) * psi[i];
  return c;
}

/// ψ_t on a facet of a perturbed problem's mesh.
template <class Number>
std::vector<Number> perturbing_slip(const scene::Problem<2>& problem, const scene::ContactFacet& pair) {
  const scene::Piece<1> piece = scene::piece_of_facet(problem, pair.first);
  const auto& by = *problem.perturbed.by;
  const auto psi =
      scene::psi_of_slip<Number>(by.contact[by.contact_of[piece.of]], problem.facets[pair.first].normal, piece);
  return {psi.begin(), psi.end()};
}

/// What friction does not see of v_t on a facet of the problem's mesh: of the first mesh, and f ψ_t. Empty: nothing.
template <class Number>
std::vector<Number> unseen_slip(const scene::Problem<2>& problem, const FirstContacts& contacts,
                                const scene::ContactFacet& pair) {
  const auto [of, corner] = scene::piece_of_facet(problem, pair.first);
  const std::array<double, 3>& own = scene::first_of(problem).contact[contacts.of_facet[of]].slip;
  const double factor = problem.perturbed.kinematics;
  if (factor == 0 && own == std::array<double, 3>{0, 0, 0}) return {};
  const auto cut =
      scene::on_stretch<Number>({Number(own[0]), Number(own[1]), Number(own[2])}, corner[0][0], corner[1][0]);
  std::vector<Number> result(cut.begin(), cut.end());
  if (factor == 0) return result;
  const std::vector<Number> psi = perturbing_slip<Number>(problem, pair);
  for (int i = 0; i < 3; ++i) result[i] += Number(factor) * psi[i];
  return result;
}

/// The same on a two-sided facet of the problem's mesh.
template <class Number>
std::array<Number, 3> kept_gap(const scene::Problem<2>& problem, const FirstContacts& contacts,
                               const scene::ContactFacet& pair) {
  const auto [of, corner] = scene::piece_of_facet(problem, pair.first);
  return scene::on_stretch(kept_gap<Number>(contacts.kept[contacts.of_facet[of]]), corner[0][0], corner[1][0]);
}

}  // namespace bracket::bounds
