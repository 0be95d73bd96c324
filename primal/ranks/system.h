// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <mpi.h>

#include <memory>
#include <vector>

#include "primal/ranks/piece.h"

namespace bracket::primal {

void start_petsc();  ///< \pre MPI is initialised
void end_petsc();

/// A node whose Bernstein coefficient is not its three unknowns: offset + Σ matrix · y. Columns of zeros in its own
/// matrix: those of its unknowns stay zero.
struct TiedNode {
  int node = -1;
  bool asked = false;  ///< whether the force at it is to be told
  scene::Vector<3> offset = scene::Vector<3>::Zero();
  std::vector<std::pair<int, Eigen::Matrix3d>> of = {};  ///< (node, matrix), itself first
};

/// How a system is to be solved.
struct Way {
  bool direct = false;      ///< by a factorisation, else by conjugate gradients with algebraic multigrid
  double tolerance = 1e-9;  ///< of the residual in the norm of the preconditioner, by that of the load
};

/// Of all nodes, on the root.
struct Answer {
  Eigen::VectorXd unknowns;  ///< y
  Eigen::VectorXd forces;    ///< K u at nodes that were asked for, along the axes; elsewhere 0
  int iterations = 0;
  bool converged = true;
};

/// The stiffness of all bodies over the processes of a communicator, on PETSc. Its functions are collective: each
/// process calls them; loads and answers are the root's.
class System {
 public:
  System(MPI_Comm processes, Piece piece, std::vector<scene::Elasticity<3>> materials);
  System(System&&) noexcept;
  ~System();

  /// Where a factorisation fails it throws, on all processes.
  /// \param tied of the nodes that its cells have, sorted by node   \param load Tᵀ f, of all nodes (root)
  /// \param start y to start from (root)
  Answer solve(const std::vector<TiedNode>& tied, const Way& way, const Eigen::VectorXd& load,
               const Eigen::VectorXd& start);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace bracket::primal
