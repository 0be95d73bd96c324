// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "bounds/bounds.h"
#include "bounds/certificate/corrections.h"
#include "bounds/certificate/links.h"
#include "bounds/coulomb.h"
#include "bounds/free_motions.h"
#include "primal/primal.h"

namespace bracket::bounds {

using scene::Support;
using scene::Vector;

namespace {

template <int dim>
std::string explain(const scene::Problem<dim>& problem, const FreeMotions<dim>& all, const Eigen::VectorXd& y) {
  const auto [body, motion] = most_moved(all, y);
  const bool friction = std::ranges::any_of(problem.contact, [](const auto& pair) { return has_friction(pair.law); });
  return fmt::format("body '{}' is pushed off: {} gains energy without end{}", problem.mesh.components[body],
                     scene::describe(motion), friction ? ", which friction does not hold" : "");
}

scene::Problem<2> without_corrections(scene::Problem<2> problem) {
  problem.corrections.clear();
  problem.carries.clear();
  problem.imbalance = 0;
  for (auto& facet : problem.facets) facet.correction = {Vector<2>::Zero(), Vector<2>::Zero()};
  return problem;
}

/// By how much, as a force, loads may lack balance that are meant to have it. Twofold, as moments have it once more.
struct Imbalance {
  double in_doubles = 0;  ///< by the rounding of sums and coordinates in double precision
  double explained = 0;   ///< also by the digits of the mesh file, and by directions that stand for other normals
};

Imbalance possible_imbalance(const scene::Problem<2>& problem) {
  const auto& mesh = problem.mesh;
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  const double terms = static_cast<double>(mesh.boundary.size() + mesh.cells.size()) + 64;  // and those of each value
  double farthest = 0, size = 0, per_length = 0, largest = 0, turned = 0;
  double shortest = std::numeric_limits<double>::infinity();
  for (const auto& [a, b] : mesh.edges) shortest = std::min(shortest, (mesh.vertices[b] - mesh.vertices[a]).norm());
  for (const Vector<2>& x : mesh.vertices) farthest = std::max(farthest, x.cwiseAbs().maxCoeff());
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    const double force = body_of(problem, static_cast<int>(c)).force.norm() * scene::volume(mesh, static_cast<int>(c));
    size += force;
    per_length += force / problem.length_scale;
  }
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    if (!scene::is_loaded(problem.facets[f])) continue;
    const double force = size_of_load(problem, static_cast<int>(f));
    size += force;
    per_length += force / scene::length(mesh, static_cast<int>(f));
    largest = std::max(largest, force / scene::length(mesh, static_cast<int>(f)));
  }
  largest += size / problem.length_scale;  // pressure of what the contact carries
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    const auto& data = problem.facets[f];
    if (data.support != Support::sliding && data.support != Support::contact) continue;
    const int facet = static_cast<int>(f);
    turned += scene::length(mesh, facet) * (scene::normal(mesh, facet) - data.normal).norm();
  }
  const double in_doubles = 2 * (terms * epsilon * size + per_length * epsilon * farthest);
  // Digits that would move nodes by more than a thousandth of the shortest edge are what is meant.
  const double digits = mesh.coordinate_rounding * farthest;
  return {in_doubles, in_doubles + 2 * (per_length * (digits <= 1e-3 * shortest ? digits : 0) + largest * turned)};
}

/// The unit loads that a facet of Γ_τ can be given, at its ends per unit of its parameter: uniform along x and y, and
/// linear across it without resultant force.
std::array<std::array<Vector<2>, 2>, 3> unit_loads(const scene::Mesh<2>& mesh, int facet) {
  const Vector<2> n = scene::normal(mesh, facet);
  return {{{Vector<2>::Unit(0), Vector<2>::Unit(0)}, {Vector<2>::Unit(1), Vector<2>::Unit(1)}, {n, -n}}};
}

