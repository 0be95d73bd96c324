// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "apps/report/report.h"

namespace bracket::apps {

/// Of the fields of a run's last level.
/// \param plane of two dimensions
template <int dim> LargestVonMisesOf<dim> largest_von_mises(const bounds::Outcome<dim>& outcome, scene::Plane plane);
template <> LargestVonMises largest_von_mises(const bounds::Outcome<2>& outcome, scene::Plane plane);
template <> LargestVonMisesOf<3> largest_von_mises(const bounds::Outcome<3>& outcome, scene::Plane plane);

}  // namespace bracket::apps
