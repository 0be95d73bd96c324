// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "contact/clock.h"
#include "primal/elasticity.h"
#include "primal/factorised.h"
#include "primal/matched_pressure.h"
#include "primal/ranks/exchange.h"
#include "primal/ranks/ranks.h"
#include "primal/ranks/ties.h"
#include "scene/bernstein.h"
#include "scene/problem/law.h"

namespace bracket::primal {

namespace {

using Eigen::Index;
using Eigen::VectorXd;
using scene::Problem;

constexpr double tight = 1e-9, loose = 1e-4;  // tolerances of the iteration

/// What all processes do together. Where it fails in one the others wait for it: the program ends.
template <class Work> auto or_end(const Work& work) {
  std::string why;
  try {
    return work();
  } catch (const std::bad_alloc&) {
    why = "the memory did not suffice";
  } catch (const std::exception& error) {
    why = error.what();
  }
  constexpr int failed = 70;  // none of our own statuses
  std::fprintf(stderr, "bracket-mpi: %s\n", why.c_str());
  MPI_Abort(MPI_COMM_WORLD, failed);
  std::abort();
}

/// A mesh that is on the processes, seen from the root.
struct OnProcesses {
  MPI_Comm processes;
  const Unknowns& unknowns;
  Pieces pieces;
  System system;
  bool direct;

