// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/mesh/mesh.h"

namespace bracket::scene {

/// Distances up to which vertices on and near a facet are one: 1e-6 of its length, in space of its shortest edge, and
/// rounding of its coordinates: as doubles, and in a file of few digits, up to 1e-3 of that length.
template <int dim> double tolerance(const Mesh<dim>& mesh, int facet);

}  // namespace bracket::scene
