// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// Planar: a function on an edge. Quadratics are Bernstein coefficients by the parameter s, 0 … 1 on the stretch.
#include "scene/problem/gap_below.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "scene/text.h"

namespace bracket::scene {

namespace {

using Quadratic = std::array<Real, 3>;

Real mean(const Quadratic& q) { return (q[0] + q[1] + q[2]) / 3; }
bool is_bounded(const Quadratic& q) { return std::isfinite(q[0]) && std::isfinite(q[1]) && std::isfinite(q[2]); }
Quadratic lower_ends(const Interval& a, const Interval& b, const Interval& c) { return {a.lower, b.lower, c.lower}; }

Vector<2> place(const Stretch& on, double t) { return on.a + t * (on.b - on.a); }

/// What is known of a function on a stretch.
struct Known {
  Interval values;
  Interval start, middle, end, slope_at_start, slope_at_end;  ///< slopes by s; of what is differentiable only
  Interval second, third;                                     ///< g''/2 and g'''/6 by s
  bool differentiable;
};

Known known(const Stretch& on) {
  const Jet over = along(on.function, on.a, on.b, on.from, on.to);
  const double half = (on.to - on.from) / 2, middle = on.from + half;
  if (over.value().is_empty())
    fail(Status::input, on.where, fmt::format("the gap has no value at {}", point(place(on, middle))));
  const Interval width = on.to - on.from;
  Known of{over.value(),          {}, {}, {}, {}, {}, over.c[2] * square(width), over.c[3] * width * square(width),
           over.c[1].is_bounded()};
  if (!of.differentiable) return of;
  const Jet start = beside(on.function, on.a, on.b, on.from, 1), end = beside(on.function, on.a, on.b, on.to, -1);
  of.middle = beside(on.function, on.a, on.b, middle, 1).value();
  of.values = intersection(of.values, of.middle + over.c[1] * width * Interval(-0.5L, 0.5L));
  of.start = intersection(start.value(), of.values);
  of.end = intersection(end.value(), of.values);
  of.middle = intersection(of.middle, of.values);
  of.slope_at_start = start.c[1] * width;
  of.slope_at_end = end.c[1] * width;
  return of;
}

/// The length of what is not known of the numbers that smooth_below() is made of.
Real uncertainty(const Known& of) {
  Real sum = 0;
  for (const Interval& x : {of.start, of.middle, of.end, of.slope_at_start, of.slope_at_end}) sum += x.upper - x.lower;
  return of.differentiable ? sum : 0;
}

/// Quadratics below a smooth function g. With the parabola q through its values at 0, ½, 1:
///     |g − q| ≤ s |s − ½| (1 − s) max |g'''|/6 ≤ ½ s (1 − s) max |g'''|/6.
std::vector<Quadratic> smooth_below(const Known& g) {
  std::vector<Quadratic> all;
  if (!g.second.is_bounded()) return all;
  const Interval least_second = g.second.lower;
  all.push_back(lower_ends(g.start, g.start + g.slope_at_start / 2, g.start + g.slope_at_start + least_second));
  all.push_back(lower_ends(g.end - g.slope_at_end + least_second, g.end - g.slope_at_end / 2, g.end));
  all.push_back(lower_ends(g.start, (g.start + g.end) / 2 - Interval(g.second.upper) / 2, g.end));
  if (!g.third.is_bounded()) return all;
  const Real most = g.third.magnitude();
  all.push_back(lower_ends(g.start, Interval(2) * g.middle - (g.start + g.end) / 2 + Interval(-most, most) / 4, g.end));
  return all;
}

/// A part of the stretch, and a quadratic below the function on it.
struct Panel {
  double from, to;
  Known known;
  Quadratic below;

