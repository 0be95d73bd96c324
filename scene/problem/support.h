// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/scene.h"

namespace bracket::scene {

/// The facets' data with prescribed displacements that agree at each vertex to the last bit: what two facets prescribe
/// there for the same component (fixed or sliding) may differ by 1e-9 of `largest`, the largest displacement given.
/// \pre the facets have their normals
/// \param conditions of each boundary part, null: none
/// \throw Error (input) if they differ by more
std::vector<FacetData<2>> with_agreement(const Mesh<2>& mesh, std::vector<FacetData<2>> facets,
                                         const std::vector<const Condition<2>*>& conditions, double largest);
/// In space: so at each vertex, that linear data agree along edges, too; where more than three directions slide, the
/// displacements along them must be those of one vector within the same tolerance.
std::vector<FacetData<3>> with_agreement(const Mesh<3>& mesh, std::vector<FacetData<3>> facets,
                                         const std::vector<const Condition<3>*>& conditions, double largest);

/// At vertices where both sides' displacements along a gap are prescribed, raises the gap to the approach that they
/// make, rounded up, if it falls short of that by no more than 8 ε of the sizes involved: those displacements, the gap
/// and the bodies, of whose positions a gap is the difference. No displacement could make good there what rounding has
/// taken.
/// A gap of sides that keep together becomes that approach, if it differs by no more, as it is enclosed. On springs
/// there is no need. A gap that is no quadratic is compared by its own value there, which Problem::gaps is told, with
/// the approach that its lower quadratics have to admit. \pre everything else is fixed   \return by how much a gap was
/// raised at most
double make_room(Problem<2>& problem);
/// In space: so at vertices and, by the Bernstein coefficients of edges, between them. Where a gap is no quadratic it
/// is raised at vertices alone.
double make_room(Problem<3>& problem);

}  // namespace bracket::scene
