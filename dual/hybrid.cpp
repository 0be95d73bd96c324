// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <optional>

#include "contact/clock.h"
#include "dual/block_element.h"
#include "dual/dual.h"

namespace bracket::dual {

namespace {

using scene::Problem;
using scene::Support;
using scene::Vector;

/// The multipliers of one edge: the displacement of its two ends, in the directions of the rows of `frame`. Place
/// 2 end + direction; the lower vertex is end 0. The frame is (normal, tangent) where a support or the contact needs it.
struct Edge {
  Eigen::Matrix2d frame = Eigen::Matrix2d::Identity();
  std::array<int, 4> unknown = {-1, -1, -1, -1};  ///< number in its body; −1: prescribed
  std::array<double, 4> prescribed = {0, 0, 0, 0};
  int node = -1;  ///< number of the edge in its body
  bool normal_held = false, tangent_held = false;
};

struct Layout {
  std::vector<Edge> edges;
  std::vector<std::vector<int>> body_cells;
  std::vector<std::vector<int>> body_nodes;  ///< offsets of each edge's unknowns, as contact::Body::nodes
};

/// Which end of its mesh edge a vertex of a boundary facet is.
template <int dim> int end_of(const scene::Mesh<dim>& mesh, int edge, int vertex) {
  return mesh.edges[edge][0] == vertex ? 0 : 1;
}

template <int dim> void set_boundary(const Problem<dim>& problem, std::vector<Edge>& edges) {
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    const auto& facet = problem.mesh.boundary[f];
    const auto& data = problem.facets[f];
    if (data.support == Support::traction) continue;
    Edge& edge = edges[facet.edge];
    edge.normal_held = data.support != Support::contact;
    edge.tangent_held = data.support == Support::fixed;
    if (data.support != Support::fixed) {
      const Vector<dim>& n = data.normal;
      edge.frame << n[0], n[1], -n[1], n[0];
    }
    for (int i = 0; i < 2; ++i) {
      const int end = end_of(problem.mesh, facet.edge, facet.vertices[i]);
      if (data.support == Support::fixed)
        for (int c = 0; c < 2; ++c) edge.prescribed[2 * end + c] = data.displacement[i][c];
      if (data.support == Support::sliding) edge.prescribed[2 * end] = data.normal_displacement[i];
    }
  }
}

template <int dim> Layout lay_out(const Problem<dim>& problem) {
  const auto& mesh = problem.mesh;
  Layout layout;
  layout.edges.resize(mesh.edges.size());
  layout.body_cells.resize(mesh.bodies.size());
  layout.body_nodes.assign(mesh.bodies.size(), {0});
  set_boundary(problem, layout.edges);
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    const int body = mesh.cell_body[c];
    layout.body_cells[body].push_back(static_cast<int>(c));
    auto& nodes = layout.body_nodes[body];
    for (const int e : mesh.cell_edges[c]) {
      Edge& edge = layout.edges[e];
      if (edge.node >= 0) continue;
      edge.node = static_cast<int>(nodes.size()) - 1;
      int next = nodes.back();
      for (int end = 0; end < 2; ++end) {
        if (!edge.normal_held) edge.unknown[2 * end] = next++;
        if (!edge.tangent_held) edge.unknown[2 * end + 1] = next++;
      }
      nodes.push_back(next);
    }
  }
  return layout;
}

/// A cell's vertices relative to the first of them: far from the origin a centroid would be rounded otherwise.
template <int dim> Triangle corners(const scene::Mesh<dim>& mesh, int cell) {
  const auto& v = mesh.cells[cell];
  return {Vector<dim>::Zero(), mesh.vertices[v[1]] - mesh.vertices[v[0]], mesh.vertices[v[2]] - mesh.vertices[v[0]]};
}

/// One cell, with its loads in the frames of its edges.
struct Cell {
  BlockElement block;
  std::array<int, n_loads> unknowns;
  LoadVector prescribed;
  std::optional<Particular> weight;  ///< only where there is a body force
};

