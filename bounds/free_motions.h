// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "contact/contact.h"
#include "scene/scene.h"

/// The bodies as wholes: how they can move, and what loads and contacts do to that.
namespace bracket::bounds {

/// The rigid motions that the supports leave to all components, side by side.
template <int dim> struct FreeMotions {
  std::vector<scene::RigidMotion<dim>> motion;
  std::vector<int> body;
};
template <int dim> FreeMotions<dim> all_free_motions(const scene::Problem<dim>& problem);

/// What contacts can do to hold the bodies: a pressure on a facet can be replaced by forces at its vertices, as many a
/// facet, and so can, behind these, the shear on a facet with friction.
struct Holding {
  Eigen::MatrixXd rows;    ///< the approach of the sides there, or their slip, under each motion
  contact::Limits limits;  ///< of the forces; the shear's each by itself: ∫ g_T by the hat functions
  bool friction = false;   ///< whether there are rows of slip
};
/// \param inset from the vertices, at most to the middle
template <int dim> Holding holding(const scene::Problem<dim>& problem, const FreeMotions<dim>& all, double inset = 0);

/// The same where Coulomb's friction bears a shear of at most μ times the pressure: in place of the rows of r and v_t
/// those of (r/μ + v_t)/2 and (r/μ − v_t)/2, whose multipliers μ p + τ and μ p − τ are ≥ 0.
template <int dim> Holding holding_by_pressure(const scene::Problem<dim>& problem, const FreeMotions<dim>& all);

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
