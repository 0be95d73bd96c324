// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "primal/primal.h"
#include "primal/rows.h"

namespace bracket::primal {

/// What displacements press with, of each body as vectors of its unknowns.
struct ContactForces {
  std::vector<Eigen::VectorXd> displacement;  ///< q
  std::vector<Eigen::VectorXd> force;         ///< of the contact on the body, by the unknowns' directions: f − K u
  std::vector<Eigen::VectorXd> stiffness;     ///< > 0 where contact may touch: about K's diagonal
  std::vector<Eigen::VectorXd> load;          ///< f
  std::vector<Eigen::MatrixXd> rigid;         ///< the motions that the supports leave
};

/// Pressures that are linear on each contact facet, at the vertices of its first facet.
template <int dim> struct MatchedPressure {
  contact::Termination termination = contact::Termination::solved;
  std::vector<std::array<double, dim>> pressure;
  std::vector<Eigen::VectorXd> force;  ///< theirs on each body, as ContactForces::force
};

/// The pressures p that balance the loads of bodies that float and are nearest to the forces z of displacements: they
/// minimise ½ |D^(−1/2) (E p − z)|² + ∫ p (g − r), with the jump term of PressureSolver, E p their forces, D the
/// stiffness there, r the displacements' approach. They need no compliance of the bodies. \param closed contact facets
/// expected to be pressed, empty: all
template <int dim>
MatchedPressure<dim> matched_pressure(const scene::Problem<dim>& problem, const Nodes<dim>& nodes,
                                      const ContactForces& forces, const std::vector<char>& closed);

}  // namespace bracket::primal
