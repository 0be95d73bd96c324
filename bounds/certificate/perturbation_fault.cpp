// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bounds/certificate/geometry.h"
#include "bounds/certificate/problem_faults.h"

namespace bracket::bounds {

using scene::Problem;
using scene::Support;

namespace {

bool finite(double x) { return std::isfinite(x); }
bool finite(const scene::Vector<2>& x) { return x.allFinite(); }
bool finite(const scene::TwofoldVector<2>& x) { return x.value.allFinite() && x.rest.allFinite(); }
template <class Values> bool each_finite(const Values& values) {
  return std::all_of(values.begin(), values.end(), [](const auto& x) { return finite(x); });
}

bool is_finite(const scene::Perturbation<2>& by) {
  return std::ranges::all_of(by.force, [](const auto& force) { return force.allFinite(); }) &&
         std::ranges::all_of(by.facets,
                             [](const auto& facet) {
                               return each_finite(facet.traction) && each_finite(facet.pressure) &&
                                      each_finite(facet.higher_traction) && each_finite(facet.higher_pressure) &&
                                      each_finite(facet.displacement) && each_finite(facet.normal_displacement);
                             }) &&
         std::ranges::all_of(by.contact, [](const auto& contact) {
           return each_finite(contact.gap) && each_finite(contact.slip) && each_finite(contact.opening) &&
                  each_finite(contact.shear) && each_finite(contact.first) && each_finite(contact.second);
         });
}

}  // namespace

std::string perturbation_fault(const Problem<2>& problem) {
  const auto& [by, loads, kinematics] = problem.perturbed;
  if (!by) return "";
  const Problem<2>& first = scene::first_of(problem);
  if (&first == &problem) return "a perturbed problem does not know its first mesh";
  if (by->force.size() != first.bodies.size() || by->facets.size() != first.facets.size() ||
      by->contact.size() != first.contact.size() || by->contact_of != scene::contacts_by_first(first))
    return "perturbation and first mesh differ in number";
  if (!std::isfinite(loads) || !std::isfinite(kinematics) || !is_finite(*by)) return "the perturbation is not finite";
  for (std::size_t f = 0; f < first.facets.size(); ++f) {
    if (first.facets[f].support == Support::traction || !is_loaded(by->facets[f])) continue;
    if (first.facets[f].support == Support::fixed)
      return fmt::format("the perturbation loads boundary facet {}, whose displacement is prescribed", f);
    if (scene::degree_of_load<2>(by->facets[f]) > 1)
      return fmt::format("the perturbation's load on boundary facet {} is not linear, and it slides or is in contact",
                         f);
  }
  for (std::size_t j = 0; j < first.contact.size(); ++j) {
    const auto& [a, b] = by->contact[j].shear;
    if ((a != 0 || b != 0) && !has_friction(first.contact[j].law))
      return fmt::format("the perturbation shears the contact of boundary facet {}, which has no friction",
                         first.contact[j].first);
  }
  for (const auto& [ends, begins] : facets_that_meet(first.mesh)) {
    if (ends < 0 || begins < 0) continue;
    const auto &in = first.facets[ends], &out = first.facets[begins];
    const bool clamped = in.support == Support::fixed && out.support == Support::fixed;
    const bool in_line = in.support == Support::sliding && out.support == Support::sliding &&
                         (in.normal == out.normal || in.normal == -out.normal);
    const auto &coming = by->facets[ends], &going = by->facets[begins];
    const double along = in.normal == -out.normal ? -1 : 1;
    if ((clamped || in_line) && (coming.displacement[1] != going.displacement[0] ||
                                 (!clamped && coming.normal_displacement[1] != along * going.normal_displacement[0])))
      return fmt::format("the perturbation of the displacements jumps between boundary facets {} and {}", ends, begins);
    const int one = by->contact_of[ends], other = by->contact_of[begins];
    if (one < 0 || other < 0 || first.contact[one].pair != first.contact[other].pair) continue;
    const auto &before = by->contact[one], &after = by->contact[other];
    if (before.gap[2] != after.gap[0] || before.first[1] != after.first[0] || before.second[1] != after.second[0])
      return fmt::format("the perturbation of the gap jumps between boundary facets {} and {}", ends, begins);
  }
  return "";
}

}  // namespace bracket::bounds
