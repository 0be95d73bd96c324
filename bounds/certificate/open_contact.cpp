// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/certificate/open_contact.h"

#include <algorithm>
#include <cmath>

#include "bounds/certificate/admissible_displacement.h"

namespace bracket::bounds {

template <int dim>
OpenContact open_contact(const scene::Problem<dim>& problem, const scene::Displacement<dim>& displacement,
                         const Certificate& certificate, int pair) {
  struct Facet {
    double gap, length;
  };
  const auto supports = vertex_supports(problem);
  const auto [field, reason] = admissible_field(problem, displacement, supports);
  OpenContact result;
  if (!field) return result;
  std::vector<Facet> open;
  double length = 0;
  for (const auto& contact : problem.contact) {
    if (contact.pair != pair) continue;
    double least = std::numeric_limits<double>::infinity();
    for (const Enclosure& r : penetration<Enclosure>(problem, supports, *field, contact))
      least = std::min(least, lower(-r));
    if (!(least > 0)) continue;
    open.push_back({least, scene::length(problem.mesh, contact.first)});
    length += open.back().length;
  }
  std::ranges::sort(open, std::greater{}, &Facet::gap);
  for (const Facet& facet : open) {
    if (result.length > 0 && result.length + facet.length > length / 2) break;
    result.length += facet.length;
    result.gap = facet.gap;
  }
  if (result.length == 0) return result;
  const Enclosure width = Enclosure(certificate.upper) - Enclosure(certificate.lower);
  const Enclosure t = (width + Enclosure(certificate.contact)) / Enclosure(2);
  result.force = upper(t / Enclosure(result.gap));
  return result;
}

template OpenContact open_contact(const scene::Problem<2>&, const scene::Displacement<2>&, const Certificate&, int);

}  // namespace bracket::bounds
