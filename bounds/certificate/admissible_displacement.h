// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <optional>

#include "bounds/certificate/approach.h"

/// Displacements that are in K exactly: real numbers that `Number` encloses or holds exactly.
namespace bracket::bounds {

/// A gap on a contact facet, as coefficients of such a degree. \param bound lower or upper
template <class Number> std::vector<Number> gap_on(const std::array<double, 3>& bound, int degree) {
  return scene::raised_to<Number>(degree, std::vector<Number>{Number(bound[0]), Number(bound[1]), Number(bound[2])});
}

/// r − g of one contact facet, g the lower gap, or that of two-sided ones, likewise. In K all are ≤ 0 but where there
/// are springs.
template <class Number>
std::vector<Number> penetration(const scene::Problem<2>& problem, const Supports& supports, const PlainField& field,
                                const scene::ContactFacet& pair) {
  std::vector<Number> r = approach_on<Number>(problem, supports, field, pair);
  std::vector<Number> gap = gap_on<Number>(pair.lower, field.degree);
  if (pair.law.two_sided) {
    const auto kept = kept_gap<Number>(problem, supports.contacts, pair);
    gap = scene::raised_to<Number>(field.degree, std::vector<Number>(kept.begin(), kept.end()));
  }
  for (std::size_t k = 0; k < r.size(); ++k) r[k] -= gap[k];
  return r;
}

/// Displacements onto the supports: what is prescribed on Γ_u is set, up to rounding; the rest shift() does.
PlainField plain_field(const scene::Problem<2>& problem, const scene::Displacement<2>& displacement,
                       const Supports& supports);

/// Why displacements of such a degree cannot keep together what has to, in one line; empty: they can.
std::string kept_fault(const scene::Problem<2>& problem, int degree, const Supports& supports);

/// The displacements of a solution, moved by no more than rounding, so that they are in K with certainty.
/// \return nothing where the prescribed displacements leave no room; then `reason`
struct AdmissibleField {
  std::optional<PlainField> field;
  std::string reason;
};
AdmissibleField admissible_field(const scene::Problem<2>& problem, const scene::Displacement<2>& displacement,
                                 const Supports& supports);

}  // namespace bracket::bounds
