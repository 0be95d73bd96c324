// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/skipped.h"

#include <algorithm>

namespace bracket::bounds {

namespace {

template <int dim> bool is_prescribed(const scene::FacetData<dim>& data) {
  using scene::Support;
  const auto moves = [](const auto& at_vertices) {
    return std::ranges::any_of(at_vertices, [](const auto& u) { return u != std::decay_t<decltype(u)>(0 * u); });
  };
  return (data.support == Support::fixed && moves(data.displacement)) ||
         (data.support == Support::sliding && moves(data.normal_displacement));
}

}  // namespace

template <int dim>
std::vector<std::string> skipped_stages(const scene::Scene<dim>& scene, const scene::Problem<dim>& problem) {
  bool floating = false;
  for (std::size_t b = 0; b < problem.mesh.components.size(); ++b)
    floating = floating || !scene::free_motions(problem, static_cast<int>(b)).empty();
  const auto heavy = [](const scene::Body<dim>& body) { return !body.force.isZero(0); };

  std::vector<std::string> skipped;
  if (problem.contact.empty()) skipped.push_back("interface problem: no contact");
  if (scene.solve.dual == scene::Dual::hybrid && std::none_of(problem.bodies.begin(), problem.bodies.end(), heavy))
    skipped.push_back("particular stress field: no body force");
  if (!floating) skipped.push_back("rigid motions: every body is held by its supports");
  if (std::none_of(problem.facets.begin(), problem.facets.end(), is_prescribed<dim>))
    skipped.push_back("work of supports: no displacement is prescribed but zero");
  if (scene.refine.strategy == scene::Strategy::none) skipped.push_back("marking and refinement: strategy \"none\"");
  if (scene.refine.strategy == scene::Strategy::uniform) skipped.push_back("marking: every cell is refined");
  return skipped;
}

template std::vector<std::string> skipped_stages(const scene::Scene<2>&, const scene::Problem<2>&);
template std::vector<std::string> skipped_stages(const scene::Scene<3>&, const scene::Problem<3>&);

}  // namespace bracket::bounds
