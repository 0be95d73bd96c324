// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <stdexcept>

#include "contact/clock.h"
#include "dual/cells.h"
#include "dual/dual.h"
#include "scene/mesh/dissection.h"

namespace bracket::dual {

namespace {

using scene::Problem;
using scene::Support;
using scene::Vector;

/// The loads on the edge displacements of each body: ∫ P·μ.
template <int dim> std::vector<Eigen::VectorXd> traction_loads(const Problem<dim>& problem, const Layout& layout) {
  const auto& mesh = problem.mesh;
  std::vector<Eigen::VectorXd> loads;
  for (const auto& nodes : layout.body_nodes) loads.push_back(Eigen::VectorXd::Zero(nodes.back()));
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    if (!scene::is_loaded(problem.facets[f])) continue;
    const auto& facet = mesh.boundary[f];
    const Edge& edge = layout.edges[facet.edge];
    const auto ends = scene::load(problem, static_cast<int>(f));
    for (int i = 0; i < 2; ++i) {
      const Vector<dim> moment = edge.frame * scene::hat_moment(ends, i);
      const int place = 2 * end_of(mesh, facet.edge, facet.vertices[i]);
      for (int k = 0; k < 2; ++k) loads[mesh.cell_component[facet.cell]][edge.unknown[place + k]] += moment[k];
    }
  }
  return loads;
}

/// Rows 2 j, 2 j + 1 of contact facet j: ∫ φ_i r over it, for the hat functions of the first facet's vertices 0 and 1.
/// Both sides count their own outward normal displacement: r = u'·n' + u''·n''.
template <int dim>
void set_contact_rows(const Problem<dim>& problem, const Layout& layout, std::vector<contact::System>& bodies) {
  const auto& mesh = problem.mesh;
  std::vector<std::vector<Eigen::Triplet<double>>> entries(bodies.size());
  for (std::size_t j = 0; j < problem.contact.size(); ++j) {
    const auto& pair = problem.contact[j];
    using Table = scene::Simplex<dim - 1>;
    const double unit = scene::length(mesh, pair.first) / Table::hat_masses_of;
    for (const int side : {pair.first, pair.second}) {
      if (side < 0) continue;
      const auto& facet = mesh.boundary[side];
      const Edge& edge = layout.edges[facet.edge];
      for (int row = 0; row < 2; ++row)
        for (int i = 0; i < 2; ++i) {
          const int vertex = facet.vertices[side == pair.first ? i : 1 - i];
          const int unknown = edge.unknown[2 * end_of(mesh, facet.edge, vertex)];
          entries[mesh.cell_component[facet.cell]].emplace_back(2 * j + row, unknown, unit * Table::hat_mass(row, i));
        }
    }
  }
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    bodies[b].rows.resize(2 * problem.contact.size(), bodies[b].nodes.back());
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

/// Stiffness for edge displacements, k = G A⁻¹ Gᵀ summed, and what the supports leave. \param paths scene::dissect()
template <int dim>
contact::System assemble(const Problem<dim>& problem, const Layout& layout, const std::vector<Cell>& cells,
                         const std::vector<std::uint64_t>& paths, int b) {
  std::vector<int> cell_nodes;
  std::vector<std::uint64_t> body_paths;
  for (const int c : layout.body_cells[b]) {
    body_paths.push_back(paths[c]);
    for (const int e : problem.mesh.cell_edges[c]) cell_nodes.push_back(layout.edges[e].node);
  }
  contact::System body;
  body.nodes = layout.body_nodes[b];
  body.sequence = contact::elimination(body_paths, cell_nodes, static_cast<int>(body.nodes.size()) - 1);
  contact::Assembly assembly(body.nodes, cell_nodes, 3);
  for (const int c : layout.body_cells[b]) {
    const auto half = half_stiffness(cells[c].compliance, cells[c].loads);
    const CellMatrix stiffness = half.transpose() * half;
    assembly.add(cells[c].unknowns, stiffness);
  }
  body.stiffness = assembly.take();
  body.rigid = rigid_motions(problem, layout, b, body.nodes.back());
  return body;
}

/// The amplitudes s of the modes in each cell.
using Amplitudes = std::vector<ModeVector>;

/// s = A⁻¹ (Gᵀ μ − ∫ τ_k : C⁻¹ λ̄)
ModeVector amplitudes(const Cell& cell, const LoadVector& edges, const Particular* weight) {
  ModeVector right = cell.loads.transpose() * edges;
  if (weight) right -= weight->coupling;
  return cell.compliance.solve(right);
}

/// What the data of a problem do within its cells, empty where they do nothing anywhere.
struct CellData {
  std::vector<LoadVector> prescribed;
  std::vector<Particular> weight;
};
const Particular* weight_of(const CellData& data, std::size_t cell) {
  return data.weight.empty() ? nullptr : &data.weight[cell];
}
LoadVector prescribed_on(const CellData& data, std::size_t cell) {
  return data.prescribed.empty() ? LoadVector::Zero() : data.prescribed[cell];
}

/// Takes the side loads of the modes and of λ̄ off the loads of each body.
template <int dim>
void subtract_tractions(const Problem<dim>& problem, const std::vector<Cell>& cells, const CellData& data,
                        const Amplitudes& amplitude, std::vector<Eigen::VectorXd>& loads) {
  for (std::size_t c = 0; c < cells.size(); ++c) {
    Eigen::VectorXd& load = loads[problem.mesh.cell_component[c]];
    LoadVector tractions = cells[c].loads * amplitude[c];
    if (const Particular* weight = weight_of(data, c)) tractions += weight->loads;
    for (int i = 0; i < n_loads; ++i)
      if (cells[c].unknowns[i] >= 0) load[cells[c].unknowns[i]] -= tractions[i];
  }
}

/// The loads of Γ_τ, of body forces and of prescribed displacements.
template <int dim>
std::vector<Eigen::VectorXd> all_loads(const Problem<dim>& problem, const std::vector<Cell>& cells,
                                       const CellData& data, std::vector<Eigen::VectorXd> of_tractions) {
  if (data.prescribed.empty() && data.weight.empty()) return of_tractions;
  Amplitudes amplitude;
  for (std::size_t c = 0; c < cells.size(); ++c)
    amplitude.push_back(amplitudes(cells[c], prescribed_on(data, c), weight_of(data, c)));
  subtract_tractions(problem, cells, data, amplitude, of_tractions);
  return of_tractions;
}

/// Takes out what the tractions of the modes lack of continuity and of the given loads: the edge displacements are
/// large against their differences within a cell, and their rounding is a jump of tractions. Evaluated from the
/// amplitudes the jump is seen to the rounding of the stresses themselves, and one more solve removes it.
template <int dim>
Amplitudes balanced(const Problem<dim>& problem, const std::vector<Cell>& cells, const CellData& data,
                    const contact::Bodies& bodies, std::vector<Eigen::VectorXd> loads, Amplitudes amplitude) {
  subtract_tractions(problem, cells, data, amplitude, loads);
  for (std::size_t b = 0; b < loads.size(); ++b) loads[b] = bodies.respond(static_cast<int>(b), loads[b]);
  for (std::size_t c = 0; c < amplitude.size(); ++c) {
    const LoadVector edges = edge_displacements(cells[c], loads[problem.mesh.cell_component[c]], LoadVector::Zero());
    amplitude[c] += amplitudes(cells[c], edges, nullptr);
  }
  return amplitude;
}

/// λ = λ̄ + Σ s_k τ_k at the corners. \param loads tractions and pressures on the edge displacements of each body
template <int dim>
scene::Stress<dim> recover(const Problem<dim>& problem, const std::vector<Cell>& cells, const CellData& data,
                           const contact::Bodies& bodies, const std::vector<Eigen::VectorXd>& loads,
                           const std::vector<Eigen::VectorXd>& elastic) {
  Amplitudes amplitude;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const LoadVector edges =
        edge_displacements(cells[c], elastic[problem.mesh.cell_component[c]], prescribed_on(data, c));
    amplitude.push_back(amplitudes(cells[c], edges, weight_of(data, c)));
  }
  for (int step = 0; step < 2; ++step) amplitude = balanced(problem, cells, data, bodies, loads, std::move(amplitude));
  scene::Stress<dim> stress;
  stress.cell.resize(amplitude.size());
  for (std::size_t c = 0; c < amplitude.size(); ++c) {
    stress.cell[c] = stress_at_corners(cells[c].piola, amplitude[c]);
    if (const Particular* weight = weight_of(data, c))
      for (int i = 0; i < 9; ++i) stress.cell[c][i] += weight->stress[i];
  }
  return stress;
}

}  // namespace

