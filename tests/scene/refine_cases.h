// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <random>

#include "scene/scene.h"

/// Problems for the tests of refinement, and what they have in common.
namespace bracket::scene::test {

/// The data of refine_cases(): gaps are `quadratic`, displacements and tractions `linear` and `other_linear`.
double linear(const Vector<2>& x);
double other_linear(const Vector<2>& x);
double quadratic(const Vector<2>& x);

struct RefineCase {
  std::string name;
  Problem<2> problem;
};

/// Three blocks, `b` on `a`, `c` beside `a` and on a rigid wall, so that a corner of `a` is in two contact pairs, with
/// vertices moved by `map`. "a.bottom" is fixed (linear, other_linear), "b.left" slides (linear), "b.top" has the
/// traction (other_linear, linear), "c.right" the pressure linear; all gaps are quadratic.
RefineCase three_blocks(const std::string& name, const std::function<Vector<2>(const Vector<2>&)>& map);

/// Straight, jagged, curved, flat and far-off blocks, arbitrary refinement edges, and a Gmsh mesh with "base" fixed as
/// "a.bottom" is.
std::vector<RefineCase> refine_cases();

/// Each cell marked with the probability 1 / one_of.
std::vector<char> some(const Mesh<2>& mesh, std::mt19937& random, unsigned one_of);

/// Expects cells counter-clockwise; each edge once in the list and in two cells that walk it both ways, or in one cell
/// and on the boundary, whose facets are those of their cells: no vertex hangs.
void expect_conforming(const Mesh<2>& mesh);

}  // namespace bracket::scene::test
