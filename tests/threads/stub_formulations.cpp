// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <future>
#include <memory>
#include <stdexcept>

#include "dual/dual.h"
#include "primal/primal.h"
#include "scene/parallel.h"

/// In place of the two formulations: the exact fields of docs/theory.md §9.1 in closed form. deal.II, CHOLMOD and BLAS
/// know no thread sanitizer, and none of them runs here.
namespace bracket {

namespace {

[[noreturn]] void refuse() { throw std::logic_error("no scene of these tests asks for it"); }

/// The displacement prescribed at the sliding top, along its normal, by the height: e22.
double strain(const scene::Problem<2>& problem) {
  double lowering = 0, low = 0, high = 0;
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    const double y = problem.mesh.vertices[problem.mesh.boundary[f].vertices[0]][1];
    low = std::min(low, y);
    high = std::max(high, y);
    if (problem.facets[f].support == scene::Support::sliding)
      lowering = std::min(lowering, problem.facets[f].normal_displacement[0]);
  }
  return lowering / (high - low);
}

scene::Vector<2> displacement(const scene::Problem<2>& problem, const scene::Vector<2>& x) {
  const auto& compliance = problem.bodies[0].material.compliance();  // of both
  const double e = strain(problem);
  return {compliance(0, 1) / compliance(1, 1) * e * x[0], e * (x[1] + 0.5)};
}

}  // namespace

namespace scene {

// In place of oneTBB's loop: its library is built without the sanitizer, which would not see what it hands over.
void in_chunks(int n, const std::function<void(int, int, int)>& work, int size) {
  const auto every_other = [&](int first) {
    for (int chunk = first; chunk < n_chunks(n, size); chunk += 2)
      work(chunk, chunk * size, std::min(n, (chunk + 1) * size));
  };
  auto odd = std::async(std::launch::async, every_other, 1);
  every_other(0);
  odd.get();
}

}  // namespace scene

namespace primal {

template <int dim> void check_prescribed(const scene::Problem<dim>&, int) {}

template <int dim> struct Solver<dim>::Factorised { int degree; };
template <int dim>
Solver<dim>::Solver(const scene::Problem<dim>&, int degree, bool)
    : factorised_(std::make_shared<const Factorised>(Factorised{degree})) {}

template <> Result<3> Solver<3>::solve(const scene::Problem<3>&, const std::vector<char>&) const { refuse(); }
template <int dim> Result<dim> Solver<dim>::solve(const scene::Problem<dim>& problem, const std::vector<char>&) const {
  const int degree = factorised_->degree;
  const auto& mesh = problem.mesh;
  Result<dim> result;
  result.displacement.degree = degree;
  for (const auto& x : mesh.vertices) result.displacement.vertex.push_back(displacement(problem, x));
  for (const auto& [a, b] : mesh.edges)
    if (degree == 2)
      result.displacement.edge.push_back(displacement(problem, (mesh.vertices[a] + mesh.vertices[b]) / 2));
  result.closed.assign(problem.contact.size(), 1);
  return result;
}

template <int dim>
PressureResult<dim> Solver<dim>::solve_with_pressure(const scene::Problem<dim>&, const std::vector<char>&) const {
  refuse();
}

template <int dim> struct PressureSolver<dim>::Rows {};
template <int dim> PressureSolver<dim>::PressureSolver(const Solver<dim>&, const scene::Problem<dim>&) {}
template <int dim>
PressureResult<dim> PressureSolver<dim>::solve(const scene::Problem<dim>&, const std::vector<char>&) const {
  refuse();
}

template void check_prescribed(const scene::Problem<2>&, int);
template void check_prescribed(const scene::Problem<3>&, int);
template class Solver<2>;
template class Solver<3>;
template class PressureSolver<2>;
template class PressureSolver<3>;

}  // namespace primal

namespace dual {

template <int dim> struct Solver<dim>::Factorised {};
template <int dim> Solver<dim>::Solver(const scene::Problem<dim>&, int, Shear) {}

template <int dim>
Result<dim> Solver<dim>::solve(const scene::Problem<dim>& problem, const std::vector<char>&,
                               const Eigen::VectorXd&) const {
  Result<dim> result;
  const scene::Voigt<dim> uniform(0, strain(problem) / problem.bodies[0].material.compliance()(1, 1), 0);
  result.stress.cell.assign(problem.mesh.cells.size(), std::vector<scene::Voigt<dim>>(9, uniform));
  result.closed.assign(problem.contact.size(), 1);
  return result;
}

template <int dim>
Result<dim> uzawa(const scene::Problem<dim>&, const scene::Stress<dim>&, const std::function<bool()>&) {
  refuse();
}
template <int dim> struct LocalSolver<dim>::Frame {};
template <int dim> LocalSolver<dim>::LocalSolver(const scene::Problem<dim>&, bool) {}
template <int dim>
Result<dim> LocalSolver<dim>::solve(const scene::Problem<dim>&, const Pressure&, const scene::Displacement<dim>&,
                                    int) const {
  refuse();
}
template <int dim> std::vector<Result<dim>> LocalSolver<dim>::solve(const std::vector<Start>&, int) const { refuse(); }

template class Solver<2>;
template class LocalSolver<2>;
template class LocalSolver<3>;
template Result<2> uzawa(const scene::Problem<2>&, const scene::Stress<2>&, const std::function<bool()>&);

}  // namespace dual
}  // namespace bracket
