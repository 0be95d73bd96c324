// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "scene/mesh/mesh.h"

namespace bracket::scene {

/// A nested dissection: each component is cut in two along facets, as few as may be, and so are its parts, down to
/// single cells. \return of each cell the way to it, from the highest bit on: 0 into the one part, 1 into the other
template <int dim> std::vector<std::uint64_t> dissect(const Mesh<dim>& mesh);

}  // namespace bracket::scene
