// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// In space; solvability.cpp has the twin of the plane.
#include <fmt/format.h>

#include <limits>

#include "bounds/bounds.h"
#include "bounds/certificate/space/corrections.h"
#include "bounds/certificate/space/links.h"
#include "bounds/free_motions.h"
#include "primal/primal.h"

namespace bracket::bounds {

namespace {

using scene::Problem;
using scene::Support;
using scene::Vector;

/// By how much, as a force, loads may lack balance that are meant to have it. Twofold, as moments have it once more.
struct ImbalanceInSpace {
  double in_doubles = 0;  ///< by the rounding of sums and coordinates in double precision
  double explained = 0;   ///< also by the digits of the mesh file, and by directions that stand for other normals
  double largest = 0;     ///< force on a facet or cell
};

ImbalanceInSpace possible_imbalance(const Problem<3>& problem) {
  const auto& mesh = problem.mesh;
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  const double terms = static_cast<double>(mesh.boundary.size() + mesh.cells.size()) + 64;  // and those of each value
  double farthest = 0, size = 0, per_length = 0, traction = 0, turned = 0, largest = 0;
  double shortest = std::numeric_limits<double>::infinity();
  for (const auto& [a, b] : mesh.edges) shortest = std::min(shortest, (mesh.vertices[b] - mesh.vertices[a]).norm());
  for (const Vector<3>& x : mesh.vertices) farthest = std::max(farthest, x.cwiseAbs().maxCoeff());
  const auto include = [&](double force, double length) {
    size += force;
    per_length += force / length;
    largest = std::max(largest, force);
  };
  for (std::size_t c = 0; c < mesh.cells.size(); ++c)
    include(body_of(problem, static_cast<int>(c)).force.norm() * scene::volume(mesh, static_cast<int>(c)),
            problem.length_scale);
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    const int facet = static_cast<int>(f);
    const double area = scene::length(mesh, facet);
    const auto& data = problem.facets[f];
    if (scene::is_loaded(data)) {
      double force = 0;
      for (const Vector<3>& at_vertex : scene::load(problem, facet)) force = std::max(force, at_vertex.norm());
      include(force, std::sqrt(area));
      traction = std::max(traction, force / area);
    }
    if (data.support == Support::sliding || data.support == Support::contact)
      turned += area * (scene::normal(mesh, facet) - data.normal).norm();
  }
  traction += size / (problem.length_scale * problem.length_scale);  // pressure of what the contact carries
  const double in_doubles = 2 * (terms * epsilon * size + per_length * epsilon * farthest);
  // Digits that would move nodes by more than a thousandth of the shortest edge are what is meant.
  const double digits = mesh.coordinate_rounding * farthest;
  return {in_doubles, in_doubles + 2 * (per_length * (digits <= 1e-3 * shortest ? digits : 0) + traction * turned),
          largest};
}

using FacetLoad = std::array<Vector<3>, 3>;

/// The unit loads that a facet of Γ_τ can be given, density times area at its vertices: uniform along the axes, and
/// turning about its middle.
std::array<FacetLoad, 6> unit_loads(const scene::Mesh<3>& mesh, int facet) {
  const auto x = scene::positions(mesh, mesh.boundary[facet].vertices);
  const Vector<3> middle = (x[0] + x[1] + x[2]) / 3;
  const double size = std::sqrt(scene::length(mesh, facet));
  std::array<FacetLoad, 6> result;
  for (int k = 0; k < 3; ++k)
    for (int i = 0; i < 3; ++i) {
      result[k][i] = Vector<3>::Unit(k);
      result[3 + k][i] = Vector<3>::Unit(k).cross(x[i] - middle) / size;
    }
  return result;
}

double work(const scene::Mesh<3>& mesh, int facet, const FacetLoad& load, const scene::RigidMotion<3>& motion) {
  double sum = 0;
  for (int i = 0; i < 3; ++i)
    sum += scene::hat_moment(load, i).dot(displacement(motion, mesh.vertices[mesh.boundary[facet].vertices[i]]));
  return sum;
}

/// Unit loads that are candidates for corrections, and their work in each motion.
struct Candidates {
  std::vector<scene::Correction<3>> load;
  Eigen::MatrixXd work;  ///< motions × loads
};
/// On the facets of bodies that can be loaded; a body with none on Γ_τ has no load but its weight, and what is to be
/// taken off must be zero to the last bit: on facets of Γ_K.
Candidates candidates(const Problem<3>& problem, const FreeMotions<3>& all) {
  const auto& mesh = problem.mesh;
  std::vector<char> can_be_loaded(mesh.components.size(), 0);
  const auto component = [&](std::size_t f) { return mesh.cell_component[mesh.boundary[f].cell]; };
  for (std::size_t f = 0; f < problem.facets.size(); ++f)
    can_be_loaded[component(f)] |= problem.facets[f].support == Support::traction;
  Candidates result;
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    if (problem.facets[f].support != (can_be_loaded[component(f)] ? Support::traction : Support::contact)) continue;
    for (const FacetLoad& unit : unit_loads(mesh, static_cast<int>(f)))
      result.load.push_back({static_cast<int>(f), unit});
  }
  result.work = Eigen::MatrixXd::Zero(all.motion.size(), result.load.size());
  for (std::size_t k = 0; k < result.load.size(); ++k)
    for (std::size_t m = 0; m < all.motion.size(); ++m)
      if (all.body[m] == component(result.load[k].facet))
        result.work(m, k) = work(mesh, result.load[k].facet, result.load[k].unit, all.motion[m]);
  return result;
}

