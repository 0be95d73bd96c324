// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "bounds/certificate/admissible_stress.h"
#include "bounds/certificate/enclosure.h"

/// Exact balance of edge loads: what computed loads lack is carried to where the bodies are held. This is also the
/// particular field λ̄ of HH81 (3.16)–(3.19), for loads that are zero inside.
namespace bracket::bounds {

/// A load on one facet that can be had in any amount to hold bodies.
struct Reaction {
  enum class Kind {
    any,     ///< Γ_u, or Γ_τ: `which` 0, 1: uniform along x, y; 2: linear along the normal, without resultant force
    normal   ///< Γ_0 and Γ_K: along the normal, at the facet's vertex `which`
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

/// Reactions whose resultants on the bodies are a basis of all: 3 for each body. Pressures are taken where they are
/// large and may fall, then those of zero, which may rise; loads on Γ_τ, which would change the data, only where
/// nothing else holds a motion.
/// \param barred pressures that are not to be taken   \return fewer where no basis was found
std::vector<Reaction> reactions(const scene::Problem<2>& problem, const std::vector<Reference>& references,
                                const PlainLoads& loads, const std::vector<Reaction>& barred);

/// Takes all pressures off the pairs of which one that is not zero is barred. \return false where there are none
bool drop_barred_pairs(const scene::Problem<2>& problem, const std::vector<Reaction>& barred, PlainLoads& loads);

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
  const auto& [a, b] = problem.mesh.boundary[reaction.facet].vertices;
  const Plane<Number> across = turned(between<Number>(problem.mesh.vertices[a], problem.mesh.vertices[b]));
  return {-across, across};
}

/// Resultant of a facet's load on its body.
template <class Number>
Resultant<Number> facet_resultant(const scene::Mesh<2>& mesh, const std::vector<Reference>& references, int facet,
                                  const SideLoad<Number>& load) {
  const auto& [a, b] = mesh.boundary[facet].vertices;
  const auto& reference = references[mesh.cell_body[mesh.boundary[facet].cell]];
  return resultant(load, between<Number>(reference.point, mesh.vertices[a]),
                   between<Number>(mesh.vertices[a], mesh.vertices[b]));
}

/// A body's entries of Gᵀp = e: force, and moment by the size of the body.
template <class Number> std::array<Number, 3> entries(const Reference& reference, const Resultant<Number>& resultant) {
  return {resultant.force.x, resultant.force.y, resultant.moment / Number(reference.size)};
}

/// What one unit of a reaction does to the bodies: their entries, one body after the other.
template <class Number>
std::vector<Number> effect(const scene::Problem<2>& problem, const std::vector<Reference>& references,
                           const Reaction& reaction) {
  const auto& mesh = problem.mesh;
  std::vector<Number> result(3 * mesh.bodies.size(), Number(0));
  SideLoad<Number> load = unit_load<Number>(problem, reaction);
  const auto on = [&](int facet, const SideLoad<Number>& on_facet) {
    const int body = mesh.cell_body[mesh.boundary[facet].cell];
    const auto part = entries(references[body], facet_resultant(mesh, references, facet, on_facet));
    for (int i = 0; i < 3; ++i) result[3 * body + i] += part[i];
  };
  if (problem.facets[reaction.facet].support == scene::Support::contact) {  // a pressure
    load = {-load[0], -load[1]};
    if (reaction.other >= 0) on(reaction.other, {-load[1], -load[0]});
  }
  on(reaction.facet, load);
  return result;
}

/// All that acts on the bodies from outside, as entries: the sum of what their cells lack.
template <class Number, class Sum>
std::vector<Number> totals(const scene::Problem<2>& problem, const std::vector<Reference>& references,
                           const Loads<Number>& loads) {
  const auto& mesh = problem.mesh;
  std::vector<Sum> sums(3 * mesh.bodies.size());
  const auto add = [&](int body, const Resultant<Number>& resultant) {
    const auto part = entries(references[body], resultant);
    for (int i = 0; i < 3; ++i) sums[3 * body + i].add(part[i]);
  };
  for (std::size_t f = 0; f < mesh.boundary.size(); ++f) {
    const auto& facet = mesh.boundary[f];
    add(mesh.cell_body[facet.cell], facet_resultant(mesh, references, static_cast<int>(f),
                                                    oriented(loads.edge[facet.edge], forward(facet))));
  }
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    const int body = mesh.cell_body[c];
    const scene::Vector<2>& force = problem.bodies[body].force;
    if (force.isZero(0)) continue;
    Plane<Number> arm;  // three times that of the centroid
    for (const int v : mesh.cells[c]) arm = arm + between<Number>(references[body].point, mesh.vertices[v]);
    const Plane<Number> weight =
        (doubled_area<Number>(mesh, static_cast<int>(c)) / Number(2)) * plane<Number>(force);
    add(body, {weight, cross(arm, weight) / Number(3)});
  }
  std::vector<Number> result;
  for (const Sum& sum : sums) result.push_back(sum.value());
  return result;
}

template <class Number> struct Balanced {
  std::optional<Loads<Number>> loads;  ///< every cell in balance
  std::string reason;                  ///< if there are none
};

/// Holds the bodies: reactions make the totals zero. \return false where they cannot be found
template <class Number, class Sum>
bool hold(const scene::Problem<2>& problem, const std::vector<Reference>& references,
          const std::vector<Reaction>& chosen, Loads<Number>& loads) {
  const std::size_t n = 3 * problem.mesh.bodies.size();
  if (chosen.size() < n) return false;
  std::vector<Number> missing = totals<Number, Sum>(problem, references, loads);
  std::vector<std::vector<Number>> matrix(n, std::vector<Number>(n));
  for (std::size_t j = 0; j < n; ++j) {
    const std::vector<Number> column = effect<Number>(problem, references, chosen[j]);
    for (std::size_t i = 0; i < n; ++i) matrix[i][j] = column[i];
    missing[j] = -missing[j];
  }
  const auto amounts = solution(std::move(matrix), std::move(missing));
  if (!amounts) return false;
  for (std::size_t j = 0; j < n; ++j) {
    const auto& [kind, facet, which, other] = chosen[j];
    if (kind == Reaction::Kind::normal) {
      loads.along_normal[facet][which] += (*amounts)[j];
      continue;
    }
    SideLoad<Number> load = unit_load<Number>(problem, chosen[j]);
    for (auto& end : load) end = (*amounts)[j] * end;
    const bool along = forward(problem.mesh.boundary[facet]);
    auto& edge = loads.edge[problem.mesh.boundary[facet].edge];
    for (int end = 0; end < 2; ++end) edge[end] = edge[end] + oriented(load, along)[end];
    if (problem.facets[facet].support == scene::Support::traction) loads.added.push_back({facet, load});
  }
  spread_normal_loads(problem, loads);
  return true;
}

/// The first of the chosen pressures that would have to be tension; nothing: none.
template <class Number>
std::optional<Reaction> in_tension(const Loads<Number>& loads, const std::vector<Reaction>& chosen,
                                   const scene::Problem<2>& problem) {
  for (const Reaction& reaction : chosen)
    if (problem.facets[reaction.facet].support == scene::Support::contact &&
        !certainly_non_negative(loads.along_normal[reaction.facet][reaction.which]))
      return reaction;
  return {};
}

/// Balances every cell of bodies that are held: each cell, from the leaves of its body's tree on, hands what it lacks
/// to its parent, through their common edge; the root lacks nothing.
template <class Number>
Loads<Number> handed_on(const scene::Problem<2>& problem, const std::vector<Reference>& about,
                        const Loads<Number>& loads) {
  const auto& mesh = problem.mesh;
  // What a cell lacks with all that hangs on it, about its first corner. It is handed on as a resultant: taken again
  // from the loads that carry it, its enclosure would grow from cell to cell.
  std::vector<Resultant<Number>> lacks(mesh.cells.size());
  const auto add_to = [](Resultant<Number>& sum, const Resultant<Number>& part) {
    sum.force = sum.force + part.force;
    sum.moment += part.moment;
  };
  const std::vector<Branch> branches = trees(mesh, about);
  Loads<Number> result = loads;
  for (auto branch = branches.rbegin(); branch != branches.rend(); ++branch) {
    if (branch->parent < 0) continue;
    const int i = branch->side;
    const Block<Number> cell = block(mesh, loads, branch->cell);
    Resultant<Number>& own = lacks[branch->cell];
    add_to(own, imbalance(problem, cell, branch->cell));
    const SideLoad<Number> carried =
        oriented(load_with({-own.force, -own.moment}, cell.x[i], cell.x[(i + 1) % 3] - cell.x[i]), cell.forward[i]);
    auto& edge = result.edge[cell.edge[i]];
    for (int end = 0; end < 2; ++end) edge[end] = edge[end] + carried[end];
    const auto corner = [&](int c) -> const scene::Vector<2>& { return mesh.vertices[mesh.cells[c][0]]; };
    const Plane<Number> arm = between<Number>(corner(branch->parent), corner(branch->cell));
    add_to(lacks[branch->parent], {own.force, own.moment + cross(arm, own.force)});
  }
  return result;
}

/// Loads that balance every cell exactly: reactions hold the bodies as wholes, then cells hand on what they lack.
template <class Number, class Sum>
Balanced<Number> balanced(const scene::Problem<2>& problem, PlainLoads given) {
  const std::vector<Reference> about = references(problem.mesh);
  Loads<Number> loads;
  // A pressure that is rounding itself may be too small to take what is missing: then another has to. Where none can,
  // all of its pair are rounding.
  constexpr std::size_t most = 20;
  std::vector<Reaction> barred;
  while (true) {
    const std::vector<Reaction> chosen = reactions(problem, about, given, barred);
    loads = loads_of<Number>(problem, given);
    if (barred.size() == most || !hold<Number, Sum>(problem, about, chosen, loads)) {
      if (!drop_barred_pairs(problem, barred, given))
        return {{}, "no supports or contacts were found that take what rounding leaves of the loads"};
      barred.clear();
      continue;
    }
    const std::optional<Reaction> tension = in_tension(loads, chosen, problem);
    if (!tension) break;
    barred.push_back(*tension);
  }
  return {handed_on(problem, about, loads), ""};
}

}  // namespace bracket::bounds
