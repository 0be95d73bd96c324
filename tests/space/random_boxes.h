// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <random>

#include "scene/scene.h"

/// Random problems that meshes in space can share.
namespace bracket::tests::space {

/// Two unit cubes on top of each other, in contact, of moduli up to 1 : 1000, the lower one perhaps on a rigid wall.
/// Each other side is fixed or slides, as one affine displacement says, is pulled or pressed, linearly, or free.
struct RandomBoxes {
  explicit RandomBoxes(std::mt19937& random);

  std::array<double, 2> young, poisson;
  Eigen::Matrix3d strain;  ///< of what is prescribed
  scene::Vector<3> force;
  std::map<std::string, scene::ConditionKind> kinds;
  std::array<Eigen::Matrix<double, 3, 4>, 2> load;  ///< of each body: 1, x, y, z
  std::array<double, 4> gap;                        ///< a + b x + c z + d x z
  bool on_wall;
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();  ///< of bodies and all data, about the origin

  /// Its bodies, each side cut in n, the vertices inside of bodies and sides moved.
  scene::Mesh<3> mesh(int n, std::mt19937& random) const;
  /// The problem on a mesh of the boxes as they are before they are turned.
  scene::Scene<3> on(const scene::Mesh<3>& mesh) const;
};

/// The next that has an equilibrium, by a coarse mesh.
RandomBoxes solvable_boxes(std::mt19937& random);

/// A random mesh of which a third of the cells was bisected, as a mesh of its own.
scene::Mesh<3> refined_once(const RandomBoxes& boxes, int n, std::mt19937& random);

/// The same scene with the numbers of its vertices, cells and facets drawn anew.
scene::Scene<3> renumbered(scene::Scene<3> scene, std::mt19937& random);

}  // namespace bracket::tests::space
