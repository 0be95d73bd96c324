// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "bounds/certificate/admissible_stress.h"

/// Exact balance of edge loads: what computed loads lack is carried to where the bodies are held. This is also the
/// particular field λ̄ of HH81 (3.16)–(3.19), for loads that are zero inside.
namespace bracket::bounds {

/// A load on one facet that can be had in any amount to hold bodies.
struct Reaction {
  enum class Kind {
    any,        ///< Γ_u; `which` 0, 1: uniform along x, y; 2: linear along the normal, without resultant force
    normal,     ///< Γ_0 and Γ_K: along the normal, at the facet's vertex `which`
    correction  ///< of the first mesh's loads, `which` of Problem::corrections
  };
  Kind kind;
  int facet;
  int which;
  int other = -1;  ///< Γ_K: the second side
  bool operator==(const Reaction&) const = default;
};

/// The point about which moments of a body are counted, and the size of the body.
struct Reference {
  scene::Vector<2> point;
  double size;
};
/// Of each body.
std::vector<Reference> references(const scene::Mesh<2>& mesh);

/// Which contact pairs press anywhere.
std::vector<char> carrying_pairs(const scene::Problem<2>& problem, const PlainLoads& loads);

/// Reactions whose resultants on the bodies are a basis of all: 3 for each body. Pressures are taken of pairs that
/// carry, where they are large and may fall before those of zero, which may rise; corrections only where nothing else
/// acts on a motion.
/// \param barred pressures that are not to be taken   \return fewer where no basis was found
std::vector<Reaction> reactions(const scene::Problem<2>& problem, const std::vector<Reference>& references,
                                const PlainLoads& loads, const std::vector<Reaction>& barred);

/// Takes all pressures off the pairs of which one that is not zero is barred. \return false where there are none
bool drop_barred_pairs(const scene::Problem<2>& problem, const std::vector<Reaction>& barred, PlainLoads& loads);

/// Whether the corrections among the reactions are zero exactly once the loads carry their own corrections: there are
/// as many as motions on which no support and no pair that carries acts, and on none of these acts a pair that the
/// corrections counted on. Then each such motion gains nothing from the loads and meets the corrections alone.
bool corrections_vanish(const scene::Problem<2>& problem, const std::vector<Reaction>& chosen,
                        const std::vector<char>& carrying);

/// A cell in its body's tree of cells.
struct Branch {
  int cell;
  int parent;  ///< −1: the root
  int side;    ///< i → i + 1, at which it touches its parent
};
/// All cells, each after its parent.
std::vector<Branch> trees(const scene::Mesh<2>& mesh, const std::vector<Reference>& references);

/// x with A x = b. \return nothing where A may be singular
std::optional<std::vector<Enclosure>> solution(std::vector<std::vector<Enclosure>> a, std::vector<Enclosure> b);

/// The unit of a reaction as a load on its facet.
template <class Number> SideLoad<Number> unit_load(const scene::Problem<2>& problem, const Reaction& reaction) {
  if (reaction.kind == Reaction::Kind::normal) {
    SideLoad<Number> load;
    load[reaction.which] = plane<Number>(problem.facets[reaction.facet].normal);
    return load;
  }
  if (reaction.which < 2) {
    const Plane<Number> unit = plane<Number>(scene::Vector<2>::Unit(reaction.which));
    return {unit, unit};
  }
  const Plane<Number> across = turned(along<Number>(problem, reaction.facet));
  return {-across, across};
}

/// Resultant of a facet's load on its body.
template <class Number>
Resultant<Number> facet_resultant(const scene::Problem<2>& problem, const std::vector<Reference>& references, int facet,
                                  const SideLoad<Number>& load) {
  const auto& reference = references[problem.mesh.cell_body[problem.mesh.boundary[facet].cell]];
  return resultant(load, arm<Number>(problem, reference.point, facet), along<Number>(problem, facet));
}

/// A body's entries of Gᵀp = e: force, and moment by the size of the body.
template <class Number> std::array<Number, 3> entries(const Reference& reference, const Resultant<Number>& resultant) {
  return {resultant.force.x, resultant.force.y, resultant.moment / Number(reference.size)};
}

/// What one unit of a reaction does to the bodies: their entries, one body after the other.
template <class Number>
std::vector<Number> effect(const scene::Problem<2>& problem, const std::vector<Reference>& references,
                           const Reaction& reaction) {
  std::vector<Number> result(3 * problem.mesh.bodies.size(), Number(0));
  const auto on = [&](const scene::Problem<2>& of, int facet, const SideLoad<Number>& on_facet) {
    const int body = of.mesh.cell_body[of.mesh.boundary[facet].cell];
    const auto part = entries(references[body], facet_resultant(of, references, facet, on_facet));
    for (int i = 0; i < 3; ++i) result[3 * body + i] += part[i];
  };
  if (reaction.kind == Reaction::Kind::correction) {
    const auto& [facet, unit] = scene::first_of(problem).corrections[reaction.which];
    on(scene::first_of(problem), facet, {plane<Number>(unit[0]), plane<Number>(unit[1])});
    return result;
  }
  SideLoad<Number> load = unit_load<Number>(problem, reaction);
  if (problem.facets[reaction.facet].support == scene::Support::contact) {  // a pressure
    load = {-load[0], -load[1]};
    if (reaction.other >= 0) on(problem, reaction.other, {-load[1], -load[0]});
  }
  on(problem, reaction.facet, load);
  return result;
}

/// All that acts on the bodies from outside, as entries: the sum of what their cells lack.
template <class Number, class Sum>
std::vector<Number> totals(const scene::Problem<2>& problem, const std::vector<Reference>& references,
                           const EdgeLoads<Number>& loads) {
  const auto& mesh = problem.mesh;
  std::vector<Sum> sums(3 * mesh.bodies.size());
  const auto add = [&](int body, const Resultant<Number>& resultant) {
    const auto part = entries(references[body], resultant);
    for (int i = 0; i < 3; ++i) sums[3 * body + i].add(part[i]);
  };
  for (std::size_t f = 0; f < mesh.boundary.size(); ++f) {
    const auto& facet = mesh.boundary[f];
    add(mesh.cell_body[facet.cell],
        facet_resultant(problem, references, static_cast<int>(f), oriented(loads.edge[facet.edge], forward(facet))));
  }
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    const int body = mesh.cell_body[c];
    const scene::Vector<2>& force = problem.bodies[body].force;
    if (force.isZero(0)) continue;
    const int cell = static_cast<int>(c);
    const auto x = corners<Number>(problem, cell);
    const Plane<Number> to_centroid =
        arm_of_cell<Number>(problem, references[body].point, cell) + (Number(1) / Number(3)) * (x[1] + x[2]);
    const Plane<Number> weight = (doubled_area(x) / Number(2)) * plane<Number>(force);
    add(body, {weight, cross(to_centroid, weight)});
  }
  std::vector<Number> result;
  for (const Sum& sum : sums) result.push_back(sum.value());
  return result;
}

