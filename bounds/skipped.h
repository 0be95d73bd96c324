// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/scene.h"

namespace bracket::bounds {

/// The stages that a scene has no use for, with the reason, one line each; they are not run.
template <int dim>
std::vector<std::string> skipped_stages(const scene::Scene<dim>& scene, const scene::Problem<dim>& problem);

}  // namespace bracket::bounds