  /// Minimises L where these rows are closed, and tells the forces that it takes.
  /// \param load f, by unknowns   \param q in: to start from
  Answer solve(const std::vector<Tie>& ties, const std::vector<int>& pinned, const VectorXd& load, double tolerance,
               VectorXd& q);
};

Answer OnProcesses::solve(const std::vector<Tie>& ties, const std::vector<int>& pinned, const VectorXd& load,
                          double tolerance, VectorXd& q) {
  const auto& nodes = unknowns.nodes.node;
  const std::vector<char> is_kept = kept(unknowns, ties, pinned);
  VectorXd own = load;
  for (const Tie& tie : ties)
    for (const auto& [other, factor] : tie.others) own[other] += factor * load[tie.unknown];
  VectorXd to = VectorXd::Zero(q.size()), start = to;
  const auto place = [&](Index unknown) { return 3 * Index{pieces.number[unknown / 3]} + unknown % 3; };
  for (Index i = 0; i < q.size(); ++i)
    if (is_kept[i]) {
      to[place(i)] = own[i];
      start[place(i)] = q[i];
    }
  const std::vector<TiedNode> tied = tied_nodes(unknowns, pieces.number, ties, pinned);
  std::vector<std::vector<TiedNode>> of_process(pieces.of.size());
  std::vector<const TiedNode*> at(nodes.size(), nullptr);
  for (const TiedNode& node : tied) at[node.node] = &node;
  for (std::size_t p = 0; p < of_process.size(); ++p) {
    for (const int i : pieces.at[p])
      if (at[pieces.number[i]] != nullptr) of_process[p].push_back(*at[pieces.number[i]]);
    std::ranges::sort(of_process[p], {}, &TiedNode::node);
  }
  const auto solved = [&] {
    return or_end([&] {
      ordered(processes, Order::solve);
      const Way way = broadcast(processes, Way{direct, tolerance});
      return system.solve(scattered(processes, of_process), way, to, start);
    });
  };
  Answer answer = solved();
  if (!answer.converged && !direct) {
    direct = true;
    answer = solved();
  }
  for (Index i = 0; i < q.size(); ++i) q[i] = is_kept[i] ? answer.unknowns[place(i)] : 0;
  for (const Tie& tie : ties) {
    q[tie.unknown] = tie.constant;
    for (const auto& [other, factor] : tie.others)
      if (is_kept[other]) q[tie.unknown] += factor * q[other];
  }
  VectorXd forces(q.size());  // K u by the unknowns' directions
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const auto first = 3 * static_cast<Index>(i);
    forces.segment<3>(first) = nodes[i].directions.transpose() * answer.forces.segment<3>(3 * Index{pieces.number[i]});
  }
  answer.forces = forces;
  return answer;
}

/// Σ coefficient · q − bound of a row.
double beyond(const Unknowns& unknowns, int row, const VectorXd& q) {
  double sum = -unknowns.rows[row].bound;
  for (const auto& [unknown, coefficient] : unknowns.terms[row]) sum += coefficient * q[unknown];
  return sum;
}

/// The multipliers of closed rows, of least squares for the forces on what they touch; of others 0.
VectorXd multipliers(const Unknowns& unknowns, const std::vector<int>& closed, const VectorXd& force) {
  VectorXd result = VectorXd::Zero(static_cast<Index>(unknowns.rows.size()));
  std::vector<char> is_closed(unknowns.rows.size(), 0);
  for (const int i : closed) is_closed[i] = 1;
  for (const auto& group : unknowns.groups) {
    std::vector<int> rows;
    std::ranges::copy_if(group.rows, std::back_inserter(rows), [&](int i) { return is_closed[i] != 0; });
    if (rows.empty()) continue;
    Eigen::MatrixXd columns =
        Eigen::MatrixXd::Zero(static_cast<Index>(group.unknowns.size()), static_cast<Index>(rows.size()));
    VectorXd of(columns.rows());
    for (std::size_t j = 0; j < rows.size(); ++j)
      for (const auto& [q, coefficient] : unknowns.terms[rows[j]])
        columns(std::ranges::lower_bound(group.unknowns, q) - group.unknowns.begin(), static_cast<Index>(j)) +=
            coefficient;
    for (Index i = 0; i < of.size(); ++i) of[i] = force[group.unknowns[i]];
    const VectorXd own = columns.householderQr().solve(of);
    for (std::size_t j = 0; j < rows.size(); ++j) result[rows[j]] = own[static_cast<Index>(j)];
  }
  return result;
}

/// By unknowns, from vectors of each body's.
VectorXd together(const Unknowns& unknowns, const std::vector<VectorXd>& of_bodies) {
  VectorXd result = VectorXd::Zero(unknowns.size());
  for (std::size_t b = 0; b < of_bodies.size(); ++b)
    for (Index i = 0; i < of_bodies[b].size(); ++i) result[unknowns.of_body[b][i]] = of_bodies[b][i];
  return result;
}
std::vector<VectorXd> apart(const Unknowns& unknowns, const VectorXd& all) {
  std::vector<VectorXd> result;
  for (const auto& list : unknowns.of_body) {
    result.emplace_back(static_cast<Index>(list.size()));
    for (std::size_t i = 0; i < list.size(); ++i) result.back()[static_cast<Index>(i)] = all[list[i]];
  }
  return result;
}

/// The free motions of each body, by its unknowns.
std::vector<Eigen::MatrixXd> motions_of(const Unknowns& unknowns) {
  const auto& [problem, nodes, rows, of_body, terms, groups] = unknowns;
  const auto& mesh = problem.mesh;
  std::vector<std::vector<scene::RigidMotion<3>>> motions;
  std::vector<Eigen::MatrixXd> result;
  for (std::size_t b = 0; b < of_body.size(); ++b) {
    motions.push_back(scene::free_motions(problem, static_cast<int>(b)));
    result.push_back(
        Eigen::MatrixXd::Zero(static_cast<Index>(of_body[b].size()), static_cast<Index>(motions[b].size())));
  }
  const auto& indices = scene::bernstein_indices<3>(nodes.degree);
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    const int body = mesh.cell_component[c];
    if (motions[body].empty()) continue;
    const auto x = scene::positions(mesh, mesh.cells[c]);
    const std::vector<int> list = cell_nodes(mesh, nodes, static_cast<int>(c));
    for (std::size_t i = 0; i < list.size(); ++i) {
      const Node<3>& node = nodes.node[list[i]];
      scene::Vector<3> at = x[0];
      for (int v = 1; v < 4; ++v) at += indices[i][v] * (x[v] - x[0]) / nodes.degree;
      for (std::size_t m = 0; m < motions[body].size(); ++m)
        for (int k = 0; k < node.free; ++k)
          result[body](node.unknown + k, static_cast<Index>(m)) =
              node.directions.col(k).dot(displacement(motions[body][m], at));
    }
  }
  return result;
}

