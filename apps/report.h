// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bounds/bounds.h"

namespace bracket::apps {

/// What a run found, in the three forms in which it is told. Numbers in them read back to the same double.
struct Report {
  scene::Scene<2> scene;
  bounds::Outcome<2> outcome;                 ///< \pre at least one level
  std::vector<bounds::ContactState> contact;  ///< as Problem::contact
};

/// report.json: the fields of the report, schema 1. A number that is not finite is null.
std::string report_json(const Report& report);

/// history.csv: a line of names, then a line per level.
std::string history_csv(const Report& report);

/// One line: the interval of the energy, its width by its size, and the guaranteed relative error (rounded up); or that
/// there is no guarantee, and why.
std::string headline(const Report& report);

/// All that follows the headline on the terminal: the mesh and what it cost, contact, checks, data, what was left out.
std::string report_text(const Report& report);

}  // namespace bracket::apps
