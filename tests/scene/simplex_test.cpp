// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/mesh/simplex.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <functional>
#include <random>
#include <set>

#include "scene/problem/problem.h"
#include "scene/problem/rigid_motion.h"
#include "scene/voigt.h"

namespace bracket::scene {
namespace {

template <int dim> using Corners = std::array<Vector<dim>, dim + 1>;
template <int dim> using Tensor = Eigen::Matrix<double, dim, dim>;

/// x_0 = 0 and x_i = e_i, moved about and as they are.
template <int dim> std::vector<Corners<dim>> simplices() {
  Corners<dim> reference;
  for (int i = 0; i <= dim; ++i) reference[i] = i == 0 ? Vector<dim>(Vector<dim>::Zero()) : Vector<dim>::Unit(i - 1);
  std::vector<Corners<dim>> result = {reference};
  std::mt19937 random(1);
  std::uniform_real_distribution<double> moved(-0.2, 0.2);
  while (result.size() < 10) {
    result.push_back(reference);
    for (Vector<dim>& x : result.back())
      for (double& c : x) c += moved(random);
  }
  return result;
}

template <int dim> std::array<Vector<dim>, dim> facet(const Corners<dim>& x, int k) {
  std::array<Vector<dim>, dim> vertices;
  for (int i = 0; i < dim; ++i) vertices[i] = x[Simplex<dim>::facets[k][i]];
  return vertices;
}

/// d! a_0! … a_d! / (a_0 + … + a_d + d)!, the mean of a product of powers of the barycentric coordinates.
template <std::size_t n> double monomial_mean(const std::array<int, n>& powers) {
  int sum = static_cast<int>(n) - 1;
  double mean = std::tgamma(n);
  for (const int a : powers) {
    mean *= std::tgamma(a + 1);
    sum += a;
  }
  return mean / std::tgamma(sum + 1);
}

/// The mean over a simplex of a polynomial in its barycentric coordinates, by Gauss points.
template <int d, class Polynomial> double mean(const Polynomial& f) {
  using Gauss = boost::math::quadrature::gauss<double, 7>;
  const auto point = [](const std::array<double, d>& x) {  // of the unit cube, folded onto the simplex
    std::array<double, d + 1> lambda;
    double rest = 1;
    for (int i = 0; i < d; ++i) {
      lambda[i] = rest * x[i];
      rest *= 1 - x[i];
    }
    lambda[d] = rest;
    return lambda;
  };
  const auto jacobian = [](const std::array<double, d>& x) {
    double value = std::tgamma(d + 1);
    for (int i = 0; i < d; ++i) value *= std::pow(1 - x[i], d - 1 - i);
    return value;
  };
  std::array<double, d> x;
  const std::function<double(int)> from = [&](int i) -> double {
    if (i == d) return jacobian(x) * f(point(x));
    return Gauss::integrate(
        [&](double s) {
          x[i] = s;
          return from(i + 1);
        },
        0.0, 1.0);
  };
  return from(0);
}

/// The basis function ψ_k of the quadratics.
template <int d> double quadratic(int k, const std::array<double, d + 1>& lambda) {
  if (k <= d) return lambda[k] * (2 * lambda[k] - 1);
  const auto& [a, b] = Simplex<d>::edges[k - d - 1];
  return 4 * lambda[a] * lambda[b];
}

template <class Dimension> struct SimplexTable : testing::Test {};
template <int d> using Dim = std::integral_constant<int, d>;
using Segments = testing::Types<Dim<1>, Dim<2>, Dim<3>>;  // facets of the plane are segments, those of space triangles
TYPED_TEST_SUITE(SimplexTable, Segments);

TYPED_TEST(SimplexTable, each_edge_joins_two_vertices_once) {
  using Table = Simplex<TypeParam::value>;
  std::set<std::set<int>> edges;
  for (int e = 0; e < Table::n_edges; ++e) {
    const auto& [a, b] = Table::edges[e];
    EXPECT_EQ(Table::edge_between(a, b), e);
    EXPECT_EQ(Table::edge_between(b, a), e);
    EXPECT_TRUE(0 <= std::min(a, b) && std::max(a, b) < Table::n_vertices && a != b);
    edges.insert({a, b});
  }
  EXPECT_EQ(edges.size(), TypeParam::value * (TypeParam::value + 1) / 2);
}

TYPED_TEST(SimplexTable, a_facet_has_all_vertices_but_the_one_opposite) {
  using Table = Simplex<TypeParam::value>;
  for (int k = 0; k < Table::n_facets; ++k) {
    std::set<int> vertices(Table::facets[k].begin(), Table::facets[k].end());
    EXPECT_EQ(vertices.size(), TypeParam::value);
    EXPECT_TRUE(vertices.insert(k).second);
    EXPECT_EQ(*vertices.rbegin(), Table::n_vertices - 1);
  }
}

TYPED_TEST(SimplexTable, hat_masses_are_those_of_products_and_add_up_to_the_volume) {
  constexpr int d = TypeParam::value;
  using Table = Simplex<d>;
  int sum = 0;
  for (int i = 0; i <= d; ++i)
    for (int j = 0; j <= d; ++j) {
      std::array<int, d + 1> powers{};
      ++powers[i];
      ++powers[j];
      EXPECT_DOUBLE_EQ(Table::hat_mass(i, j), Table::hat_masses_of * monomial_mean(powers));
      EXPECT_NEAR(mean<d>([&](const auto& lambda) { return lambda[i] * lambda[j]; }), monomial_mean(powers), 1e-15);
      sum += Table::hat_mass(i, j);
    }
  EXPECT_EQ(sum, Table::hat_masses_of);
}

TYPED_TEST(SimplexTable, moments_of_quadratics_are_those_of_their_polynomials) {
  constexpr int d = TypeParam::value;
  using Table = Simplex<d>;
  for (int k = 0; k < Table::n_quadratic; ++k) {
    const double own = mean<d>([&](const auto& lambda) { return quadratic<d>(k, lambda); });
    EXPECT_NEAR(double(Table::quadratic_mean(k)) / Table::quadratic_means_of, own, 1e-15);
    for (int i = 0; i <= d; ++i) {
      const double with_hat = mean<d>([&](const auto& lambda) { return quadratic<d>(k, lambda) * lambda[i]; });
      EXPECT_NEAR(double(Table::quadratic_moment(k, i)) / Table::quadratic_moments_of, with_hat, 1e-15);
    }
  }
}

TYPED_TEST(SimplexTable, moments_of_linear_functions_are_exact) {
  constexpr int d = TypeParam::value;
  std::array<double, d + 1> f, g;
  for (int i = 0; i <= d; ++i) f[i] = 1 + i * i, g[i] = 3 - 2 * i;
  const auto linear = [](const auto& values, const auto& lambda) {
    double value = 0;
    for (int i = 0; i <= d; ++i) value += values[i] * lambda[i];
    return value;
  };
  for (int i = 0; i <= d; ++i)
    EXPECT_NEAR(hat_moment(f, i), mean<d>([&](const auto& lambda) { return lambda[i] * linear(f, lambda); }), 1e-14);
  for (int k = 0; k < Simplex<d>::n_quadratic; ++k)
    EXPECT_NEAR(quadratic_moment(f, k),
                mean<d>([&](const auto& lambda) { return quadratic<d>(k, lambda) * linear(f, lambda); }), 1e-14);
  EXPECT_NEAR(integral_of_product(f, g, 2),
              2 * mean<d>([&](const auto& lambda) { return linear(f, lambda) * linear(g, lambda); }), 1e-13);
}

template <class Dimension> struct SimplexInSpace : testing::Test {};
using Spaces = testing::Types<Dim<2>, Dim<3>>;
TYPED_TEST_SUITE(SimplexInSpace, Spaces);

TYPED_TEST(SimplexInSpace, facets_close_and_point_outward) {
  constexpr int dim = TypeParam::value;
  for (const Corners<dim>& x : simplices<dim>()) {
    const double size = volume<dim>(x);
    ASSERT_GT(size, 0);
    Vector<dim> sum = Vector<dim>::Zero();
    for (int k = 0; k <= dim; ++k) {
      const Vector<dim> outward = area_vector<dim>(facet<dim>(x, k));
      const Vector<dim> height = facet<dim>(x, k)[0] - x[k];
      EXPECT_NEAR(outward.dot(height), dim * size, 1e-14);  // base times height
      sum += outward;
    }
    EXPECT_LT(sum.norm(), 1e-15);
  }
}

TYPED_TEST(SimplexInSpace, hat_functions_are_one_at_their_own_vertex_only) {
  constexpr int dim = TypeParam::value;
  for (const Corners<dim>& x : simplices<dim>()) {
    const auto gradients = hat_gradients<dim>(x);
    for (int k = 0; k <= dim; ++k)
      for (int j = 0; j <= dim; ++j) EXPECT_NEAR(1 + gradients[k].dot(x[j] - x[k]), j == k, 1e-13);
  }
}

TYPED_TEST(SimplexInSpace, the_volume_is_that_of_an_affine_map) {
  constexpr int dim = TypeParam::value;
  EXPECT_DOUBLE_EQ(volume<dim>(simplices<dim>()[0]), 1 / std::tgamma(dim + 1));
  for (Corners<dim> x : simplices<dim>()) {
    const double before = volume<dim>(x);
    const Tensor<dim> map = Tensor<dim>::Random() + 2 * Tensor<dim>::Identity();
    for (Vector<dim>& corner : x) corner = map * corner + Vector<dim>::Ones();
    EXPECT_NEAR(volume<dim>(x), map.determinant() * before, 1e-13);
    std::swap(x[0], x[1]);
    EXPECT_NEAR(volume<dim>(x), -map.determinant() * before, 1e-13);
  }
}

/// The tensor of a stress: column j is its traction on e_j.
template <int dim> Tensor<dim> tensor(const Voigt<dim>& stress) {
  Tensor<dim> result;
  for (int j = 0; j < dim; ++j) result.col(j) = traction<dim>(stress, Vector<dim>::Unit(j));
  return result;
}

TYPED_TEST(SimplexInSpace, a_stress_is_a_symmetric_tensor_and_back) {
  constexpr int dim = TypeParam::value;
  for (int k = 0; k < n_voigt<dim>; ++k) {
    const Voigt<dim> stress = Voigt<dim>::Unit(k);
    const Tensor<dim> sigma = tensor<dim>(stress);
    EXPECT_EQ(sigma, sigma.transpose());
    for (int l = 0; l < n_voigt<dim>; ++l) {
      const auto& [i, j] = Simplex<dim>::voigt[l];
      EXPECT_EQ(sigma(i, j), k == l);
      EXPECT_EQ(i == j, l < dim);
    }
  }
}

TYPED_TEST(SimplexInSpace, stress_and_strain_do_the_work_of_their_tensors) {
  constexpr int dim = TypeParam::value;
  for (int times = 0; times < 10; ++times) {
    const Voigt<dim> stress = Voigt<dim>::Random();
    const Tensor<dim> gradient = Tensor<dim>::Random();
    EXPECT_NEAR(stress.dot(strain<dim>(gradient)), (tensor<dim>(stress).transpose() * gradient).trace(), 1e-15);
  }
}

TYPED_TEST(SimplexInSpace, rigid_motions_are_independent_and_strain_nothing) {
  constexpr int dim = TypeParam::value;
  constexpr int count = Simplex<dim>::n_rigid_motions;
  EXPECT_EQ(count, dim * (dim + 1) / 2);
  Eigen::Matrix<double, dim*(dim + 1), count> at_vertices_of_simplex;
  for (int m = 0; m < count; ++m) {
    RigidMotion<dim> motion;
    motion.centre = Vector<dim>::Constant(0.3);
    if (m < dim) motion.translation[m] = 1;
    if (m >= dim) motion.rotation[m - dim] = 1;
    const auto u = [&](const Vector<dim>& x) { return displacement(motion, x); };
    const Vector<dim> at_origin = u(Vector<dim>::Zero());
    Tensor<dim> gradient;
    at_vertices_of_simplex.col(m).template head<dim>() = at_origin;
    for (int j = 0; j < dim; ++j) {
      gradient.col(j) = u(Vector<dim>::Unit(j)) - at_origin;
      at_vertices_of_simplex.col(m).template segment<dim>(dim * (j + 1)) = u(Vector<dim>::Unit(j));
    }
    EXPECT_LT(strain<dim>(gradient).norm(), 1e-15);
    EXPECT_EQ(gradient.isZero(0), m < dim);
  }
  EXPECT_EQ(Eigen::FullPivLU<Eigen::MatrixXd>(at_vertices_of_simplex).rank(), count);
}

TYPED_TEST(SimplexInSpace, facets_begin_without_data) {
  constexpr int dim = TypeParam::value;
  const FacetData<dim> data;
  EXPECT_EQ(data.support, Support::traction);
  EXPECT_TRUE(data.normal.isZero(0));
  for (int i = 0; i < dim; ++i) {
    EXPECT_TRUE(data.traction[i].isZero(0) && data.correction[i].isZero(0) && data.displacement[i].isZero(0));
    EXPECT_TRUE(data.pressure[i] == 0 && data.normal_displacement[i] == 0);
  }
}

}  // namespace
}  // namespace bracket::scene
