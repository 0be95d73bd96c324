// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/problem/problem.h"
#include "tests/scene/inputs.h"

/// Scenes for the tests of this folder.
namespace bracket::scene::test {

/// A unit cube "lower", y from 0 to 1, and "upper", y from 1 to 2, cut in `cells` along each axis, in contact; E = 1,
/// ν = 0.3; the base is fixed.
Scene<3> unit_boxes(int cells);

/// The same bodies and parts as a given mesh, with a scene's other data.
Scene<3> given(const Mesh<3>& mesh, Scene<3> scene = {});

/// The mesh of a scene with its inner vertices, and those inside of sides along these, moved at random by up to a share
/// of `size`: contact stays matched, flat sides stay flat.
Mesh<3> shaken(Mesh<3> mesh, Random& random, double size);

/// By another order of axes, turned and moved.
Mesh<3> turned_about(Mesh<3> mesh, const Eigen::Matrix3d& rotation, const Vector<3>& by);

Eigen::Matrix3d random_rotation(Random& random);

/// How often a cell of the first mesh was bisected to come to this one.
int generation(const Problem<3>& problem, std::size_t cell);

}  // namespace bracket::scene::test
