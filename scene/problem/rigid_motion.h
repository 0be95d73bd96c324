// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/problem/problem.h"

namespace bracket::scene {

/// An infinitesimal rigid motion: a translation and rotations (radians) about `centre`.
template <int dim> struct RigidMotion {
  Vector<dim> translation = Vector<dim>::Zero();
  std::array<double, Simplex<dim>::n_rotations> rotation{};  ///< in the planes of Simplex; one, counter-clockwise
  Vector<dim> centre = Vector<dim>::Zero();
};
/// The displacement of the point x.
template <int dim> Vector<dim> displacement(const RigidMotion<dim>& motion, const Vector<dim>& x) {
  const Vector<dim> arm = x - motion.centre;
  Vector<dim> u = motion.translation;
  for (std::size_t r = 0; r < motion.rotation.size(); ++r) {
    const auto& [i, j] = Simplex<dim>::rotations[r];
    u[i] -= motion.rotation[r] * arm[j];
    u[j] += motion.rotation[r] * arm[i];
  }
  return u;
}

/// The rigid motions that the supports of a component of the mesh leave free (none to all of them), linearly
/// independent, each moving some point of it by about 1 [HH81, R ∩ V].
template <int dim> std::vector<RigidMotion<dim>> free_motions(const Problem<dim>& problem, int component);

/// "moving it by (0, 1)" or "turning it clockwise about (2, 3)", in space "turning it about the axis through (0, 0, 1)
/// along (1, 0, 0)", to which it turns right-handed, for messages; coordinates at rounding level are 0.
/// \pre some point of its component is moved by about 1, as by free_motions()
template <int dim> std::string describe(const RigidMotion<dim>& motion);
template <> std::string describe(const RigidMotion<2>& motion);
template <> std::string describe(const RigidMotion<3>& motion);

}  // namespace bracket::scene
