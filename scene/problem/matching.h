// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "scene/scene.h"

namespace bracket::scene {

/// The facets of two sides, two by two: those that coincide (within tolerance()) and run opposite to each other, in the
/// order of the first; nothing if any is left over. Linear but for sorting.
std::optional<std::vector<std::array<int, 2>>> match_sides(const Mesh<2>& mesh, const std::vector<int>& first,
                                                           const std::vector<int>& second);

/// The mesh with the vertices of each second facet that lie within tolerance() of those of the first put on them, to
/// the last bit; with a note if any of them moved. \throw Error (mesh) if that turns a cell over
template <int dim> Mesh<dim> with_sides_joined(Mesh<dim> mesh, const std::vector<ContactFacetOf<dim>>& contact);

}  // namespace bracket::scene
