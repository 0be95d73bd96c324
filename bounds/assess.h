// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bounds/bounds.h"
#include "scene/field/on_scene.h"

/// The error ‖u_x − u‖_A of a displacement u_x from another program between two guaranteed bounds
/// (docs/other-programs.md).
namespace bracket::bounds {

struct ErrorInterval {
  double lower = 0;
  double upper = std::numeric_limits<double>::infinity();
};

/// What one mesh said of it.
struct AssessedLevel {
  int cells = 0;
  /// ‖σ(u_x) − m‖ ± √T, m = ½ (σ(u_h) + λ_h).
  ErrorInterval by_stress;
  /// From ‖u_s − u‖² = 2 (L(u_s) − L(u)) − 2 ∫ p (g − r(u_s)) with u_s on the supports, ± ‖u_s − u_x‖_A; [0, ∞): not
  /// computed on this level.
  ErrorInterval by_energy;
  double stress_error = 0;                ///< ≥ √T, the error of m
  double norm_lower = 0, norm_upper = 0;  ///< ‖u_h‖_A is between
  double seconds = 0;                     ///< that judging u_x took
};

template <int dim> struct AssessmentOf {
  scene::Status status = scene::Status::done;
  std::string guarantee = "none";  ///< as Outcome::guarantee
  std::string reason;              ///< if there is no guarantee or the budget was spent: one line
  ErrorInterval error;             ///< in the energy norm: levels and both kinds intersected
  ErrorInterval relative;          ///< by ‖u_h‖_A; not numbers where that may be zero

  scene::FieldOnSceneOf<dim> field;  ///< u_x on the first mesh, its problem as it was solved
  double largest = 0;                ///< the largest displacement of u_x at a node
  double misfit = 0;                 ///< the largest distance of u_x at a node from what supports prescribe
  double penetration = 0;            ///< the largest r(u_s) − g, ≥ 0
  double data_energy = 0;            ///< what fixing the data on the first mesh did to the energy: see data_effect()
  std::vector<double> cell;          ///< ‖σ(u_x) − m‖² of the last level, on each cell of the first mesh
  std::vector<AssessedLevel> levels;
};
using Assessment = AssessmentOf<2>;

/// Solves the scene from the mesh of the displacement on, by quadratic displacements and by stresses, until the error
/// of the mean stress is at most a twentieth of that of u_x, or the budget of scene.refine is spent; targets and
/// quantities of the scene do not count. Where two finer meshes do not make the error of the mean stress smaller, as it
/// is but rounding, the run is done, too.
/// \throw scene::Error as run(); where nothing could be solved also with the status that the run ended with
template <int dim>
AssessmentOf<dim> assess(const scene::Scene<dim>& scene, scene::FieldOnSceneOf<dim> field,
                         const Observer<dim>& observer = {});

}  // namespace bracket::bounds
