// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "primal/systems.h"

#include <algorithm>

#include "primal/elasticity.h"
#include "scene/on_facet.h"

namespace bracket::primal {

namespace {

using scene::Problem;
using scene::Support;
using scene::Vector;
using Triplets = std::vector<Eigen::Triplet<double>>;

/// Adds a cell to its body, its nodes written in their own directions: u = prescribed + directions q.
template <int dim>
void add_cell(const Nodes<dim>& nodes, const std::vector<int>& list, Eigen::MatrixXd stiffness,
              contact::Assembly& assembly, Triplets& held) {
  std::vector<int> unknowns(dim * list.size(), -1);
  for (std::size_t i = 0; i < list.size(); ++i) {
    const Node<dim>& node = nodes.node[list[i]];
    for (int c = 0; c < node.free; ++c) unknowns[dim * i + c] = node.unknown + c;
    if (!node.directions.isIdentity(0))
      stiffness.middleRows<dim>(dim * i) = (node.directions.transpose() * stiffness.middleRows<dim>(dim * i)).eval();
  }
  for (std::size_t i = 0; i < list.size(); ++i) {
    const Node<dim>& node = nodes.node[list[i]];
    for (int c = 0; node.free < dim && c < dim; ++c)
      for (std::size_t k = 0; k < unknowns.size(); ++k)
        if (unknowns[k] >= 0) held.emplace_back(unknowns[k], dim * list[i] + c, stiffness(k, dim * i + c));
    if (!node.directions.isIdentity(0))
      stiffness.middleCols<dim>(dim * i) = (stiffness.middleCols<dim>(dim * i) * node.directions).eval();
  }
  assembly.add(unknowns, stiffness);
}

template <int dim> void set_rigid_motions(const Problem<dim>& problem, const Nodes<dim>& nodes, Systems<dim>& systems) {
  const auto& mesh = problem.mesh;
  std::vector<std::vector<scene::RigidMotion<dim>>> motions(systems.body.size());
  for (std::size_t b = 0; b < motions.size(); ++b) {
    motions[b] = scene::free_motions(problem, static_cast<int>(b));
    systems.body[b].rigid = Eigen::MatrixXd::Zero(nodes.body_nodes[b].back(), motions[b].size());
  }
  const auto set = [&](int body, const Node<dim>& node, const Vector<dim>& x) {
    for (std::size_t m = 0; m < motions[body].size(); ++m)
      for (int k = 0; k < node.free; ++k)
        systems.body[body].rigid(node.unknown + k, m) = node.directions.col(k).dot(displacement(motions[body][m], x));
  };
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    const int body = mesh.cell_component[c];
    if (motions[body].empty()) continue;
    const std::vector<int> list = cell_nodes(mesh, nodes, static_cast<int>(c));
    const auto& indices = scene::bernstein_indices<dim>(nodes.degree);
    const auto x = scene::positions(mesh, mesh.cells[c]);
    for (std::size_t i = 0; i < list.size(); ++i) {
      Vector<dim> at = x[0];
      for (int corner = 1; corner <= dim; ++corner) at += indices[i][corner] * (x[corner] - x[0]) / nodes.degree;
      set(body, nodes.node[list[i]], at);
    }
  }
}

template <int dim> void set_contact_rows(const std::vector<Row>& rows, const Nodes<dim>& nodes, Systems<dim>& systems) {
  std::vector<Triplets> entries(systems.body.size());
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (const auto& entry : rows[i].entries)
      entries[entry.body].emplace_back(static_cast<int>(i), entry.unknown, entry.coefficient);
  for (std::size_t b = 0; b < entries.size(); ++b) {
    systems.body[b].rows.resize(rows.size(), nodes.body_nodes[b].back());
    systems.body[b].rows.setFromTriplets(entries[b].begin(), entries[b].end());
  }
}

/// The springs of the contact, if there are any; in space there are none. A row's multiplier presses them.
void add_springs(const Problem<3>&, const std::vector<Row>&, int, Systems<3>&) {}
void add_springs(const Problem<2>& problem, const std::vector<Row>& rows, int degree, Systems<2>& systems) {
  const int last = spring_degree(degree), n = last + 1;
  contact::System springs;
  springs.nodes = {0};
  Triplets stiffness, entries;
  for (const auto& pair : problem.contact) {
    if (!has_springs(pair.law)) continue;
    const int begin = springs.nodes.back();
    const double length = scene::length(problem.mesh, pair.first);
    for (int i = 0; i < n; ++i)
      for (int k = 0; k <= i; ++k) {  // B_i B_k is a multiple of one polynomial of twice the degree
        double mean = 0;
        for (int end = 0; end < 2; ++end)
          mean += scene::number<double>(scene::bernstein_mass(2 * last, i + k, 1, end)) * pair.law.modulus[end];
        const double factor =
            static_cast<double>(scene::binomial(last, i) * scene::binomial(last, k)) / scene::binomial(2 * last, i + k);
        stiffness.emplace_back(begin + i, begin + k, length * factor * mean);
      }
    springs.nodes.push_back(begin + n);
  }
  const int size = springs.nodes.back();
  if (size == 0) return;
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (rows[i].spring >= 0) entries.emplace_back(static_cast<int>(i), rows[i].spring, -1);
  springs.stiffness.resize(size, size);
  springs.stiffness.setFromTriplets(stiffness.begin(), stiffness.end());
  springs.rows.resize(static_cast<int>(rows.size()), size);
  springs.rows.setFromTriplets(entries.begin(), entries.end());
  springs.rigid.resize(size, 0);
  systems.body.push_back(std::move(springs));
}

template <int dim> void add_load(const Node<dim>& node, const Vector<dim>& force, Eigen::VectorXd& load) {
  for (int k = 0; k < node.free; ++k) load[node.unknown + k] += node.directions.col(k).dot(force);
}

template <int dim>
void add_weights(const Problem<dim>& problem, const Nodes<dim>& nodes, std::vector<Eigen::VectorXd>& loads) {
  const auto& mesh = problem.mesh;
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    const int body = mesh.cell_component[c];
    const Vector<dim>& force = body_of(problem, static_cast<int>(c)).force;
    if (force.isZero(0)) continue;
    const std::vector<int> list = cell_nodes(mesh, nodes, static_cast<int>(c));
    const Vector<dim> share = force * (scene::volume(mesh, static_cast<int>(c)) / static_cast<double>(list.size()));
    for (const int i : list) add_load<dim>(nodes.node[i], share, loads[body]);
  }
}

