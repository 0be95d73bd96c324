// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <stdexcept>
#include <variant>

#include "contact/clock.h"
#include "dual/cells.h"
#include "dual/dual.h"
#include "dual/rows.h"
#include "scene/mesh/dissection.h"
#include "scene/parallel.h"

namespace bracket::dual {

namespace {

using scene::Problem;
using scene::Vector;

/// The loads on the edge displacements of each body: ∫ P·μ.
template <int dim> std::vector<Eigen::VectorXd> traction_loads(const Problem<dim>& problem, const Layout& layout) {
  const auto& mesh = problem.mesh;
  const int degree = layout.degree;
  std::vector<Eigen::VectorXd> loads;
  for (const auto& nodes : layout.body_nodes) loads.push_back(Eigen::VectorXd::Zero(nodes.back()));
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    if (!scene::is_loaded(problem.facets[f])) continue;
    const auto& facet = mesh.boundary[f];
    const Edge& edge = layout.edges[facet.edge];
    const auto ends = scene::load(problem, static_cast<int>(f));
    const auto higher = scene::higher_load(problem, static_cast<int>(f));
    const int own = degree_of_load(problem.facets[f]);
    for (int i = 0; i <= degree; ++i) {
      Vector<dim> moment = Vector<dim>::Zero();
      for (int k = 0; k < 2; ++k) moment += scene::number<double>(scene::bernstein_mass(degree, i, 1, k)) * ends[k];
      for (int k = 2; k <= own; ++k) moment += scene::legendre_moment<double>(degree, i, k) * higher[k - 2];
      moment = (edge.frame * moment).eval();
      const int place = 2 * along_edge(mesh, degree, facet.edge, facet.vertices[0], i);
      for (int k = 0; k < 2; ++k)  // none where a support holds the edge
        if (const int unknown = edge.unknown[place + k]; unknown >= 0)
          loads[mesh.cell_component[facet.cell]][unknown] += moment[k];
    }
  }
  return loads;
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
      const auto& [a, b] = scene::positions(mesh, mesh.edges[e]);
      for (int place = 0; place < 2 * (layout.degree + 1); ++place)
        for (std::size_t m = 0; edge.unknown[place] >= 0 && m < motions.size(); ++m)
          rigid(edge.unknown[place], m) =
              edge.frame.row(place % 2) *
              displacement(motions[m], scene::linear_coefficient<double>(a, b, layout.degree, place / 2));
    }
  return rigid;
}

/// Stiffness for edge displacements, k = G A⁻¹ Gᵀ summed, and what the supports leave. \param paths scene::dissect()
template <int degree, int dim>
contact::System assemble(const Problem<dim>& problem, const Layout& layout, const std::vector<Cell<degree>>& cells,
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
  const std::vector<int>& own = layout.body_cells[b];
  constexpr std::size_t together = 4096;  // cells whose matrices are held until they are added
  std::vector<CellMatrix<degree>> stiffness;
  for (std::size_t begin = 0; begin < own.size(); begin += together) {
    stiffness.resize(std::min(together, own.size() - begin));
    scene::for_each_index(static_cast<int>(stiffness.size()), [&](int i) {
      const Cell<degree>& cell = cells[own[begin + i]];
      const auto half = half_stiffness<degree>(cell.compliance, cell.loads);
      stiffness[i] = half.transpose() * half;
    });
    for (std::size_t i = 0; i < stiffness.size(); ++i) assembly.add(cells[own[begin + i]].unknowns, stiffness[i]);
  }
  body.stiffness = assembly.take();
  body.rigid = rigid_motions(problem, layout, b, body.nodes.back());
  return body;
}

/// The amplitudes s of the modes in each cell.
template <int degree> using Amplitudes = std::vector<ModeVector<degree>>;

/// s = A⁻¹ (Gᵀ μ − ∫ τ_k : C⁻¹ λ̄)
template <int degree>
ModeVector<degree> amplitudes(const Cell<degree>& cell, const LoadVector<degree>& edges,
                              const Particular<degree>* weight) {
  ModeVector<degree> right = cell.loads.transpose() * edges;
  if (weight) right -= weight->coupling;
  return cell.compliance.solve(right);
}

/// What the data of a problem do within its cells, empty where they do nothing anywhere.
template <int degree> struct CellData {
  std::vector<LoadVector<degree>> prescribed;
  std::vector<Particular<degree>> weight;
};
template <int degree> const Particular<degree>* weight_of(const CellData<degree>& data, std::size_t cell) {
  return data.weight.empty() ? nullptr : &data.weight[cell];
}
template <int degree> LoadVector<degree> prescribed_on(const CellData<degree>& data, std::size_t cell) {
  return data.prescribed.empty() ? LoadVector<degree>(LoadVector<degree>::Zero()) : data.prescribed[cell];
}

