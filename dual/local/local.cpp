// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "contact/clock.h"
#include "dual/dual.h"
#include "dual/local/contact_sweep.h"

namespace bracket::dual {

template <int dim>
LocalSolver<dim>::LocalSolver(const scene::Problem<dim>& problem, bool again)
    : frame_(std::make_shared<const Frame>(problem, again)) {}

template <int dim>
Result<dim> LocalSolver<dim>::solve(const scene::Problem<dim>& problem, const Pressure& pressure,
                                    const scene::Displacement<dim>& displacement, int sweeps) const {
  constexpr int contact_sweeps = 2;  // before the first sweep; after each one more
  Clock clock;
  Result<dim> result;
  contact::Statistics& statistics = result.statistics;
  statistics.seconds = frame_->seconds;
  try {
    if (frame_->not_definite) throw NotDefinite(*frame_->not_definite);
    Loads<dim> loads(*frame_, problem, pressure, displacement);
    statistics.seconds.assemble += clock.lap();
    loads.equilibrate();
    statistics.seconds.factorise += clock.lap();
    for (int i = 0; i < contact_sweeps; ++i) contact_sweep(loads);
    statistics.seconds.contact += clock.lap();
    for (int i = 0; i < sweeps; ++i) {
      loads.sweep();
      statistics.seconds.factorise += clock.lap();
      contact_sweep(loads);
      statistics.seconds.contact += clock.lap();
    }
    result.stress = loads.stress();
    statistics.seconds.recover = clock.lap();
    statistics.unknowns = loads.unknowns();
    statistics.rows = dim * static_cast<int>(problem.contact.size());
    for (const auto& facet : loads.pressure())
      statistics.active_rows += static_cast<int>(std::ranges::count_if(facet, [](double p) { return p != 0; }));
  } catch (const NotDefinite& star) {
    result.termination = contact::Termination::not_definite;
    std::vector<std::string> at;
    for (const double x : problem.mesh.vertices[star.vertex]) at.push_back(fmt::format("{:.7g}", x));
    result.reason = fmt::format(
        "stresses: the cells at the vertex ({}) are too thin, or their moduli too unlike, for the precision of a "
        "double",
        fmt::join(at, ", "));
  }
  return result;
}

template <int dim>
Result<dim> local(const scene::Problem<dim>& problem, const std::vector<std::array<double, std::size_t{dim}>>& pressure,
                  const scene::Displacement<dim>& displacement, int sweeps) {
  return LocalSolver<dim>(problem).solve(problem, pressure, displacement, sweeps);
}

template class LocalSolver<2>;
template class LocalSolver<3>;
template Result<2> local<2>(const scene::Problem<2>&, const std::vector<std::array<double, 2>>&,
                            const scene::Displacement<2>&, int);
template Result<3> local<3>(const scene::Problem<3>&, const std::vector<std::array<double, 3>>&,
                            const scene::Displacement<3>&, int);

}  // namespace bracket::dual
