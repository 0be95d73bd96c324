// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/scene.h"

namespace bracket::scene {

/// The facets of two boundary parts, two by two: those that coincide (within 1e-8 of their length) and run opposite to
/// each other. In the order of the first part's facets.
/// \throw Error (mesh), with the line `where` before it, if any facet of either part is left over
std::vector<std::array<int, 2>> match_sides(const Mesh<2>& mesh, int first_part, int second_part,
                                            const std::string& where);

/// The mesh with the vertices of each matched second facet put on those of the first, to the last bit; with a note if
/// any of them moved.
/// \throw Error (mesh) if that turns a cell over
Mesh<2> with_sides_joined(Mesh<2> mesh, const std::vector<ContactFacet>& contact);

}  // namespace bracket::scene