/// The amounts of the chosen reactions that make the totals zero. \return nothing where they cannot be found
template <class Number, class Sum>
std::optional<std::vector<Number>> amounts_that_hold(const scene::Problem<2>& problem,
                                                     const std::vector<Reference>& references,
                                                     const std::vector<Reaction>& chosen,
                                                     const EdgeLoads<Number>& loads) {
  const std::size_t n = 3 * problem.mesh.bodies.size();
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
    const auto& [kind, facet, which, other] = chosen[j];
    if (kind == Reaction::Kind::normal) loads.along_normal[facet][which] += amounts[j];
    if (kind != Reaction::Kind::any) continue;
    SideLoad<Number> load = unit_load<Number>(problem, chosen[j]);
    for (auto& end : load) end = amounts[j] * end;
    const bool along = forward(problem.mesh.boundary[facet]);
    auto& edge = loads.edge[problem.mesh.boundary[facet].edge];
    for (int end = 0; end < 2; ++end) edge[end] = edge[end] + oriented(load, along)[end];
  }
  spread_normal_loads(problem, loads);
}

/// The loads of the data alone.
PlainLoads no_loads(const scene::Problem<2>& problem);
/// Those on the first mesh, with unit pressures where the corrections count on a pair: what reactions() chooses from.
PlainLoads assumed_loads(const scene::Problem<2>& first);

template <class Number> struct Corrections {
  std::vector<Corrected<Number>> loads;
  std::string reason;  ///< if they cannot be had: one line
};

/// The corrections of the first mesh's loads by their true amounts, of those that are on Γ_τ (others are zero): those
/// with which the loads are in balance along all motions on which neither supports nor the pairs that carry act at all.
template <class Number, class Sum> Corrections<Number> corrected(const scene::Problem<2>& problem) {
  const scene::Problem<2>& first = scene::first_of(problem);
  if (first.corrections.empty()) return {};
  const std::vector<Reference> about = references(first.mesh);
  const PlainLoads assumed = assumed_loads(first);
  const std::vector<Reaction> chosen = reactions(first, about, assumed, {});
  const EdgeLoads<Number> loads = loads_of<Number>(first, no_loads(first), {});
  const auto amounts = amounts_that_hold<Number, Sum>(first, about, chosen, loads);
  if (!amounts || !corrections_vanish(first, chosen, carrying_pairs(first, assumed)))
    return {{}, "the corrections of the loads do not bring a body that nothing holds into balance"};
  Corrections<Number> result;
  for (std::size_t j = 0; j < chosen.size(); ++j) {
    if (chosen[j].kind != Reaction::Kind::correction) continue;
    const auto& [facet, unit] = first.corrections[chosen[j].which];
    const Number& own = (*amounts)[j];
    if (first.facets[facet].support == scene::Support::traction)
      result.loads.push_back({facet, {own * plane<Number>(unit[0]), own * plane<Number>(unit[1])}});
    else if (!certainly_non_negative(own) || !certainly_non_negative(-own))  // not zero
      return {{}, "the weight of a body that nothing but contacts holds is not in balance to the last bit"};
  }
  return result;
}

