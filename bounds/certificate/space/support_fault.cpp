// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "bounds/certificate/space/exact_rank.h"
#include "bounds/certificate/space/problem_faults.h"
#include "bounds/certificate/space/supports.h"

namespace bracket::bounds::space {

using scene::Problem;
using scene::Support;
using scene::Vector;

namespace {

/// What a facet of Γ_0 prescribes at a vertex.
struct Known {
  int facet;
  Vector<3> normal;
  Rational value;
};

/// Whether u·normal = value can be for all, exactly.
bool agree(const std::vector<Known>& known) {
  for (const Known& one : known)  // mostly there is but one normal
    if (one.normal != known[0].normal || one.value != known[0].value) {
      std::vector<Row> rows, extended;
      for (const Known& other : known) {
        rows.push_back(exact_row(other.normal));
        extended.push_back(rows.back());
        extended.back().push_back(other.value);
      }
      return rank(std::move(rows)) == rank(std::move(extended));
    }
  return true;
}

Rational component(const scene::TwofoldVector<3>& u, const Vector<3>& n) {
  Rational sum(0);
  for (int k = 0; k < 3; ++k) sum += (Rational(u.value[k]) + Rational(u.rest[k])) * Rational(n[k]);
  return sum;
}

/// The first two facets that prescribe different displacements at a vertex; −1: there are none.
/// \param same(facet, vertex, facet, vertex): whether two of Γ_u prescribe the same   \param along(facet, vertex): what
/// one of Γ_0 prescribes along its normal
template <class Same, class Along>
std::array<int, 2> clash(const Problem<3>& first, const Same& same, const Along& along) {
  const auto& mesh = first.mesh;
  const auto fixed = fixed_vertices(first);
  std::vector<std::vector<Known>> known(mesh.vertices.size());
  for (int f = 0; f < static_cast<int>(first.facets.size()); ++f)
    for (int i = 0; i < 3; ++i) {
      const int vertex = mesh.boundary[f].vertices[i];
      const FacetCorner& held = fixed[vertex];
      if (first.facets[f].support == Support::fixed && !same(held.facet, held.corner, f, i)) return {held.facet, f};
      if (first.facets[f].support != Support::sliding || held.facet >= 0) continue;
      auto& here = known[vertex];
      const Known own{f, first.facets[f].normal, along(f, i)};
      if (std::ranges::any_of(here,
                              [&](const Known& one) { return one.normal == own.normal && one.value == own.value; }))
        continue;
      here.push_back(own);
      if (!agree(here)) return {here[0].facet, f};
    }
  return {-1, -1};
}

}  // namespace

std::string support_fault(const Problem<3>& first) {
  for (std::size_t f = 0; f < first.facets.size(); ++f)
    if (first.facets[f].support != Support::traction && scene::is_loaded(first.facets[f]))
      return fmt::format("boundary facet {} {} and is loaded", f,
                         first.facets[f].support == Support::contact ? "is in contact" : "slides");
  const auto same = [&](int f, int i, int g, int k) {
    return first.facets[f].displacement[i] == first.facets[g].displacement[k];
  };
  const auto along = [&](int f, int i) { return Rational(first.facets[f].normal_displacement[i]); };
  const auto [one, other] = clash(first, same, along);
  if (one < 0) return "";
  return fmt::format("boundary facets {} and {} prescribe different displacements where they meet", one, other);
}

namespace {

bool is_number(double x) { return std::isfinite(x); }
bool is_number(const scene::TwofoldVector<3>& x) { return x.value.allFinite() && x.rest.allFinite(); }
template <class Values> bool each_is_finite(const Values& values) {
  return std::ranges::all_of(values, [](const auto& x) { return is_number(x); });
}
bool is_finite(const scene::Perturbation<3>& by) {
  return std::ranges::all_of(by.force, [](const auto& force) { return force.allFinite(); }) &&
         std::ranges::all_of(by.facets,
                             [](const auto& facet) {
                               return each_is_finite(facet.traction) && each_is_finite(facet.pressure) &&
                                      each_is_finite(facet.displacement) && each_is_finite(facet.normal_displacement);
                             }) &&
         std::ranges::all_of(by.contact, [](const auto& contact) {
           return each_is_finite(contact.gap) && each_is_finite(contact.opening) && each_is_finite(contact.first) &&
                  each_is_finite(contact.second);
         });
}

/// Whether ψ is one at the nodes of a pair's facets.
bool psi_jumps(const Problem<3>& first, const scene::Perturbation<3>& by) {
  std::map<std::array<int, 2>, std::array<int, 2>> met;  // pair and node: contact and node of it
  for (int j = 0; j < static_cast<int>(first.contact.size()); ++j) {
    const auto nodes = nodes_of_facet(first.mesh, first.contact[j].first);
    for (int k = 0; k < 6; ++k) {
      const auto [known, is_new] = met.insert({{first.contact[j].pair, nodes[k]}, {j, k}});
      if (is_new) continue;
      const auto [other, node] = known->second;
      const auto &one = by.contact[j], &given = by.contact[other];
      if (one.gap[k] != given.gap[node]) return true;
      if (k < 3 && (one.first[k] != given.first[node] || one.second[k] != given.second[node])) return true;
    }
  }
  return false;
}

}  // namespace

std::string perturbation_fault(const Problem<3>& problem) {
  const auto& [by, loads, kinematics] = problem.perturbed;
  if (!by) return "";
  const Problem<3>& first = scene::first_of(problem);
  if (&first == &problem) return "a perturbed problem does not know its first mesh";
  if (by->force.size() != first.bodies.size() || by->facets.size() != first.facets.size() ||
      by->contact.size() != first.contact.size() || by->contact_of != scene::contacts_by_first(first))
    return "perturbation and first mesh differ in number";
  if (!std::isfinite(loads) || !std::isfinite(kinematics) || !is_finite(*by)) return "the perturbation is not finite";
  for (std::size_t f = 0; f < first.facets.size(); ++f)
    if (is_loaded(by->facets[f]) && first.facets[f].support == Support::fixed)
      return fmt::format("the perturbation loads boundary facet {}, whose displacement is prescribed", f);
  const auto is_zero = [](const auto& values) { return std::ranges::all_of(values, [](double x) { return x == 0; }); };
  for (const auto& facet : by->facets)
    if (scene::degree_of_load<3>(facet) > 1) return "the loads of the perturbation are not linear";
  for (const auto& contact : by->contact)
    if (!is_zero(contact.slip) || !is_zero(contact.shear)) return "the perturbation shears a contact without friction";
  const auto same = [&by = by](int f, int i, int g, int k) {
    return by->facets[f].displacement[i] == by->facets[g].displacement[k];
  };
  const auto along = [&, &by = by](int f, int i) {
    return Rational(component(by->facets[f].displacement[i], first.facets[f].normal) +
                    Rational(by->facets[f].normal_displacement[i]));
  };
  if (const auto [one, other] = clash(first, same, along); one >= 0)
    return fmt::format("the perturbation of the displacements jumps between boundary facets {} and {}", one, other);
  return psi_jumps(first, *by) ? "the perturbation of the gap jumps between facets of a contact" : "";
}

}  // namespace bracket::bounds::space
