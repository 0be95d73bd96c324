// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "contact/clock.h"
#include "dual/dual.h"
#include "dual/local/contact_sweep.h"
#include "dual/local/frame.h"

namespace bracket::dual {

template <int dim>
LocalSolver<dim>::LocalSolver(const scene::Problem<dim>& problem, bool again)
    : frame_(std::make_shared<const Frame>(problem, again)) {}

template <int dim>
std::vector<Result<dim>> LocalSolver<dim>::solve(const std::vector<Start>& starts, int sweeps) const {
  constexpr int contact_sweeps = 2;  // before the first sweep; after each one more
  std::vector<Result<dim>> results(starts.size());
  if (starts.empty()) return results;
  Clock clock;
  contact::Phases seconds{.assemble = frame_->seconds};
  const Facets<dim>& facets = frame_->facets;
  const std::vector<Star<dim>>& stars = frame_->stars;
  try {
    std::vector<std::unique_ptr<Loads<dim>>> loads;
    {
      std::optional<Repair<dim>> own;
      if (!frame_->repair) own.emplace(starts.front().problem, stars);
      for (const Start& start : starts)
        loads.push_back(std::make_unique<Loads<dim>>(facets, stars, own ? *own : *frame_->repair, start));
    }
    Energies<dim> own;
    if (frame_->energy.empty()) own = energies_of(starts.front().problem);
    const Energies<dim>& energy = frame_->energy.empty() ? own : frame_->energy;
    const auto for_each_star = [&](void (Loads<dim>::*work)(const StarSystem<dim>&)) {
      frame_->for_each_star([&](const Star<dim>& star) {
        const StarSystem<dim> system(star, energy);
        for (const auto& one : loads) (*one.*work)(system);
      });
    };
    seconds.assemble += clock.lap();
    for_each_star(&Loads<dim>::hand_out);
    for (const auto& one : loads) one->end_handing_out();
    seconds.factorise += clock.lap();
    for (int i = 0; i < contact_sweeps; ++i) contact_sweep(stars, energy, loads);
    seconds.contact += clock.lap();
    for (int i = 0; i < sweeps; ++i) {
      for_each_star(&Loads<dim>::sweep);
      seconds.factorise += clock.lap();
      contact_sweep(stars, energy, loads);
      seconds.contact += clock.lap();
    }
    for (std::size_t i = 0; i < starts.size(); ++i) results[i].stress = loads[i]->stress();
    seconds.recover = clock.lap();
    for (std::size_t i = 0; i < starts.size(); ++i) {
      contact::Statistics& statistics = results[i].statistics;
      statistics.seconds = seconds;
      statistics.unknowns = loads[i]->unknowns();
      statistics.rows = dim * static_cast<int>(starts[i].problem.contact.size());
      for (const auto& facet : loads[i]->pressure())
        statistics.active_rows += static_cast<int>(std::ranges::count_if(facet, [](double p) { return p != 0; }));
    }
  } catch (const NotDefinite& star) {
    std::vector<std::string> at;
    for (const double x : frame_->facets.position[star.vertex]) at.push_back(fmt::format("{:.7g}", x));
    for (Result<dim>& result : results) {
      result.termination = contact::Termination::not_definite;
      result.reason = fmt::format(
          "stresses: the cells at the vertex ({}) are too thin, or their moduli too unlike, for the precision of a "
          "double",
          fmt::join(at, ", "));
    }
  }
  return results;
}

template <int dim>
Result<dim> LocalSolver<dim>::solve(const scene::Problem<dim>& problem, const Pressure& pressure,
                                    const scene::Displacement<dim>& displacement, int sweeps) const {
  return std::move(solve({{problem, pressure, displacement}}, sweeps).front());
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
