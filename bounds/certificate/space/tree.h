// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bounds/certificate/space/faces.h"

/// The ways on which cells hand on what they lack of balance.
namespace bracket::bounds::space {

/// A cell in the trees of its body.
struct Branch {
  int cell;
  int parent;  ///< −1: a root
  int side;    ///< the facet at which it touches its parent; of a root the facet of Γ_u that takes all, −1: none
};
/// All cells, each after its parent: the shortest paths from Γ_u, or, of a body without, from the cell at its largest
/// facet of Γ_0 or Γ_K, if it has none from its largest cell.
std::vector<Branch> trees(const scene::Problem<3>& problem, const std::vector<Face>& faces);

}  // namespace bracket::bounds::space