Problem<3> without_corrections(Problem<3> problem) {
  problem.corrections.clear();
  problem.carries.clear();
  problem.imbalance = 0;
  for (auto& facet : problem.facets) facet.correction.fill(Vector<3>::Zero());
  return problem;
}

/// An orthonormal basis of the combinations of motions that the pairs that carry do not resist.
Eigen::MatrixXd unresisted(const Problem<3>& problem, const Eigen::MatrixXd& rows) {
  Eigen::MatrixXd of_carrying = rows;
  for (std::size_t j = 0; j < problem.contact.size(); ++j)
    if (!problem.carries[problem.contact[j].pair] && !problem.contact[j].law.two_sided)
      of_carrying.middleRows<3>(3 * static_cast<Eigen::Index>(j)).setZero();
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(of_carrying.transpose());
  qr.setThreshold(1e-9);  // as scene::free_motions()
  const Eigen::MatrixXd q = qr.householderQ();
  return q.rightCols(q.cols() - qr.rank());
}

/// The problem with corrections along all motions that neither supports nor the pairs that the loads need act on.
/// \param pressure that balances the loads but for what is explained, as rows of holding()
/// \param rounding what a pair carries at most if it carries nothing
Problem<3> with_corrections(Problem<3> problem, const FreeMotions<3>& all, const Holding& holding,
                            const Eigen::VectorXd& pressure, const ImbalanceInSpace& imbalance) {
  for (const auto& pair : problem.contact)
    problem.carries.resize(std::max<std::size_t>(problem.carries.size(), pair.pair + 1), 0);
  std::vector<double> force(problem.carries.size(), 0);
  for (std::size_t j = 0; j < problem.contact.size(); ++j)
    force[problem.contact[j].pair] += problem.contact[j].law.two_sided
                                          ? std::numeric_limits<double>::infinity()
                                          : pressure.segment<3>(3 * static_cast<Eigen::Index>(j)).sum();
  for (std::size_t pair = 0; pair < force.size(); ++pair) problem.carries[pair] = force[pair] > imbalance.in_doubles;
  const int unheld = space::unheld_motions(problem, problem.carries);
  if (unheld == 0) {
    problem.carries.clear();
    return problem;
  }
  const auto hidden = [] {
    return scene::Error(scene::Status::not_guaranteed,
                        "rounding hides how a body is held: supports or contacts act on its motion by rounding only");
  };
  const Eigen::MatrixXd motions = unresisted(problem, holding.rows);
  if (motions.cols() != unheld) throw hidden();
  const Candidates all_loads = candidates(problem, all);
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(motions.transpose() * all_loads.work);
  if (qr.rank() < unheld) throw hidden();
  for (int k = 0; k < unheld; ++k) problem.corrections.push_back(all_loads.load[qr.colsPermutation().indices()[k]]);
  const auto [amounts, reason] = space::corrected<scene::Enclosure, scene::LongSum>(scene::first_of(problem));
  if (!reason.empty()) throw hidden();
  double largest = 0;
  for (const auto& [facet, load] : amounts)
    for (int i = 0; i < 3; ++i) {
      Vector<3> added;
      for (int c = 0; c < 3; ++c) added[c] = static_cast<double>(load[i][c].middle);
      problem.facets[facet].correction[i] += added;
      largest = std::max(largest, added.norm());
    }
  problem.imbalance = largest > 0 ? largest / imbalance.largest : 0;
  return problem;
}

}  // namespace

template <> Problem<3> balanced(Problem<3> problem, int degree) {
  primal::check_prescribed(problem, degree);
  problem = without_corrections(std::move(problem));
  const FreeMotions<3> all = all_free_motions(problem);
  if (all.motion.empty()) return problem;
  const Holding held = holding(problem, all);
  const LoadWork given = load_work(problem, all);
  const ImbalanceInSpace imbalance = possible_imbalance(problem);
  contact::Balance balance{true, Eigen::VectorXd::Zero(held.rows.rows()), {}};
  if (given.size > 0) balance = contact::balance(held.rows, given.work, imbalance.in_doubles, held.limits);
  if (!balance.possible) balance = contact::balance(held.rows, given.work, imbalance.explained, held.limits);
  if (!balance.possible) {
    const auto [body, motion] = most_moved(all, balance.motion);
    throw scene::Error(
        scene::Status::ill_posed,
        fmt::format("body '{}' is pushed off: {} gains energy without end, with a force of {:.3g} of which rounding "
                    "explains {:.3g}; support it, or change the loads so that pressure balances them",
                    problem.mesh.components[body], scene::describe(motion), balance.motion.norm(),
                    imbalance.explained));
  }
  const auto by_pressure = [&](double tolerance) {
    const Holding inside = holding(problem, all, 4 * tolerance / given.work.norm() * problem.length_scale);
    return contact::balance(inside.rows, given.work, tolerance, inside.limits).possible;
  };
  if (given.size > 0 && given.work.norm() > imbalance.explained && !by_pressure(imbalance.in_doubles) &&
      !by_pressure(imbalance.explained))
    throw scene::Error(
        scene::Status::ill_posed,
        "the loads can only be balanced by forces at the end of a contact, through which their resultant passes: "
        "such a reaction has infinite energy; move the load, or enlarge the contact");
  return with_corrections(std::move(problem), all, held, balance.pressure, imbalance);
}

}  // namespace bracket::bounds
