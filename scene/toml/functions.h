// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/jet.h"

/// The functions that formulas know.
namespace bracket::scene {

struct Named {
  const char* name;
  double (*at)(double);
  Jet (*over)(const Jet&);
};
/// Of one argument.
extern const std::array<Named, 21> functions;

}  // namespace bracket::scene
