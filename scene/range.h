// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace bracket::scene {

/// Moduli, loads, lengths and displacements of a scene are 0 or of a size within these: displacements, which are
/// load · length / modulus, can then still be squared, and energies do not overflow.
inline constexpr double smallest_size = 1e-50, largest_size = 1e50;

/// "name must be finite, is value" or "name must be 0 or of a size …, is value"; empty: it is.
std::string size_message(double value, const std::string& name);

/// \throw Error (input) "where: message" with the message of size_message(), if there is one
void check_size(double value, const std::string& where, const std::string& name);

}  // namespace bracket::scene
