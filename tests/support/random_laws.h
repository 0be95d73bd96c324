// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/support/random_scenes.h"

namespace bracket::tests {

/// random_scene() with a law for each of its contacts, drawn with values from nothing to more than there are loads;
/// gaps of sides that keep together are none.
RandomScene random_laws(std::uint64_t seed);

}  // namespace bracket::tests
