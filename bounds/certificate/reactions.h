// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "bounds/certificate/linear_system.h"
#include "bounds/certificate/totals.h"

/// Reactions that hold the bodies as wholes.
namespace bracket::bounds {

/// A load on one facet that can be had in any amount to hold bodies.
struct Reaction {
  enum class Kind {
    any,        ///< Γ_u; `which` 0, 1: uniform along x, y; 2: linear along the normal, without resultant force
    normal,     ///< Γ_0 and Γ_K: along the normal, the Bernstein polynomial `which` of the facet
    shear,      ///< Γ_K with friction: along the tangent, likewise
    correction  ///< of the first mesh's loads, `which` of Problem::corrections
  };
  Kind kind;
  int facet;
  int which;
  int other = -1;  ///< Γ_K: the second side
  int degree = 1;  ///< normal, shear: of the polynomial
  bool operator==(const Reaction&) const = default;
};

/// Reactions whose resultants on the bodies are a basis of all: 3 for each body. Pressures are taken of pairs that
/// carry, where they are large and may fall before those of zero, which may rise; shear of these, where much is left to
/// its bound, only where no pressure or support acts on a motion; corrections only where nothing else does.
/// \param barred pressures and shears that are not to be taken   \return fewer where no basis was found
std::vector<Reaction> reactions(const scene::Problem<2>& problem, const std::vector<Reference>& references,
                                const PlainLoads& loads, const std::vector<Reaction>& barred);

/// Takes all pressures off the pairs of which one that is not zero is barred. \return false where there are none
bool drop_barred_pairs(const scene::Problem<2>& problem, const std::vector<Reaction>& barred, PlainLoads& loads);

/// The unit of a reaction as a load on its facet: what is linear of it, which has its resultant.
template <class Number> SideLoad<Number> unit_load(const scene::Problem<2>& problem, const Reaction& reaction) {
  if (reaction.kind == Reaction::Kind::normal || reaction.kind == Reaction::Kind::shear) {
    std::vector<Number> unit(reaction.degree + 1, Number(0));
    unit[reaction.which] = Number(1);
    Vector2<Number> n = vector2<Number>(problem.facets[reaction.facet].normal);
    if (reaction.kind == Reaction::Kind::shear) n = turned(n);
    const auto [at0, at1] = split<Number>(unit).linear;
    return {at0 * n, at1 * n};
  }
  if (reaction.which < 2) {
    const Vector2<Number> unit = vector2<Number>(scene::Vector<2>::Unit(reaction.which));
    return {unit, unit};
  }
  const Vector2<Number> across = turned(along<Number>(problem, reaction.facet));
  return {-across, across};
}

/// What one unit of a reaction does to the bodies: their entries, one body after the other.
template <class Number>
std::vector<Number> effect(const scene::Problem<2>& problem, const std::vector<Reference>& references,
                           const Reaction& reaction) {
  std::vector<Number> result(3 * problem.mesh.components.size(), Number(0));
  const auto on = [&](const scene::Problem<2>& of, int facet, const SideLoad<Number>& on_facet) {
    const int body = of.mesh.cell_component[of.mesh.boundary[facet].cell];
    const auto part = entries(references[body], facet_resultant(of, references, facet, on_facet));
    for (int i = 0; i < 3; ++i) result[3 * body + i] += part[i];
  };
  if (reaction.kind == Reaction::Kind::correction) {
    const auto& [facet, unit] = scene::first_of(problem).corrections[reaction.which];
    on(scene::first_of(problem), facet, {vector2<Number>(unit[0]), vector2<Number>(unit[1])});
    return result;
  }
  SideLoad<Number> load = unit_load<Number>(problem, reaction);
  if (problem.facets[reaction.facet].support == scene::Support::contact) {  // a pressure or shear
    load = {-load[0], -load[1]};
    if (reaction.other >= 0) on(problem, reaction.other, {-load[1], -load[0]});
  }
  on(problem, reaction.facet, load);
  return result;
}

/// The amounts of the chosen reactions that make the totals zero. \return nothing where they cannot be found
template <class Number, class Sum>
std::optional<std::vector<Number>> amounts_that_hold(const scene::Problem<2>& problem,
                                                     const std::vector<Reference>& references,
                                                     const std::vector<Reaction>& chosen,
                                                     const EdgeLoads<Number>& loads) {
  const std::size_t n = 3 * problem.mesh.components.size();
  if (chosen.size() < n) return {};
  std::vector<Number> missing = totals<Number, Sum>(problem, references, loads);
  std::vector<std::vector<Number>> matrix(n, std::vector<Number>(n));
  for (std::size_t j = 0; j < n; ++j) {
    const std::vector<Number> column = effect<Number>(problem, references, chosen[j]);
    for (std::size_t i = 0; i < n; ++i) matrix[i][j] = column[i];
    missing[j] = -missing[j];
  }
  return solution(std::move(matrix), std::move(missing));
}

/// Holds the bodies: adds reactions that make the totals zero.
template <class Number>
void add_reactions(const scene::Problem<2>& problem, const std::vector<Reaction>& chosen,
                   const std::vector<Number>& amounts, EdgeLoads<Number>& loads) {
  for (std::size_t j = 0; j < chosen.size(); ++j) {
    const auto& [kind, facet, which, other, degree] = chosen[j];
    if (kind == Reaction::Kind::normal) loads.along_normal[facet][which] += amounts[j];
    if (kind == Reaction::Kind::shear) loads.along_tangent[facet][which] += amounts[j];
    if (kind != Reaction::Kind::any) continue;
    SideLoad<Number> load = unit_load<Number>(problem, chosen[j]);
    for (auto& end : load) end = amounts[j] * end;
    const bool along = forward(problem.mesh.boundary[facet]);
    auto& edge = loads.edge[problem.mesh.boundary[facet].edge];
    for (int end = 0; end < 2; ++end) edge[end] = edge[end] + oriented(load, along)[end];
  }
  spread_loads(problem, loads);
}

/// The first of the chosen pressures that would have to be tension where that cannot be, or of the shears that would
/// have to exceed its bound; nothing: none.
template <class Number>
std::optional<Reaction> beyond_law(const scene::Problem<2>& problem, const EdgeLoads<Number>& loads,
                                   const std::vector<Reaction>& chosen) {
  std::vector<const scene::ContactFacet*> contact_at(problem.facets.size(), nullptr);
  for (const auto& pair : problem.contact) contact_at[pair.first] = &pair;
  const FirstContacts contacts = first_contacts(problem);
  for (const Reaction& reaction : chosen) {
    if (reaction.kind != Reaction::Kind::normal && reaction.kind != Reaction::Kind::shear) continue;
    const scene::ContactFacet* pair = contact_at[reaction.facet];
    if (!pair) continue;
    if (reaction.kind == Reaction::Kind::shear) {
      const Number bound = shear_bound<Number>(problem, contacts, *pair, loads.degree)[reaction.which];
      const Number& shear = loads.along_tangent[reaction.facet][reaction.which];
      if (!certainly_non_negative(bound - shear) || !certainly_non_negative(bound + shear)) return reaction;
    } else if (!pair->law.two_sided && !certainly_non_negative(loads.along_normal[reaction.facet][reaction.which])) {
      return reaction;
    }
  }
  return {};
}

}  // namespace bracket::bounds
