// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bounds/certificate/space/approach.h"

/// Displacements that are in K exactly.
namespace bracket::bounds::space {

/// r − g of one contact facet, g the lower gap, by Bernstein coefficients: in K all are ≤ 0. \pre not two-sided
template <class Number>
std::array<Number, 6> penetration(const scene::Problem<3>& problem, const Supports& supports, const PlainField& field,
                                  const scene::ContactFacetOf<3>& pair) {
  auto r = approach_on<Number>(problem, supports, field, pair);
  for (int k = 0; k < 6; ++k) r[k] -= Number(pair.lower[k]);
  return r;
}

/// Displacements at nodes; where they are held, what is prescribed, up to rounding.
PlainField plain_field(const scene::Problem<3>& problem, const scene::Displacement<3>& u, const Supports& supports);

/// The displacements of a solution, moved by no more than rounding, so that they are in K with certainty.
/// \return nothing where the prescribed displacements leave no room; then `reason`
struct AdmissibleField {
  std::optional<PlainField> field;
  std::string reason;
};
AdmissibleField admissible_field(const scene::Problem<3>& problem, const scene::Displacement<3>& displacement,
                                 const Supports& supports);

}  // namespace bracket::bounds::space
