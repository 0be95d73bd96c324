// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <random>
#include <string>
#include <vector>

#include "scene/fields.h"
#include "scene/problem/problem.h"

/// Displacements to be judged, and fields to judge them by.
namespace bracket::tests {

struct GivenField {
  std::string name;
  scene::Displacement<2> displacement;
};
/// The solver's own of a degree, and what no solver would give: spoilt by noise of half its size, then also carried
/// away by rigid motions in which strains drown, and with the first sides of contacts pushed in, as penalties do.
std::vector<GivenField> given_fields(const scene::Problem<2>& first, int degree, std::mt19937& generator);

struct Fields {
  scene::Displacement<2> displacement;
  scene::Stress<2> stress;
};
Fields solved(const scene::Problem<2>& problem, int degree);

}  // namespace bracket::tests
