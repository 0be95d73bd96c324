// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "scene/enclosure.h"

namespace bracket::bounds {

using scene::Enclosure;

/// x with A x = b. \return nothing where A may be singular
std::optional<std::vector<Enclosure>> solution(std::vector<std::vector<Enclosure>> a, std::vector<Enclosure> b);

}  // namespace bracket::bounds
