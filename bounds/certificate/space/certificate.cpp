// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/certificate/certificate.h"

#include <algorithm>
#include <cmath>

#include "bounds/certificate/space/sides.h"

namespace bracket::bounds {

template <>
Certificate certify(const scene::Problem<3>& problem, const scene::Displacement<3>& displacement,
                    const scene::Stress<3>& stress) {
  using scene::Enclosure, scene::LongSum;
  if (std::string fault = space::fault_of(problem, displacement, stress); !fault.empty()) return {.reason = fault};
  const auto [corrections, unbalanced] = space::corrected<Enclosure, LongSum>(scene::first_of(problem));
  if (!unbalanced.empty()) return {.reason = unbalanced};
  const space::Sides sides = space::both_sides(problem, corrections, displacement, stress);
  if (!sides.reason.empty()) return {.reason = sides.reason};

  Certificate certificate;
  certificate.lower = lower(-sides.below) + 0.0;  // not −0
  certificate.upper = upper(sides.above.total) + 0.0;
  certificate.strain_energy = std::max(0.0, lower(sides.above.strain));
  certificate.contact = std::max(0.0, upper(space::contact_work<Enclosure, LongSum>(
                                          problem, sides.supports, sides.field, sides.loads.along_normal)));
  certificate.valid = std::isfinite(certificate.lower) && std::isfinite(certificate.upper);
  if (!certificate.valid)
    certificate.reason = "the energies could not be enclosed: numbers too large or too small, or cells too thin";
  return certificate;
}

}  // namespace bracket::bounds
