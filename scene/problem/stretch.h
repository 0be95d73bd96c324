// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// Planar: functions on an edge that is a facet, by its parameter: 0 at vertex 0, 1 at vertex 1.
#pragma once

#include <array>

namespace bracket::scene {

/// a + t (b − a), exact at both ends.
template <class Value> Value between_ends(const Value& a, const Value& b, double t) {
  if (t == 0) return a;
  if (t == 1) return b;
  return a + t * (b - a);
}
template <class Value> Value between_ends(const std::array<Value, 2>& ends, double t) {
  return between_ends(ends[0], ends[1], t);
}

/// The Bernstein coefficients of a quadratic on the stretch [from, to] of its edge, by those on the whole: its blossom.
template <class Number> std::array<Number, 3> on_stretch(const std::array<Number, 3>& whole, double from, double to) {
  const auto blossom = [&](double s, double t) {
    return between_ends(between_ends(whole[0], whole[1], s), between_ends(whole[1], whole[2], s), t);
  };
  return {blossom(from, from), blossom(from, to), blossom(to, to)};
}

}  // namespace bracket::scene
