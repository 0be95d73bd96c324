// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/scene.h"

namespace bracket::scene {

/// The contact facets of the first mesh with the laws of their pairs.
/// \throw Error (input) if a modulus is not positive, a bound of the shear or a coefficient of friction negative, if
/// one
///     is not linear on a facet, the last constant, or if there is friction between sides that do not coincide
std::vector<ContactFacet> with_laws(const Scene<2>& scene, const Mesh<2>& mesh, std::vector<ContactFacet> contact);
/// In space there are none but whether sides keep together.
std::vector<ContactFacetOf<3>> with_laws(const Scene<3>& scene, const Mesh<3>& mesh,
                                         std::vector<ContactFacetOf<3>> contact);

}  // namespace bracket::scene