template <int dim> Cell make_cell(const Problem<dim>& problem, const Layout& layout, int c) {
  const auto& mesh = problem.mesh;
  const auto& body = problem.bodies[mesh.cell_body[c]];
  const Triangle t = corners(mesh, c);
  Cell cell;
  cell.block = block_element(t, body.compliance);
  if (!body.force.isZero(0)) cell.weight = particular(t, cell.block, body.compliance, body.force);
  for (int e = 0; e < 3; ++e) {
    const int mesh_edge = mesh.cell_edges[c][e];
    const Edge& edge = layout.edges[mesh_edge];
    for (int i = 0; i < 2; ++i) {
      const int row = 4 * e + 2 * i;
      const int place = 2 * end_of(mesh, mesh_edge, mesh.cells[c][(e + 1 + i) % 3]);
      cell.block.loads.middleRows<2>(row) = (edge.frame * cell.block.loads.middleRows<2>(row)).eval();
      if (cell.weight) cell.weight->loads.segment<2>(row) = (edge.frame * cell.weight->loads.segment<2>(row)).eval();
      for (int k = 0; k < 2; ++k) {
        cell.unknowns[row + k] = edge.unknown[place + k];
        cell.prescribed[row + k] = edge.prescribed[place + k];
      }
    }
  }
  return cell;
}

/// The loads of Γ_τ on the edge displacements of each body: ∫ P·μ.
template <int dim> std::vector<Eigen::VectorXd> traction_loads(const Problem<dim>& problem, const Layout& layout) {
  const auto& mesh = problem.mesh;
  std::vector<Eigen::VectorXd> loads;
  for (const auto& nodes : layout.body_nodes) loads.push_back(Eigen::VectorXd::Zero(nodes.back()));
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    const auto& data = problem.facets[f];
    if (data.support != Support::traction) continue;
    const auto& facet = mesh.boundary[f];
    const Edge& edge = layout.edges[facet.edge];
    const double sixth = scene::length(mesh, static_cast<int>(f)) / 6;
    for (int i = 0; i < 2; ++i) {
      const Vector<dim> moment = sixth * (2 * data.traction[i] + data.traction[1 - i]);
      const int place = 2 * end_of(mesh, facet.edge, facet.vertices[i]);
      for (int k = 0; k < 2; ++k) loads[mesh.cell_body[facet.cell]][edge.unknown[place + k]] += moment[k];
    }
  }
  return loads;
}

/// Rows 2 j, 2 j + 1 of contact facet j: ∫ φ_i r over it, for the hat functions of the first facet's vertices 0 and 1.
/// Both sides count their own outward normal displacement: r = u'·n' + u''·n''.
template <int dim> void set_contact_rows(const Problem<dim>& problem, const Layout& layout, std::vector<contact::Body>& bodies) {
  const auto& mesh = problem.mesh;
  std::vector<std::vector<Eigen::Triplet<double>>> entries(bodies.size());
  for (std::size_t j = 0; j < problem.contact.size(); ++j) {
    const auto& pair = problem.contact[j];
    const double sixth = scene::length(mesh, pair.first) / 6;
    for (const int side : {pair.first, pair.second}) {
      if (side < 0) continue;
      const auto& facet = mesh.boundary[side];
      const Edge& edge = layout.edges[facet.edge];
      for (int row = 0; row < 2; ++row)
        for (int i = 0; i < 2; ++i) {
          const int vertex = facet.vertices[side == pair.first ? i : 1 - i];
          const int unknown = edge.unknown[2 * end_of(mesh, facet.edge, vertex)];
          entries[mesh.cell_body[facet.cell]].emplace_back(2 * j + row, unknown, sixth * (row == i ? 2 : 1));
        }
    }
  }
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    bodies[b].rows.resize(2 * problem.contact.size(), bodies[b].load.size());
    bodies[b].rows.setFromTriplets(entries[b].begin(), entries[b].end());
  }
}

/// ∫ φ_i g over each contact facet.
template <int dim> Eigen::VectorXd gap_moments(const Problem<dim>& problem) {
  Eigen::VectorXd moments(2 * problem.contact.size());
  for (std::size_t j = 0; j < problem.contact.size(); ++j) {
    const auto& g = problem.contact[j].gap;
    const double length = scene::length(problem.mesh, problem.contact[j].first);
    for (int i = 0; i < 2; ++i) moments[2 * j + i] = length * (g[i] / 6 + g[2] / 3);
  }
  return moments;
}

