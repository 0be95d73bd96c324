// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "bounds/quantities/parts.h"
#include "scene/text.h"

namespace bracket::bounds {

using scene::Enclosure;
using scene::Perturbation;
using scene::Problem;
using scene::Quantity;

namespace {

/// The contact that is asked of, which has friction. \param what is asked of it
int rubbing_pair(const scene::Scene<2>& scene, const Quantity<2>& quantity, const char* what) {
  const int pair = pair_named(scene, quantity.of, quantity.where);
  const scene::Law law = scene.contact[pair].law;
  if (law != scene::Law::tresca && law != scene::Law::coulomb)
    refuse(quantity, fmt::format("{} has bounds where there is friction, and '{}' has none; its law is \"{}\"", what,
                                 quantity.of, name(law)));
  return pair;
}

}  // namespace

Functionals<2> shear_force(const scene::Scene<2>& scene, const Problem<2>& first, const Quantity<2>& quantity) {
  const int pair = rubbing_pair(scene, quantity, "a shear force");
  Perturbation<2> perturbation = scene::no_perturbation(first);
  for (std::size_t j = 0; j < first.contact.size(); ++j)
    if (first.contact[j].pair == pair) perturbation.contact[j].slip = {-1, -1, -1};
  return linear(std::move(perturbation), Enclosure(1));
}

Functionals<2> mean_slip(const scene::Scene<2>& scene, const Problem<2>& first, const Quantity<2>& quantity) {
  const int pair = rubbing_pair(scene, quantity, "a slip");
  Perturbation<2> perturbation = scene::no_perturbation(first);
  Enclosure length;
  for (std::size_t j = 0; j < first.contact.size(); ++j) {
    if (first.contact[j].pair != pair) continue;
    if (!has_friction(first.contact[j].law)) {
      const auto [a, b] = scene::positions(first.mesh, first.mesh.boundary[first.contact[j].first].vertices);
      refuse(quantity, fmt::format("a slip has bounds where there is friction, and there is none on the edge of the "
                                   "first mesh from {} to {}; make two contacts",
                                   scene::point(a), scene::point(b)));
    }
    perturbation.contact[j].shear = {1, 1};
    length += facet_size(first, first.contact[j].first);
  }
  return linear(std::move(perturbation), length);
}

}  // namespace bracket::bounds
