// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/free_motions.h"

#include <algorithm>
#include <limits>

#include "scene/problem/law.h"
#include "scene/problem/stretch.h"

namespace bracket::bounds {

using scene::Vector;

template <int dim> FreeMotions<dim> all_free_motions(const scene::Problem<dim>& problem) {
  FreeMotions<dim> all;
  for (std::size_t b = 0; b < problem.mesh.components.size(); ++b)
    for (const auto& motion : scene::free_motions(problem, static_cast<int>(b))) {
      all.motion.push_back(motion);
      all.body.push_back(static_cast<int>(b));
    }
  return all;
}

namespace {

/// The points of a side where forces are thought to act, one for each vertex of the first facet, off it by `inset`, at
/// most to the middle.
template <int dim>
std::array<Vector<dim>, std::size_t{dim}> points_of(const scene::Problem<dim>& problem,
                                                    const scene::ContactFacetOf<dim>& pair, bool of_first,
                                                    double inset) {
  const auto& mesh = problem.mesh;
  const auto x = scene::positions(mesh, mesh.boundary[of_first ? pair.first : pair.second].vertices);
  std::array<Vector<dim>, dim> points;
  if constexpr (dim == 2) {
    const double t = std::min(0.5, inset / scene::length(mesh, pair.first));
    for (int i = 0; i < dim; ++i) points[i] = scene::between_ends(x, of_first == (i == 0) ? t : 1 - t);
  } else {
    const Vector<dim> middle = (x[0] + x[1] + x[2]) / dim;
    for (int i = 0; i < dim; ++i) {
      const Vector<dim> inward = middle - x[of_first ? i : pair.meets[i]];
      points[i] = middle - std::max(0.0, 1 - inset / inward.norm()) * inward;
    }
  }
  return points;
}

/// The jump along a direction at those points of a contact facet, u' − u'', under each motion: a row for each.
template <int dim>
Eigen::MatrixXd jumps(const scene::Problem<dim>& problem, const FreeMotions<dim>& all,
                      const scene::ContactFacetOf<dim>& pair, const Vector<dim>& direction, double inset) {
  const auto& mesh = problem.mesh;
  Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(dim, all.motion.size());
  for (const bool of_first : {true, false}) {
    const int side = of_first ? pair.first : pair.second;
    if (side < 0) continue;
    const auto points = points_of(problem, pair, of_first, inset);
    for (std::size_t m = 0; m < all.motion.size(); ++m)
      if (all.body[m] == mesh.cell_component[mesh.boundary[side].cell])
        for (int i = 0; i < dim; ++i)
          rows(i, m) += (of_first ? 1 : -1) * direction.dot(displacement(all.motion[m], points[i]));
  }
  return rows;
}

}  // namespace

template <int dim> Holding holding(const scene::Problem<dim>& problem, const FreeMotions<dim>& all, double inset) {
  constexpr double unlimited = std::numeric_limits<double>::infinity();
  const auto& contact = problem.contact;
  const auto n_normal = static_cast<Eigen::Index>(dim * contact.size());
  const auto rubbing =
      std::count_if(contact.begin(), contact.end(), [](const auto& pair) { return has_friction(pair.law); });
  const Eigen::Index n = n_normal + dim * rubbing;
  Holding result{Eigen::MatrixXd::Zero(n, all.motion.size()),
                 {Eigen::VectorXd::Zero(n), Eigen::VectorXd::Constant(n, unlimited)},
                 rubbing > 0};
  Eigen::Index slip = n_normal;
  for (std::size_t j = 0; j < contact.size(); ++j) {
    const auto& pair = contact[j];
    const Vector<dim>& d = problem.facets[pair.first].normal;
    result.rows.middleRows(dim * j, dim) = jumps(problem, all, pair, d, inset);
    if (pair.law.two_sided) result.limits.lower.segment(dim * j, dim).setConstant(-unlimited);
    if constexpr (dim == 2) {
      if (!has_friction(pair.law)) continue;
      result.rows.middleRows(slip, dim) = jumps<dim>(problem, all, pair, scene::tangent(d), inset);
      const double length = scene::length(problem.mesh, pair.first);
      for (int i = 0; i < dim; ++i, ++slip) {
        result.limits.upper[slip] = length * (2 * pair.law.friction[i] + pair.law.friction[1 - i]) / 6;
        result.limits.lower[slip] = -result.limits.upper[slip];
      }
    }
  }
  return result;
}

template <int dim> Holding holding_by_pressure(const scene::Problem<dim>& problem, const FreeMotions<dim>& all) {
  Holding result = holding(problem, all);
  auto slip = static_cast<Eigen::Index>(dim * problem.contact.size());
  for (std::size_t j = 0; j < problem.contact.size(); ++j) {
    const scene::FacetLaw& law = problem.contact[j].law;
    if (!has_friction(law)) continue;
    if (law.coulomb > 0) {
      const Eigen::MatrixXd pressed = result.rows.middleRows(dim * j, dim) / law.coulomb;
      const Eigen::MatrixXd sheared = result.rows.middleRows(slip, dim);
      result.rows.middleRows(dim * j, dim) = (pressed + sheared) / 2;
      result.rows.middleRows(slip, dim) = (pressed - sheared) / 2;
      result.limits.lower.segment(slip, dim).setZero();
      result.limits.upper.segment(slip, dim).setConstant(std::numeric_limits<double>::infinity());
    }
    slip += dim;
  }
  return result;
}

template <int dim> LoadWork load_work(const scene::Problem<dim>& problem, const FreeMotions<dim>& all) {
  const auto& mesh = problem.mesh;
  LoadWork result{Eigen::VectorXd::Zero(all.motion.size()), 0};
  const auto add = [&](int body, const Vector<dim>& force, const Vector<dim>& x) {
    for (std::size_t m = 0; m < all.motion.size(); ++m) {
      if (all.body[m] != body) continue;
      const double work = force.dot(displacement(all.motion[m], x));
      result.work[m] += work;
      result.size += std::abs(work);
    }
  };
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    const int body = mesh.cell_component[c];
    const Vector<dim>& force = body_of(problem, static_cast<int>(c)).force;
    if (force.isZero(0)) continue;
    Vector<dim> sum = mesh.vertices[mesh.cells[c][0]];
    for (int k = 1; k <= dim; ++k) sum += mesh.vertices[mesh.cells[c][k]];
    add(body, scene::volume(mesh, static_cast<int>(c)) * force, sum / (dim + 1));
  }
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    if (!scene::is_loaded(problem.facets[f])) continue;
    const auto& facet = mesh.boundary[f];
    const int body = mesh.cell_component[facet.cell];
    const auto ends = scene::load(problem, static_cast<int>(f));
    for (int i = 0; i < dim; ++i)  // a linear load on a linear motion
      add(body, scene::hat_moment(ends, i), mesh.vertices[facet.vertices[i]]);
    for (const Vector<dim>& beside :
         scene::higher_load(problem, static_cast<int>(f)))  // no work, in parts that have some
      for (std::size_t m = 0; m < all.motion.size(); ++m)
        for (int i = 0; i < dim && all.body[m] == body; ++i)
          result.size += beside.norm() / dim * displacement(all.motion[m], mesh.vertices[facet.vertices[i]]).norm();
  }
  return result;
}

