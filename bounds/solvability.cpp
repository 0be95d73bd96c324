// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "bounds/bounds.h"
#include "primal/primal.h"

namespace bracket::bounds {

using scene::Support;
using scene::Vector;

namespace {

/// The rigid motions that the supports leave to all bodies, side by side.
template <int dim> struct Motions {
  std::vector<scene::RigidMotion<dim>> motion;
  std::vector<int> body;
};

template <int dim> Motions<dim> all_free_motions(const scene::Problem<dim>& problem) {
  Motions<dim> all;
  for (std::size_t b = 0; b < problem.bodies.size(); ++b)
    for (const auto& motion : scene::free_motions(problem, static_cast<int>(b))) {
      all.motion.push_back(motion);
      all.body.push_back(static_cast<int>(b));
    }
  return all;
}

/// The approach of the contact sides under each motion, at the ends of each contact facet: a pressure on a facet can be
/// replaced by forces at its ends.
template <int dim> Eigen::MatrixXd approaches(const scene::Problem<dim>& problem, const Motions<dim>& all) {
  const auto& mesh = problem.mesh;
  Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(dim * problem.contact.size(), all.motion.size());
  for (std::size_t j = 0; j < problem.contact.size(); ++j) {
    const auto& pair = problem.contact[j];
    const auto& first = mesh.boundary[pair.first];
    const Vector<dim> d = problem.facets[pair.first].normal;
    for (std::size_t m = 0; m < all.motion.size(); ++m) {
      double sign = 0;
      if (all.body[m] == mesh.cell_body[first.cell]) sign += 1;
      if (pair.second >= 0 && all.body[m] == mesh.cell_body[mesh.boundary[pair.second].cell]) sign -= 1;
      for (int i = 0; i < dim; ++i)
        rows(dim * j + i, m) = sign * d.dot(displacement(all.motion[m], mesh.vertices[first.vertices[i]]));
    }
  }
  return rows;
}

/// The work of the loads in each motion, and the sum of its parts' sizes.
struct Loads {
  Eigen::VectorXd work;
  double size = 0;
};

template <int dim> Loads loads(const scene::Problem<dim>& problem, const Motions<dim>& all) {
  const auto& mesh = problem.mesh;
  Loads result{Eigen::VectorXd::Zero(all.motion.size()), 0};
  const auto add = [&](int body, const Vector<dim>& force, const Vector<dim>& x) {
    for (std::size_t m = 0; m < all.motion.size(); ++m) {
      if (all.body[m] != body) continue;
      const double work = force.dot(displacement(all.motion[m], x));
      result.work[m] += work;
      result.size += std::abs(work);
    }
  };
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    const int body = mesh.cell_body[c];
    if (problem.bodies[body].force.isZero(0)) continue;
    const auto& v = mesh.cells[c];
    add(body, scene::volume(mesh, static_cast<int>(c)) * problem.bodies[body].force,
        (mesh.vertices[v[0]] + mesh.vertices[v[1]] + mesh.vertices[v[2]]) / 3);
  }
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    const auto& data = problem.facets[f];
    if (data.support != Support::traction) continue;
    const auto& facet = mesh.boundary[f];
    // A linear traction on a linear motion: hat-function moments at the ends.
    const double sixth = scene::length(mesh, static_cast<int>(f)) / 6;
    for (int i = 0; i < dim; ++i)
      add(mesh.cell_body[facet.cell], sixth * (2 * data.traction[i] + data.traction[1 - i]),
          mesh.vertices[facet.vertices[i]]);
  }
  return result;
}

/// The body that a motion moves most, and how. Each free motion moves points of its body by about 1, so that y says how
/// far: what moves them by less than 1e-8 of the most is rounding of the loads, and would be told as a turn about a
/// point far away.
template <int dim>
std::string explain(const scene::Problem<dim>& problem, const Motions<dim>& all, const Eigen::VectorXd& y) {
  constexpr double negligible = 1e-8;
  Eigen::Index most = 0;
  y.cwiseAbs().maxCoeff(&most);
  const int body = all.body[most];
  scene::RigidMotion<dim> motion{Vector<dim>::Zero(), 0, all.motion[most].centre};
  const double unit = std::abs(y[most]);
  for (std::size_t m = 0; m < all.motion.size(); ++m) {
    if (all.body[m] != body || std::abs(y[m]) < negligible * unit) continue;
    motion.translation += y[m] / unit * all.motion[m].translation;
    motion.rotation += y[m] / unit * all.motion[m].rotation;
  }
  return fmt::format("body '{}' is pushed off: {} gains energy without end", problem.mesh.bodies[body],
                     scene::describe(motion));
}

}  // namespace

template <int dim> double check_solvability(const scene::Problem<dim>& problem, int degree) {
  primal::check_prescribed(problem, degree);
  const Motions<dim> all = all_free_motions(problem);
  if (all.motion.empty()) return 0;
  const Eigen::MatrixXd rows = approaches(problem, all);
  const Loads given = loads(problem, all);
  if (given.size == 0) return 0;
  const contact::Balance balance = contact::balance(rows, given.work, given.size);
  if (!balance.possible)
    throw scene::Error(scene::Status::ill_posed,
                       explain(problem, all, balance.motion) +
                           "; support it, or change the loads so that pressure balances them");
  return (given.work - rows.transpose() * balance.pressure).cwiseAbs().maxCoeff() / given.size;
}

template double check_solvability(const scene::Problem<2>&, int);

}  // namespace bracket::bounds