Eigen::MatrixXd together(const Unknowns& unknowns, const std::vector<Eigen::MatrixXd>& of_bodies) {
  Index count = 0;
  for (const auto& motions : of_bodies) count += motions.cols();
  if (count == 0) return Eigen::MatrixXd(0, 0);
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(unknowns.size(), count);
  count = 0;
  for (std::size_t b = 0; b < of_bodies.size(); ++b)
    for (Index m = 0; m < of_bodies[b].cols(); ++m, ++count)
      for (Index i = 0; i < of_bodies[b].rows(); ++i) result(unknowns.of_body[b][i], count) = of_bodies[b](i, m);
  return result;
}

/// An isotropic material of about the stiffness of another: what is nearly incompressible gives way to contact as
/// others do.
scene::Elasticity<3> compressible(const scene::Material<3>& material) {
  const double young = 3 / material.compliance().topLeftCorner<3, 3>().trace();
  return scene::isotropic<3>(young, 0.3).stiffness();
}

/// About the diagonal of K at the unknowns that contact may touch, of each body; elsewhere zero.
std::vector<VectorXd> stiffness_at_contact(const Unknowns& unknowns) {
  const auto& [problem, nodes, rows, of_body, terms, groups] = unknowns;
  std::vector<char> touched(nodes.node.size(), 0);
  for (const auto& group : groups)
    for (const int q : group.unknowns) touched[q / 3] = 1;
  VectorXd all = VectorXd::Zero(unknowns.size());
  Eigen::MatrixXd stiffness;
  for (std::size_t c = 0; c < problem.mesh.cells.size(); ++c) {
    const std::vector<int> list = cell_nodes(problem.mesh, nodes, static_cast<int>(c));
    if (std::ranges::none_of(list, [&](int i) { return touched[i] != 0; })) continue;
    set_cell_stiffness<3>(scene::positions(problem.mesh, problem.mesh.cells[c]),
                          compressible(body_of(problem, static_cast<int>(c)).material), nodes.degree, stiffness);
    for (std::size_t i = 0; i < list.size(); ++i) {
      const auto at = 3 * static_cast<Index>(i);
      all.segment<3>(3 * Index{list[i]}).array() += stiffness.block<3, 3>(at, at).trace() / 3;
    }
  }
  return apart(unknowns, all);
}

/// The rows that least energy closes, and the displacements.
struct Contact {
  std::vector<int> closed;
  VectorXd q;
  VectorXd force;  ///< of the contact, by unknowns
  int iterations = 0;
};

/// Rows that are to be closed next, by what displacements say.
struct Next {
  std::vector<int> closed;
  bool changed = false;
};

/// Rows that are passed close, rows that pull open; but no more of these than what keeps bodies held.
/// \param may_open whether any may   \param unresisted how many free motions no contact resists
Next next_rows(const Unknowns& unknowns, const Eigen::MatrixXd& motions, Index unresisted, const Contact& now,
               double tolerance, bool may_open) {
  const VectorXd multiplier = multipliers(unknowns, now.closed, now.force);
  // What the solver's tolerance explains is no reason to open or to close.
  const double noise = tolerance * now.q.lpNorm<Eigen::Infinity>();
  const double noise_of_force = tolerance * (multiplier.size() > 0 ? multiplier.lpNorm<Eigen::Infinity>() : 0.0);
  std::vector<char> is_closed(unknowns.rows.size(), 0);
  for (const int row : now.closed) is_closed[row] = 1;
  Next next;
  std::vector<int> released;
  for (std::size_t i = 0; i < unknowns.rows.size(); ++i)
    if (const int row = static_cast<int>(i); !is_closed[i] && beyond(unknowns, row, now.q) > noise)
      next.closed.push_back(row);
  next.changed = !next.closed.empty();
  for (const int row : now.closed) {
    const bool stays = !may_open || unknowns.rows[row].lower < 0 || multiplier[row] >= -noise_of_force;
    (stays ? next.closed : released).push_back(row);
  }
  std::ranges::sort(released, {}, [&](int row) { return multiplier[row]; });  // what pulls most first
  const std::vector<int> kept = next.closed;
  for (std::size_t count = released.size();; count /= 2) {
    next.closed = kept;
    next.closed.insert(next.closed.end(), released.begin() + static_cast<std::ptrdiff_t>(count), released.end());
    if (count > 0 && free_motions(unknowns, motions, next.closed).cols() > unresisted) continue;
    next.changed = next.changed || count > 0;
    return next;
  }
}

