// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/toml/nodes.h"

namespace bracket::scene {

template <int dim> Quantity<dim> read_quantity(const toml::table& entry);  ///< of [[quantity]]

}  // namespace bracket::scene
