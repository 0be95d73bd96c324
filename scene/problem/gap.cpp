// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// Planar: gaps on an edge that is a facet.
#include "scene/problem/gap.h"

#include <algorithm>

#include "scene/problem/gap_below.h"
#include "scene/problem/stretch.h"

namespace bracket::scene {

namespace {

std::array<double, 3> rounded_down(const std::array<Interval, 3>& c) { return {lower(c[0]), lower(c[1]), lower(c[2])}; }
std::array<double, 3> rounded_up(const std::array<Interval, 3>& c) { return {upper(c[0]), upper(c[1]), upper(c[2])}; }

/// By what a gap is raised on a stretch of its edge, by how much at the edge's ends.
std::array<Interval, 3> raised_on(const std::array<double, 2>& ends, double from, double to) {
  std::array<Interval, 3> sum;
  if (ends[0] == 0 && ends[1] == 0) return sum;
  const std::array<std::array<double, 2>, 3> arguments = {{{from, from}, {from, to}, {to, to}}};
  for (int i = 0; i < 3; ++i) {
    const auto& [s, t] = arguments[i];
    sum[i] = Interval(ends[0]) * Interval(1 - s) * Interval(1 - t) + Interval(ends[1]) * Interval(s) * Interval(t);
  }
  return sum;
}

std::array<Interval, 3> plus(const std::array<double, 3>& c, const std::array<Interval, 3>& d) {
  return {Interval(c[0]) + d[0], Interval(c[1]) + d[1], Interval(c[2]) + d[2]};
}

}  // namespace

bool cross(const GapBounds& bounds) {
  std::array<Interval, 3> left;
  for (int i = 0; i < 3; ++i) left[i] = Interval(bounds.upper[i]) - Interval(bounds.lower[i]);
  if (left[0].upper < 0 || left[2].upper < 0) return true;
  return left[1].upper < 0 && square(left[1]).lower > (left[0] * left[2]).upper;
}

std::optional<GapBounds> quadratic_gap(const Function<2>& gap, const Vector<2>& a, const Vector<2>& b) {
  const Jet whole = along(gap, a, b, 0, 1);
  if (whole.partial || !whole.value().is_bounded() || !whole.c[3].is_zero()) return {};
  const Jet start = beside(gap, a, b, 0, 1), end = beside(gap, a, b, 1, -1);
  std::array<Interval, 3> c = {start.value(), start.value() + start.c[1] / 2, end.value()};
  const Interval from_end = end.value() - end.c[1] / 2, both = intersection(c[1], from_end);
  if (!both.is_empty()) c[1] = both;
  return GapBounds{rounded_down(c), rounded_up(c)};
}

Interval gap_at_end(const Function<2>& gap, const Vector<2>& a, const Vector<2>& b, int end) {
  return beside(gap, a, b, end, end == 0 ? 1 : -1).value();
}

GapBounds enclosed_gap(const GivenGap<2>& given, const Vector<2>& a, const Vector<2>& b, const Piece<1>& stretch) {
  const double from = stretch.corner[0][0], to = stretch.corner[1][0];
  constexpr double unbounded = std::numeric_limits<double>::infinity();
  const std::array<double, 2> at_least = {from == 0 ? given.at_least[0] : -unbounded,
                                          to == 1 ? given.at_least[1] : -unbounded};
  const Function<2> negative({}, [&](const Function<2>::Range& x) { return -given.function.over(x); });
  const auto below = quadratic_below({given.function, a, b, from, to, given.where}, at_least);
  const auto above = quadratic_below({negative, a, b, from, to, given.where}, {-unbounded, -unbounded});
  const auto raised = raised_on(given.raised, from, to);
  return {rounded_down(plus(below, raised)), rounded_up(plus({-above[0], -above[1], -above[2]}, raised))};
}

ContactFacet on_piece(const Problem<2>& first, int contact, int one, int other, const Piece<1>& piece) {
  const ContactFacet& given = first.contact[contact];
  ContactFacet facet = given;
  facet.first = one;
  facet.second = other;
  for (int i = 0; i < 2; ++i) {
    facet.law.modulus[i] = between_ends(given.law.modulus, piece.corner[i][0]);
    facet.law.friction[i] = between_ends(given.law.friction, piece.corner[i][0]);
  }
  facet.slip = on_stretch(given.slip, piece.corner[0][0], piece.corner[1][0]);
  if (!first.gaps.empty() && first.gaps[contact].function) {
    const auto& [a, b] = first.mesh.boundary[given.first].vertices;
    const GapBounds bounds = enclosed_gap(first.gaps[contact], first.mesh.vertices[a], first.mesh.vertices[b], piece);
    facet.lower = bounds.lower;
    facet.upper = bounds.upper;
    return facet;
  }
  const double from = piece.corner[0][0], to = piece.corner[1][0];
  const auto cut = [&](const std::array<double, 3>& whole) {
    return on_stretch(std::array<Enclosure, 3>{whole[0], whole[1], whole[2]}, from, to);
  };
  const auto below = cut(given.lower), above = cut(given.upper);
  for (int i = 0; i < 3; ++i) {
    facet.lower[i] = lower(below[i]);
    facet.upper[i] = upper(above[i]);
  }
  return facet;
}

template <int dim> bool has_quadratic_gaps(const Problem<dim>& problem) {
  return std::none_of(first_of(problem).gaps.begin(), first_of(problem).gaps.end(),
                      [](const GivenGap<dim>& gap) { return static_cast<bool>(gap.function); });
}

template bool has_quadratic_gaps(const Problem<2>&);
template bool has_quadratic_gaps(const Problem<3>&);

}  // namespace bracket::scene
