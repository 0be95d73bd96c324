// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <stop_token>

#include "bounds/certificate/certificate.h"
#include "bounds/estimate/estimate.h"
#include "bounds/quantities/quantities.h"
#include "contact/contact.h"
#include "primal/primal.h"

/// The bracket −S(λ_h) ≤ L(u) ≤ L(u_h) and what follows from it (docs/theory.md §1). Everything here is computed from
/// plain field values by code of its own: what certifies shares nothing with what solves.
namespace bracket::bounds {

struct Seconds {
  double mesh = 0;  ///< reading, meshing and fixing the data; later marking and refining
  double primal = 0;
  double dual = 0;
  double estimate = 0;  ///< indicators and checks
  double certify = 0;
  double quantities = 0;
  double total = 0;  ///< wall clock; the two formulations run side by side
};

/// How Coulomb's friction was approached on one mesh (docs/theory.md §11.1).
struct FrictionSteps {
  int steps = 0;         ///< problems whose shear has a given bound; 0: no contact has Coulomb's law
  double residual = 0;   ///< η ≥ 0, an energy, of the last; zero for a solution of Coulomb's problem only
  bool settled = false;  ///< η is at most twice the width of the last step's bracket
};

/// How far the last of Coulomb's steps is from the law, near a place on a contact: what its solution presses there, ∫ p
/// ψ for a weight ψ that is one at that place and falls to zero around it, and what its bound of the shear was made of,
/// ∫ g_T ψ/μ. For a solution of Coulomb's problem the two are equal. Forces per thickness, between guaranteed bounds.
struct FrictionForce {
  int contact = -1;  ///< index into Scene::contact
  scene::Vector<2> at = scene::Vector<2>::Zero();
  double lower = 0, upper = 0;  ///< infinite: no bound
  double assumed_lower = 0, assumed_upper = 0;
};

/// What one mesh gave.
struct Level {
  int cells = 0;
  Bracket bracket;  ///< from the certificate; without one, from the plain energies
  PlainEnergies plain;
  Certificate certificate;
  Checks checks;
  double oscillation_energy = 0;  ///< of the data, which the first mesh fixes: see data_effect()
  std::string oscillation_part;   ///< the boundary part with the largest share of it; empty: there is none
  Seconds seconds;
  contact::Statistics primal, dual;
  FrictionSteps friction;
};

/// What a run has found; the fields are those of the last level.
template <int dim> struct Outcome {
  scene::Status status = scene::Status::done;
  /// "rounding-safe"; "discretisation": as that, but for data of which some are known at points only; "tresca-step": as
  /// these, for the bound of the shear of the last of the steps by which Coulomb's friction is approached; "none".
  std::string guarantee = "none";
  std::string reason;  ///< if there is no guarantee or the budget was spent: one line
  /// The bracket of the run: its levels' brackets of one fixed problem, intersected. The displacement spaces are
  /// nested, so that where gaps are quadratic the last upper bound is the least; the stress spaces are not.
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
  double relative_error_bound = std::numeric_limits<double>::infinity();  ///< √(2 (upper − lower)) / ‖u_h‖_A; not a
                                                                          ///< number if `unstrained`, but for [0, 0]
  /// Where parts are arcs each level is the problem of its own polygon, with Coulomb's friction that of a bound of its
  /// own, and the bounds are those of the last: by how
  /// much the middle of the interval moved with the last mesh. Infinite: there is but one level.
  double moved = std::numeric_limits<double>::infinity();
  bool unstrained = false;  ///< the bodies but follow prescribed displacements and gaps; what is left is rounding
  scene::Problem<dim> problem;
  scene::Displacement<dim> displacement;
  scene::Stress<dim> stress;
  Indicator indicator;
  std::vector<Level> levels;
  std::vector<QuantityInterval> quantities;  ///< as Scene::quantities, then the zones of contacts
  std::vector<FrictionForce> friction;       ///< on the last level, where contacts have Coulomb's friction
  std::vector<std::string> skipped;          ///< stages that the scene did not need
};

/// Who follows a run, and may end it.
template <int dim> struct Observer {
  std::function<void(const std::string& stage)> stage;    ///< told as each stage of a level begins
  std::function<void(const Outcome<dim>& so_far)> level;  ///< told as each level is done
  std::stop_token stop;                                   ///< asked after each level
};

/// The problem, which is solvable, with its loads in balance to the last bit along all motions that nothing holds: what
/// they lack of it is taken off (Problem::corrections), where rounding of the loads, the coordinates and the directions
/// explains it. Coulomb's friction gets its first bound. Prescribed displacements keep the contact, and pressures can
/// balance the loads [HH81 (1.16)]. \param problem on its first mesh; corrections that it has are made anew   \param
/// degree of the displacements, 1 to 4 \throw scene::Error (ill_posed), with the place on the contact or with the body,
/// the motion and both forces
template <int dim> scene::Problem<dim> balanced(scene::Problem<dim> problem, int degree);
template <> scene::Problem<3> balanced(scene::Problem<3> problem, int degree);

/// The whole main job: mesh, fixed data, solvability; then level by level both formulations, checks, bracket, marking
/// and refinement, until the target or the budget of scene.refine. Where the data are not linear on the edges of the
/// first mesh and that matters, it is refined there first. Where the bodies do but follow the prescribed
/// displacements and gaps, rigidly and without loads, the bracket is [0, 0] and the first mesh is the last. Where the
/// memory does not suffice for a level, or no thread can be had for it, the run ends like one whose budget is spent.
/// Quantities are computed on the last level and on earlier ones of at most a quarter of its cells, more often where a
/// target of theirs is all that is left to reach; the goal on each. The run is done when all targets are met.
/// \param engine who solves for displacements; empty: primal::Solver. What another one has is certified like its
///        fields, so that its errors widen the interval. It knows neither quantities nor contact laws.
/// \throw scene::Error for all that the user can mend, as scene::check(); ill_posed, too, where a motion that nothing
///        resists changes a quantity both ways; input, where an engine is asked for what it does not know
template <int dim>
Outcome<dim> run(const scene::Scene<dim>& scene, const Observer<dim>& observer = {},
                 const primal::Engine<dim>& engine = {});

/// The same from data that are fixed already and may have been changed since: of `scene` only the settings count, and
/// nothing is known of what fixing the data did (Level::oscillation_energy is 0).
template <int dim>
Outcome<dim> run(const scene::Scene<dim>& scene, scene::Problem<dim> problem, const Observer<dim>& observer = {});

}  // namespace bracket::bounds