/// A primal–dual active set. The first steps need not be solved to the end.
/// \param load f   \param closed rows expected to be
Contact active_set(OnProcesses& on, const VectorXd& load, const Eigen::MatrixXd& motions, std::vector<int> closed) {
  // Later nothing opens any more, so that it ends, but for rows that depend on others and replace each other without
  // end: then the last displacements will do.
  constexpr int loose_steps = 3, opening_steps = 20, most_steps = 60;
  const Unknowns& unknowns = on.unknowns;
  std::vector<int> all(unknowns.rows.size());
  std::iota(all.begin(), all.end(), 0);
  const Index unresisted = free_motions(unknowns, motions, all).cols();
  if (free_motions(unknowns, motions, closed).cols() > unresisted) closed = all;
  Contact now{std::move(closed), VectorXd::Zero(unknowns.size()), {}};
  bool is_loose = !all.empty();
  for (int step = 1;; ++step) {
    const double tolerance = is_loose ? loose : tight;
    const std::vector<Tie> tied = ties(unknowns, now.closed);
    const std::vector<int> pinned = pins(unknowns, free_motions(unknowns, motions, now.closed), tied);
    const Answer solved = on.solve(tied, pinned, load, tolerance, now.q);
    now.iterations += solved.iterations;
    now.force = load - solved.forces;
    Next next = next_rows(unknowns, motions, unresisted, now, tolerance, step <= opening_steps);
    if ((!next.changed || step >= most_steps) && !is_loose) return now;
    is_loose = next.changed && step < loose_steps;
    if (next.changed) now.closed = std::move(next.closed);
  }
}

bool by_factorisation(const Problem<3>& problem, int degree) {
  const std::size_t nodes = problem.mesh.vertices.size() + (degree > 1 ? problem.mesh.edges.size() : 0);
  constexpr std::size_t few = 20000;
  // Largest by smallest modulus, 2 (1 + ν)/(1 − 2 ν) where isotropic: at ν = 0.49 multigrid takes four times the
  // iterations of 0.3, at 0.4999 forty times.
  constexpr double incompressible = 150;
  if (3 * nodes <= few) return true;
  return std::ranges::any_of(problem.bodies, [&](const auto& body) {
    const Eigen::SelfAdjointEigenSolver<scene::Elasticity<3>> moduli(body.material.stiffness(), Eigen::EigenvaluesOnly);
    return moduli.eigenvalues()[5] > incompressible * moduli.eigenvalues()[0];
  });
}

/// The system of a mesh, handed out.
OnProcesses handed_out(const Unknowns& unknowns, bool direct) {
  std::vector<std::vector<int>> linked;
  for (const auto& group : unknowns.groups) {
    linked.emplace_back();
    for (const int q : group.unknowns) linked.back().push_back(q / 3);
  }
  int count = 1;
  MPI_Comm_size(MPI_COMM_WORLD, &count);
  Pieces pieces = cut(unknowns.problem, unknowns.nodes, linked, count);
  std::vector<scene::Elasticity<3>> materials;
  for (const auto& body : unknowns.problem.bodies) materials.push_back(body.material.stiffness());
  return or_end([&] {
    ordered(MPI_COMM_WORLD, Order::mesh);
    Piece own = scattered(MPI_COMM_WORLD, pieces.of);
    System system(MPI_COMM_WORLD, std::move(own), broadcast(MPI_COMM_WORLD, std::move(materials)));
    pieces.of.assign(pieces.of.size(), {});  // the processes have them
    return OnProcesses{MPI_COMM_WORLD, unknowns, std::move(pieces), std::move(system), direct};
  });
}

/// Pressures that are linear on each facet, and the displacements by them without contact.
PressureResult<3> pressed(OnProcesses& on, const Contact& contact, const std::vector<VectorXd>& load,
                          const std::vector<Eigen::MatrixXd>& motions, const std::vector<char>& closed) {
  const Unknowns& unknowns = on.unknowns;
  const ContactForces forces{apart(unknowns, contact.q), apart(unknowns, contact.force), stiffness_at_contact(unknowns),
                             load, motions};
  MatchedPressure<3> matched = matched_pressure(unknowns.problem, unknowns.nodes, forces, closed);
  PressureResult<3> result;
  result.termination = matched.termination;
  if (matched.termination != contact::Termination::solved) {
    result.reason = "pressures: none that is linear on each facet of the contact balances the loads";
    return result;
  }
  result.pressure = std::move(matched.pressure);
  std::vector<VectorXd> left = load;
  for (std::size_t b = 0; b < left.size(); ++b) left[b] -= matched.force[b];
  VectorXd q = contact.q;
  on.solve({}, pins(unknowns, together(unknowns, motions), {}), together(unknowns, left), tight, q);
  result.displacement = recover(unknowns.problem.mesh, unknowns.nodes, apart(unknowns, q));
  return result;
}

}  // namespace

