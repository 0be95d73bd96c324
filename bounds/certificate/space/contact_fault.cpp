// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "bounds/certificate/space/exact_rank.h"
#include "bounds/certificate/space/kept_gap.h"
#include "bounds/certificate/space/problem_faults.h"

namespace bracket::bounds::space {

using scene::Problem;
using scene::Support;
using scene::Vector;

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

std::string direction_fault(const Problem<3>& problem) {
  const double cosine = std::cos(25 * 3.14159265358979323846 / 180);
  for (int f = 0; f < static_cast<int>(problem.facets.size()); ++f) {
    const auto& [support, normal] = std::pair(problem.facets[f].support, problem.facets[f].normal);
    if (support != Support::sliding && support != Support::contact) continue;
    const auto n = whole_area_vector<double>(scene::first_of(problem).mesh, scene::piece_of_facet(problem, f).of);
    const Vector<3> outward(n[0], n[1], n[2]);
    if (std::abs(normal.squaredNorm() - 1) > 16 * epsilon)
      return fmt::format("the direction of boundary facet {} is not a unit vector", f);
    if (!(outward.dot(normal) >= cosine * outward.norm()))
      return fmt::format("the direction of boundary facet {} is more than 25 degrees off its outward normal", f);
  }
  return "";
}

/// Barycentric coordinates 0, 1, 2, exact.
std::array<double, 3> barycentric(const std::array<double, 2>& at) { return {(1 - at[0]) - at[1], at[0], at[1]}; }

/// Whether the two facets of a contact are the same pieces of two facets that coincide on the first mesh.
bool coincide(const Problem<3>& problem, const scene::ContactFacetOf<3>& pair, const std::array<int, 3>& whole_meets) {
  const scene::Mesh<3>& first = scene::first_of(problem).mesh;
  const auto one = scene::piece_of_facet(problem, pair.first), other = scene::piece_of_facet(problem, pair.second);
  for (int i = 0; i < 3; ++i) {
    if (first.vertices[first.boundary[one.of].vertices[i]] !=
        first.vertices[first.boundary[other.of].vertices[whole_meets[i]]])
      return false;
    const auto here = barycentric(one.corner[i]), there = barycentric(other.corner[pair.meets[i]]);
    for (int k = 0; k < 3; ++k)
      if (here[k] != there[whole_meets[k]]) return false;
  }
  return true;
}

std::string law_fault(const Problem<3>& first, const scene::ContactFacetOf<3>& pair) {
  const auto& [two_sided, modulus, friction, coulomb] = pair.law;
  if (modulus != std::array<double, 2>{0, 0} || friction != std::array<double, 2>{0, 0} || coulomb != 0)
    return " has springs or friction, of which there is no certificate in space";
  if (!two_sided) return "";
  for (int k = 0; k < 6; ++k)
    if (!(pair.upper[k] - pair.lower[k] <= 16 * epsilon * (first.length_scale + std::abs(pair.lower[k]))))
      return " is two-sided and its gap is not known up to rounding";
  return "";
}

/// Whether the gaps on a piece enclose those of the first mesh, exactly.
bool enclose(const scene::ContactFacetOf<3>& pair, const scene::ContactFacetOf<3>& whole,
             const scene::Piece<2>& piece) {
  const auto agrees = [&](const scene::FacetQuadratic<3>& own, const scene::FacetQuadratic<3>& given, bool is_lower) {
    if (std::ranges::all_of(given, [&](double c) { return c == given[0]; }))
      return std::ranges::all_of(own, [&](double c) { return is_lower ? c <= given[0] : c >= given[0]; });
    const auto exact = on_piece(numbers<Rational>(given), piece);
    for (int k = 0; k < 6; ++k)
      if (is_lower ? Rational(own[k]) > exact[k] : Rational(own[k]) < exact[k]) return false;
    return true;
  };
  return agrees(pair.lower, whole.lower, true) && agrees(pair.upper, whole.upper, false);
}

}  // namespace

std::string contact_fault(const Problem<3>& problem) {
  if (std::string fault = direction_fault(problem); !fault.empty()) return fault;
  const Problem<3>& first = scene::first_of(problem);
  const std::vector<int> contact_of_facet = contacts_by_first(first);
  std::vector<char> taken(problem.facets.size(), 0);
  for (const auto& pair : problem.contact) {
    const std::string name = fmt::format("the contact of boundary facet {}", pair.first);
    for (const int side : {pair.first, pair.second}) {
      if (side < 0) continue;
      if (taken[side] || problem.facets[side].support != Support::contact)
        return name + " is not its only one, or a side of it has another support";
      taken[side] = 1;
    }
    if (pair.second >= 0 && problem.facets[pair.second].normal != -problem.facets[pair.first].normal)
      return name + " has directions that are not opposite on its two sides";
    for (int k = 0; k < 6; ++k)
      if (pair.lower[k] > pair.upper[k]) return name + " has a lower gap above its upper one";
    if (const std::string fault = law_fault(first, pair); !fault.empty()) return name + fault;
    const scene::Piece<2> piece = scene::piece_of_facet(problem, pair.first);
    const int number = contact_of_facet[piece.of];
    if (number < 0) return name + " is none of the first mesh";
    const auto& whole = first.contact[number];
    if (whole.pair != pair.pair || whole.law.two_sided != pair.law.two_sided ||
        (pair.second < 0 ? whole.second >= 0 : scene::piece_of_facet(problem, pair.second).of != whole.second))
      return name + " is none of the first mesh";
    if (pair.second >= 0 && !coincide(problem, pair, whole.meets)) return name + " has sides that do not coincide";
    if (!first.gaps.empty() && first.gaps[number].function) return name + " has a gap that is no quadratic";
    if (!enclose(pair, whole, piece)) return name + " has gaps that do not enclose those of the first mesh";
  }
  for (std::size_t f = 0; f < problem.facets.size(); ++f)
    if (problem.facets[f].support == Support::contact && !taken[f])
      return fmt::format("boundary facet {} is in contact with nothing", f);
  return "";
}

}  // namespace bracket::bounds::space
