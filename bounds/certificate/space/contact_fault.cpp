// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "bounds/certificate/space/exact_rank.h"
#include "bounds/certificate/space/kept_gap.h"
#include "bounds/certificate/space/problem_faults.h"
#include "scene/problem/space/face_gap.h"

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

std::string law_fault(const Problem<3>& first, int contact) {
  const auto& pair = first.contact[contact];
  const auto& [two_sided, modulus, friction, coulomb] = pair.law;
  if (modulus != std::array<double, 2>{0, 0} || friction != std::array<double, 2>{0, 0} || coulomb != 0)
    return " has springs or friction, of which there is no certificate in space";
  if (!two_sided) return "";
  if (!first.gaps.empty() && first.gaps[contact].function) return " is two-sided and its gap is no quadratic";
  for (int k = 0; k < 6; ++k)
    if (!(pair.upper[k] - pair.lower[k] <= 16 * epsilon * (first.length_scale + std::abs(pair.lower[k]))))
      return " is two-sided and its gap is not known up to rounding";
  return "";
}

/// Whether the gaps of a contact on a piece enclose those of the first mesh: quadratics exactly, functions as
/// scene::on_piece() finds them.
bool enclose(const Problem<3>& problem, const scene::ContactFacetOf<3>& pair, int whole, const scene::Piece<2>& piece) {
  const Problem<3>& first = scene::first_of(problem);
  const auto& given = first.contact[whole];
  const auto is_constant = [](const scene::FacetQuadratic<3>& c) {
    return std::ranges::all_of(c, [&](double one) { return one == c[0]; });
  };
  const auto& [by, loads, kinematics] = problem.perturbed;
  const bool is_given = !first.gaps.empty() && first.gaps[whole].function;
  if (!by && !is_given && is_constant(given.lower) && is_constant(given.upper)) {
    return std::ranges::all_of(pair.lower, [&](double c) { return c <= given.lower[0]; }) &&
           std::ranges::all_of(pair.upper, [&](double c) { return c >= given.upper[0]; });
  }
  auto lower = scene::on_part(numbers<Rational>(given.lower), piece.corner);
  auto upper = scene::on_part(numbers<Rational>(given.upper), piece.corner);
  if (is_given) {
    const auto found = scene::on_piece(first, whole, pair.first, pair.second, piece);
    lower = numbers<Rational>(found.lower);
    upper = numbers<Rational>(found.upper);
  }
  std::array<Rational, 6> added{};
  if (by && kinematics != 0) added = scene::psi<Rational>(by->contact[whole], problem.facets[pair.first].normal, piece);
  for (int k = 0; k < 6; ++k) {
    const Rational moved = Rational(kinematics) * added[k];
    if (Rational(pair.lower[k]) > lower[k] + moved || Rational(pair.upper[k]) < upper[k] + moved) return false;
  }
  return true;
}

}  // namespace

std::string contact_fault(const Problem<3>& problem) {
  if (std::string fault = direction_fault(problem); !fault.empty()) return fault;
  const Problem<3>& first = scene::first_of(problem);
  const std::vector<int> contact_of_facet = scene::contacts_by_first(first);
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
    const scene::Piece<2> piece = scene::piece_of_facet(problem, pair.first);
    const int number = contact_of_facet[piece.of];
    if (number < 0) return name + " is none of the first mesh";
    const auto& whole = first.contact[number];
    if (const std::string fault = law_fault(first, number); !fault.empty()) return name + fault;
    if (whole.pair != pair.pair || whole.law.modulus != pair.law.modulus || whole.law.friction != pair.law.friction ||
        whole.law.coulomb != pair.law.coulomb || whole.law.two_sided != pair.law.two_sided ||
        (pair.second < 0 ? whole.second >= 0 : scene::piece_of_facet(problem, pair.second).of != whole.second))
      return name + " is none of the first mesh";
    if (pair.second >= 0 && !coincide(problem, pair, whole.meets)) return name + " has sides that do not coincide";
    if (!enclose(problem, pair, number, piece)) return name + " has gaps that do not enclose those of the first mesh";
  }
  for (std::size_t f = 0; f < problem.facets.size(); ++f)
    if (problem.facets[f].support == Support::contact && !taken[f])
      return fmt::format("boundary facet {} is in contact with nothing", f);
  return "";
}

}  // namespace bracket::bounds::space
