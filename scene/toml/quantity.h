// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/toml/nodes.h"

namespace bracket::scene {

Quantity<2> read_quantity(const toml::table& entry);  ///< of [[quantity]]

}  // namespace bracket::scene