  Real least() const { return std::max(known.values.lower, *std::min_element(below.begin(), below.end())); }
  /// What is left between the bounds on it.
  Real area() const { return (known.values.upper - mean(below)) * (to - from); }
};

Panel panel(Stretch on, double from, double to) {
  on.from = from;
  on.to = to;
  const Known of = known(on);
  Quadratic best = {of.values.lower, of.values.lower, of.values.lower};
  for (const Quadratic& q : smooth_below(of))
    if (is_bounded(q) && mean(q) > mean(best)) best = q;
  return {from, to, of, best};
}

/// Halves the panel with the most between its bounds, `times` times. So jumps and kinks end up in narrow panels.
std::vector<Panel> halved(const Stretch& on, std::vector<Panel> panels, int times) {
  for (int i = 0; i < times; ++i) {
    const auto widest = std::max_element(panels.begin(), panels.end(),
                                         [](const Panel& a, const Panel& b) { return a.area() < b.area(); });
    const double from = widest->from, to = widest->to, middle = from + (to - from) / 2;
    if (middle == from || middle == to) break;
    *widest = panel(on, from, middle);
    panels.insert(widest + 1, panel(on, middle, to));
  }
  return panels;
}

Real least_of(const std::vector<Panel>& panels) {
  Real least = Interval::unbounded;
  for (const Panel& one : panels) least = std::min(least, one.least());
  return least;
}

/// Where a quadratic is compared with that of a panel: the arguments of their blossoms, and the panel's coefficient.
struct PanelPair {
  Interval s, t;
  Real bound;
};

std::vector<PanelPair> comparisons(const Stretch& on, const std::vector<Panel>& panels) {
  const Interval width = Interval(on.to) - Interval(on.from);
  std::vector<PanelPair> all;
  for (const Panel& one : panels) {
    const Interval s = (Interval(one.from) - Interval(on.from)) / width;
    const Interval t = (Interval(one.to) - Interval(on.from)) / width;
    all.insert(all.end(), {{s, s, one.below[0]}, {s, t, one.below[1]}, {t, t, one.below[2]}});
  }
  return all;
}

/// The largest middle coefficient with which the quadratic with these end values is below all panels'; none: no value.
std::optional<Real> largest_middle(const std::vector<PanelPair>& all, Real start, Real end) {
  Real middle = Interval::unbounded;
  for (const auto& [s, t, bound] : all) {
    const Interval of_start = (Interval(1) - s) * (Interval(1) - t), of_end = s * t;
    const Interval of_middle = s * (Interval(1) - t) + t * (Interval(1) - s);
    const Interval left = Interval(bound) - Interval(start) * of_start - Interval(end) * of_end;
    if (of_middle.lower > 0)
      middle = std::min(middle, (left / of_middle).lower);
    else if (left.lower < 0)
      return {};
  }
  if (!std::isfinite(middle)) return {};
  return middle;
}

/// The largest value at 1 with which the line from `start` at 0 is below all panels'; none: no value.
std::optional<Real> largest_end(const std::vector<PanelPair>& all, Real start) {
  Real end = Interval::unbounded;
  for (const auto& [s, t, bound] : all) {
    const Interval at = (s + t) / 2, left = Interval(bound) - Interval(start) * (Interval(1) - at);
    if (at.lower > 0)
      end = std::min(end, (left / at).lower);
    else if (left.lower < 0)
      return {};
  }
  if (!std::isfinite(end)) return {};
  return end;
}

/// The value at 0 of the line below all panels' that is the highest at ½: through two corners of their lower hull.
Real start_of_highest(const std::vector<PanelPair>& all) {
  Real highest = Interval::unbounded, start = -Interval::unbounded;
  for (const auto& left : all)
    for (const auto& right : all) {
      const Real s = (left.s.lower + left.t.lower) / 2, t = (right.s.lower + right.t.lower) / 2;
      if (!(s <= 0.5L && t > 0.5L)) continue;
      const Real slope = (right.bound - left.bound) / (t - s), at_half = left.bound + (0.5L - s) * slope;
      if (at_half >= highest) continue;
      highest = at_half;
      start = left.bound - s * slope;
    }
  return start;
}

std::vector<PanelPair> mirrored(std::vector<PanelPair> all) {
  for (auto& [s, t, bound] : all) {
    s = Interval(1) - s;
    t = Interval(1) - t;
  }
  return all;
}

/// Quadratics and lines below all panels, with ends that are free or at their least.
std::vector<Quadratic> rough_below(const Stretch& on, const std::vector<Panel>& panels,
                                   const std::array<Real, 2>& least_at_ends) {
  const std::vector<PanelPair> all = comparisons(on, panels), back = mirrored(all);
  std::vector<Quadratic> found;
  const auto add_line = [&](Real start, std::optional<Real> end) {
    if (end) found.push_back({start, ((Interval(start) + Interval(*end)) / 2).lower, *end});
  };
  const Real start = start_of_highest(all);
  if (std::isfinite(start)) add_line(start, largest_end(all, start));
  add_line(least_at_ends[0], largest_end(all, least_at_ends[0]));
  if (const auto from_end = largest_end(back, least_at_ends[1])) add_line(*from_end, least_at_ends[1]);
  for (const Real first : {panels.front().below[0], least_at_ends[0]})
    for (const Real last : {panels.back().below[2], least_at_ends[1]})
      if (const auto middle = largest_middle(all, first, last)) found.push_back({first, *middle, last});
  return found;
}

std::array<double, 3> rounded(const Quadratic& q) {
  return {lower(Interval(q[0])), lower(Interval(q[1])), lower(Interval(q[2]))};
}

/// Whether a quadratic is nowhere below `least`: c₁ ≥ −√(c₀ c₂) by its coefficients above that.
bool keeps_above(const std::array<double, 3>& q, Real least) {
  std::array<Interval, 3> left;
  for (int i = 0; i < 3; ++i) left[i] = Interval(q[i]) - Interval(least);
  if (left[0].lower < 0 || left[2].lower < 0) return false;
  return left[1].lower >= 0 || square(left[1]).upper <= (left[0] * left[2]).lower;
}

}  // namespace

std::array<double, 3> quadratic_below(const Stretch& stretch, const std::array<double, 2>& at_least) {
  const double from = stretch.from, to = stretch.to;
  const Known whole = known(stretch);
  std::vector<Panel> panels = halved(stretch, {panel(stretch, from, to)}, 3);
  std::optional<std::array<double, 3>> best;
  int best_rank = -1;
  Real least = least_of(panels);
  const auto consider = [&](const std::vector<Quadratic>& candidates) {
    // What is not known of the numbers that a quadratic is made of may take it below the least value, too.
    const Real floor = Real(lower(Interval(least))) - 2 * uncertainty(whole);
    for (const Quadratic& q : candidates) {
      if (!is_bounded(q)) continue;
      const std::array<double, 3> c = rounded(q);
      const bool admits = c[0] >= at_least[0] && c[2] >= at_least[1], above = keeps_above(c, floor);
      const int rank = admits && above ? 2 : admits ? 1 : above ? 0 : -1;
      if (rank < 0 || rank < best_rank ||
          (rank == best_rank && c[0] + c[1] + c[2] <= (*best)[0] + (*best)[1] + (*best)[2]))
        continue;
      best = c;
      best_rank = rank;
    }
  };
  consider(smooth_below(whole));
  const bool smooth = 4 * whole.third.magnitude() <= whole.values.upper - whole.values.lower;
  if (best_rank < 2 || !smooth) {
    panels = halved(stretch, std::move(panels), 28);
    least = least_of(panels);
    best_rank = -1;  // what was accepted may be below the least value, which is now better known
    consider(smooth_below(whole));
    consider({{least, least, least}});
    const std::array<Real, 2> ends = {std::max<Real>(least, at_least[0]), std::max<Real>(least, at_least[1])};
    consider(rough_below(stretch, panels, ends));
  }
  if (!best)
    fail(
        Status::input, stretch.where,
        fmt::format("the gap has no bounds between {} and {}", point(place(stretch, from)), point(place(stretch, to))));
  return *best;
}

}  // namespace bracket::scene
