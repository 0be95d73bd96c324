// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "bounds/bounds.h"

/// Results as files that ParaView opens: VTK XML, unstructured grids, appended raw data.
namespace bracket::apps {

/// The fields on the three parts of each cell, each part a triangle with points of its own, because stresses jump.
/// Point data: displacement (x, y, 0), stress_displacement σ(u_h) and stress_equilibrated λ_h (xx, yy, xy). Cell data:
/// body (index), indicator (the cell's term of the gap identity, the same on its three parts) and indicator_density
/// (that term by the area of the cell).
std::string solution_vtu(const scene::Problem<2>& problem, const scene::Displacement<2>& displacement,
                         const scene::Stress<2>& stress, const bounds::Indicator& indicator);

/// Each contact facet as a line with points of its own, at its place on the first side. Point data: pressure (of λ_h)
/// and gap (what u_h leaves of it, g − r). Cell data: pair (index) and indicator.
std::string contact_vtu(const scene::Problem<2>& problem, const std::vector<bounds::ContactState>& contact,
                        const bounds::Indicator& indicator);

/// A ParaView collection of solution_k.vtu and, with a contact, contact_k.vtu of the levels k from `first` on, which
/// stand for time.
std::string collection_pvd(int first, int levels, bool contact);

}  // namespace bracket::apps