/// The rigid motions that the supports of a body leave, as edge displacements.
template <int dim> Eigen::MatrixXd rigid_motions(const Problem<dim>& problem, const Layout& layout, int body, int unknowns) {
  const auto& mesh = problem.mesh;
  const auto motions = scene::free_motions(problem, body);
  Eigen::MatrixXd rigid = Eigen::MatrixXd::Zero(unknowns, motions.size());
  if (motions.empty()) return rigid;
  for (const int c : layout.body_cells[body])
    for (const int e : mesh.cell_edges[c]) {
      const Edge& edge = layout.edges[e];
      for (int place = 0; place < 4; ++place)
        for (std::size_t m = 0; edge.unknown[place] >= 0 && m < motions.size(); ++m)
          rigid(edge.unknown[place], m) =
              edge.frame.row(place % 2) * displacement(motions[m], mesh.vertices[mesh.edges[e][place / 2]]);
    }
  return rigid;
}

/// Stiffness for edge displacements, k = G A⁻¹ Gᵀ summed, and the loads of body forces and prescribed displacements.
template <int dim> contact::Body assemble(const Problem<dim>& problem, const Layout& layout, int b) {
  std::vector<int> cell_nodes;
  for (const int c : layout.body_cells[b])
    for (const int e : problem.mesh.cell_edges[c]) cell_nodes.push_back(layout.edges[e].node);
  contact::Body body;
  body.nodes = layout.body_nodes[b];
  body.load = Eigen::VectorXd::Zero(body.nodes.back());
  contact::Assembly assembly(body.nodes, cell_nodes, 3);
  for (const int c : layout.body_cells[b]) {
    const Cell cell = make_cell(problem, layout, c);
    const auto half = half_stiffness(cell.block);
    const CellMatrix stiffness = half.transpose() * half;
    assembly.add(cell.unknowns, stiffness);
    LoadVector load = LoadVector::Zero();
    if (!cell.prescribed.isZero(0)) load -= stiffness * cell.prescribed;
    if (cell.weight)
      load += half.transpose() * cell.block.compliance.llt().matrixL().solve(cell.weight->coupling) - cell.weight->loads;
    for (int i = 0; i < n_loads; ++i)
      if (cell.unknowns[i] >= 0) body.load[cell.unknowns[i]] += load[i];
  }
  body.stiffness = assembly.take();
  body.rigid = rigid_motions(problem, layout, b, body.nodes.back());
  return body;
}

/// The amplitudes s of the modes in each cell.
using Amplitudes = std::vector<ModeVector>;

/// The cell's share of edge displacements that are unknown; prescribed ones are `otherwise`.
LoadVector edge_displacements(const Cell& cell, const Eigen::VectorXd& unknowns, const LoadVector& otherwise) {
  LoadVector edges = otherwise;
  for (int i = 0; i < n_loads; ++i)
    if (cell.unknowns[i] >= 0) edges[i] = unknowns[cell.unknowns[i]];
  return edges;
}

/// s = A⁻¹ (Gᵀ μ − ∫ τ_k : C⁻¹ λ̄)
ModeVector amplitudes(const Cell& cell, const LoadVector& edges) {
  ModeVector right = cell.block.loads.transpose() * edges;
  if (cell.weight) right -= cell.weight->coupling;
  return cell.block.compliance.llt().solve(right);
}

/// Takes out what the tractions of the modes lack of continuity and of the given loads: the edge displacements are large
/// against their differences within a cell, and their rounding is a jump of tractions. Evaluated from the amplitudes the
/// jump is seen to the rounding of the stresses themselves, and one more solve removes it.
template <int dim>
void balance_tractions(const Problem<dim>& problem, const Layout& layout, const std::vector<Eigen::VectorXd>& loads,
                       const contact::Solution& solution, Amplitudes& amplitude) {
  std::vector<Eigen::VectorXd> residual = loads;
  for (std::size_t c = 0; c < amplitude.size(); ++c) {
    const Cell cell = make_cell(problem, layout, static_cast<int>(c));
    Eigen::VectorXd& r = residual[problem.mesh.cell_body[c]];
    LoadVector tractions = cell.block.loads * amplitude[c];
    if (cell.weight) tractions += cell.weight->loads;
    for (int i = 0; i < n_loads; ++i)
      if (cell.unknowns[i] >= 0) r[cell.unknowns[i]] -= tractions[i];
  }
  std::vector<Eigen::VectorXd> correction;
  for (std::size_t b = 0; b < residual.size(); ++b) correction.push_back(solution.respond(static_cast<int>(b), residual[b]));
  for (std::size_t c = 0; c < amplitude.size(); ++c) {
    const Cell cell = make_cell(problem, layout, static_cast<int>(c));
    const LoadVector edges = edge_displacements(cell, correction[problem.mesh.cell_body[c]], LoadVector::Zero());
    amplitude[c] += cell.block.compliance.llt().solve(cell.block.loads.transpose() * edges);
  }
}