Processes::Processes(int* argc, char*** argv) {
  int provided = 0;  // threads of the root's own stages call nothing of MPI
  MPI_Init_thread(argc, argv, MPI_THREAD_FUNNELED, &provided);
  start_petsc();
}
Processes::~Processes() {
  end_petsc();
  MPI_Finalize();
}
bool Processes::is_root() const {
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  return rank == 0;
}
int Processes::count() const {
  int count = 1;
  MPI_Comm_size(MPI_COMM_WORLD, &count);
  return count;
}

Ranks::Ranks(const Processes&) {}
Ranks::~Ranks() { ordered(MPI_COMM_WORLD, Order::end); }

std::string Ranks::way(const Problem<3>& problem, int degree) const {
  return by_factorisation(problem, degree) ? "a factorisation (MUMPS)" : "conjugate gradients with multigrid (PETSc)";
}

Solved<3> Ranks::solve(const Problem<3>& problem, int degree, const std::vector<char>& closed_facets) const {
  const contact::BlasThreads one(1);
  contact::reserve_blas_memory(1);
  Clock clock;
  const Nodes<3> nodes = make_nodes(problem, degree);
  const std::vector<Row> rows = contact_rows(problem, nodes);
  const Unknowns unknowns = unknowns_of(problem, nodes, rows);
  OnProcesses on = handed_out(unknowns, by_factorisation(problem, degree));
  Solved<3> solved;
  Result<3>& result = solved.displacements;
  result.statistics.seconds.order = clock.lap();
  const std::vector<VectorXd> load = loads(problem, nodes);
  const std::vector<Eigen::MatrixXd> motions = motions_of(unknowns);
  std::vector<int> closed;
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (closed_facets.empty() || rows[i].lower < 0 || (closed_facets[rows[i].facet] & scene::touches) != 0)
      closed.push_back(static_cast<int>(i));
  const Contact contact = active_set(on, together(unknowns, load), together(unknowns, motions), std::move(closed));
  result.displacement = recover(problem.mesh, nodes, apart(unknowns, contact.q));
  result.closed.assign(problem.contact.size(), 0);
  for (const int i : contact.closed) result.closed[rows[i].facet] |= scene::touches;
  for (const auto& list : unknowns.of_body) result.statistics.unknowns += static_cast<int>(list.size());
  result.statistics.rows = static_cast<int>(rows.size());
  result.statistics.active_rows = static_cast<int>(contact.closed.size());
  result.statistics.iterations = contact.iterations;
  result.statistics.seconds.contact = clock.lap();
  if (rows.empty())
    solved.with_pressure.displacement = result.displacement;
  else
    solved.with_pressure = pressed(on, contact, load, motions, result.closed);
  return solved;
}

void serve(const Processes&) {
  const contact::BlasThreads one(1);
  or_end([] {
    contact::reserve_blas_memory(1);
    std::unique_ptr<System> system;
    for (;;) switch (ordered(MPI_COMM_WORLD)) {
        case Order::end: return;
        case Order::mesh: {
          system.reset();
          Piece piece = scattered(MPI_COMM_WORLD, std::vector<Piece>());
          auto materials = broadcast(MPI_COMM_WORLD, std::vector<scene::Elasticity<3>>());
          system = std::make_unique<System>(MPI_COMM_WORLD, std::move(piece), std::move(materials));
          break;
        }
        case Order::solve: {
          const Way way = broadcast(MPI_COMM_WORLD, Way());
          const auto tied = scattered(MPI_COMM_WORLD, std::vector<std::vector<TiedNode>>());
          system->solve(tied, way, {}, {});
          break;
        }
      }
  });
}

}  // namespace bracket::primal
