// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/certificate/block_stress.h"

#include <gtest/gtest.h>

#include <random>

#include "dual/block_element.h"
#include "dual/dual.h"
#include "tests/bounds/certificate/rational.h"

namespace bracket::bounds {
namespace {

using scene::Vector;
template <class Number> using Triangle = std::array<Vector2<Number>, 3>;
template <class Number> using Loads = std::array<SideLoad<Number>, 3>;

class RandomUnits {
 public:
  explicit RandomUnits(unsigned seed) : generator_(seed) {}
  double operator()() { return std::uniform_real_distribution<double>(-1, 1)(generator_); }
  Vector<2> point() { return {(*this)(), (*this)()}; }

 private:
  std::mt19937 generator_;
};

/// Isosceles, turned by 1 rad, its first corner away from the origin.
std::array<Vector<2>, 3> isosceles(double degrees, double size) {
  const double angle = degrees * M_PI / 360;
  const Eigen::Rotation2Dd turn(1);
  const Vector<2> tip(3, -2);
  return {tip, tip + turn * (size * Vector<2>(std::cos(angle), -std::sin(angle))),
          tip + turn * (size * Vector<2>(std::cos(angle), std::sin(angle)))};
}

/// Good ones, slivers of 1° (at the tip, or with two such angles), tiny, huge and random ones.
std::vector<std::array<Vector<2>, 3>> triangles() {
  std::vector<std::array<Vector<2>, 3>> result = {isosceles(60, 1),     isosceles(1, 1),     isosceles(178, 1),
                                                  isosceles(0.001, 10), isosceles(90, 1e-6), isosceles(50, 1e9)};
  RandomUnits random(1);
  while (result.size() < 30) {
    const std::array<Vector<2>, 3> t = {random.point(), random.point(), random.point()};
    const Vector<2> u = t[1] - t[0], v = t[2] - t[0];
    if (u[0] * v[1] - u[1] * v[0] > 1e-3) result.push_back(t);
  }
  return result;
}

template <class Number> Triangle<Number> seen_from_first(const std::array<Vector<2>, 3>& t) {
  return {between<Number>(t[0], t[0]), between<Number>(t[0], t[1]), between<Number>(t[0], t[2])};
}

template <class Number> Wrench<Number> total(const Triangle<Number>& x, const Loads<Number>& load) {
  Wrench<Number> sum;
  for (int i = 0; i < 3; ++i) {
    const auto part = resultant(load[i], x[i], x[(i + 1) % 3] - x[i]);
    sum.force = sum.force + part.force;
    sum.moment += part.moment;
  }
  return sum;
}

/// Random loads, exactly balanced by the one on the last side.
Loads<Exact> balanced_loads(RandomUnits& random, const Triangle<Exact>& x) {
  Loads<Exact> load;
  for (auto& side : load)
    for (auto& end : side) end = vector2<Exact>(random.point());
  const Wrench<Exact> rest = total(x, load);
  const auto balance = load_with({-rest.force, -rest.moment}, x[2], x[0] - x[2]);
  for (int end = 0; end < 2; ++end) load[2][end] = load[2][end] + balance[end];
  return load;
}

/// σ (n ds)
template <class Number> Vector2<Number> on_normal(const std::array<Number, 3>& s, const Vector2<Number>& n) {
  return {s[0] * n.x + s[2] * n.y, s[2] * n.x + s[1] * n.y};
}

bool equal(const Vector2<Exact>& a, const Vector2<Exact>& b) { return a.x == b.x && a.y == b.y; }

TEST(Wrench, is_that_of_the_load_whose_it_is) {
  RandomUnits random(2);
  for (int trial = 0; trial < 20; ++trial) {
    const auto arm = vector2<Exact>(random.point()), e = vector2<Exact>(random.point());
    const SideLoad<Exact> load = {vector2<Exact>(random.point()), vector2<Exact>(random.point())};
    const auto sum = resultant(load, arm, e);
    // Simpson's rule, exact for the moment of a linear load.
    const Exact two(2), four(4), six(6);
    const auto middle = (Exact(1) / two) * (load[0] + load[1]);
    EXPECT_TRUE(equal(sum.force, middle));
    EXPECT_EQ(sum.moment,
              (cross(arm, load[0]) + four * cross(arm + (Exact(1) / two) * e, middle) + cross(arm + e, load[1])) / six);
    const auto again = resultant(load_with(sum, arm, e), arm, e);
    EXPECT_TRUE(equal(again.force, sum.force));
    EXPECT_EQ(again.moment, sum.moment);
  }
}

TEST(BlockStress, is_in_equilibrium_inside_and_with_the_side_loads_exactly) {
  RandomUnits random(3);
  for (const auto& t : triangles()) {
    const auto x = seen_from_first<Exact>(t);
    const auto load = balanced_loads(random, x);
    const auto stress = stress_of_balanced(x, load);
    const Vector2<Exact> centroid = (Exact(1) / Exact(3)) * (x[0] + x[1] + x[2]);
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3;
      const Vector2<Exact> n = -turned(x[j] - x[i]), inner = -turned(centroid - x[j]),
                           before = -turned(x[i] - centroid);
      EXPECT_TRUE(equal(on_normal(stress[i][0], n), load[i][0]));
      EXPECT_TRUE(equal(on_normal(stress[i][1], n), load[i][1]));
      EXPECT_TRUE(equal(on_normal(stress[i][1], inner), on_normal(stress[j][0], inner)));
      EXPECT_TRUE(equal(on_normal(stress[i][2], inner), on_normal(stress[j][2], inner)));
      // The divergence of a linear field: each corner's value times the normal opposite to it.
      const Vector2<Exact> divergence =
          on_normal(stress[i][0], inner) + on_normal(stress[i][1], before) + on_normal(stress[i][2], n);
      EXPECT_TRUE(equal(divergence, {}));
    }
  }
}

/// Largest difference by the largest stress.
template <class A, class B> double distance(const A& a, const B& b) {
  double difference = 0, largest = 0;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k)
      for (int m = 0; m < 3; ++m) {
        difference = std::max(difference, static_cast<double>(std::abs(a(i, k, m) - b(i, k, m))));
        largest = std::max(largest, static_cast<double>(std::abs(a(i, k, m))));
      }
  return difference / largest;
}