template <int dim> struct Solver<dim>::Factorised {
  Layout layout;
  std::vector<Cell> cells;
  contact::Bodies bodies;
  double order, assemble;  ///< seconds
};

template <int dim> Solver<dim>::Solver(const Problem<dim>& problem) {
  Clock clock;
  const std::vector<std::uint64_t> paths = scene::dissect(problem.mesh);
  const double dissected = clock.lap();
  Layout layout = lay_out(problem);
  std::vector<Cell> cells = make_cells(problem, layout);
  std::vector<contact::System> systems;
  for (std::size_t b = 0; b < problem.mesh.components.size(); ++b)
    systems.push_back(assemble(problem, layout, cells, paths, static_cast<int>(b)));
  set_contact_rows(problem, layout, systems);
  const double assembled = clock.lap();
  factorised_ = std::make_shared<const Factorised>(
      Factorised{std::move(layout), std::move(cells), contact::Bodies(std::move(systems)), dissected, assembled});
}

template <int dim> Result<dim> Solver<dim>::solve(const Problem<dim>& problem, const std::vector<char>& closed) const {
  const Clock clock;
  const auto& [layout, cells, bodies, dissected, assembled] = *factorised_;
  if (lay_out(problem).body_nodes != layout.body_nodes ||
      2 * static_cast<Eigen::Index>(problem.contact.size()) != bodies.systems().front().rows.rows())
    throw std::invalid_argument(
        "dual::Solver: the problem has other unknowns or contact facets than the one that was "
        "factorised");
  const CellData data{prescribed_displacements(problem), weights(problem, layout, cells)};
  std::vector<Eigen::VectorXd> loads = traction_loads(problem, layout);
  const std::vector<Eigen::VectorXd> all = all_loads(problem, cells, data, loads);
  std::vector<char> guess;
  for (const char facet : closed) guess.insert(guess.end(), 2, facet);
  const double of_data = clock.seconds();

  contact::Solution solution = bodies.solve(all, gap_moments(problem), guess);
  Result<dim> result;
  result.termination = solution.termination;
  result.reason = contact::reason(
      solution, "stresses", problem.mesh.components,
      "on this mesh no admissible pressure balances the loads (their resultant passes too close to the end of a "
      "contact line for its edges); refine the mesh there, unless the resultant passes through the end itself: then no "
      "mesh has such a pressure",
      "the gaps and the prescribed displacements contradict each other");
  if (solution.termination == contact::Termination::solved) {
    const Clock recovering;
    for (std::size_t b = 0; b < loads.size(); ++b) loads[b] -= bodies.systems()[b].rows.transpose() * solution.pressure;
    result.stress = recover(problem, cells, data, bodies, loads, solution.elastic);
    solution.seconds.recover += recovering.seconds();
  }
  result.closed.assign(problem.contact.size(), 0);
  for (std::size_t i = 0; i < solution.active.size(); ++i)
    if (solution.active[i]) result.closed[i / 2] = 1;
  result.statistics = contact::statistics(bodies, solution);
  result.statistics.seconds.order += dissected;
  result.statistics.seconds.assemble = assembled + of_data;
  return result;
}

template <int dim> Result<dim> solve(const Problem<dim>& problem, const std::vector<char>& closed) {
  return Solver<dim>(problem).solve(problem, closed);
}

template struct Result<2>;
template class Solver<2>;
template Result<2> solve(const Problem<2>&, const std::vector<char>&);

}  // namespace bracket::dual
