// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bounds/certificate/space/displacement_energy.h"
#include "bounds/certificate/space/equilibrate.h"

/// Both fields of a problem as the certificate moves them, and their energies.
namespace bracket::bounds::space {

struct Sides {
  std::string reason;            ///< if one of them could not be moved
  FieldEnergy<Enclosure> above;  ///< of displacements in K
  Supports supports;
  PlainField field;
  Enclosure below;  ///< S of stresses in balance
  Loads<Enclosure> loads;
};
/// \param corrections as corrected() has them   \pre fault_of() finds none
Sides both_sides(const scene::Problem<3>& problem, const std::vector<Corrected<Enclosure>>& corrections,
                 const scene::Displacement<3>& displacement, const scene::Stress<3>& stress);

/// What arithmetic, problem or fields lack of what a certificate needs, in one line; empty: nothing.
std::string displacement_fault(const scene::Mesh<3>& mesh, const scene::Displacement<3>& displacement);
std::string fault_of(const scene::Problem<3>& problem, const scene::Displacement<3>& displacement,
                     const scene::Stress<3>& stress);

}  // namespace bracket::bounds::space
