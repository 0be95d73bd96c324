// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/report/deformed.h"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/QR>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>

#include "scene/bernstein.h"
#include "scene/offsets.h"

namespace bracket::apps {
namespace {

using scene::Mesh;
using scene::Problem;
using scene::Vector;

/// By what a contact's facet is to be shifted along its normal, by Bernstein coefficients along it.
struct Wanted {
  int facet;
  std::array<double, 3> shift;
};

std::vector<Wanted> wanted(const Problem<2>& problem, double factor) {
  std::vector<Wanted> result;
  for (const scene::ContactFacet& contact : problem.contact) {
    Wanted first{contact.first, {}};
    if (contact.second >= 0) {
      result.push_back({contact.second, {}});
      const Vector<2>& d = problem.facets[contact.first].normal;
      const auto a = scene::positions(problem.mesh, problem.mesh.boundary[contact.first].vertices);
      const auto b = scene::positions(problem.mesh, problem.mesh.boundary[contact.second].vertices);
      const double from = (b[1] - a[0]).dot(d), to = (b[0] - a[1]).dot(d);  // the second side runs the other way
      for (int k = 0; k < 3; ++k)
        first.shift[k] = scene::linear_coefficient<double>(from, to, 2, k) - factor * contact.upper[k];
    }
    result.push_back(first);
  }
  return result;
}

/// What the shift of a vertex has to be: that along directions of contact and supports, and in what directions it is
/// free.
struct Bound {
  std::vector<Vector<2>> direction;
  std::vector<double> amount;
  bool whole = false;  ///< at right angles to the directions, too
};

std::vector<Bound> bounds_of(const Problem<2>& problem, const std::vector<Wanted>& all) {
  std::vector<Bound> result(problem.mesh.vertices.size());
  for (const Wanted& one : all)
    for (int end = 0; end < 2; ++end) {
      Bound& bound = result[problem.mesh.boundary[one.facet].vertices[end]];
      bound.direction.push_back(problem.facets[one.facet].normal);
      bound.amount.push_back(one.shift[2 * end]);
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
Vector<2> least_shift(const Bound& bound) {
  if (bound.direction.empty()) return Vector<2>::Zero();
  const auto n = static_cast<Eigen::Index>(bound.direction.size());
  Eigen::MatrixX2d directions(n, 2);
  for (Eigen::Index i = 0; i < n; ++i) directions.row(i) = bound.direction[i];
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixX2d> decomposition;
  decomposition.setThreshold(0.2);  // the sine of about 20 degrees, below which a contact line is no corner
  decomposition.compute(directions);
  return decomposition.solve(Eigen::Map<const Eigen::VectorXd>(bound.amount.data(), n));
}

/// The directions in which a vertex is free.
Eigen::Matrix2d freedom(const Bound& bound) {
  if (bound.whole) return Eigen::Matrix2d::Zero();
  Eigen::Matrix2d free = Eigen::Matrix2d::Identity();
  for (const Vector<2>& direction : bound.direction) {  // those left by the ones before
    const Vector<2> left = free * direction;
    if (left.norm() > 0.2) free -= left * left.transpose() / left.squaredNorm();
  }
  return free;
}

/// The harmonic field with what is given at vertices.
std::vector<Vector<2>> extended(const Mesh<2>& mesh, const std::vector<Bound>& bounds) {
  const auto n = static_cast<Eigen::Index>(mesh.vertices.size());
  std::vector<Eigen::Matrix2d> free;
  Eigen::VectorXd given(2 * n);
  for (Eigen::Index v = 0; v < n; ++v) {
    free.push_back(freedom(bounds[v]));
    given.segment<2>(2 * v) = least_shift(bounds[v]);
  }
  // (F K F + 1 − F) q = −F K w of what is given, w; the field is w + F q.
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd right = Eigen::VectorXd::Zero(2 * n);
  const auto add = [&](int i, int j, const Eigen::Matrix2d& block) {
    for (int k = 0; k < 2; ++k)
      for (int l = 0; l < 2; ++l) entries.emplace_back(2 * i + k, 2 * j + l, block(k, l));
  };
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) {
    const auto& vertex = mesh.cells[cell];
    const auto x = scene::positions(mesh, vertex);
    const std::array<Vector<2>, 3> side = {x[2] - x[1], x[0] - x[2], x[1] - x[0]};
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        const double k = side[i].dot(side[j]) / (4 * scene::volume(mesh, static_cast<int>(cell)));
        add(vertex[i], vertex[j], k * free[vertex[i]] * free[vertex[j]]);
        right.segment<2>(2 * vertex[i]) -= k * free[vertex[i]] * given.segment<2>(2 * vertex[j]);
      }
  }
  for (int v = 0; v < n; ++v) add(v, v, Eigen::Matrix2d::Identity() - free[v]);
  Eigen::SparseMatrix<double> matrix(2 * n, 2 * n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  Eigen::ConjugateGradient<Eigen::SparseMatrix<double>, Eigen::Lower | Eigen::Upper> solver(matrix);
  solver.setTolerance(1e-5);  // far below a pixel
  const Eigen::VectorXd found = solver.solve(right);
  std::vector<Vector<2>> shift;
  for (Eigen::Index v = 0; v < n; ++v) shift.emplace_back(given.segment<2>(2 * v) + free[v] * found.segment<2>(2 * v));
  return shift;
}

double largest_gap(const Problem<2>& problem) {
  double largest = 0;
  for (const scene::ContactFacet& contact : problem.contact)
    for (const double g : contact.upper) largest = std::max(largest, std::abs(g));
  return largest;
}

}  // namespace

double magnification(const Problem<2>& problem, const scene::Displacement<2>& displacement) {
  double largest = 0;
  for (const Vector<2>& u : displacement.vertex) largest = std::max(largest, u.norm());
  if (largest == 0) return 1;
  const double gap = largest_gap(problem);
  double factor = 0.06 * problem.length_scale / largest;
  if (gap > 0) factor = std::min(factor, std::max(1.0, 0.12 * problem.length_scale / gap));
  const double unit = std::pow(10, std::floor(std::log10(factor)) - 1);
  return std::floor(factor / unit) * unit;
}

DrawnShape drawn_shape(const Problem<2>& problem, double factor) {
  DrawnShape shape{factor, std::vector<Vector<2>>(problem.mesh.vertices.size(), Vector<2>::Zero()),
                   std::vector<std::array<double, 3>>(problem.mesh.boundary.size())};
  const std::vector<Wanted> all = wanted(problem, factor);
  const bool none = std::ranges::all_of(all, [](const Wanted& one) { return one.shift == std::array<double, 3>{}; });
  if (none) return shape;
  shape.shift = extended(problem.mesh, bounds_of(problem, all));
  for (const Wanted& one : all) {
    const auto& [a, b] = problem.mesh.boundary[one.facet].vertices;
    const Vector<2>& d = problem.facets[one.facet].normal;
    for (int k = 0; k < 3; ++k)
      shape.beside[one.facet][k] =
          one.shift[k] - scene::linear_coefficient<double>(shape.shift[a].dot(d), shape.shift[b].dot(d), 2, k);
  }
  return shape;
}

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