/// λ = λ̄ + Σ s_k τ_k at the corners. \param loads tractions and pressures on the edge displacements of each body
template <int dim>
Stress<dim> recover(const Problem<dim>& problem, const Layout& layout, const std::vector<Eigen::VectorXd>& loads,
                    const contact::Solution& solution) {
  Amplitudes amplitude(problem.mesh.cells.size());
  for (std::size_t c = 0; c < amplitude.size(); ++c) {
    const Cell cell = make_cell(problem, layout, static_cast<int>(c));
    amplitude[c] = amplitudes(cell, edge_displacements(cell, solution.elastic[problem.mesh.cell_body[c]], cell.prescribed));
  }
  for (int step = 0; step < 2; ++step) balance_tractions(problem, layout, loads, solution, amplitude);
  Stress<dim> stress;
  stress.cell.resize(amplitude.size());
  for (std::size_t c = 0; c < amplitude.size(); ++c) {
    const Cell cell = make_cell(problem, layout, static_cast<int>(c));
    stress.cell[c] = stress_at_corners(cell.block, amplitude[c]);
    for (int i = 0; cell.weight && i < 9; ++i) stress.cell[c][i] += cell.weight->stress[i];
  }
  return stress;
}

template <int dim> std::string explain(const scene::Mesh<dim>& mesh, const contact::Solution& solution) {
  switch (solution.outcome) {
    case contact::Outcome::solved: return "";
    case contact::Outcome::no_equilibrium:
      return "stresses: on this mesh no admissible pressure balances the loads (their resultant passes too close to "
             "the end of a contact line for its edges); refine the mesh there, unless the resultant passes through "
             "the end itself: then no mesh has such a pressure";
    case contact::Outcome::contradiction:
      return "stresses: the gaps and the prescribed displacements contradict each other";
    case contact::Outcome::not_definite:
      return "stresses: in floating point " +
             (solution.body < 0 ? "the contact holds a body by rounding only"
                                : "the body '" + mesh.bodies[solution.body] + "' is not held") +
             "; moduli are too unlike or cells too thin";
  }
  return "";
}

}  // namespace

template <int dim> Result<dim> solve(const Problem<dim>& problem, const std::vector<char>& closed) {
  const Clock clock;
  const Layout layout = lay_out(problem);
  std::vector<contact::Body> bodies;
  for (std::size_t b = 0; b < problem.bodies.size(); ++b) bodies.push_back(assemble(problem, layout, static_cast<int>(b)));
  std::vector<Eigen::VectorXd> loads = traction_loads(problem, layout);
  for (std::size_t b = 0; b < bodies.size(); ++b) bodies[b].load += loads[b];
  set_contact_rows(problem, layout, bodies);

  Result<dim> result;
  result.rows = static_cast<int>(2 * problem.contact.size());
  for (const auto& body : bodies) result.unknowns += static_cast<int>(body.load.size());
  result.assemble = clock.seconds();

  std::vector<char> guess;
  for (const char facet : closed) guess.insert(guess.end(), 2, facet);
  contact::Solution solution = contact::solve(bodies, gap_moments(problem), guess);
  result.outcome = solution.outcome;
  result.reason = explain(problem.mesh, solution);
  result.iterations = solution.iterations;
  result.imbalance = solution.imbalance;
  if (solution.outcome == contact::Outcome::solved) {
    const Clock recovering;
    for (std::size_t b = 0; b < bodies.size(); ++b) loads[b] -= bodies[b].rows.transpose() * solution.pressure;
    result.stress = recover(problem, layout, loads, solution);
    solution.seconds.recover += recovering.seconds();
  }
  result.active_rows = static_cast<int>(std::count(solution.active.begin(), solution.active.end(), 1));
  result.closed.assign(problem.contact.size(), 0);
  for (std::size_t i = 0; i < solution.active.size(); ++i)
    if (solution.active[i]) result.closed[i / 2] = 1;
  result.seconds = solution.seconds;
  return result;
}

template struct Stress<2>;
template struct Result<2>;
template Result<2> solve(const Problem<2>&, const std::vector<char>&);

}  // namespace bracket::dual
