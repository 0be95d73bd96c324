// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "bounds/certificate/problem_faults.h"
#include "scene/problem/gap.h"

namespace bracket::bounds {

using scene::Problem;

namespace {

/// Of numbers of this size.
double rounding(double size) { return 16 * std::numeric_limits<double>::epsilon() * size; }

bool agree(const std::array<double, 2>& one, const std::array<double, 2>& other) {
  const double size = std::max(std::abs(other[0]), std::abs(other[1]));
  return std::abs(one[0] - other[0]) <= rounding(size) && std::abs(one[1] - other[1]) <= rounding(size);
}

bool are_sizes(const std::array<double, 2>& values) {
  return std::ranges::all_of(values, [](double value) { return std::isfinite(value) && value >= 0; });
}

/// What is wrong with the law of a contact facet of the first mesh.
std::string own_fault(const Problem<2>& first, std::size_t contact) {
  const auto& pair = first.contact[contact];
  const auto& [two_sided, modulus, friction, coulomb] = pair.law;  // μ is no part of the problem
  if (!are_sizes(modulus) || !are_sizes(friction)) return "has a modulus or friction that is negative or not finite";
  if ((modulus[0] > 0) != (modulus[1] > 0)) return "has springs at one end only";
  if (scene::has_springs(pair.law) && scene::has_friction(pair.law)) return "has springs and friction at once";
  if (scene::has_friction(pair.law) && pair.second >= 0) {
    const auto one = positions(first.mesh, first.mesh.boundary[pair.first].vertices);
    const auto other = positions(first.mesh, first.mesh.boundary[pair.second].vertices);
    if (one[0] != other[1] || one[1] != other[0]) return "has friction across a distance";
  }
  if (!std::ranges::all_of(pair.slip, [](double value) { return std::isfinite(value); }))
    return "has a jump that is not finite";
  if (!std::isfinite(coulomb) || coulomb < 0) return "has a coefficient of friction that is negative or not finite";
  if (!two_sided) return "";
  if (!first.gaps.empty() && first.gaps[contact].function) return "is two-sided and its gap is no quadratic";
  for (int i = 0; i < 3; ++i)
    if (pair.upper[i] - pair.lower[i] > rounding(first.length_scale + std::abs(pair.lower[i])))
      return "is two-sided and its gap is not known up to rounding";
  return "";
}

}  // namespace

std::string law_fault(const Problem<2>& problem) {
  const Problem<2>& first = scene::first_of(problem);
  for (std::size_t j = 0; j < first.contact.size(); ++j)
    if (const std::string fault = own_fault(first, j); !fault.empty())
      return fmt::format("the contact of boundary facet {} {}", first.contact[j].first, fault);
  if (!problem.origin.first) return "";
  const std::vector<int> contact_of_facet = scene::contacts_by_first(first);
  for (const auto& pair : problem.contact) {
    const auto& piece = problem.origin.facets[pair.first];
    const scene::FacetLaw exact =
        scene::on_piece(first, contact_of_facet[piece.of], pair.first, pair.second, piece).law;
    const bool is_step = exact.coulomb > 0;  // of Coulomb's, with a bound of the shear that is of this mesh
    if (pair.law.two_sided != exact.two_sided || !agree(pair.law.modulus, exact.modulus) ||
        pair.law.coulomb != exact.coulomb ||
        !(is_step ? are_sizes(pair.law.friction) : agree(pair.law.friction, exact.friction)) ||
        scene::has_springs(pair.law) != scene::has_springs(exact) ||
        scene::has_friction(pair.law) != scene::has_friction(exact))
      return fmt::format("the contact of boundary facet {} has another law than on the first mesh", pair.first);
  }
  return "";
}

}  // namespace bracket::bounds
