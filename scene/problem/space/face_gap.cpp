// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// In space: gaps on a face.
#include "scene/problem/space/face_gap.h"

#include <fmt/format.h>

#include <algorithm>

#include "scene/enclosure.h"
#include "scene/text.h"

namespace bracket::scene {

namespace {

using Coefficients = std::array<Interval, 6>;

FaceGapBounds rounded(const Coefficients& below, const Coefficients& above) {
  FaceGapBounds bounds;
  for (int i = 0; i < 6; ++i) {
    bounds.lower[i] = lower(below[i]);
    bounds.upper[i] = upper(above[i]);
  }
  return bounds;
}

OnFace towards(const OnFace& from, const OnFace& to) { return {to[0] - from[0], to[1] - from[1]}; }

/// Into a part from its corner i, nearer to its side towards corner k: ¾ of it and ¼ of the other one.
OnFace inwards(const FacePart& part, int i, int k) {
  const OnFace near = towards(part[i], part[k]), far = towards(part[i], part[3 - i - k]);
  return {0.75 * near[0] + 0.25 * far[0], 0.75 * near[1] + 0.25 * far[1]};
}

/// The derivative at corner i of a part towards its corner k, by those along two directions into it.
Interval slope_along(const Function<3>& f, const Face& face, const FacePart& part, int i, int k) {
  const Interval near = at_point(f, face, part[i], inwards(part, i, k)).c[1];
  const Interval far = at_point(f, face, part[i], inwards(part, i, 3 - i - k)).c[1];
  return (Interval(3) * near - far) / 2;
}

/// f'' along a side of a part, over the part, by those along three directions that no side has.
Interval curvature_along(const Function<3>& f, const Face& face, const FacePart& part, int i, int k) {
  const OnFace side = towards(part[i], part[k]);
  const Interval direct = Interval(2) * over_part(f, face, part, side).c[2];
  const auto form = [&](const OnFace& direction) { return Interval(2) * over_part(f, face, part, direction).c[2]; };
  const Interval one = form(across_face[0]), other = form(across_face[1]), both = form({3, 3});
  const Interval mixed = (both - one - other) / 2;
  const Interval s = (Interval(2) * Interval(side[0]) - Interval(side[1])) / 3;
  const Interval t = (Interval(2) * Interval(side[1]) - Interval(side[0])) / 3;
  const Interval combined = square(s) * one + square(t) * other + Interval(2) * s * t * mixed;
  if (!direct.is_bounded()) return combined;
  return combined.is_bounded() ? intersection(direct, combined) : direct;
}

/// A quadratic below a smooth function that has its values at the corners; nothing where it may not be smooth. With the
/// second derivatives H_ik along the sides, Taylor's expansions at a point for the three corners add up to
///     f ≥ Σ φ_i f(x_i) − ½ Σ φ_i φ_k (max H_ik + φ_l (max H_ik − min H_ik)).
std::optional<Coefficients> smooth_below(const Function<3>& f, const Face& face, const FacePart& part) {
  if (over_part(f, face, part, across_face[0]).partial) return {};
  Coefficients c;
  for (int i = 0; i < 3; ++i) {
    const Jet jet = at_point(f, face, part[i], inwards(part, i, (i + 1) % 3));
    if (jet.partial || !jet.value().is_bounded()) return {};
    c[i] = jet.value();
  }
  for (int e = 0; e < 3; ++e) {
    const auto& [i, k] = Simplex<2>::edges[e];
    const Interval curvature = curvature_along(f, face, part, i, k);
    if (!curvature.is_bounded()) return {};
    const Interval most(curvature.upper), least(curvature.lower);
    c[3 + e] = (c[i] + c[k]) / 2 - (most + (most - least)) / 4;
  }
  return c;
}

/// The least value of a function on a part: what it is known to be, with the part that may have the least cut in four,
/// again and again.
Real least_on(const Function<3>& f, const Face& face, const FacePart& part, const std::string& where) {
  constexpr int cuts = 16;
  struct Known {
    FacePart part;
    Real least;
  };
  const auto known = [&](const FacePart& on) {
    const Interval value = over_part(f, face, on, across_face[0]).value();
    if (value.is_empty()) fail(Status::input, where, "the gap has no value at " + point(place(face, on[0])));
    return Known{on, value.lower};
  };
  std::vector<Known> all = {known(part)};
  for (int i = 0; i < cuts; ++i) {
    const auto worst = std::ranges::min_element(all, {}, &Known::least);
    const auto [a, b, c] = worst->part;
    const auto half = [](const OnFace& p, const OnFace& q) { return OnFace{(p[0] + q[0]) / 2, (p[1] + q[1]) / 2}; };
    const OnFace bc = half(b, c), ca = half(c, a), ab = half(a, b);
    all.erase(worst);
    for (const FacePart& quarter :
         {FacePart{a, ab, ca}, FacePart{ab, b, bc}, FacePart{ca, bc, c}, FacePart{bc, ca, ab}})
      all.push_back(known(quarter));
  }
  const Real least = std::ranges::min_element(all, {}, &Known::least)->least;
  if (!std::isfinite(least))
    fail(Status::input, where,
         fmt::format("the gap has no bounds between {}, {} and {}", point(place(face, part[0])),
                     point(place(face, part[1])), point(place(face, part[2]))));
  return least;
}

Real mean(const Coefficients& c) {
  Real sum = 0;
  for (const Interval& one : c) sum += one.lower;
  return sum / 6;
}

Coefficients quadratic_below(const Function<3>& f, const Face& face, const FacePart& part, const std::string& where) {
  const auto smooth = smooth_below(f, face, part);
  Real magnitude = 0, spread = 0;
  if (smooth) {
    const Interval value = over_part(f, face, part, across_face[0]).value();
    spread = value.upper - value.lower;
    for (int e = 3; e < 6; ++e) magnitude = std::max(magnitude, ((*smooth)[e % 3] - (*smooth)[e]).magnitude());
    if (magnitude <= 4 * spread || spread == 0) return *smooth;
  }
  Coefficients constant;
  constant.fill(Interval(least_on(f, face, part, where)));
  return smooth && mean(*smooth) >= mean(constant) ? *smooth : constant;
}

}  // namespace

std::optional<FaceGapBounds> quadratic_gap(const Function<3>& gap, const Face& face) {
  if (!is_polynomial(gap, face, 2)) return {};
  Coefficients c;
  for (int i = 0; i < 3; ++i) c[i] = gap_at_corner(gap, face, i);
  for (int e = 0; e < 3; ++e) {
    const auto& [i, k] = Simplex<2>::edges[e];
    const Interval one = c[i] + slope_along(gap, face, whole_face, i, k) / 2;
    const Interval other = c[k] + slope_along(gap, face, whole_face, k, i) / 2;
    const Interval both = intersection(one, other);
    c[3 + e] = both.is_empty() ? hull(one, other) : both;
  }
  return rounded(c, c);
}

Interval gap_at_corner(const Function<3>& gap, const Face& face, int corner) {
  return at_point(gap, face, whole_face[corner], inwards(whole_face, corner, (corner + 1) % 3)).value();
}

FaceGapBounds enclosed_gap(const GivenGap<3>& given, const Face& face, const FacePart& part) {
  const Function<3> negative({}, [&](const Function<3>::Range& x) { return -given.function.over(x); });
  Coefficients below = quadratic_below(given.function, face, part, given.where);
  Coefficients above = quadratic_below(negative, face, part, given.where);
  Coefficients raised{};
  for (int i = 0; i < 3; ++i) raised[i] = given.raised[i];
  raised = on_part(raised, part);
  for (int i = 0; i < 6; ++i) {
    below[i] = below[i] + raised[i];
    above[i] = -above[i] + raised[i];
  }
  return rounded(below, above);
}

ContactFacetOf<3> on_piece(const Problem<3>& first, int contact, int one, int other, const Piece<2>& piece) {
  const ContactFacetOf<3>& given = first.contact[contact];
  ContactFacetOf<3> facet = given;
  facet.first = one;
  facet.second = other;
  FaceGapBounds bounds;
  if (!first.gaps.empty() && first.gaps[contact].function) {
    bounds = enclosed_gap(first.gaps[contact], positions(first.mesh, first.mesh.boundary[given.first].vertices),
                          piece.corner);
  } else {
    const auto cut = [&](const FacetQuadratic<3>& whole) {
      Coefficients c;
      for (int i = 0; i < 6; ++i) c[i] = whole[i];
      return on_part(c, piece.corner);
    };
    bounds = rounded(cut(given.lower), cut(given.upper));
  }
  facet.lower = bounds.lower;
  facet.upper = bounds.upper;
  return facet;
}

}  // namespace bracket::scene
