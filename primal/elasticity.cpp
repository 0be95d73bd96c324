// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "primal/elasticity.h"

#include <deal.II/base/polynomials_barycentric.h>
#include <deal.II/base/quadrature_lib.h>

#include "scene/bernstein.h"
#include "scene/voigt.h"

namespace bracket::primal {

namespace {

/// ∫ ∂_a B_i ∂_b B_j over the triangle (0,0), (1,0), (0,1), by 2 a + b: what the cells of a degree share.
using Products = std::array<Eigen::MatrixXd, 4>;

Products make_products(int degree) {
  std::vector<std::array<dealii::BarycentricPolynomial<2>, 2>> slopes;
  for (const auto& i : scene::bernstein_indices(degree)) {
    const int trinomial = scene::binomial(degree, i[0]) * scene::binomial(i[1] + i[2], i[1]);
    dealii::TableIndices<3> powers;
    for (int corner = 0; corner < 3; ++corner) powers[corner] = i[corner];
    const dealii::BarycentricPolynomial<2> polynomial(powers, trinomial);
    slopes.push_back({polynomial.derivative(0), polynomial.derivative(1)});
  }
  const dealii::QWitherdenVincentSimplex<2> quadrature(degree);  // exact up to degree 2 degree − 1
  const auto n = static_cast<Eigen::Index>(slopes.size());
  Products products;
  for (Eigen::MatrixXd& each : products) each.setZero(n, n);
  Eigen::MatrixXd at(2, n);
  for (unsigned int q = 0; q < quadrature.size(); ++q) {
    for (Eigen::Index i = 0; i < n; ++i)
      for (int a = 0; a < 2; ++a) at(a, i) = slopes[i][a].value(quadrature.point(q));
    for (int a = 0; a < 2; ++a)
      for (int b = 0; b < 2; ++b) products[2 * a + b] += quadrature.weight(q) * at.row(a).transpose() * at.row(b);
  }
  return products;
}

const Products& products(int degree) {
  static const std::array<Products, 4> of_degree = {make_products(1), make_products(2), make_products(3),
                                                    make_products(4)};
  return of_degree.at(degree - 1);
}

}  // namespace

template <int dim>
void for_each_cell(const scene::Problem<dim>& problem, int component, int degree, const UseCell& use) {
  static_assert(dim == 2, "the Bernstein polynomials are those of a triangle");
  const auto& mesh = problem.mesh;
  const Products& reference = products(degree);
  const Eigen::Index n = reference[0].rows();
  Eigen::MatrixXd stiffness(dim * n, dim * n);
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    if (mesh.cell_component[c] != component) continue;
    const int cell = static_cast<int>(c);
    const auto gradient = scene::hat_gradients<dim>(scene::positions(mesh, mesh.cells[c]));
    Eigen::Matrix<double, scene::n_voigt<dim>, dim * dim> strain;  // of unit slopes of each component
    for (int a = 0; a < dim; ++a)
      for (int k = 0; k < dim; ++k) {
        Eigen::Matrix<double, dim, dim> of_displacement = Eigen::Matrix<double, dim, dim>::Zero();
        of_displacement.row(k) = gradient[a + 1].transpose();
        strain.col(dim * a + k) = scene::strain<dim>(of_displacement);
      }
    const Eigen::Matrix<double, dim * dim, dim* dim> form =
        2 * scene::volume(mesh, cell) * (strain.transpose() * body_of(problem, cell).material.stiffness() * strain);
    for (int k = 0; k < dim; ++k)
      for (int l = 0; l < dim; ++l) {
        auto entries = stiffness(Eigen::seqN(k, n, dim), Eigen::seqN(l, n, dim));
        entries.setZero();
        for (int a = 0; a < dim; ++a)
          for (int b = 0; b < dim; ++b) entries += form(dim * a + k, dim * b + l) * reference[dim * a + b];
      }
    use(cell, stiffness);
  }
}

template void for_each_cell(const scene::Problem<2>&, int, int, const UseCell&);

}  // namespace bracket::primal
