// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/report/deformed.h"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/QR>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>

#include "scene/bernstein.h"
#include "scene/offsets.h"
#include "scene/on_facet.h"

namespace bracket::apps {
namespace {

using scene::Mesh;
using scene::Problem;
using scene::Vector;

template <int n> using Square = Eigen::Matrix<double, n, n>;

/// By what a contact's facet is to be shifted along its normal, by Bernstein coefficients on it.
template <int dim> struct Wanted {
  int facet;
  scene::FacetQuadratic<dim> shift;
};

template <int dim> std::vector<Wanted<dim>> wanted(const Problem<dim>& problem, double factor) {
  std::vector<Wanted<dim>> result;
  for (const scene::ContactFacetOf<dim>& contact : problem.contact) {
    Wanted<dim> first{contact.first, {}};
    if (contact.second >= 0) {
      result.push_back({contact.second, {}});
      const Vector<dim>& d = problem.facets[contact.first].normal;
      const auto a = scene::positions(problem.mesh, problem.mesh.boundary[contact.first].vertices);
      const auto b = scene::positions(problem.mesh, problem.mesh.boundary[contact.second].vertices);
      std::array<double, dim> apart;
      for (int i = 0; i < dim; ++i) apart[i] = (b[contact.meets[i]] - a[i]).dot(d);
      const std::vector<double> drawn = scene::linear_on_facet<double>(apart, 2);
      for (std::size_t k = 0; k < drawn.size(); ++k) first.shift[k] = drawn[k] - factor * contact.upper[k];
    }
    result.push_back(first);
  }
  return result;
}

/// What the shift of a vertex has to be: that along directions of contact and supports, and in what directions it is
/// free.
template <int dim> struct Bound {
  std::vector<Vector<dim>> direction;
  std::vector<double> amount;
  bool whole = false;  ///< at right angles to the directions, too
};

template <int dim> std::vector<Bound<dim>> bounds_of(const Problem<dim>& problem, const std::vector<Wanted<dim>>& all) {
  std::vector<Bound<dim>> result(problem.mesh.vertices.size());
  for (const Wanted<dim>& one : all)
    for (int i = 0; i < dim; ++i) {
      Bound<dim>& bound = result[problem.mesh.boundary[one.facet].vertices[i]];
      bound.direction.push_back(problem.facets[one.facet].normal);
      bound.amount.push_back(one.shift[dim == 2 ? 2 * i : i]);
      bound.whole = true;
    }
  for (std::size_t facet = 0; facet < problem.facets.size(); ++facet)
    for (const int vertex : problem.mesh.boundary[facet].vertices) {
      if (problem.facets[facet].support == scene::Support::sliding) {
        result[vertex].direction.push_back(problem.facets[facet].normal);
        result[vertex].amount.push_back(0);
      } else if (problem.facets[facet].support == scene::Support::fixed) {
        result[vertex].whole = true;  // contact may move it all the same: what lies on each other has to do so
      }
    }
  return result;
}

/// The least shift that meets the directions of a vertex; those that are nearly one, as along an arc, count as one.
template <int dim> Vector<dim> least_shift(const Bound<dim>& bound) {
  if (bound.direction.empty()) return Vector<dim>::Zero();
  const auto n = static_cast<Eigen::Index>(bound.direction.size());
  using Directions = Eigen::Matrix<double, Eigen::Dynamic, dim>;
  Directions directions(n, dim);
  for (Eigen::Index i = 0; i < n; ++i) directions.row(i) = bound.direction[i];
  Eigen::CompleteOrthogonalDecomposition<Directions> decomposition;
  decomposition.setThreshold(0.2);  // the sine of about 20 degrees, below which a contact line is no corner
  decomposition.compute(directions);
  return decomposition.solve(Eigen::Map<const Eigen::VectorXd>(bound.amount.data(), n));
}

/// The directions in which a vertex is free.
template <int dim> Square<dim> freedom(const Bound<dim>& bound) {
  if (bound.whole) return Square<dim>::Zero();
  Square<dim> free = Square<dim>::Identity();
  for (const Vector<dim>& direction : bound.direction) {  // those left by the ones before
    const Vector<dim> left = free * direction;
    if (left.norm() > 0.2) free -= left * left.transpose() / left.squaredNorm();
  }
  return free;
}

/// ∫ ∇φ_i·∇φ_j of the hat functions of a triangle or tetrahedron.
Square<3> laplacian(const std::array<Vector<2>, 3>& x) {
  const std::array<Vector<2>, 3> side = {x[2] - x[1], x[0] - x[2], x[1] - x[0]};
  Square<3> result;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) result(i, j) = side[i].dot(side[j]) / (4 * scene::volume<2>(x));
  return result;
}
Square<4> laplacian(const std::array<Vector<3>, 4>& x) {
  const auto gradient = scene::hat_gradients<3>(x);
  Square<4> result;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) result(i, j) = scene::volume<3>(x) * gradient[i].dot(gradient[j]);
  return result;
}

