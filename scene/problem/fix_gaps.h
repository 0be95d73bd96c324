// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "scene/problem/problem.h"
#include "scene/scene.h"

namespace bracket::scene {

/// Largest error and largest value over facets.
struct Extent {
  double error = 0, largest = 0;

  template <class Values> void include(const Values& values) {
    error = std::max(error, values.error);
    largest = std::max(largest, values.largest);
  }
  double relative() const { return largest > 0 ? error / largest : 0; }
};

/// Fills in the gaps of the contact on the first mesh, and what friction does not see of the slip (docs/theory.md §2,
/// §11). \return how far what is interpolated is from what is given, and what was changed to make room for supports
/// \pre everything else is fixed   \throw Error (input) where a function has no finite value
template <int dim> Extent fix_gaps(const Scene<dim>& scene, Problem<dim>& problem);

}  // namespace bracket::scene