/// The first of the chosen pressures that would have to be tension; nothing: none.
template <class Number>
std::optional<Reaction> in_tension(const EdgeLoads<Number>& loads, const std::vector<Reaction>& chosen,
                                   const scene::Problem<2>& problem) {
  for (const Reaction& reaction : chosen)
    if (reaction.kind == Reaction::Kind::normal && problem.facets[reaction.facet].support == scene::Support::contact &&
        !certainly_non_negative(loads.along_normal[reaction.facet][reaction.which]))
      return reaction;
  return {};
}

/// Balances every cell of bodies that are held: each cell, from the leaves of its body's tree on, hands what it lacks
/// to its parent, through their common edge; the root lacks nothing.
template <class Number>
EdgeLoads<Number> handed_on(const scene::Problem<2>& problem, const std::vector<Reference>& about,
                            const EdgeLoads<Number>& loads) {
  const auto& mesh = problem.mesh;
  // What a cell lacks with all that hangs on it, about its first corner. It is handed on as a resultant: taken again
  // from the loads that carry it, its enclosure would grow from cell to cell.
  std::vector<Resultant<Number>> lacks(mesh.cells.size());
  const auto add_to = [](Resultant<Number>& sum, const Resultant<Number>& part) {
    sum.force = sum.force + part.force;
    sum.moment += part.moment;
  };
  const std::vector<Branch> branches = trees(mesh, about);
  EdgeLoads<Number> result = loads;
  for (auto branch = branches.rbegin(); branch != branches.rend(); ++branch) {
    if (branch->parent < 0) continue;
    const int i = branch->side;
    const Block<Number> cell = block(problem, loads, branch->cell);
    Resultant<Number>& own = lacks[branch->cell];
    add_to(own, imbalance(problem, cell, branch->cell));
    const SideLoad<Number> carried =
        oriented(load_with({-own.force, -own.moment}, cell.x[i], cell.x[(i + 1) % 3] - cell.x[i]), cell.forward[i]);
    auto& edge = result.edge[cell.edge[i]];
    for (int end = 0; end < 2; ++end) edge[end] = edge[end] + carried[end];
    // From the parent's first corner to that of the cell, by way of a corner that they share.
    const auto& of_parent = mesh.cells[branch->parent];
    const auto shared = std::find(of_parent.begin(), of_parent.end(), mesh.cells[branch->cell][i]) - of_parent.begin();
    const Plane<Number> to_cell = corners<Number>(problem, branch->parent)[shared] - cell.x[i];
    add_to(lacks[branch->parent], {own.force, own.moment + cross(to_cell, own.force)});
  }
  return result;
}

template <class Number> struct Balanced {
  std::optional<EdgeLoads<Number>> loads;  ///< every cell in balance
  std::string reason;                      ///< if there are none
};

/// Loads that balance every cell exactly: reactions hold the bodies as wholes, then cells hand on what they lack.
/// \param corrections as corrected() has them
template <class Number, class Sum>
Balanced<Number> balanced(const scene::Problem<2>& problem, const std::vector<Corrected<Number>>& corrections,
                          PlainLoads given) {
  const std::vector<Reference> about = references(scene::first_of(problem).mesh);
  // A pressure that is rounding itself may be too small to take what is missing: then another has to. Where none can,
  // all of its pair are rounding.
  constexpr std::size_t most = 20;
  std::vector<Reaction> barred;
  while (true) {
    const std::vector<Reaction> chosen = reactions(problem, about, given, barred);
    EdgeLoads<Number> loads = loads_of<Number>(problem, given, corrections);
    std::optional<std::vector<Number>> amounts;
    if (barred.size() < most && corrections_vanish(problem, chosen, carrying_pairs(problem, given)))
      amounts = amounts_that_hold<Number, Sum>(problem, about, chosen, loads);
    if (!amounts) {
      if (!drop_barred_pairs(problem, barred, given))
        return {{}, "no supports or contacts were found that take what rounding leaves of the loads"};
      barred.clear();
      continue;
    }
    add_reactions(problem, chosen, *amounts, loads);
    const std::optional<Reaction> tension = in_tension(loads, chosen, problem);
    if (!tension) return {handed_on(problem, about, loads), ""};
    barred.push_back(*tension);
  }
}

}  // namespace bracket::bounds
