// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <stdexcept>

#include "contact/clock.h"
#include "primal/nodes.h"
#include "primal/primal.h"
#include "primal/systems.h"
#include "scene/mesh/dissection.h"

namespace bracket::primal {

namespace {

using scene::Problem;
using scene::Vector;

template <int dim>
scene::Displacement<dim> recover(const scene::Mesh<dim>& mesh, const Nodes<dim>& nodes,
                                 const std::vector<Eigen::VectorXd>& unknowns) {
  scene::Displacement<dim> field;
  field.degree = nodes.degree;
  field.vertex.resize(mesh.vertices.size());
  field.edge.resize(nodes.degree == 2 ? mesh.edges.size() : 0);
  const auto value = [&](const Node<dim>& node, int body) {
    Vector<dim> u = node.prescribed;
    for (int k = 0; k < node.free; ++k) u += node.directions.col(k) * unknowns[body][node.unknown + k];
    return u;
  };
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    const int body = mesh.cell_component[c];
    for (const int v : mesh.cells[c]) field.vertex[v] = value(nodes.node[nodes.at_vertex(v)], body);
    if (nodes.degree == 2)
      for (const int e : mesh.cell_edges[c]) field.edge[e] = value(nodes.node[nodes.at_edge(mesh, e)], body);
  }
  return field;
}

}  // namespace

template <int dim> void check_prescribed(const Problem<dim>& problem, int degree) {
  contact_rows(problem, make_nodes(problem, degree));
}

template <int dim> struct Solver<dim>::Factorised {
  Nodes<dim> nodes;
  bool any_gap;
  std::vector<Row> rows;
  std::vector<Eigen::SparseMatrix<double>> held;  ///< as Systems::held
  contact::Bodies bodies;
  double order, assemble;  ///< seconds
};

template <int dim> Solver<dim>::Solver(const Problem<dim>& problem, int degree, bool any_gap) {
  Clock clock;
  const std::vector<std::uint64_t> paths = scene::dissect(problem.mesh);
  const double dissected = clock.lap();
  Nodes<dim> nodes = make_nodes(problem, degree);
  std::vector<Row> rows = contact_rows(problem, nodes, any_gap);
  Systems<dim> systems = assemble(problem, nodes, rows, paths);
  const double assembled = clock.lap();
  factorised_ =
      std::make_shared<const Factorised>(Factorised{std::move(nodes), any_gap, std::move(rows), std::move(systems.held),
                                                    contact::Bodies(std::move(systems.body)), dissected, assembled});
}

template <int dim> Result<dim> Solver<dim>::solve(const Problem<dim>& problem, const std::vector<char>& closed) const {
  const Clock clock;
  const auto& [laid_out, any_gap, of_rows, held, bodies, dissected, assembled] = *factorised_;
  const Nodes<dim> nodes = make_nodes(problem, laid_out.degree);
  const std::vector<Row> rows = contact_rows(problem, nodes, any_gap);
  if (nodes.body_nodes != laid_out.body_nodes ||
      !std::equal(rows.begin(), rows.end(), of_rows.begin(), of_rows.end(),
                  [](const Row& a, const Row& b) { return a.entries == b.entries; }))
    throw std::invalid_argument(
        "primal::Solver: the problem has other unknowns or contact rows than the one that was "
        "factorised");
  std::vector<Eigen::VectorXd> load = loads(problem, nodes);
  const Eigen::VectorXd given = prescribed(nodes);
  for (std::size_t b = 0; b < load.size(); ++b) load[b] -= held[b] * given;
  Eigen::VectorXd bounds(rows.size());
  std::vector<char> guess;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    bounds[i] = rows[i].bound;
    if (!closed.empty()) guess.push_back(closed[rows[i].facet]);
  }
  const double of_data = clock.seconds();

  const contact::Solution solution = bodies.solve(load, bounds, guess);
  Result<dim> result;
  result.termination = solution.termination;
  result.reason =
      contact::reason(solution, "displacements", problem.mesh.components, "no admissible pressure balances the loads",
                      "the gaps and the prescribed displacements contradict each other, none is admissible");
  if (solution.termination == contact::Termination::solved)
    result.displacement = recover(problem.mesh, nodes, solution.displacement);
  result.closed.assign(problem.contact.size(), 0);
  for (std::size_t i = 0; i < solution.active.size(); ++i)
    if (solution.active[i]) result.closed[rows[i].facet] = 1;

  result.statistics = contact::statistics(bodies, solution);
  result.statistics.seconds.order += dissected;
  result.statistics.seconds.assemble = assembled + of_data;
  return result;
}

template <int dim> Result<dim> solve(const Problem<dim>& problem, int degree, const std::vector<char>& closed) {
  return Solver<dim>(problem, degree).solve(problem, closed);
}

template struct Result<2>;
template class Solver<2>;
template void check_prescribed(const Problem<2>&, int);
template Result<2> solve(const Problem<2>&, int, const std::vector<char>&);

}  // namespace bracket::primal
