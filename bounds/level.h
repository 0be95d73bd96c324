// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <optional>
#include <set>
#include <thread>

#include "bounds/bounds.h"
#include "bounds/quantities/pair.h"
#include "contact/clock.h"
#include "dual/dual.h"
#include "primal/primal.h"

/// What a run does on one mesh.
namespace bracket::bounds {

/// Both formulations' fields of one problem, or why there are none, and what they were solved with.
template <int dim> struct SolvedStep {
  primal::Result<dim> primal;
  dual::Result<dim> dual;
  Solvers<dim> solvers;
  double primal_seconds = 0, dual_seconds = 0, seconds = 0;  ///< of this and the steps before it, and of all they took
};

/// A problem to be solved, and what is expected of its contact.
template <int dim> struct Meshed {
  scene::Problem<dim> problem;
  std::vector<char> primal_closed = {}, dual_closed = {};  ///< empty: unknown
  double seconds = 0;                                      ///< that it took to make
  bool changed = false;                                    ///< the data are no more those of the scene
  std::vector<std::string> notes = {};                     ///< of the scene's own mesh
  FrictionSteps friction = {};
  std::optional<SolvedStep<dim>> step = {};  ///< the last of Coulomb's, which is of this problem
  int times_resolved = 0;                    ///< how often that was refined for the data,
  std::set<std::string> resolved = {};       ///< and those of which parts
};

/// Both formulations on one mesh, and what follows from their fields.
template <int dim> struct Examined {
  primal::Result<dim> primal;
  dual::Result<dim> dual;
  std::string unsolved;     ///< why one of them has no field; empty: both have, and the rest is set
  DataEffect effect;        ///< on the first mesh, of data that are the scene's
  bool unstrained = false;  ///< the bodies but follow the prescribed displacements and gaps: see is_unstrained()
  Level level;
  Indicator indicator;
  Solvers<dim> solvers;  ///< kept where quantities are asked for
};

/// Of BLAS: in the plane each of the two formulations has a thread of its own; in space they run in turn.
template <int dim> int blas_threads() {
  return dim == 2 ? 1 : static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

/// How often local stresses are swept on a mesh.
template <int dim> int sweeps_of(const scene::Scene<dim>& scene, const scene::Mesh<dim>& mesh);

/// {displacement | stress} → certificate, bracket, indicators.
/// \param earlier levels of the run
/// \param run_clock since it began: Uzawa's iteration, alone in being slow, ends when the time is spent
/// \param engine who solves for displacements; empty: we ourselves
template <int dim>
Examined<dim> examine(const scene::Scene<dim>& scene, const Meshed<dim>& meshed, const std::vector<Level>& earlier,
                      const Clock& run_clock, const Observer<dim>& observer, const primal::Engine<dim>& engine);

/// Why a level does not carry a run on.
struct Objection {
  std::string reason;       ///< empty: it does
  bool reported = true;     ///< it is the run's last level all the same
  bool guaranteed = false;  ///< what the levels before guarantee still holds
};
/// That it has no certificate; that its bounds contradict each other or those of earlier levels; that the upper bound
/// rose although the sets of admissible displacements are nested.
/// \param one_problem whether the levels are of one problem; if not, they are not compared
template <int dim>
Objection objection(const Outcome<dim>& earlier, const scene::Problem<dim>& problem, const Examined<dim>& examined,
                    bool one_problem);

}  // namespace bracket::bounds
