// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "contact/clock.h"
#include "dual/cells.h"
#include "dual/dual.h"

namespace bracket::dual {

namespace {

using scene::Problem;
using scene::Support;
using scene::Vector;

/// The loads of Γ_τ on the edge displacements of each body: ∫ P·μ.
template <int dim> std::vector<Eigen::VectorXd> traction_loads(const Problem<dim>& problem, const Layout& layout) {
  const auto& mesh = problem.mesh;
  std::vector<Eigen::VectorXd> loads;
  for (const auto& nodes : layout.body_nodes) loads.push_back(Eigen::VectorXd::Zero(nodes.back()));
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    if (problem.facets[f].support != Support::traction) continue;
    const auto& facet = mesh.boundary[f];
    const Edge& edge = layout.edges[facet.edge];
    const auto ends = scene::load(problem, static_cast<int>(f));
    for (int i = 0; i < 2; ++i) {
      const Vector<dim> moment = (2 * ends[i] + ends[1 - i]) / 6;
      const int place = 2 * end_of(mesh, facet.edge, facet.vertices[i]);
      for (int k = 0; k < 2; ++k) loads[mesh.cell_body[facet.cell]][edge.unknown[place + k]] += moment[k];
    }
  }
  return loads;
}

/// Rows 2 j, 2 j + 1 of contact facet j: ∫ φ_i r over it, for the hat functions of the first facet's vertices 0 and 1.
/// Both sides count their own outward normal displacement: r = u'·n' + u''·n''.
template <int dim>
void set_contact_rows(const Problem<dim>& problem, const Layout& layout, std::vector<contact::Body>& bodies) {
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

/// The rigid motions that the supports of a body leave, as edge displacements.
template <int dim>
Eigen::MatrixXd rigid_motions(const Problem<dim>& problem, const Layout& layout, int body, int unknowns) {
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
      load +=
          half.transpose() * cell.block.compliance.llt().matrixL().solve(cell.weight->coupling) - cell.weight->loads;
    for (int i = 0; i < n_loads; ++i)
      if (cell.unknowns[i] >= 0) body.load[cell.unknowns[i]] += load[i];
  }
  body.stiffness = assembly.take();
  body.rigid = rigid_motions(problem, layout, b, body.nodes.back());
  return body;
}

/// The amplitudes s of the modes in each cell.
using Amplitudes = std::vector<ModeVector>;

/// s = A⁻¹ (Gᵀ μ − ∫ τ_k : C⁻¹ λ̄)
ModeVector amplitudes(const Cell& cell, const LoadVector& edges) {
  ModeVector right = cell.block.loads.transpose() * edges;
  if (cell.weight) right -= cell.weight->coupling;
  return cell.block.compliance.llt().solve(right);
}

/// Takes out what the tractions of the modes lack of continuity and of the given loads: the edge displacements are
/// large against their differences within a cell, and their rounding is a jump of tractions. Evaluated from the
/// amplitudes the jump is seen to the rounding of the stresses themselves, and one more solve removes it.
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
  for (std::size_t b = 0; b < residual.size(); ++b)
    correction.push_back(solution.respond(static_cast<int>(b), residual[b]));
  for (std::size_t c = 0; c < amplitude.size(); ++c) {
    const Cell cell = make_cell(problem, layout, static_cast<int>(c));
    const LoadVector edges = edge_displacements(cell, correction[problem.mesh.cell_body[c]], LoadVector::Zero());
    amplitude[c] += cell.block.compliance.llt().solve(cell.block.loads.transpose() * edges);
  }
}

/// λ = λ̄ + Σ s_k τ_k at the corners. \param loads tractions and pressures on the edge displacements of each body
template <int dim>
scene::Stress<dim> recover(const Problem<dim>& problem, const Layout& layout, const std::vector<Eigen::VectorXd>& loads,
                           const contact::Solution& solution) {
  Amplitudes amplitude(problem.mesh.cells.size());
  for (std::size_t c = 0; c < amplitude.size(); ++c) {
    const Cell cell = make_cell(problem, layout, static_cast<int>(c));
    const Eigen::VectorXd& elastic = solution.elastic[problem.mesh.cell_body[c]];
    amplitude[c] = amplitudes(cell, edge_displacements(cell, elastic, cell.prescribed));
  }
  for (int step = 0; step < 2; ++step) balance_tractions(problem, layout, loads, solution, amplitude);
  scene::Stress<dim> stress;
  stress.cell.resize(amplitude.size());
  for (std::size_t c = 0; c < amplitude.size(); ++c) {
    const Cell cell = make_cell(problem, layout, static_cast<int>(c));
    stress.cell[c] = stress_at_corners(cell.block, amplitude[c]);
    for (int i = 0; cell.weight && i < 9; ++i) stress.cell[c][i] += cell.weight->stress[i];
  }
  return stress;
}

}  // namespace

template <int dim> Result<dim> solve(const Problem<dim>& problem, const std::vector<char>& closed) {
  const Clock clock;
  const Layout layout = lay_out(problem);
  std::vector<contact::Body> bodies;
  for (std::size_t b = 0; b < problem.bodies.size(); ++b)
    bodies.push_back(assemble(problem, layout, static_cast<int>(b)));
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
  result.reason = contact::reason(
      solution, "stresses", problem.mesh.bodies,
      "on this mesh no admissible pressure balances the loads (their resultant passes too close to the end of a "
      "contact line for its edges); refine the mesh there, unless the resultant passes through the end itself: then no "
      "mesh has such a pressure",
      "the gaps and the prescribed displacements contradict each other");
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

template struct Result<2>;
template Result<2> solve(const Problem<2>&, const std::vector<char>&);

}  // namespace bracket::dual
