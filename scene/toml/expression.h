// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/scene.h"

namespace bracket::scene {

/// A formula in x and y, in space in z as well, with pi and e, as an enclosed function, in the language of
/// scene/toml/formula.h. Numbers stand for the doubles nearest to them. \throw Error (input), at `where`, if it is not
/// one formula, names something unknown or assigns
template <int dim = 2> Function<dim> parse_expression(const std::string& formula, const std::string& where);

}  // namespace bracket::scene