// Each free motion moves points of its body by about 1, so that y says how far: what moves them by less than 1e-8 of
// the most is rounding of the loads, and would be told as a turn about a point far away.
template <int dim> Moved<dim> most_moved(const FreeMotions<dim>& all, const Eigen::VectorXd& y) {
  constexpr double negligible = 1e-8;
  Eigen::Index most = 0;
  y.cwiseAbs().maxCoeff(&most);
  const int body = all.body[most];
  scene::RigidMotion<dim> motion{Vector<dim>::Zero(), {}, all.motion[most].centre};
  const double unit = std::abs(y[most]);
  for (std::size_t m = 0; m < all.motion.size(); ++m) {
    if (all.body[m] != body || std::abs(y[m]) < negligible * unit) continue;
    motion.translation += y[m] / unit * all.motion[m].translation;
    for (std::size_t r = 0; r < motion.rotation.size(); ++r)
      motion.rotation[r] += y[m] / unit * all.motion[m].rotation[r];
  }
  return {body, motion};
}

template FreeMotions<2> all_free_motions(const scene::Problem<2>&);
template Holding holding(const scene::Problem<2>&, const FreeMotions<2>&, double);
template Holding holding_by_pressure(const scene::Problem<2>&, const FreeMotions<2>&);
template LoadWork load_work(const scene::Problem<2>&, const FreeMotions<2>&);
template Moved<2> most_moved(const FreeMotions<2>&, const Eigen::VectorXd&);
template FreeMotions<3> all_free_motions(const scene::Problem<3>&);
template Holding holding(const scene::Problem<3>&, const FreeMotions<3>&, double);
template LoadWork load_work(const scene::Problem<3>&, const FreeMotions<3>&);
template Moved<3> most_moved(const FreeMotions<3>&, const Eigen::VectorXd&);

}  // namespace bracket::bounds
