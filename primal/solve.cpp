// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "contact/clock.h"
#include "primal/elasticity.h"
#include "primal/nodes.h"
#include "primal/primal.h"

namespace bracket::primal {

namespace {

using scene::Problem;
using scene::Support;
using scene::Vector;

/// Indices into Nodes::node of a cell's nodes, in the order of elasticity.h.
template <int dim> std::vector<int> cell_nodes(const scene::Mesh<dim>& mesh, const Nodes<dim>& nodes, int cell) {
  std::vector<int> list;
  for (const int v : mesh.cells[cell]) list.push_back(nodes.at_vertex(v));
  if (nodes.degree == 2)
    for (const int e : mesh.cell_edges[cell]) list.push_back(nodes.at_edge(mesh, e));
  return list;
}

/// Adds a cell to its body, its nodes written in their own directions: u = prescribed + directions q.
template <int dim>
void add_cell(const Nodes<dim>& nodes, const std::vector<int>& list, const Eigen::MatrixXd& stiffness,
              const Eigen::VectorXd& load, contact::Assembly& assembly, Eigen::VectorXd& body_load) {
  Eigen::MatrixXd k = stiffness;
  Eigen::VectorXd prescribed(dim * list.size());
  std::vector<int> unknowns(dim * list.size(), -1);
  for (std::size_t i = 0; i < list.size(); ++i) prescribed.segment<dim>(dim * i) = nodes.node[list[i]].prescribed;
  Eigen::VectorXd f = load;
  if (!prescribed.isZero(0)) f -= stiffness * prescribed;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const Node<dim>& node = nodes.node[list[i]];
    for (int c = 0; c < node.free; ++c) unknowns[dim * i + c] = node.unknown + c;
    if (node.directions.isIdentity(0)) continue;
    k.middleRows<dim>(dim * i) = (node.directions.transpose() * k.middleRows<dim>(dim * i)).eval();
    k.middleCols<dim>(dim * i) = (k.middleCols<dim>(dim * i) * node.directions).eval();
    f.segment<dim>(dim * i) = (node.directions.transpose() * f.segment<dim>(dim * i)).eval();
  }
  assembly.add(unknowns, k);
  for (std::size_t i = 0; i < unknowns.size(); ++i)
    if (unknowns[i] >= 0) body_load[unknowns[i]] += f[i];
}

template <int dim> contact::Body assemble(const Problem<dim>& problem, const Nodes<dim>& nodes, int b) {
  const auto& mesh = problem.mesh;
  std::vector<int> numbers;
  for (std::size_t c = 0; c < mesh.cells.size(); ++c)
    if (mesh.cell_body[c] == b)
      for (const int i : cell_nodes(mesh, nodes, static_cast<int>(c))) numbers.push_back(nodes.node[i].number);
  contact::Body body;
  body.nodes = nodes.body_nodes[b];
  body.load = Eigen::VectorXd::Zero(body.nodes.back());
  contact::Assembly assembly(body.nodes, numbers, nodes_per_cell(nodes.degree));
  for_each_cell<dim>(problem, b, nodes.degree,
                     [&](int cell, const Eigen::MatrixXd& stiffness, const Eigen::VectorXd& load) {
                       add_cell(nodes, cell_nodes(mesh, nodes, cell), stiffness, load, assembly, body.load);
                     });
  body.stiffness = assembly.take();
  return body;
}

template <int dim> void add_load(const Node<dim>& node, const Vector<dim>& force, Eigen::VectorXd& load) {
  for (int k = 0; k < node.free; ++k) load[node.unknown + k] += node.directions.col(k).dot(force);
}

/// ∫ P·φ over Γ_τ, exact for linear P.
template <int dim>
void add_tractions(const Problem<dim>& problem, const Nodes<dim>& nodes, std::vector<contact::Body>& bodies) {
  const auto& mesh = problem.mesh;
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    if (problem.facets[f].support != Support::traction) continue;
    const auto& facet = mesh.boundary[f];
    Eigen::VectorXd& load = bodies[mesh.cell_body[facet.cell]].load;
    const auto ends = scene::load(problem, static_cast<int>(f));
    for (int i = 0; i < dim; ++i) {
      const Vector<dim> force =
          nodes.degree == 1 ? Vector<dim>((2 * ends[i] + ends[1 - i]) / 6) : Vector<dim>(ends[i] / 6);
      add_load(nodes.node[nodes.at_vertex(facet.vertices[i])], force, load);
    }
    if (nodes.degree == 2) add_load<dim>(nodes.node[nodes.at_edge(mesh, facet.edge)], (ends[0] + ends[1]) / 3, load);
  }
}

