// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "scene/scene.h"

namespace bracket::apps {

/// The units of a scene's numbers, each with a blank in front, to be written behind a number; empty: not known. What is
/// told by thickness, as forces and energies in the plane, is so in its unit.
struct Units {
  std::string length, stress, force, energy, angle;
  std::string area, volume, body_force;
  std::string energy_norm;  ///< the root of an energy
};

/// What the label of a scene's units says, such as "N, mm, MPa": it names one unit of length and one of force or of
/// stress, in any order, or both where they fit together. Of any other label nothing is known: it stands as it is.
Units units_of(const std::string& label, int dim = 2);

/// The unit of a quantity; empty also where a weight of the user's own is in it.
template <int dim> std::string unit_of(const scene::Quantity<dim>& quantity, const Units& units);

}  // namespace bracket::apps
