// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <random>

#include "dual/dual.h"
#include "dual/local/small_blocks.h"
#include "dual/local/star_system.h"
#include "tests/support/problems_in_space.h"
#include "tests/support/scenes.h"

namespace bracket::dual {
namespace {

using scene::Problem;

constexpr double poissons[] = {0.3, 0.4999, 0.4999999};

template <int dim> Problem<dim> problem(double poisson, double flat);
template <> Problem<2> problem<2>(double poisson, double flat) {
  scene::Scene<2> s;
  s.blocks = {tests::block("b", 0, 1, 0, 1 / flat, 3, 3)};
  s.bodies = {{"b", scene::isotropic<2>(2, poisson, scene::Plane::strain)}};
  s.boundary = {{"b.left", tests::fixed(0, 0)}, {"b.bottom", tests::sliding(0)}};
  return tests::problem(s);
}
template <> Problem<3> problem<3>(double poisson, double flat) {
  Problem<3> result = tests::problem_on(tests::mesh_of({tests::Box{"b", {{{0, 1}, {0, 1}, {0, 1 / flat}}}, {2, 2, 2}}}),
                                        {{scene::isotropic<3>(2, poisson, scene::Plane::strain)}});
  tests::fix(result, "b.left", tests::nowhere());
  tests::slide(result, "b.back", tests::everywhere(0));
  return result;
}

template <int dim> Eigen::MatrixXd dense(const CellForm<dim>& form) {
  constexpr int one = n_facet_loads<dim>;
  Eigen::MatrixXd result(n_cell_loads<dim>, n_cell_loads<dim>);
  for (int i = 0; i <= dim; ++i)
    for (int k = 0; k <= dim; ++k) result.block(one * i, one * k, one, one) = form.rows_of(i, k);
  return result;
}

template <int dim> void expect_forms_of_cells() {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> number(-1, 1);
  for (const double poisson : poissons)
    for (const double flat : {1.0, 20.0}) {
      const Problem<dim> p = problem<dim>(poisson, flat);
      const Energy<dim> energy = energy_of(p, 1);
      const Eigen::MatrixXd h = dense<dim>(energy.loads), k = dense<dim>(energy.stiffness);
      // H is that of the stress itself: at its vertices and centroid a quadratic form is integrated exactly.
      CellVector<dim> loads;
      for (double& x : loads) x = number(random);
      const scene::Vector<dim> force = 0.3 * scene::Vector<dim>::Ones();
      const auto stress = stress_of<dim>(p.mesh.cells[1], geometry_of(p.mesh, 1), loads, force);
      const auto& compliance = body_of(p, 1).material.compliance();
      const auto of = [&](const scene::Voigt<dim>& s) { return s.dot(compliance * s); };
      double twice = 0;
      for (const auto& part : stress) {
        scene::Voigt<dim> sum = scene::Voigt<dim>::Zero();
        for (const auto& tensor : part) {
          const Eigen::Map<const scene::Voigt<dim>> t(tensor.data());
          sum += t;
          twice += of(t);
        }
        twice += of(sum);
      }
      twice *= scene::volume(p.mesh, 1) / ((dim + 1) * (dim + 1) * (dim + 2));
      const double of_force = twice - loads.dot(h * loads) - 2 * loads.dot(energy.by_body_force * force);
      const auto by_force = stress_of<dim>(p.mesh.cells[1], geometry_of(p.mesh, 1), CellVector<dim>::Zero(), force);
      const double expected = of(Eigen::Map<const scene::Voigt<dim>>(by_force[0][dim].data())) *
                              scene::volume(p.mesh, 1) * 2 / ((dim + 1) * (dim + 2));
      EXPECT_NEAR(of_force, expected, 1e-12 * twice) << poisson << " " << flat;
      const CellVector<dim> slope = h * loads;
      for (int corner = 0; corner <= dim; ++corner) {
        EXPECT_TRUE(
            (times<dim>(energy.loads, corner, loads) - on_spokes<dim>(corner, slope)).isZero(1e-12 * slope.norm()));
        const SpokeVector<dim> own = on_spokes<dim>(corner, loads);
        const CellVector<dim> by_own = h * on_cell<dim>(corner, own);
        constexpr int one = n_facet_loads<dim>;
        EXPECT_TRUE((opposite_times<dim>(energy.loads, corner, own) - by_own.template segment<one>(one * corner))
                        .isZero(1e-12 * by_own.norm()));
      }
      // k is its inverse on loads in balance, by as much as H can be told to be singular.
      const double rounding = 1e-14 * h.norm() * k.norm();
      EXPECT_LE((k * h * k - k).norm(), rounding * k.norm()) << poisson << " " << flat;
      // Motions and nothing else leave it without loads.
      const Eigen::VectorXd eigenvalue = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(k).eigenvalues();
      constexpr int m = scene::Simplex<dim>::n_rigid_motions;
      EXPECT_LE(eigenvalue.head(m).cwiseAbs().maxCoeff(), rounding * k.norm()) << poisson << " " << flat;
      EXPECT_GE(eigenvalue[m], 0.5 / h.norm()) << poisson << " " << flat;
    }
}
TEST(LocalForms, of_cells_are_those_of_their_stresses) {
  expect_forms_of_cells<2>();
  expect_forms_of_cells<3>();
}

/// \return the largest of what a star's loads lack of resultants and sums
template <int dim>
double lacking(const Problem<dim>& p, const Facets<dim>& facets, const Star<dim>& star, const StarData<dim>& data,
               const typename StarSystem<dim>::Solution& found) {
  constexpr int one = n_facet_loads<dim>, m = scene::Simplex<dim>::n_rigid_motions;
  double most = 0;
  std::vector<FacetVector<dim>> sum(star.spokes().size(), FacetVector<dim>::Zero());
  for (std::size_t c = 0; c < star.cells().size(); ++c) {
    Eigen::Matrix<double, m, 1> resultant = -data.resultant[c];
    for (int i = 0; i < dim; ++i) {
      const int f = star.spokes_of(c)[i];
      const FacetVector<dim> own = found.loads[c].template segment<one>(one * i);
      resultant += resultants<dim>(star.arms(f)) * own;
      sum[f] += own;
    }
    most = std::max(most, resultant.template lpNorm<Eigen::Infinity>());
  }
  for (std::size_t f = 0; f < sum.size(); ++f) {
    const auto& facet = facets.facet[star.spokes()[f]];
    if (facet.boundary >= 0 && facet.support == scene::Support::fixed) continue;
    FacetVector<dim> rest = sum[f] - data.sum[f];
    if (facet.boundary >= 0 && facet.support == scene::Support::sliding)
      for (int k = 0; k < dim; ++k) {
        const scene::Vector<dim> d = p.facets[facet.boundary].normal;
        rest.template segment<dim>(dim * k) -= d * d.dot(rest.template segment<dim>(dim * k)) / d.squaredNorm();
      }
    most = std::max(most, rest.template lpNorm<Eigen::Infinity>());
  }
  return most;
}

template <int dim> void expect_balance() {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> number(-1, 1);
  for (const double poisson : poissons)
    for (const double flat : {1.0, 20.0}) {
      const Problem<dim> p = problem<dim>(poisson, flat);
      const Facets<dim> facets = facets_of(p);
      const Stars stars = stars_of(p.mesh);
      Energies<dim> energy;
      for (std::size_t c = 0; c < p.mesh.cells.size(); ++c) energy.push_back(energy_of(p, static_cast<int>(c)));
      double condition = 0, load = 0;  // the largest of all stars
      for (const Energy<dim>& one : energy)
        condition = std::max(condition, dense<dim>(one.loads).norm() * dense<dim>(one.stiffness).norm());
      std::vector<double> missing;
      for (std::size_t v = 0; v < p.mesh.vertices.size(); ++v) {
        const Star<dim> star(p, facets, stars, static_cast<int>(v));
        const StarSystem<dim> system(star, energy);
        StarData<dim> data(star), second(star);
        for (std::size_t c = 0; c < star.cells().size(); ++c)
          for (auto* of : {&data, &second})
            for (double& x : of->gradient[c]) x = number(random);
        const auto found = system.solve(data), other = system.solve(second);
        missing.push_back(lacking<dim>(p, facets, star, data, found));
        for (const auto& loads : found.loads) load = std::max(load, loads.template lpNorm<Eigen::Infinity>());
        // Of least energy: what other loads in balance gain to first order is nothing.
        double gain = 0, size = 0;
        for (std::size_t c = 0; c < star.cells().size(); ++c) {
          const int corner = star.corner(c);
          const SpokeVector<dim> slope =
              times<dim>(energy[star.cells()[c]].loads, corner, found.loads[c]) + data.gradient[c];
          gain += slope.dot(other.loads[c]);
          size += data.gradient[c].norm() * (other.loads[c].norm() + 1e-16 * load);
        }
        EXPECT_LE(std::abs(gain), 1e-14 * condition * size) << dim << " " << poisson << " " << flat << " " << v;
      }
      for (const double one : missing) EXPECT_LE(one, 1e-13 * load) << dim << " " << poisson << " " << flat;
    }
}
TEST(LocalStar, is_in_balance_to_rounding_however_stiff_or_flat_its_cells_are) {
  expect_balance<2>();
  expect_balance<3>();
}

/// A block against a wall, its data by one number.
template <int dim> Problem<dim> pressed(double by);
template <> Problem<2> pressed<2>(double by) {
  scene::Scene<2> s;
  s.blocks = {tests::block("b", 0, 1, 0, 1, 4, 4)};
  s.bodies = {{"b", scene::isotropic<2>(2, 0.3, scene::Plane::strain)}};
  s.boundary = {{"b.left", tests::fixed(0.1 * by, 0)}, {"b.right", tests::sliding(-0.2 * by)}};
  s.boundary["b.top"] = tests::pressure(0.3 + by);
  s.contact = {{"b.bottom", "rigid", 0.01 * by, ""}};
  return tests::problem(s);
}
template <> Problem<3> pressed<3>(double by) {
  Problem<3> result = tests::problem_on(tests::mesh_of({tests::Box{"b", {{{0, 1}, {0, 1}, {0, 1}}}, {2, 2, 2}}}),
                                        {{scene::isotropic<3>(2, 0.3, scene::Plane::strain)}});
  tests::fix(result, "b.left", [=](const scene::Vector<3>&) { return scene::Vector<3>(0.1 * by, 0, 0); });
  tests::slide(result, "b.right", tests::everywhere(-0.2 * by));
  tests::load(result, "b.top", [=](const scene::Vector<3>& x) { return scene::Vector<3>(0, -0.3 - by * x[0], 0); });
  tests::touch(result, "b.bottom", "", tests::everywhere(0.01 * by));
  return result;
}

/// The largest difference of two stresses by the largest of them.
template <int dim> double difference(const scene::Stress<dim>& a, const scene::Stress<dim>& b) {
  double most = 0, largest = 0;
  for (std::size_t c = 0; c < a.cell.size(); ++c)
    for (std::size_t i = 0; i < a.cell[c].size(); ++i) {
      most = std::max(most, (a.cell[c][i] - b.cell[c][i]).cwiseAbs().maxCoeff());
      largest = std::max(largest, a.cell[c][i].cwiseAbs().maxCoeff());
    }
  EXPECT_GT(largest, 0);
  return most / largest;
}

/// What is kept of one problem, which is gone, serves others as if it were made for them, alone and together.
template <int dim> void expect_the_same_with_what_is_kept() {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> number(-0.1, 0.1);
  const LocalSolver<dim> kept(Problem<dim>(pressed<dim>(0)), true);
  const std::array<Problem<dim>, 3> problems = {pressed<dim>(0), pressed<dim>(1), pressed<dim>(-0.7)};
  std::array<scene::Displacement<dim>, 3> u;
  std::array<typename LocalSolver<dim>::Pressure, 3> pressure;
  std::vector<typename LocalSolver<dim>::Start> starts;
  std::vector<Result<dim>> alone;
  for (std::size_t i = 0; i < problems.size(); ++i) {
    const Problem<dim>& problem = problems[i];
    u[i].degree = 2;
    for (std::size_t v = 0; v < problem.mesh.vertices.size(); ++v)
      u[i].vertex.push_back(number(random) * scene::Vector<dim>::Ones());
    for (std::size_t e = 0; e < problem.mesh.edges.size(); ++e)
      u[i].edge.push_back(number(random) * scene::Vector<dim>::Ones());
    pressure[i].resize(problem.contact.size());
    for (auto& facet : pressure[i])
      for (double& p : facet) p = std::max(0.0, number(random));
    starts.push_back({problem, pressure[i], u[i]});
    const Result<dim> once = local(problem, pressure[i], u[i], 1);
    alone.push_back(kept.solve(problem, pressure[i], u[i], 1));
    ASSERT_EQ(once.reason + alone[i].reason, "");
    EXPECT_LE(difference(once.stress, alone[i].stress), 1e-12) << dim << " " << i;
    EXPECT_EQ(once.statistics.unknowns, alone[i].statistics.unknowns);
  }
  const std::vector<Result<dim>> together = kept.solve(starts, 1);
  ASSERT_EQ(together.size(), alone.size());
  for (std::size_t i = 0; i < alone.size(); ++i) {
    ASSERT_EQ(together[i].reason, "");
    EXPECT_EQ(difference(alone[i].stress, together[i].stress), 0) << dim << " " << i;
    EXPECT_EQ(alone[i].statistics.active_rows, together[i].statistics.active_rows);
  }
}
TEST(LocalSolver, solves_any_data_with_what_it_keeps) {
  expect_the_same_with_what_is_kept<2>();
  expect_the_same_with_what_is_kept<3>();
}

/// a, b and a definite one, by the kernels of so many lanes: c − a bᵀ, the lower half of c − a aᵀ, L, c L⁻ᵀ.
template <int lanes, class Block>
std::array<Block, 4> by_kernels(const Block& a, const Block& b, const Block& definite) {
  const Block c = a.transpose() + b;
  std::array<Block, 4> result = {c, c, definite, c};
  subtract_product<lanes>(result[0], a, b);
  subtract_square<lanes>(result[1], a);
  EXPECT_TRUE(factorise(result[2]));
  divide<lanes>(result[3], result[2]);
  for (const int i : {1, 2}) result[i] = Block(result[i].template triangularView<Eigen::Lower>());
  return result;
}
template <int n> void expect_blocks_are_right() {
  using Block = Eigen::Matrix<double, n, n>;
  const Block a = Block::Random(), b = Block::Random(), c = a.transpose() + b,
              definite = a * a.transpose() + Block::Identity();
  const auto [product, square, factor, quotient] = by_kernels<2>(a, b, definite);
  Block root = factor;
  root.diagonal() = factor.diagonal().cwiseInverse();
  const double rounding = 100 * n * n * std::numeric_limits<double>::epsilon();
  EXPECT_LE((product - (c - a * b.transpose())).cwiseAbs().maxCoeff(), rounding);
  EXPECT_LE((square - Block((c - a * a.transpose()).template triangularView<Eigen::Lower>())).cwiseAbs().maxCoeff(),
            rounding);
  EXPECT_LE((root * root.transpose() - definite).cwiseAbs().maxCoeff(), rounding);
  EXPECT_LE((quotient * root.transpose() - c).cwiseAbs().maxCoeff(), rounding);
  EXPECT_EQ(by_kernels<4>(a, b, definite), by_kernels<2>(a, b, definite));
}
TEST(SmallBlocks, are_what_they_say_and_do_not_depend_on_the_machine) {
  expect_blocks_are_right<4>();
  expect_blocks_are_right<9>();
}

}  // namespace
}  // namespace bracket::dual
