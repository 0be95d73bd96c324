// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/scene.h"

namespace bracket::scene {

/// The FacetData::normal of each boundary facet: normals that agree up to sign within 1e-6 rad, or what the
/// digits of the mesh's coordinates leave open of them (up to 2e-3), and those between which
/// others make such steps, become one: at right angles to the chord of the longest straight chain among their facets,
/// of chains along an axis if there are any. So pressure along it balances the same pressure on the rest of the
/// contour. Steps that add up to more than 1e-5 rad are a fine arc rather than one straight line: there both angles are
/// a tenth, and again, until the arc has its corners. \pre the mesh has cells \param counts of each facet, whether
/// chains are made of it: those that slide or touch (empty, or none: all)
std::vector<Vector<2>> shared_normals(const Mesh<2>& mesh, const std::vector<char>& counts = {});

/// In space: normals that agree up to sign within 1e-6 rad, or what digits leave open (up to 2e-3), with that of the
/// largest facet among them become one: along the axis if its is, else along the sum of their area vectors, of those
/// that `counts` names if there are any. So pressure along it balances the same pressure on the rest of a closed body.
std::vector<Vector<3>> shared_normals(const Mesh<3>& mesh, const std::vector<char>& counts = {});

}  // namespace bracket::scene
