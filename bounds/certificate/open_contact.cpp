// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/certificate/open_contact.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "bounds/certificate/admissible_displacement.h"
#include "bounds/certificate/space/admissible_displacement.h"

namespace bracket::bounds {

namespace {

/// \param field admissible_field(), if it could be
template <int dim, class Field, class Penetration>
std::vector<double> least_gaps(const scene::Problem<dim>& problem, const Field& field, const Penetration& penetration) {
  std::vector<double> gaps;
  for (const auto& contact : problem.contact) {
    double least = std::numeric_limits<double>::infinity();
    if (!field || contact.law.two_sided)
      least = 0;
    else
      for (const Enclosure& coefficient : penetration(contact)) least = std::min(least, lower(-coefficient));
    gaps.push_back(least);
  }
  return gaps;
}

/// Of each contact facet: the gap that is left on all of it for sure; none where the displacements are not admissible,
/// and where pressures can be tension, of which little need not be said.
std::vector<double> least_gaps(const scene::Problem<2>& problem, const scene::Displacement<2>& displacement) {
  const auto supports = supports_of(problem);
  const auto [field, reason] = admissible_field(problem, displacement, supports);
  const auto into = [&, &field = field](const auto& contact) {
    return penetration<Enclosure>(problem, supports, *field, contact);
  };
  return least_gaps(problem, field, into);
}
std::vector<double> least_gaps(const scene::Problem<3>& problem, const scene::Displacement<3>& displacement) {
  const auto supports = space::supports_of(problem, displacement.degree);
  const auto [field, reason] = space::admissible_field(problem, displacement, supports);
  const auto into = [&, &field = field](const auto& contact) {
    return space::penetration<Enclosure>(problem, supports, *field, contact);
  };
  return least_gaps(problem, field, into);
}

/// T / δ
double at_most(const Certificate& certificate, double gap) {
  const Enclosure width = Enclosure(certificate.upper) - Enclosure(certificate.lower);
  return upper((width + Enclosure(certificate.contact)) / Enclosure(2) / Enclosure(gap));
}

}  // namespace

template <int dim>
OpenContact open_contact(const scene::Problem<dim>& problem, const scene::Displacement<dim>& displacement,
                         const Certificate& certificate, int pair) {
  struct Facet {
    double gap, length;
  };
  const std::vector<double> gaps = least_gaps(problem, displacement);
  std::vector<Facet> open;
  double length = 0;
  for (std::size_t j = 0; j < gaps.size(); ++j) {
    if (problem.contact[j].pair != pair || !(gaps[j] > 0)) continue;
    open.push_back({gaps[j], scene::length(problem.mesh, problem.contact[j].first)});
    length += open.back().length;
  }
  std::ranges::sort(open, std::greater{}, &Facet::gap);
  OpenContact result;
  for (const Facet& facet : open) {
    if (result.length > 0 && result.length + facet.length > length / 2) break;
    result.length += facet.length;
    result.gap = facet.gap;
  }
  if (result.length > 0) result.force = at_most(certificate, result.gap);
  return result;
}

template <int dim>
double force_at_most(const scene::Problem<dim>& problem, const scene::Displacement<dim>& displacement,
                     const Certificate& certificate, const std::vector<char>& chosen) {
  const std::vector<double> gaps = least_gaps(problem, displacement);
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t j = 0; j < gaps.size(); ++j)
    if (chosen[j]) least = std::min(least, gaps[j]);
  return least > 0 ? at_most(certificate, least) : std::numeric_limits<double>::infinity();
}

#define INSTANTIATE(dim)                                                                                             \
  template OpenContact open_contact(const scene::Problem<dim>&, const scene::Displacement<dim>&, const Certificate&, \
                                    int);                                                                            \
  template double force_at_most(const scene::Problem<dim>&, const scene::Displacement<dim>&, const Certificate&,     \
                                const std::vector<char>&);
INSTANTIATE(2)
INSTANTIATE(3)
#undef INSTANTIATE

}  // namespace bracket::bounds
