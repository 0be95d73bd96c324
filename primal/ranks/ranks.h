// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "primal/primal.h"

/// Displacements in space by the processes of MPI: a mesh in pieces, on PETSc.
namespace bracket::primal {

/// MPI and PETSc, from the first line of a program to its last. One in a process.
class Processes {
 public:
  Processes(int* argc, char*** argv);
  ~Processes();
  Processes(const Processes&) = delete;
  Processes& operator=(const Processes&) = delete;

  bool is_root() const;
  int count() const;
};

/// The root's hold of all processes, until it goes.
class Ranks {
 public:
  explicit Ranks(const Processes& processes);
  ~Ranks();
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;

  /// How solve() solves linear systems, in words: by a factorisation where there are at most 20 000 unknowns, or where
  /// a material is nearly incompressible, else by conjugate gradients.
  std::string way(const scene::Problem<3>& problem, int degree) const;

  /// As primal::Solver::solve() and solve_with_pressure(), but for two things: iterations end at a residual of 1e-9
  /// of the load, in the preconditioner's norm; and pressures are those of matched_pressure(). Where a process fails
  /// while all are at work the program ends. \param problem without springs and friction, of at least as many cells as
  /// there are processes \param degree 1 or 2   \param closed contact facets expected to be closed (as Result::closed,
  /// or empty: all)
  Solved<3> solve(const scene::Problem<3>& problem, int degree, const std::vector<char>& closed = {}) const;
};

/// What the other processes do: what the root asks for, until its Ranks go.
void serve(const Processes& processes);

}  // namespace bracket::primal