/// The harmonic field with what is given at vertices.
template <int dim> std::vector<Vector<dim>> extended(const Mesh<dim>& mesh, const std::vector<Bound<dim>>& bounds) {
  const auto n = static_cast<Eigen::Index>(mesh.vertices.size());
  std::vector<Square<dim>> free;
  Eigen::VectorXd given(dim * n);
  for (Eigen::Index v = 0; v < n; ++v) {
    free.push_back(freedom(bounds[v]));
    given.template segment<dim>(dim * v) = least_shift(bounds[v]);
  }
  // (F K F + 1 − F) q = −F K w of what is given, w; the field is w + F q.
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd right = Eigen::VectorXd::Zero(dim * n);
  const auto add = [&](int i, int j, const Square<dim>& block) {
    for (int k = 0; k < dim; ++k)
      for (int l = 0; l < dim; ++l) entries.emplace_back(dim * i + k, dim * j + l, block(k, l));
  };
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) {
    const auto& vertex = mesh.cells[cell];
    const Square<dim + 1> stiffness = laplacian(scene::positions(mesh, vertex));
    for (int i = 0; i <= dim; ++i)
      for (int j = 0; j <= dim; ++j) {
        const double k = stiffness(i, j);
        add(vertex[i], vertex[j], k * free[vertex[i]] * free[vertex[j]]);
        right.template segment<dim>(dim * vertex[i]) -=
            k * free[vertex[i]] * given.template segment<dim>(dim * vertex[j]);
      }
  }
  for (int v = 0; v < n; ++v) add(v, v, Square<dim>::Identity() - free[v]);
  Eigen::SparseMatrix<double> matrix(dim * n, dim * n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  Eigen::ConjugateGradient<Eigen::SparseMatrix<double>, Eigen::Lower | Eigen::Upper> solver(matrix);
  solver.setTolerance(1e-5);  // far below a pixel
  const Eigen::VectorXd found = solver.solve(right);
  std::vector<Vector<dim>> shift;
  for (Eigen::Index v = 0; v < n; ++v)
    shift.emplace_back(given.template segment<dim>(dim * v) + free[v] * found.template segment<dim>(dim * v));
  return shift;
}

template <int dim> double largest_gap(const Problem<dim>& problem) {
  double largest = 0;
  for (const scene::ContactFacetOf<dim>& contact : problem.contact)
    for (const double g : contact.upper) largest = std::max(largest, std::abs(g));
  return largest;
}

}  // namespace

template <int dim> double magnification(const Problem<dim>& problem, const scene::Displacement<dim>& displacement) {
  double largest = 0;
  for (const Vector<dim>& u : displacement.vertex) largest = std::max(largest, u.norm());
  if (largest == 0) return 1;
  const double gap = largest_gap(problem);
  double factor = 0.06 * problem.length_scale / largest;
  if (gap > 0) factor = std::min(factor, std::max(1.0, 0.12 * problem.length_scale / gap));
  const double unit = std::pow(10, std::floor(std::log10(factor)) - 1);
  return std::floor(factor / unit) * unit;
}