template <int dim>
void set_rigid_motions(const Problem<dim>& problem, const Nodes<dim>& nodes, std::vector<contact::Body>& bodies) {
  const auto& mesh = problem.mesh;
  std::vector<std::vector<scene::RigidMotion<dim>>> motions(bodies.size());
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    motions[b] = scene::free_motions(problem, static_cast<int>(b));
    bodies[b].rigid = Eigen::MatrixXd::Zero(bodies[b].load.size(), motions[b].size());
  }
  const auto set = [&](int body, const Node<dim>& node, const Vector<dim>& x) {
    for (std::size_t m = 0; m < motions[body].size(); ++m)
      for (int k = 0; k < node.free; ++k)
        bodies[body].rigid(node.unknown + k, m) = node.directions.col(k).dot(displacement(motions[body][m], x));
  };
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    const int body = mesh.cell_body[c];
    if (motions[body].empty()) continue;
    for (const int v : mesh.cells[c]) set(body, nodes.node[nodes.at_vertex(v)], mesh.vertices[v]);
    if (nodes.degree == 1) continue;
    for (const int e : mesh.cell_edges[c])
      set(body, nodes.node[nodes.at_edge(mesh, e)],
          (mesh.vertices[mesh.edges[e][0]] + mesh.vertices[mesh.edges[e][1]]) / 2);
  }
}

/// Hands the rows to the bodies; returns their bounds.
Eigen::VectorXd set_contact_rows(const std::vector<Row>& rows, std::vector<contact::Body>& bodies) {
  Eigen::VectorXd bounds(rows.size());
  std::vector<std::vector<Eigen::Triplet<double>>> entries(bodies.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    bounds[i] = rows[i].bound;
    for (const auto& entry : rows[i].entries)
      entries[entry.body].emplace_back(static_cast<int>(i), entry.unknown, entry.coefficient);
  }
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    bodies[b].rows.resize(rows.size(), bodies[b].load.size());
    bodies[b].rows.setFromTriplets(entries[b].begin(), entries[b].end());
  }
  return bounds;
}

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
    const int body = mesh.cell_body[c];
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

template <int dim> Result<dim> solve(const Problem<dim>& problem, int degree, const std::vector<char>& closed) {
  const Clock clock;
  const Nodes<dim> nodes = make_nodes(problem, degree);
  const std::vector<Row> rows = contact_rows(problem, nodes);
  std::vector<contact::Body> bodies;
  for (std::size_t b = 0; b < problem.bodies.size(); ++b)
    bodies.push_back(assemble(problem, nodes, static_cast<int>(b)));
  add_tractions(problem, nodes, bodies);
  set_rigid_motions(problem, nodes, bodies);
  const Eigen::VectorXd bounds = set_contact_rows(rows, bodies);

  Result<dim> result;
  result.rows = static_cast<int>(rows.size());
  for (const auto& body : bodies) result.unknowns += static_cast<int>(body.load.size());
  result.assemble = clock.seconds();

  std::vector<char> guess;
  if (!closed.empty())
    for (const Row& row : rows) guess.push_back(closed[row.facet]);
  contact::Solution solution = contact::solve(bodies, bounds, guess);
  result.outcome = solution.outcome;
  result.reason =
      contact::reason(solution, "displacements", problem.mesh.bodies, "no admissible pressure balances the loads",
                      "the gaps and the prescribed displacements contradict each other, none is admissible");
  result.iterations = solution.iterations;
  result.imbalance = solution.imbalance;
  if (solution.outcome == contact::Outcome::solved)
    result.displacement = recover(problem.mesh, nodes, solution.displacement);
  result.active_rows = static_cast<int>(std::count(solution.active.begin(), solution.active.end(), 1));
  result.closed.assign(problem.contact.size(), 0);
  for (std::size_t i = 0; i < solution.active.size(); ++i)
    if (solution.active[i]) result.closed[rows[i].facet] = 1;
  result.seconds = solution.seconds;
  return result;
}

template struct Result<2>;
template void check_prescribed(const Problem<2>&, int);
template Result<2> solve(const Problem<2>&, int, const std::vector<char>&);

}  // namespace bracket::primal
