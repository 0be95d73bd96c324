// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <stdexcept>

#include "contact/clock.h"
#include "primal/factorised.h"
#include "scene/mesh/dissection.h"
#include "scene/problem/law.h"

namespace bracket::primal {

using scene::Problem;
using scene::Vector;

template <int dim>
scene::Displacement<dim> recover(const scene::Mesh<dim>& mesh, const Nodes<dim>& nodes,
                                 const std::vector<Eigen::VectorXd>& unknowns) {
  const int degree = nodes.degree;
  scene::Displacement<dim> field{degree, {}, {}, {}};
  field.vertex.resize(mesh.vertices.size());
  field.edge.resize(scene::n_inside_edge(degree) * mesh.edges.size());
  const auto& points = scene::control_points<dim>(degree);
  const auto& indices = scene::bernstein_indices<dim>(degree);
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    const int cell = static_cast<int>(c);
    const Eigen::VectorXd& own = unknowns[mesh.cell_component[c]];
    std::vector<Vector<dim>> u;
    for (const int i : cell_nodes(mesh, nodes, cell)) {
      const Node<dim>& node = nodes.node[i];
      u.push_back(node.prescribed);
      for (int k = 0; k < node.free; ++k) u.back() += node.directions.col(k) * own[node.unknown + k];
    }
    for (int v = 0; v <= dim; ++v) field.vertex[mesh.cells[c][v]] = u[scene::vertex_place(degree, v)];
    for (int e = 0; e < scene::Simplex<dim>::n_edges && degree > 1; ++e) {
      const auto& [from, to] = scene::Simplex<dim>::edges[e];
      std::vector<Vector<dim>> side(degree + 1, u[scene::vertex_place(degree, from)]);
      side[degree] = u[scene::vertex_place(degree, to)];
      for (std::size_t i = 0; i < points.size(); ++i)
        if (points[i].on == scene::ControlPoint::On::edge && points[i].which == e) side[points[i].k] = u[i];
      for (int k = 1; k < degree; ++k)
        field.edge[scene::place_inside_edge(mesh, degree, mesh.cell_edges[c][e], mesh.cells[c][from], k)] =
            scene::value_on_segment(side, static_cast<double>(k) / degree);
    }
    if constexpr (dim == 2)
      for (std::size_t i = 0; i < points.size(); ++i) {
        if (points[i].on != scene::ControlPoint::On::cell) continue;
        std::array<double, 3> at;
        for (int corner = 0; corner < 3; ++corner) at[corner] = static_cast<double>(indices[i][corner]) / degree;
        field.cell.push_back(scene::value_on_triangle(u, degree, at));
      }
  }
  return field;
}

template <int dim> void check_prescribed(const Problem<dim>& problem, int degree) {
  contact_rows(problem, make_nodes(problem, degree));
}

template <int dim> Solver<dim>::Solver(const Problem<dim>& problem, int degree, bool any_gap) {
  Clock clock;
  const std::vector<std::uint64_t> paths = scene::dissect(problem.mesh);
  const double dissected = clock.lap();
  Nodes<dim> nodes = make_nodes(problem, degree);
  std::vector<Row> rows = contact_rows(problem, nodes, any_gap);
  Systems<dim> systems = assemble(problem, nodes, rows, paths);
  const double assembled = clock.lap();
  factorised_ = std::make_shared<const Factorised>(
      Factorised{std::move(nodes), any_gap, std::move(rows), std::move(systems.held),
                 contact::Bodies(std::move(systems.body), dim == 3), dissected, assembled});
}

template <int dim> Result<dim> Solver<dim>::solve(const Problem<dim>& problem, const std::vector<char>& closed) const {
  const Clock clock;
  const Factorised& of = *factorised_;
  const Nodes<dim> nodes = of.own_nodes(problem);
  const std::vector<Row> rows = contact_rows(problem, nodes, of.any_gap);
  if (!std::equal(rows.begin(), rows.end(), of.rows.begin(), of.rows.end(),
                  [](const Row& a, const Row& b) { return a.entries == b.entries; }))
    throw std::invalid_argument("primal: the problem has other contact rows than the one that was factorised");
  const std::vector<Eigen::VectorXd> load = of.forces(problem, nodes);
  Eigen::VectorXd bounds(rows.size());
  contact::Limits limits{Eigen::VectorXd(rows.size()), Eigen::VectorXd(rows.size())};
  std::vector<char> guess;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    bounds[i] = rows[i].bound;
    limits.lower[i] = rows[i].lower;
    limits.upper[i] = rows[i].upper;
    if (!closed.empty())
      guess.push_back((closed[rows[i].facet] & (rows[i].is_slip ? scene::sticks : scene::touches)) != 0);
  }
  const double of_data = clock.seconds();

  const contact::Solution solution = of.bodies.solve(load, bounds, guess, limits);
  std::vector<std::string> names = problem.mesh.components;
  names.push_back("springs");
  Result<dim> result;
  result.termination = solution.termination;
  result.reason =
      contact::reason(solution, "displacements", names, "no admissible pressure balances the loads",
                      "the gaps and the prescribed displacements contradict each other, none is admissible");
  if (solution.termination == contact::Termination::solved)
    result.displacement = recover(problem.mesh, nodes, solution.displacement);
  result.closed.assign(problem.contact.size(), 0);
  for (std::size_t i = 0; i < solution.active.size(); ++i)
    if (solution.active[i]) result.closed[rows[i].facet] |= rows[i].is_slip ? scene::sticks : scene::touches;

  result.statistics = contact::statistics(of.bodies, solution);
  result.statistics.seconds.order += of.order;
  result.statistics.seconds.assemble = of.assemble + of_data;
  return result;
}

template <int dim> Result<dim> solve(const Problem<dim>& problem, int degree, const std::vector<char>& closed) {
  return Solver<dim>(problem, degree).solve(problem, closed);
}

template scene::Displacement<2> recover(const scene::Mesh<2>&, const Nodes<2>&, const std::vector<Eigen::VectorXd>&);
template scene::Displacement<3> recover(const scene::Mesh<3>&, const Nodes<3>&, const std::vector<Eigen::VectorXd>&);
template struct Result<2>;
template struct Result<3>;
template class Solver<2>;
template class Solver<3>;
template void check_prescribed(const Problem<2>&, int);
template void check_prescribed(const Problem<3>&, int);
template Result<2> solve(const Problem<2>&, int, const std::vector<char>&);
template Result<3> solve(const Problem<3>&, int, const std::vector<char>&);

}  // namespace bracket::primal
