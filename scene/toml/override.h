// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "scene/toml/toml.h"

namespace bracket::scene {

/// The table `scene` with one key replaced or added. `assignment` is "key=value": a dotted key whose parts may be
/// quoted, with entries of lists by number from 0 (contact.0.gap); names with dots in them, such as boundary parts,
/// need no quotes. The value is TOML, or, if it is not, a string. The node's place becomes "--set key=value".
/// \throw Error (input) if there is no key or it leads through something that is neither table nor list
toml::table with_override(toml::table scene, const std::string& assignment);

}  // namespace bracket::scene
