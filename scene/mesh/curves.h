// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/scene.h"

namespace bracket::scene {

/// The circle on which each boundary part lies; nothing: none is declared.
using Arcs = std::vector<std::optional<Circle>>;

/// \throw Error (input: unknown parts; mesh: vertices off the declared circle, or through which there is none)
Arcs arcs_of(const Scene<2>& scene, const Mesh<2>& mesh);

/// The point of the circle nearest to x.
Vector<2> onto(const Circle& circle, const Vector<2>& x);

/// The mesh with those vertices of arcs that are not among the first `old` put on them.
/// \throw Error (mesh) if that turns a cell over
Mesh<2> with_new_vertices_on_arcs(Mesh<2> mesh, const Arcs& arcs, std::size_t old);

}  // namespace bracket::scene