template <int dim>
void add_tractions(const Problem<dim>& problem, const Nodes<dim>& nodes, std::vector<Eigen::VectorXd>& loads) {
  const auto& mesh = problem.mesh;
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    if (!scene::is_loaded(problem.facets[f])) continue;
    const auto& facet = mesh.boundary[f];
    Eigen::VectorXd& load = loads[mesh.cell_component[facet.cell]];
    const auto at_vertices = scene::load(problem, static_cast<int>(f));
    const std::vector<int> list = facet_nodes(mesh, nodes, static_cast<int>(f));
    for (std::size_t k = 0; k < list.size(); ++k) {
      Vector<dim> force = Vector<dim>::Zero();
      for (int i = 0; i < dim; ++i)
        force += scene::number<double>(scene::hat_mean<dim>(nodes.degree, static_cast<int>(k), i)) * at_vertices[i];
      if constexpr (dim == 2) {  // what is not linear
        const auto higher = scene::higher_load(problem, static_cast<int>(f));
        for (int j = 2; j <= degree_of_load(problem.facets[f]); ++j)
          force += scene::legendre_moment<double>(nodes.degree, static_cast<int>(k), j) * higher[j - 2];
      }
      add_load(nodes.node[list[k]], force, load);
    }
  }
}

}  // namespace

template <int dim>
Systems<dim> assemble(const Problem<dim>& problem, const Nodes<dim>& nodes, const std::vector<Row>& rows,
                      const std::vector<std::uint64_t>& paths) {
  const auto& mesh = problem.mesh;
  Systems<dim> systems;
  systems.body.resize(mesh.components.size());
  std::vector<std::vector<int>> numbers(mesh.components.size());
  std::vector<std::vector<std::uint64_t>> body_paths(mesh.components.size());
  int per_cell = 0;  // vertices, edges and cells that nodes are numbered by
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    body_paths[mesh.cell_component[c]].push_back(paths[c]);
    std::vector<int> own;
    for (const int i : cell_nodes(mesh, nodes, static_cast<int>(c))) own.push_back(nodes.node[i].number);
    std::sort(own.begin(), own.end());
    own.erase(std::unique(own.begin(), own.end()), own.end());
    per_cell = static_cast<int>(own.size());
    auto& of_body = numbers[mesh.cell_component[c]];
    of_body.insert(of_body.end(), own.begin(), own.end());
  }
  for (std::size_t b = 0; b < systems.body.size(); ++b) {
    contact::System& body = systems.body[b];
    body.nodes = nodes.body_nodes[b];
    body.sequence = contact::elimination(body_paths[b], numbers[b], static_cast<int>(body.nodes.size()) - 1);
    contact::Assembly assembly(body.nodes, numbers[b], per_cell);
    Triplets held;
    for_each_cell<dim>(problem, static_cast<int>(b), nodes.degree, [&](int cell, const Eigen::MatrixXd& stiffness) {
      add_cell(nodes, cell_nodes(mesh, nodes, cell), stiffness, assembly, held);
    });
    body.stiffness = assembly.take();
    Eigen::SparseMatrix<double> columns(body.nodes.back(), dim * static_cast<int>(nodes.node.size()));
    columns.setFromTriplets(held.begin(), held.end());
    systems.held.push_back(std::move(columns));
  }
  set_rigid_motions(problem, nodes, systems);
  set_contact_rows(rows, nodes, systems);
  add_springs(problem, rows, nodes.degree, systems);
  return systems;
}

template <int dim> std::vector<Eigen::VectorXd> loads(const Problem<dim>& problem, const Nodes<dim>& nodes) {
  std::vector<Eigen::VectorXd> loads;
  for (const auto& offsets : nodes.body_nodes) loads.push_back(Eigen::VectorXd::Zero(offsets.back()));
  add_weights(problem, nodes, loads);
  add_tractions(problem, nodes, loads);
  return loads;
}

template <int dim> Eigen::VectorXd prescribed(const Nodes<dim>& nodes) {
  Eigen::VectorXd all(dim * nodes.node.size());
  for (std::size_t i = 0; i < nodes.node.size(); ++i) all.segment<dim>(dim * i) = nodes.node[i].prescribed;
  return all;
}

template struct Systems<2>;
template struct Systems<3>;
template Systems<2> assemble(const Problem<2>&, const Nodes<2>&, const std::vector<Row>&,
                             const std::vector<std::uint64_t>&);
template Systems<3> assemble(const Problem<3>&, const Nodes<3>&, const std::vector<Row>&,
                             const std::vector<std::uint64_t>&);
template std::vector<Eigen::VectorXd> loads(const Problem<2>&, const Nodes<2>&);
template std::vector<Eigen::VectorXd> loads(const Problem<3>&, const Nodes<3>&);
template Eigen::VectorXd prescribed(const Nodes<2>&);
template Eigen::VectorXd prescribed(const Nodes<3>&);

}  // namespace bracket::primal
