// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bounds/certificate/certificate.h"
#include "bounds/certificate/equilibrate.h"

/// Both fields of a problem as the certificate moves them, and their energies.
namespace bracket::bounds {

/// Stresses in balance.
struct Below {
  std::string reason;     ///< if there is no bound
  Enclosure energy;       ///< S
  Enclosure of_boundary;  ///< what it has beside that of the cells
  EdgeLoads<Enclosure> loads;
};
/// Displacements in K.
struct Above {
  std::string reason;
  FieldEnergy<Enclosure> energy;
  Enclosure of_loads;  ///< what it has beside that of the strain
  Supports supports;
  PlainField field;
};
struct Sides {
  std::string reason;  ///< if one of them could not be moved
  Above above;
  Below below;
};
/// \param corrections as corrected() has them   \pre fault_of() finds none
Sides both_sides(const scene::Problem<2>& problem, const std::vector<Corrected<Enclosure>>& corrections,
                 const scene::Displacement<2>& displacement, const scene::Stress<2>& stress, Digits digits);

/// What the displacements lack of being those of the problem's mesh, in one line; empty: nothing.
std::string displacement_fault(const scene::Problem<2>& problem, const scene::Displacement<2>& displacement);

/// What arithmetic, problem or fields lack of what a certificate needs, in one line; empty: nothing.
std::string fault_of(const scene::Problem<2>& problem, const scene::Displacement<2>& displacement,
                     const scene::Stress<2>& stress);

}  // namespace bracket::bounds
