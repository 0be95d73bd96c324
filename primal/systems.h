// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "contact/contact.h"
#include "primal/rows.h"

namespace bracket::primal {

/// The bodies as linear systems in the unknowns of their nodes. Where contact has springs, they are one more, behind
/// the bodies: its unknowns are the Bernstein coefficients of their shortening s on each facet, its energy is ½ ∫ k s².
template <int dim> struct Systems {
  std::vector<contact::System> body;
  /// K between a body's unknowns and the prescribed displacements of all nodes, component by component:
  /// what it takes off the load is this times them.
  std::vector<Eigen::SparseMatrix<double>> held;
};
/// \param rows contact_rows()   \param paths scene::dissect()
template <int dim>
Systems<dim> assemble(const scene::Problem<dim>& problem, const Nodes<dim>& nodes, const std::vector<Row>& rows,
                      const std::vector<std::uint64_t>& paths);

/// ∫ F·φ and ∫ P·φ over Γ_τ of each body, exact for constant F and linear P.
template <int dim> std::vector<Eigen::VectorXd> loads(const scene::Problem<dim>& problem, const Nodes<dim>& nodes);

/// The prescribed displacements of all nodes, as the columns of Systems::held.
template <int dim> Eigen::VectorXd prescribed(const Nodes<dim>& nodes);

}  // namespace bracket::primal
