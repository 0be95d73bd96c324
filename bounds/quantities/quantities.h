// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "scene/quantity.h"

/// Quantities of interest between two guaranteed bounds (docs/theory.md §10).
namespace bracket::bounds {

/// What one mesh said of a quantity.
struct QuantityLevel {
  int cells = 0;
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
  double s = 0;        ///< the factor of the perturbation; 0: none was needed, or none was found
  double seconds = 0;  ///< of this quantity on this level
  std::string reason;  ///< if a bound is missing: one line
};

/// A quantity as far as a run has come.
struct QuantityInterval {
  std::string name;
  scene::QuantityKind kind = scene::QuantityKind::energy;
  int contact = -1;       ///< of a force, an opening or a slip: index into Scene::contact
  int zone = -1;          ///< which of the contact's zones it is the force of; −1: asked for by name
  bool weighted = false;  ///< near an end where supports or contacts meet its weight falls to zero
  /// Levels intersected where they are one problem, else the last. Infinite: no bound on that side.
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
  /// Width by the larger of |lower| and |upper|; not a number where 0 is inside or a bound is infinite.
  double relative_width = std::numeric_limits<double>::quiet_NaN();
  bool target_reached = true;  ///< or none was asked
  std::string reason;          ///< if a bound is missing: one line
  std::vector<QuantityLevel> levels;
};

}  // namespace bracket::bounds
