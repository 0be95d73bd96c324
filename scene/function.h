// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <utility>

#include "scene/jet.h"
#include "scene/types.h"

namespace bracket::scene {

/// A given function of position, which may be called from several threads. Data can be bounded where it can be
/// evaluated over ranges, too: a number, an expression, or code that is made for both by enclosed(). Of any other code
/// nothing is known between the points at which it is sampled.
template <int dim> class Function {
 public:
  using Point = Vector<dim>;
  using Range = std::array<Jet, dim>;

  Function() = default;  ///< empty: not to be called
  Function(double constant)
      : Function([constant](const Point&) { return constant; }, [constant](const Range&) { return Jet(constant); }) {}
  /// Sampled.
  template <class AtPoints>
  requires(!std::is_same_v<AtPoints, Function> && std::is_invocable_r_v<double, const AtPoints&, const Point&>)
      Function(AtPoints at_points)
      : at_points_(std::move(at_points)) {}
  /// \param over encloses the values of `at_points`, were those computed without rounding
  Function(std::function<double(const Point&)> at_points, std::function<Jet(const Range&)> over)
      : at_points_(std::move(at_points)), over_(std::move(over)) {}

  double operator()(const Point& x) const { return at_points_(x); }
  /// \pre is_enclosed()
  Jet over(const Range& x) const { return over_(x); }
  bool is_enclosed() const { return static_cast<bool>(over_); }
  explicit operator bool() const { return static_cast<bool>(at_points_); }

 private:
  std::function<double(const Point&)> at_points_;
  std::function<Jet(const Range&)> over_;
};

/// A function by code that is written once for points and for ranges, [](const auto& x) { return sin(x[0]); }, with
/// choose() in place of ?: and if.
template <int dim, class Generic> Function<dim> enclosed(const Generic& f) {
  return {[f](const Vector<dim>& x) -> double { return f(x); },
          [f](const typename Function<dim>::Range& x) -> Jet { return f(x); }};
}

/// An enclosed function along the straight line from a to b, over [from, to] of the parameter that is 0 at a, 1 at b.
template <int dim>
Jet along(const Function<dim>& f, const Vector<dim>& a, const Vector<dim>& b, double from, double to) {
  typename Function<dim>::Range x;
  for (int i = 0; i < dim; ++i) x[i] = linear(a[i], b[i], from, to);
  return f.over(x);
}
/// The same just after a point (side 1) or before it (−1).
template <int dim> Jet beside(const Function<dim>& f, const Vector<dim>& a, const Vector<dim>& b, double at, int side) {
  typename Function<dim>::Range x;
  for (int i = 0; i < dim; ++i) x[i] = linear_beside(a[i], b[i], at, side);
  return f.over(x);
}

}  // namespace bracket::scene