/// Takes the side loads of the modes and of λ̄ off the loads of each body.
template <int degree, int dim>
void subtract_tractions(const Problem<dim>& problem, const std::vector<Cell<degree>>& cells,
                        const CellData<degree>& data, const Amplitudes<degree>& amplitude,
                        std::vector<Eigen::VectorXd>& loads) {
  std::vector<LoadVector<degree>> tractions(cells.size());
  scene::for_each_index(static_cast<int>(cells.size()), [&](int c) {
    tractions[c] = cells[c].loads * amplitude[c];
    if (const Particular<degree>* weight = weight_of(data, c)) tractions[c] += weight->loads;
  });
  for (std::size_t c = 0; c < cells.size(); ++c) {
    Eigen::VectorXd& load = loads[problem.mesh.cell_component[c]];
    for (int i = 0; i < n_loads(degree); ++i)
      if (cells[c].unknowns[i] >= 0) load[cells[c].unknowns[i]] -= tractions[c][i];
  }
}

/// The loads of Γ_τ, of body forces and of prescribed displacements.
template <int degree, int dim>
std::vector<Eigen::VectorXd> all_loads(const Problem<dim>& problem, const std::vector<Cell<degree>>& cells,
                                       const CellData<degree>& data, std::vector<Eigen::VectorXd> of_tractions) {
  if (data.prescribed.empty() && data.weight.empty()) return of_tractions;
  Amplitudes<degree> amplitude(cells.size());
  scene::for_each_index(static_cast<int>(cells.size()), [&](int c) {
    amplitude[c] = amplitudes<degree>(cells[c], prescribed_on(data, c), weight_of(data, c));
  });
  subtract_tractions(problem, cells, data, amplitude, of_tractions);
  return of_tractions;
}

/// Takes out what the tractions of the modes lack of continuity and of the given loads: the edge displacements are
/// large against their differences within a cell, and their rounding is a jump of tractions. Evaluated from the
/// amplitudes the jump is seen to the rounding of the stresses themselves, and one more solve removes it.
template <int degree, int dim>
Amplitudes<degree> balanced(const Problem<dim>& problem, const std::vector<Cell<degree>>& cells,
                            const CellData<degree>& data, const contact::Bodies& bodies,
                            std::vector<Eigen::VectorXd> loads, Amplitudes<degree> amplitude) {
  subtract_tractions(problem, cells, data, amplitude, loads);
  for (std::size_t b = 0; b < loads.size(); ++b) loads[b] = bodies.respond(static_cast<int>(b), loads[b]);
  scene::for_each_index(static_cast<int>(amplitude.size()), [&](int c) {
    const LoadVector<degree> edges =
        edge_displacements<degree>(cells[c], loads[problem.mesh.cell_component[c]], LoadVector<degree>::Zero());
    amplitude[c] += amplitudes<degree>(cells[c], edges, nullptr);
  });
  return amplitude;
}

/// λ = λ̄ + Σ s_k τ_k at the corners. \param loads tractions and pressures on the edge displacements of each body
template <int degree, int dim>
scene::Stress<dim> recover(const Problem<dim>& problem, const std::vector<Cell<degree>>& cells,
                           const CellData<degree>& data, const contact::Bodies& bodies,
                           const std::vector<Eigen::VectorXd>& loads, const std::vector<Eigen::VectorXd>& elastic) {
  Amplitudes<degree> amplitude(cells.size());
  const int n = static_cast<int>(cells.size());
  scene::for_each_index(n, [&](int c) {
    const LoadVector<degree> edges =
        edge_displacements<degree>(cells[c], elastic[problem.mesh.cell_component[c]], prescribed_on(data, c));
    amplitude[c] = amplitudes<degree>(cells[c], edges, weight_of(data, c));
  });
  for (int step = 0; step < 2; ++step) amplitude = balanced(problem, cells, data, bodies, loads, std::move(amplitude));
  scene::Stress<dim> stress{degree, {}};
  stress.cell.resize(amplitude.size());
  scene::for_each_index(n, [&](int c) {
    const BlockStress<degree> own = block_stress<degree>(cells[c].piola, amplitude[c]);
    stress.cell[c].assign(own.begin(), own.end());
    if (const Particular<degree>* weight = weight_of(data, c))
      for (int i = 0; i < n_coefficients(degree); ++i) stress.cell[c][i] += weight->stress[i];
  });
  return stress;
}

/// The bodies of one degree, factorised.
template <int degree, int dim> struct OfDegree {
  Layout layout;
  std::vector<Cell<degree>> cells;
  Shear shear;
  contact::Bodies bodies;
  double order, assemble;  ///< seconds
};

template <int degree, int dim> OfDegree<degree, dim> factorised(const Problem<dim>& problem, Shear shear) {
  Clock clock;
  const std::vector<std::uint64_t> paths = scene::dissect(problem.mesh);
  const double dissected = clock.lap();
  Layout layout = lay_out(problem, degree);
  std::vector<Cell<degree>> cells = make_cells<degree>(problem, layout);
  std::vector<contact::System> systems;
  for (std::size_t b = 0; b < problem.mesh.components.size(); ++b)
    systems.push_back(assemble<degree>(problem, layout, cells, paths, static_cast<int>(b)));
  set_contact_rows(problem, layout, contact_rows(problem, degree, shear), systems);
  add_springs(problem, degree, systems);
  const double assembled = clock.lap();
  return {std::move(layout), std::move(cells), shear, contact::Bodies(std::move(systems)), dissected, assembled};
}

