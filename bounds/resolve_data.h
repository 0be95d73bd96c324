// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "bounds/level.h"

namespace bracket::bounds {

/// The first mesh, finer where what fixing the data there did to the energy (DataEffect) is more than a tenth of the
/// width that the target asks for, target² ‖u_h‖²_A / 2 (1e-2 without a target), with the data fixed on it anew; a note
/// of the mesh says how often and where that has been done.
/// \return none where the effect is small enough, the scene is not to be refined, or a quarter of Refine::max_cells or
///         of max_seconds is spent
template <int dim>
std::optional<Meshed<dim>> with_data_resolved(const scene::Scene<dim>& scene, const Meshed<dim>& meshed,
                                              const Examined<dim>& examined, const Clock& run_clock);

}  // namespace bracket::bounds
