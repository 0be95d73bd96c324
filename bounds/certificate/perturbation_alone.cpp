// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/certificate/perturbation_alone.h"

namespace bracket::bounds {

template <int dim>
scene::Problem<dim> perturbation_alone(const scene::Problem<dim>& first,
                                       std::shared_ptr<const scene::Perturbation<dim>> by, std::vector<char> carrying) {
  scene::Problem<dim> bare = first;
  bare.carries = std::move(carrying);
  for (auto& body : bare.bodies) body.force.setZero();
  for (auto& facet : bare.facets) {
    facet.traction.fill(scene::Vector<dim>::Zero());
    facet.correction = facet.traction;
    facet.pressure.fill(0);
    facet.higher_traction.fill(scene::Vector<dim>::Zero());
    facet.higher_pressure.fill(0);
  }
  return scene::perturbed(bare, std::move(by), 1, 0);
}

template scene::Problem<2> perturbation_alone(const scene::Problem<2>&, std::shared_ptr<const scene::Perturbation<2>>,
                                              std::vector<char>);
template scene::Problem<3> perturbation_alone(const scene::Problem<3>&, std::shared_ptr<const scene::Perturbation<3>>,
                                              std::vector<char>);

}  // namespace bracket::bounds
