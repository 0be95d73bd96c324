// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <random>

#include "scene/fields.h"
#include "scene/problem/problem.h"

/// Problems in space, made by hand: boxes of tetrahedra, and refinement by halving single edges.
namespace bracket::tests {

using scene::Vector;

/// A body of cubes, each cut in six tetrahedra along its diagonal.
struct Box {
  Vector<3> from, to;
  std::array<int, 3> cells;
  scene::Material<3> material;
  Vector<3> force = Vector<3>::Zero();
};

/// What a boundary facet is to be, told by its body, the middle and the outward normal that it has before `warp`.
using Label = std::function<scene::FacetData<3>(int body, const Vector<3>& middle, const Vector<3>& normal)>;
using Warp = std::function<Vector<3>(const Vector<3>&)>;

/// FacetData::normal is set here, and facets of Γ_K are put into pairs: with the facet of another body that has the
/// same vertices, else with a wall; one number for each body and direction of the first side.
scene::Problem<3> problem_of(
    const std::vector<Box>& boxes, const Label& label, const Warp& warp = [](const Vector<3>& x) { return x; });

/// `mesh`, of which vertices, cells, cell_body and bodies are given, with all the rest; each body is a component.
scene::Mesh<3> with_topology(scene::Mesh<3> mesh);

/// With one edge halved, by its number, and with it those that it meets in contacts.
scene::Problem<3> halved(const scene::Problem<3>& problem, int edge);
/// With so many edges halved, one after the other: mostly the longest one of some cell.
scene::Problem<3> refined(scene::Problem<3> problem, int halvings, std::mt19937& generator);

scene::Material<3> steel(double young = 1, double poisson = 0.3);
/// Of no symmetry.
scene::Material<3> crystal();

/// Numbers of this size at every node. \param degree 1 or 2
scene::Displacement<3> random_displacement(const scene::Problem<3>& problem, int degree, double size,
                                           std::mt19937& generator);
/// `mean`, and in addition numbers of this size.
scene::Stress<3> random_stress(const scene::Problem<3>& problem, const scene::Voigt<3>& mean, double size,
                               std::mt19937& generator);

}  // namespace bracket::tests