template <int degree, int dim>
Result<dim> solved(const OfDegree<degree, dim>& of, const Problem<dim>& problem, const std::vector<char>& closed,
                   const Eigen::VectorXd& wider) {
  const Clock clock;
  const auto& [layout, cells, shear, bodies, dissected, assembled] = of;
  const std::vector<RowOf> rows = contact_rows(problem, degree, shear);
  if (lay_out(problem, degree).body_nodes != layout.body_nodes ||
      static_cast<Eigen::Index>(rows.size()) != bodies.systems().front().rows.rows())
    throw std::invalid_argument(
        "dual::Solver: the problem has other unknowns or contact facets than the one that was factorised");
  if (scene::degree_of_loads(problem) > degree)
    throw std::invalid_argument(
        "dual::Solver: the loads have a higher degree than the stresses, which cannot carry them");
  const CellData<degree> data{prescribed_displacements<degree>(problem), weights<degree>(problem, layout, cells)};
  std::vector<Eigen::VectorXd> loads = traction_loads(problem, layout);
  std::vector<Eigen::VectorXd> all = all_loads<degree>(problem, cells, data, loads);
  if (const auto& systems = bodies.systems(); systems.size() > all.size())  // springs
    all.push_back(Eigen::VectorXd::Zero(systems.back().stiffness.rows()));
  Eigen::VectorXd of_gap = moments(problem, degree, &scene::ContactFacet::upper);
  if (wider.size() > 0) of_gap += wider;
  const Eigen::VectorXd of_slip = moments(problem, degree, &scene::ContactFacet::slip);
  Eigen::VectorXd gaps(static_cast<Eigen::Index>(rows.size()));
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const int place = (degree + 1) * rows[r].facet + rows[r].i;
    gaps[r] = rows[r].of_approach * of_gap[place] + rows[r].of_slip * of_slip[place];
  }
  std::vector<char> guess;
  for (const RowOf& row : rows)
    if (!closed.empty()) guess.push_back((closed[row.facet] & row.state()) != 0);
  const double of_data = clock.seconds();

  contact::Solution solution = bodies.solve(all, gaps, guess, limits(problem, degree, rows));
  std::vector<std::string> names = problem.mesh.components;
  names.push_back("springs");
  Result<dim> result;
  result.termination = solution.termination;
  result.reason = contact::reason(
      solution, "stresses", names,
      "on this mesh no admissible pressure balances the loads (their resultant passes too close to the end of a "
      "contact line for its edges); refine the mesh there, unless the resultant passes through the end itself: then no "
      "mesh has such a pressure",
      "the gaps and the prescribed displacements contradict each other");
  if (solution.termination == contact::Termination::solved) {
    const Clock recovering;
    for (std::size_t b = 0; b < loads.size(); ++b) loads[b] -= bodies.systems()[b].rows.transpose() * solution.pressure;
    result.stress = recover<degree>(problem, cells, data, bodies, loads, solution.elastic);
    solution.seconds.recover += recovering.seconds();
  }
  result.closed.assign(problem.contact.size(), 0);
  for (std::size_t i = 0; i < solution.active.size(); ++i)
    if (solution.active[i]) result.closed[rows[i].facet] |= rows[i].state();
  result.statistics = contact::statistics(bodies, solution);
  result.statistics.seconds.order += dissected;
  result.statistics.seconds.assemble = assembled + of_data;
  return result;
}

}  // namespace

template <int dim> struct Solver<dim>::Factorised {
  std::variant<OfDegree<1, dim>, OfDegree<2, dim>, OfDegree<3, dim>> of;
};

template <int dim> Solver<dim>::Solver(const Problem<dim>& problem, int degree, Shear shear) {
  const auto keep = [&](auto of) { factorised_ = std::make_shared<const Factorised>(Factorised{std::move(of)}); };
  switch (degree) {
    case 1: keep(factorised<1>(problem, shear)); break;
    case 2: keep(factorised<2>(problem, shear)); break;
    case 3: keep(factorised<3>(problem, shear)); break;
    default: throw std::invalid_argument("dual::Solver: block elements have a degree from 1 to 3");
  }
}

template <int dim>
Result<dim> Solver<dim>::solve(const Problem<dim>& problem, const std::vector<char>& closed,
                               const Eigen::VectorXd& wider) const {
  return std::visit([&](const auto& of) { return solved(of, problem, closed, wider); }, factorised_->of);
}

template <int dim> Result<dim> solve(const Problem<dim>& problem, int degree, const std::vector<char>& closed) {
  return Solver<dim>(problem, degree).solve(problem, closed);
}

template struct Result<2>;
template class Solver<2>;
template Result<2> solve(const Problem<2>&, int, const std::vector<char>&);

}  // namespace bracket::dual
