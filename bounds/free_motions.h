// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/scene.h"

/// The bodies as wholes: how they can move, and what loads and contacts do to that.
namespace bracket::bounds {

/// The rigid motions that the supports leave to all components, side by side.
template <int dim> struct FreeMotions {
  std::vector<scene::RigidMotion<dim>> motion;
  std::vector<int> body;
};
template <int dim> FreeMotions<dim> all_free_motions(const scene::Problem<dim>& problem);

/// The approach of the contact sides under each motion, at the ends of each contact facet: a pressure on a facet can be
/// replaced by forces at its ends.
/// \param inset from the ends, at most to the middle
template <int dim>
Eigen::MatrixXd approaches(const scene::Problem<dim>& problem, const FreeMotions<dim>& all, double inset = 0);

/// The work of the loads in each motion, and the sum of its parts' sizes.
struct LoadWork {
  Eigen::VectorXd work;
  double size = 0;
};
template <int dim> LoadWork load_work(const scene::Problem<dim>& problem, const FreeMotions<dim>& all);

/// The component that a combination y of the motions moves most, and how.
template <int dim> struct Moved {
  int body;
  scene::RigidMotion<dim> motion;
};
template <int dim> Moved<dim> most_moved(const FreeMotions<dim>& all, const Eigen::VectorXd& y);

}  // namespace bracket::bounds
