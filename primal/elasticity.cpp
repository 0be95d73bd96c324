// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "primal/elasticity.h"

#include "primal/reference_products.h"
#include "scene/bernstein.h"
#include "scene/voigt.h"

namespace bracket::primal {

template <int dim>
void set_cell_stiffness(const std::array<scene::Vector<dim>, dim + 1>& corners,
                        const scene::Elasticity<dim>& elasticity, int degree, Eigen::MatrixXd& stiffness) {
  using Products = Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>;
  const Eigen::Index n = scene::n_bernstein<dim>(degree);
  const auto reference = [&](int a, int b) {
    return Products(reference_products<dim>(degree) + (dim * a + b) * n * n, n, n);
  };
  constexpr int by_volume = dim == 2 ? 2 : 6;  // of the reference cell
  const auto gradient = scene::hat_gradients<dim>(corners);
  Eigen::Matrix<double, scene::n_voigt<dim>, dim * dim> strain;  // of unit slopes of each component
  for (int a = 0; a < dim; ++a)
    for (int k = 0; k < dim; ++k) {
      Eigen::Matrix<double, dim, dim> of_displacement = Eigen::Matrix<double, dim, dim>::Zero();
      of_displacement.row(k) = gradient[a + 1].transpose();
      strain.col(dim * a + k) = scene::strain<dim>(of_displacement);
    }
  const Eigen::Matrix<double, dim * dim, dim* dim> form =
      by_volume * scene::volume<dim>(corners) * (strain.transpose() * elasticity * strain);
  stiffness.resize(dim * n, dim * n);
  for (int k = 0; k < dim; ++k)
    for (int l = 0; l < dim; ++l) {
      auto entries = stiffness(Eigen::seqN(k, n, dim), Eigen::seqN(l, n, dim));
      entries.setZero();
      for (int a = 0; a < dim; ++a)
        for (int b = 0; b < dim; ++b) entries += form(dim * a + k, dim * b + l) * reference(a, b);
    }
}

template <int dim>
void for_each_cell(const scene::Problem<dim>& problem, int component, int degree, const UseCell& use) {
  const auto& mesh = problem.mesh;
  Eigen::MatrixXd stiffness;
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    if (mesh.cell_component[c] != component) continue;
    const int cell = static_cast<int>(c);
    set_cell_stiffness<dim>(scene::positions(mesh, mesh.cells[c]), body_of(problem, cell).material.stiffness(), degree,
                            stiffness);
    use(cell, stiffness);
  }
}

template void set_cell_stiffness<2>(const std::array<scene::Vector<2>, 3>&, const scene::Elasticity<2>&, int,
                                    Eigen::MatrixXd&);
template void set_cell_stiffness<3>(const std::array<scene::Vector<3>, 4>&, const scene::Elasticity<3>&, int,
                                    Eigen::MatrixXd&);
template void for_each_cell(const scene::Problem<2>&, int, int, const UseCell&);
template void for_each_cell(const scene::Problem<3>&, int, int, const UseCell&);

}  // namespace bracket::primal
