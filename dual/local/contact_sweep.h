// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "dual/local/loads.h"

namespace bracket::dual {

/// Once around the vertices in contact: the stars of both sides get the loads and the pressures on their contact facets
/// of least S together, p ≥ 0 where the sides can part; those of several problems, which share what is made of the
/// mesh.
/// \throw NotDefinite
template <int dim>
void contact_sweep(const std::vector<Star<dim>>& stars, const Energies<dim>& energy,
                   const std::vector<std::unique_ptr<Loads<dim>>>& loads);

}  // namespace bracket::dual