template <int dim> DrawnShapeOf<dim> drawn_shape(const Problem<dim>& problem, double factor) {
  DrawnShapeOf<dim> shape{factor, std::vector<Vector<dim>>(problem.mesh.vertices.size(), Vector<dim>::Zero()),
                          std::vector<scene::FacetQuadratic<dim>>(problem.mesh.boundary.size())};
  const std::vector<Wanted<dim>> all = wanted(problem, factor);
  const bool none =
      std::ranges::all_of(all, [](const Wanted<dim>& one) { return one.shift == scene::FacetQuadratic<dim>{}; });
  if (none) return shape;
  shape.shift = extended(problem.mesh, bounds_of(problem, all));
  for (const Wanted<dim>& one : all) {
    const Vector<dim>& d = problem.facets[one.facet].normal;
    std::array<double, dim> along;
    for (int i = 0; i < dim; ++i) along[i] = shape.shift[problem.mesh.boundary[one.facet].vertices[i]].dot(d);
    const std::vector<double> linear = scene::linear_on_facet<double>(along, 2);
    for (std::size_t k = 0; k < linear.size(); ++k) shape.beside[one.facet][k] = one.shift[k] - linear[k];
  }
  return shape;
}

#define INSTANTIATE(dim)                                                                      \
  template double magnification(const scene::Problem<dim>&, const scene::Displacement<dim>&); \
  template DrawnShapeOf<dim> drawn_shape(const scene::Problem<dim>&, double);
INSTANTIATE(2)
INSTANTIATE(3)
#undef INSTANTIATE

Vector<2> beside(const Problem<2>& problem, const DrawnShape& shape, int facet, double t) {
  const auto& coefficients = shape.beside[facet];
  return scene::value_on_segment(std::vector<double>(coefficients.begin(), coefficients.end()), t) *
         problem.facets[facet].normal;
}

Vector<2> drawn_on_facet(const Problem<2>& problem, const scene::Displacement<2>* displacement, const DrawnShape& shape,
                         int facet, double t) {
  const Mesh<2>& mesh = problem.mesh;
  const auto& [a, b] = mesh.boundary[facet].vertices;
  const Vector<2> x = (1 - t) * (mesh.vertices[a] + shape.shift[a]) + t * (mesh.vertices[b] + shape.shift[b]) +
                      beside(problem, shape, facet, t);
  if (displacement == nullptr) return x;
  std::array<double, 3> point = {0, 0, 0};
  point[scene::Simplex<2>::facets[mesh.boundary[facet].local][0]] = 1 - t;
  point[scene::Simplex<2>::facets[mesh.boundary[facet].local][1]] = t;
  return x + shape.factor * scene::displacement_at(mesh, *displacement, mesh.boundary[facet].cell, point);
}

Vector<2> drawn_opposite(const Problem<2>& problem, const scene::Displacement<2>* displacement, const DrawnShape& shape,
                         const scene::ContactFacet& contact, double t) {
  if (contact.second >= 0) return drawn_on_facet(problem, displacement, shape, contact.second, 1 - t);
  const auto& [a, b] = scene::positions(problem.mesh, problem.mesh.boundary[contact.first].vertices);
  const double gap = scene::value_on_segment(std::vector<double>(contact.upper.begin(), contact.upper.end()), t);
  return (1 - t) * a + t * b + shape.factor * gap * problem.facets[contact.first].normal;
}

Vector<2> drawn_in_cell(const Problem<2>& problem, const scene::Displacement<2>& displacement, const DrawnShape& shape,
                        int cell, const std::array<double, 3>& point) {
  Vector<2> x = shape.factor * scene::displacement_at(problem.mesh, displacement, cell, point);
  for (int k = 0; k < 3; ++k) {
    const int vertex = problem.mesh.cells[cell][k];
    x += point[k] * (problem.mesh.vertices[vertex] + shape.shift[vertex]);
  }
  return x;
}

}  // namespace bracket::apps