/// The problem with tractions that do, in each motion, as much more work as `missing` says, on few facets.
scene::Problem<2> with_work(scene::Problem<2> problem, const FreeMotions<2>& all, const Eigen::VectorXd& missing) {
  const auto& mesh = problem.mesh;
  std::vector<int> facets;
  for (std::size_t f = 0; f < problem.facets.size(); ++f)
    if (problem.facets[f].support == Support::traction) facets.push_back(static_cast<int>(f));
  if (facets.empty()) return problem;
  Eigen::MatrixXd work = Eigen::MatrixXd::Zero(missing.size(), static_cast<Eigen::Index>(3 * facets.size()));
  for (std::size_t j = 0; j < facets.size(); ++j)
    for (int which = 0; which < 3; ++which)
      for (std::size_t m = 0; m < all.motion.size(); ++m) {
        if (all.body[m] != mesh.cell_component[mesh.boundary[facets[j]].cell]) continue;
        const auto load = unit_loads(mesh, facets[j])[which];
        for (int i = 0; i < 2; ++i)
          work(m, 3 * j + which) += scene::hat_moment(load, i).dot(
              displacement(all.motion[m], mesh.vertices[mesh.boundary[facets[j]].vertices[i]]));
      }
  const Eigen::VectorXd amounts = work.colPivHouseholderQr().solve(missing);
  for (std::size_t j = 0; j < facets.size(); ++j)
    for (int which = 0; which < 3; ++which)
      for (int i = 0; i < 2; ++i)
        problem.facets[facets[j]].traction[i] +=
            amounts[3 * j + which] / scene::length(mesh, facets[j]) * unit_loads(mesh, facets[j])[which][i];
  return problem;
}

/// The problem with corrections along all motions that neither supports nor the pairs that the loads need act on.
/// \param pressure that balances the loads but for what is explained, as rows of holding()
/// \param rounding what a pair carries at most, by pressure or friction, if it carries nothing
scene::Problem<2> with_corrections(scene::Problem<2> problem, const Eigen::VectorXd& pressure, double rounding) {
  for (const auto& pair : problem.contact)
    problem.carries.resize(std::max<std::size_t>(problem.carries.size(), pair.pair + 1), 0);
  std::vector<double> force(problem.carries.size(), 0);
  for (std::size_t j = 0; j < problem.contact.size(); ++j)
    force[problem.contact[j].pair] += problem.contact[j].law.two_sided ? std::numeric_limits<double>::infinity()
                                                                       : pressure[2 * j] + pressure[2 * j + 1];
  auto shear = static_cast<Eigen::Index>(2 * problem.contact.size());
  for (const auto& pair : problem.contact)
    for (int i = 0; i < 2 && has_friction(pair.law); ++i) force[pair.pair] += std::abs(pressure[shear++]);
  for (std::size_t pair = 0; pair < force.size(); ++pair) problem.carries[pair] = force[pair] > rounding;
  const int unheld = unheld_motions(problem, problem.carries);
  if (unheld == 0) {
    problem.carries.clear();
    return problem;
  }
  const auto& mesh = problem.mesh;
  std::vector<char> can_be_loaded(mesh.components.size(), 0);
  for (std::size_t f = 0; f < problem.facets.size(); ++f)
    can_be_loaded[mesh.cell_component[mesh.boundary[f].cell]] |= problem.facets[f].support == Support::traction;
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    // A body with no facet on Γ_τ has no load but its weight: what is to be taken off must be zero to the last bit.
    const bool loadable = can_be_loaded[mesh.cell_component[mesh.boundary[f].cell]];
    if (problem.facets[f].support != (loadable ? Support::traction : Support::contact)) continue;
    for (const auto& unit : unit_loads(mesh, static_cast<int>(f)))
      problem.corrections.push_back({static_cast<int>(f), unit});
  }
  const auto about = references(mesh);
  std::vector<scene::Correction<2>> chosen;
  for (const Reaction& reaction : reactions(problem, about, assumed_loads(problem), {}))
    if (reaction.kind == Reaction::Kind::correction) chosen.push_back(problem.corrections[reaction.which]);
  problem.corrections = std::move(chosen);
  const auto [amounts, reason] = corrected<Enclosure, LongSum>(scene::first_of(problem));
  if (static_cast<int>(problem.corrections.size()) != unheld || !reason.empty())
    throw scene::Error(scene::Status::not_guaranteed,
                       "rounding hides how a body is held: supports or contacts act on its motion by rounding only");
  double largest = 0;
  for (const auto& [facet, load] : amounts)
    for (int end = 0; end < 2; ++end) {
      const Vector<2> added(static_cast<double>(load[end].x.middle), static_cast<double>(load[end].y.middle));
      problem.facets[facet].correction[end] += added;
      largest = std::max(largest, added.norm());
    }
  problem.imbalance = largest > 0 ? largest / largest_load(problem) : 0;
  return problem;
}

