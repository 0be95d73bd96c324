// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "scene/problem/problem.h"

/// The loads of a perturbation beside those of the problem, in any dimension.
namespace bracket::bounds {

/// The first mesh with the loads of the perturbation alone, which corrections are to balance along motions on which
/// neither supports act nor pairs that carry.
/// \param first the problem that is perturbed, on its first mesh   \param carrying of each pair, when perturbed
template <int dim>
scene::Problem<dim> perturbation_alone(const scene::Problem<dim>& first,
                                       std::shared_ptr<const scene::Perturbation<dim>> by, std::vector<char> carrying);

}  // namespace bracket::bounds
