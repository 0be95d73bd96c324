// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/problem/given_gap.h"

#include "scene/problem/law.h"
#include "scene/problem/sides.h"

namespace bracket::scene {

namespace {

Function<2> component(const std::array<Function<2>, 2>& jump, const Vector<2>& along) {
  const auto at_points = [jump, along](const Vector<2>& x) { return along[0] * jump[0](x) + along[1] * jump[1](x); };
  if (!jump[0].is_enclosed() || !jump[1].is_enclosed()) return at_points;
  return {at_points, [jump, along](const Function<2>::Range& x) {
            return Jet(along[0]) * jump[0].over(x) + Jet(along[1]) * jump[1].over(x);
          }};
}

}  // namespace

std::optional<Function<2>> given_gap(const ContactPair<2>& pair, const Vector<2>& d) {
  if (pair.jump) return component(*pair.jump, d);
  if (pair.gap) return pair.gap;
  if (const auto* circle = std::get_if<CircleObstacle>(&pair.second.obstacle)) return distance(*circle, d);
  return {};
}

std::optional<Function<3>> given_gap(const ContactPair<3>& pair, const Vector<3>&) { return pair.gap; }

std::optional<Function<2>> given_slip(const ContactPair<2>& pair, const Vector<2>& d) {
  if (!pair.jump) return {};
  return component(*pair.jump, tangent(d));
}

}  // namespace bracket::scene