/// \throw scene::Error (ill_posed) where no shear of at most μ times a pressure balances the loads
template <int dim> void check_coulomb(const scene::Problem<dim>& problem) {
  const FreeMotions<dim> all = all_free_motions(problem);
  const LoadWork given = load_work(problem, all);
  if (!has_coulomb(problem) || given.size == 0) return;
  const auto [rows, limits, friction] = holding_by_pressure(problem, all);
  const auto balance = contact::balance(rows, given.work, possible_imbalance(problem).explained, limits);
  if (balance.possible) return;
  throw scene::Error(scene::Status::ill_posed,
                     fmt::format("{} by a shear of at most mu times the pressure, with a force of {:.3g}; support it, "
                                 "or change the loads or mu",
                                 explain(problem, all, balance.motion), balance.motion.norm()));
}

}  // namespace

template <int dim> scene::Problem<dim> balanced(scene::Problem<dim> problem, int degree) {
  primal::check_prescribed(problem, degree);
  problem = without_corrections(std::move(problem));
  check_coulomb(problem);
  problem = with_first_friction(std::move(problem), degree);
  const FreeMotions<dim> all = all_free_motions(problem);
  if (all.motion.empty()) return problem;
  const auto [rows, limits, friction] = holding(problem, all);
  LoadWork given = load_work(problem, all);
  const auto [rounding, explained] = possible_imbalance(problem);
  contact::Balance balance{true, Eigen::VectorXd::Zero(rows.rows()), {}};
  if (given.size > 0) balance = contact::balance(rows, given.work, rounding, limits);
  if (!balance.possible) balance = contact::balance(rows, given.work, explained, limits);
  if (!balance.possible)
    throw scene::Error(scene::Status::ill_posed,
                       explain(problem, all, balance.motion) +
                           fmt::format(", with a force of {:.3g} of which rounding explains {:.3g}; support it, or "
                                       "change the loads so that pressure balances them",
                                       balance.motion.norm(), explained));
  double changed = 0;
  if (const Eigen::VectorXd left = given.work - rows.transpose() * balance.pressure; left.norm() > rounding) {
    // What a contact holds by the rounding of its directions only: there it must not have to.
    problem = with_work(std::move(problem), all, -left);
    changed = left.cwiseAbs().maxCoeff() / given.size;
    given = load_work(problem, all);
    if (const auto exact = contact::balance(rows, given.work, rounding, limits); exact.possible) balance = exact;
  }
  const auto by_pressure = [&](double tolerance) {
    const double inset = 4 * tolerance / given.work.norm() * problem.length_scale;
    const Holding inside = holding(problem, all, inset);
    return contact::balance(inside.rows, given.work, tolerance, inside.limits).possible;
  };
  if (given.size > 0 && given.work.norm() > explained && !by_pressure(rounding) && !by_pressure(explained))
    throw scene::Error(
        scene::Status::ill_posed,
        "the loads can only be balanced by a force at the end of a contact line, through which their "
        "resultant passes: a point reaction has infinite energy; move the load, or lengthen the contact");
  problem = with_corrections(std::move(problem), balance.pressure, rounding);
  problem.imbalance = std::max(problem.imbalance, changed);
  return problem;
}

template scene::Problem<2> balanced(scene::Problem<2>, int);

}  // namespace bracket::bounds