/// Square of the longest side by twice the area. Lengths across the triangle are known to rounding of lengths along it.
double aspect(const std::array<Vector<2>, 3>& t) {
  const Vector<2> u = t[1] - t[0], v = t[2] - t[0];
  return std::max({u.squaredNorm(), v.squaredNorm(), (v - u).squaredNorm()}) / (u[0] * v[1] - u[1] * v[0]);
}

template <class Number> double rounding_error(const std::array<Vector<2>, 3>& t, const Loads<Exact>& load) {
  Loads<Number> rounded;
  for (int i = 0; i < 3; ++i)
    for (int end = 0; end < 2; ++end)
      rounded[i][end] = {load[i][end].x.value.convert_to<Number>(), load[i][end].y.value.convert_to<Number>()};
  const auto stress = stress_of_balanced(seen_from_first<Number>(t), rounded);
  const auto exact = stress_of_balanced(seen_from_first<Exact>(t), load);
  return distance([&](int i, int k, int m) { return exact[i][k][m].value.template convert_to<long double>(); },
                  [&](int i, int k, int m) { return static_cast<long double>(stress[i][k][m]); });
}

TEST(BlockStress, in_floating_point_is_the_exact_one_to_rounding) {
  // About a hundred roundings, each of which the shape makes as much larger as it is long.
  RandomUnits random(4);
  for (const auto& t : triangles()) {
    const auto load = balanced_loads(random, seen_from_first<Exact>(t));
    EXPECT_LE(rounding_error<double>(t, load), 100 * std::numeric_limits<double>::epsilon() * aspect(t));
    EXPECT_LE(rounding_error<long double>(t, load), 100 * std::numeric_limits<long double>::epsilon() * aspect(t));
  }
}

TEST(BlockStress, is_that_of_the_block_elements_of_the_solver) {
  RandomUnits random(5);
  const auto compliance = scene::isotropic<2>(2, 0.3, scene::Plane::strain).compliance();
  for (const auto& t : triangles()) {
    const auto element = dual::block_element<1>(t, compliance);
    const dual::ModeVector<1> amplitudes = dual::ModeVector<1>::NullaryExpr([&] { return random(); });
    const dual::Corners solver = dual::block_stress<1>(element.piola, amplitudes);
    const auto x = seen_from_first<double>(t);
    Loads<double> load;
    const auto at = [&](int i, int k) -> const scene::Voigt<2>& { return solver[3 * ((i + 2) % 3) + k]; };
    for (int i = 0; i < 3; ++i)
      for (int end = 0; end < 2; ++end)
        load[i][end] = on_normal<double>({at(i, end)[0], at(i, end)[1], at(i, end)[2]}, -turned(x[(i + 1) % 3] - x[i]));
    const auto stress = stress_of_balanced(x, load);
    // Its loads are balanced to rounding of the largest stress, so the shape counts twice.
    EXPECT_LE(distance([&](int i, int k, int m) { return at(i, k)[m]; },
                       [&](int i, int k, int m) { return stress[i][k][m]; }),
              100 * std::numeric_limits<double>::epsilon() * aspect(t) * aspect(t));
  }
}

}  // namespace
}  // namespace bracket::bounds
