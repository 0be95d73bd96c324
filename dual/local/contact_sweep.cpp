// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "dual/local/contact_sweep.h"

#include <limits>

#include "dual/local/boundary.h"
#include "dual/local/contact_step.h"
#include "scene/bernstein.h"

namespace bracket::dual {

namespace {

using scene::Problem;

/// A star that a contact acts on.
template <int dim> struct Touched {
  const Star<dim>* star;
  StarSystem<dim> system;
  StarData<dim> data;
  typename StarSystem<dim>::Solution at_rest;  ///< by the pressures as they are
};
/// The loads of a unit pressure at a vertex of a contact facet.
template <int dim> struct UnitPressure {
  struct On {
    std::size_t touched;
    int spoke;
    FacetVector<dim> load;
  };
  std::vector<On> on;  ///< one side or both
  int contact, vertex;
};

/// ∫ ψ_k g⁺ over a contact facet, k one of the first facet's vertices.
template <int dim> double gap_moment(const scene::Mesh<dim>& mesh, const scene::ContactFacetOf<dim>& pair, int k) {
  const double size = scene::area_vector<dim>(scene::positions(mesh, mesh.boundary[pair.first].vertices)).norm();
  double sum = 0;
  for (std::size_t i = 0; i < pair.upper.size(); ++i) {
    if constexpr (dim == 2) {
      sum += scene::number<double>(scene::bernstein_mass(1, k, 2, static_cast<int>(i))) * pair.upper[i];
    } else {  // of vertices 1/10, 1/30; of edges that end at the vertex 1/15, the other 1/30
      const bool own = i < 3 ? static_cast<int>(i) == k : static_cast<int>(i) - 3 != k;
      sum += (i < 3 ? (own ? 3 : 1) : (own ? 2 : 1)) / 30.0 * pair.upper[i];
    }
  }
  return size * sum;
}

/// S by changes of the pressures.
template <int dim>
SmallProblem small_problem(const Loads<dim>& loads, const std::vector<Touched<dim>>& touched,
                           const std::vector<UnitPressure<dim>>& units) {
  const auto n = static_cast<Eigen::Index>(units.size());
  SmallProblem problem{Eigen::MatrixXd(n, n), Eigen::VectorXd(n), {}, Eigen::VectorXd(n)};
  std::vector<Eigen::Index> first_motion;
  Eigen::Index motions = 0;
  for (const Touched<dim>& one : touched) {
    first_motion.push_back(motions);
    motions += one.star->motions().cols();
  }
  problem.motion = Eigen::MatrixXd::Zero(n, motions);
  for (Eigen::Index i = 0; i < n; ++i) {
    const UnitPressure<dim>& unit = units[i];
    const auto& pair = loads.problem().contact[unit.contact];
    problem.least[i] =
        pair.law.two_sided ? -std::numeric_limits<double>::infinity() : -loads.pressure()[unit.contact][unit.vertex];
    problem.slope[i] = gap_moment(loads.problem().mesh, pair, unit.vertex);
    problem.form.col(i).setZero();
    for (const auto& [t, spoke, load] : unit.on) {
      problem.slope[i] += load.dot(touched[t].at_rest.displacement[spoke]);
      const Star<dim>& star = *touched[t].star;
      Eigen::Matrix<double, scene::Simplex<dim>::n_rigid_motions, 1> wrench = resultants<dim>(star.arms(spoke)) * load;
      wrench.template tail<scene::Simplex<dim>::n_rotations>() /= star.size();
      problem.motion.row(i).segment(first_motion[t], star.motions().cols()) += wrench.transpose() * star.motions();
      const auto moved = touched[t].system.moved_by(spoke, load);
      for (Eigen::Index k = 0; k < n; ++k)
        for (const auto& other : units[k].on)
          if (other.touched == t) problem.form(k, i) += other.load.dot(moved[other.spoke]);
    }
  }
  problem.form = (0.5 * (problem.form + problem.form.transpose())).eval();
  return problem;
}

template <int dim> void press(Loads<dim>& loads, int vertex, const std::vector<int>& contacts) {
  const Problem<dim>& all = loads.problem();
  const auto& boundary = all.mesh.boundary;
  std::vector<Touched<dim>> touched;
  const auto touch = [&](int v) {
    for (std::size_t t = 0; t < touched.size(); ++t)
      if (touched[t].star == &loads.star(v)) return t;
    StarSystem<dim> system = loads.system(loads.star(v));
    StarData<dim> data = loads.as_they_are(loads.star(v));
    auto at_rest = system.solve(data);
    touched.push_back({&loads.star(v), std::move(system), std::move(data), std::move(at_rest)});
    return touched.size() - 1;
  };
  std::vector<UnitPressure<dim>> units;
  for (const int j : contacts) {
    const auto& pair = all.contact[j];
    const auto& first = boundary[pair.first].vertices;
    const auto place = std::find(first.begin(), first.end(), vertex) - first.begin();
    const double size = scene::area_vector<dim>(scene::positions(all.mesh, first)).norm();
    for (int k = 0; k < dim; ++k) {
      UnitPressure<dim> unit{{}, j, k};
      const auto act = [&](int facet, int at_star, int own, double sign) {
        const std::size_t t = touch(at_star);
        const auto& spokes = touched[t].star->spokes();
        const int number = number_of(all.mesh, facet);
        FacetVector<dim> load = FacetVector<dim>::Zero();
        load.template segment<dim>(dim * slot(loads.facets(), number, boundary[facet].vertices[own])) =
            sign * size * all.facets[pair.first].normal;
        unit.on.push_back(
            {t, static_cast<int>(std::lower_bound(spokes.begin(), spokes.end(), number) - spokes.begin()), load});
      };
      act(pair.first, vertex, k, -1);
      if (pair.second >= 0) act(pair.second, boundary[pair.second].vertices[pair.meets[place]], pair.meets[k], 1);
      units.push_back(std::move(unit));
    }
  }
  const SmallProblem problem = small_problem(loads, touched, units);
  const Eigen::VectorXd change = descend(problem, 8 * static_cast<int>(units.size()));
  for (std::size_t i = 0; i < units.size(); ++i) {
    loads.add_pressure(units[i].contact, units[i].vertex, change[static_cast<Eigen::Index>(i)]);
    for (const auto& [t, spoke, load] : units[i].on)
      touched[t].data.sum[spoke] += change[static_cast<Eigen::Index>(i)] * load;
  }
  for (const Touched<dim>& one : touched) loads.add(*one.star, one.system.solve(one.data).loads);
}

}  // namespace

template <int dim> void contact_sweep(Loads<dim>& loads) {
  const Problem<dim>& problem = loads.problem();
  std::vector<std::vector<int>> contacts(problem.mesh.vertices.size());
  for (std::size_t j = 0; j < problem.contact.size(); ++j)
    for (const int v : problem.mesh.boundary[problem.contact[j].first].vertices)
      contacts[v].push_back(static_cast<int>(j));
  for (std::size_t v = 0; v < contacts.size(); ++v)
    if (!contacts[v].empty()) press(loads, static_cast<int>(v), contacts[v]);
}

template void contact_sweep(Loads<2>&);
template void contact_sweep(Loads<3>&);

}  // namespace bracket::dual
