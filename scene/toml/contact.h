// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/toml/nodes.h"

namespace bracket::scene {

template <int dim> ContactPair<dim> read_contact(const toml::table& entry);
/// Whether an entry of [[contact]] is a bond.
bool is_bond(const toml::table& entry);
Bond read_bond(const toml::table& entry);                             ///< of [[contact]]
Curve read_curve(const toml::table& entry, const std::string& part);  ///< of [curves."PART"]

}  // namespace bracket::scene
