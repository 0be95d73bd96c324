// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/bernstein.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "scene/mesh/topology.h"
#include "scene/offsets.h"
#include "tests/support/scenes.h"

namespace bracket::scene {
namespace {

template <int degree> void expect_squares_are_the_mass() {
  const auto& indices = bernstein_indices(degree);
  for (std::size_t i = 0; i < indices.size(); ++i)
    for (std::size_t k = 0; k < indices.size(); ++k) {
      const auto [part, whole] = bernstein_mean(indices[i], indices[k]);
      // Σ c_i c_k / divisor = part / whole, over a common divisor
      long long common = 1;
      for (const auto& square : squares<degree>) common = std::lcm(common, square.divisor);
      long long sum = 0;
      for (const auto& square : squares<degree>)
        sum += common / square.divisor * square.coefficient[i] * square.coefficient[k];
      EXPECT_EQ(sum * whole, common * part) << "degree " << degree << ", " << i << " and " << k;
    }
}

TEST(Bernstein, squares_add_up_to_the_mass) {
  expect_squares_are_the_mass<0>();
  expect_squares_are_the_mass<1>();
  expect_squares_are_the_mass<2>();
  expect_squares_are_the_mass<3>();
}

class Random {
 public:
  explicit Random(unsigned seed) : generator_(seed) {}
  double operator()() { return std::uniform_real_distribution<double>(-1, 1)(generator_); }
  std::vector<double> values(int n) {
    std::vector<double> result(n);
    for (double& x : result) x = (*this)();
    return result;
  }
  std::array<double, 3> point() {  // also outside
    const double a = (*this)(), b = (*this)();
    return {a, b, 1 - a - b};
  }

 private:
  std::mt19937 generator_;
};

TEST(Bernstein, a_polynomial_stays_itself_when_raised_cut_or_seen_from_another_triangle) {
  Random random(1);
  for (int degree = 1; degree <= 4; ++degree)
    for (int trial = 0; trial < 20; ++trial) {
      const auto c = random.values(n_bernstein(degree));
      const auto x = random.point();
      const double value = value_on_triangle(c, degree, x);
      EXPECT_NEAR(value_on_triangle(raised_on_triangle<double>(c, degree), degree + 1, x), value, 1e-12);
      for (int k = 0; k < 3; ++k) {  // x = Σ y corner, the centroid the last of them
        const std::array<double, 3> y = {x[(k + 1) % 3] - x[k], x[(k + 2) % 3] - x[k], 3 * x[k]};
        EXPECT_NEAR(value_on_triangle(on_centroid_part<double>(c, degree, k), degree, y), value, 1e-12);
      }
      const std::array<std::array<double, 3>, 3> corners = {random.point(), random.point(), random.point()};
      std::array<double, 3> there = {0, 0, 0};
      for (int k = 0; k < 3; ++k)
        for (int i = 0; i < 3; ++i) there[i] += x[k] * corners[k][i];
      EXPECT_NEAR(value_on_triangle(on_triangle(c, degree, corners), degree, x), value_on_triangle(c, degree, there),
                  1e-11);
      const auto f = random.values(degree + 1), g = random.values(3);
      EXPECT_NEAR(value_on_segment(raised<double>(f), x[0]), value_on_segment(f, x[0]), 1e-12);
      EXPECT_NEAR(bernstein_product(f, g), bernstein_product(raised<double>(f), raised<double>(g)), 1e-14);
    }
}

/// Two of the degree.
Vector<2> polynomial(const Vector<2>& x, int degree) {
  const double s = x[0] - 0.3 * x[1], t = x[1] + 0.2 * x[0];
  return {std::pow(s, degree) - t, 2 * std::pow(t, degree) + std::pow(s, degree - 1) * t};
}

/// The same mesh with its vertices in a random order.
Mesh<2> renumbered(const Mesh<2>& mesh, std::mt19937& generator) {
  std::vector<int> number(mesh.vertices.size());
  std::iota(number.begin(), number.end(), 0);
  std::shuffle(number.begin(), number.end(), generator);
  Mesh<2> result;
  result.cell_body = mesh.cell_body;
  result.bodies = mesh.bodies;
  result.vertices.resize(number.size());
  for (std::size_t v = 0; v < number.size(); ++v) result.vertices[number[v]] = mesh.vertices[v];
  for (const auto& [a, b, c] : mesh.cells) result.cells.push_back({number[b], number[c], number[a]});
  return with_topology(std::move(result), {}, "renumbered");
}

Displacement<2> interpolated(const Mesh<2>& mesh, int degree) {
  Displacement<2> u{degree, {}, {}, {}};
  for (const auto& x : mesh.vertices) u.vertex.push_back(polynomial(x, degree));
  for (const auto& edge : mesh.edges)
    for (int k = 1; k < degree; ++k) {
      const auto& [a, b] = positions(mesh, edge);
      u.edge.push_back(polynomial(a + static_cast<double>(k) / degree * (b - a), degree));
    }
  for (const auto& cell : mesh.cells)
    for (const auto& i : bernstein_indices(degree)) {
      if (i[0] == 0 || i[1] == 0 || i[2] == 0) continue;
      const auto x = positions(mesh, cell);
      u.cell.push_back(polynomial((i[0] * x[0] + i[1] * x[1] + i[2] * x[2]) / degree, degree));
    }
  return u;
}

TEST(Offsets, polynomials_are_themselves_whatever_the_numbers_of_vertices) {
  std::mt19937 generator(2);
  Random random(3);
  for (int trial = 0; trial < 10; ++trial) {
    Scene<2> scene;
    scene.blocks = {tests::block("b", 0, 2, 0, 1, 3, 2)};
    scene.bodies = {{"b", isotropic<2>(1, 0.3, Plane::strain)}};
    const Mesh<2> mesh = renumbered(build_mesh(scene), generator);
    for (int degree = 1; degree <= 4; ++degree) {
      const auto u = interpolated(mesh, degree);
      for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
        const auto offset = offsets_on_cell(mesh, u, static_cast<int>(c));
        const auto x = positions(mesh, mesh.cells[c]);
        const auto at = random.point();
        Vector<2> value = value_on_triangle(offset, degree, at), place = Vector<2>::Zero();
        for (int k = 0; k < 3; ++k) {
          value += at[k] * u.vertex[mesh.cells[c][k]];
          place += at[k] * x[k];
        }
        EXPECT_LT((value - polynomial(place, degree)).norm(), 1e-11) << "degree " << degree;
      }
      for (std::size_t f = 0; f < mesh.boundary.size(); ++f) {
        const auto& [a, b] = mesh.boundary[f].vertices;
        const auto offset = offsets_on_facet(mesh, u, static_cast<int>(f));
        const Vector<2> place = 0.7 * mesh.vertices[a] + 0.3 * mesh.vertices[b];
        const Vector<2> value = 0.7 * u.vertex[a] + 0.3 * u.vertex[b] + value_on_segment(offset, 0.3);
        EXPECT_LT((value - polynomial(place, degree)).norm(), 1e-11) << "degree " << degree;
      }
    }
  }
}

}  // namespace
}  // namespace bracket::scene
