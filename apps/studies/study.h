// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "apps/plots/picture.h"
#include "apps/report/report.h"

namespace bracket::apps {

/// A scene refined in one way.
struct Series {
  std::string strategy;
  int degree;
  std::vector<bounds::Level> levels = {};
  std::vector<LevelSeconds> around = {};  ///< as `levels`; elapsed since the start of the series
  std::string end = "running";            ///< why it ended
};

/// A line per level, and the observed orders.
std::string study_text(const std::vector<Series>& series);

std::string study_csv(const std::vector<Series>& series);
std::string study_json(const scene::Scene<2>& scene, const std::vector<Series>& series);

/// Guaranteed error against run time, with the observed orders.
/// \pre some level has an error that is finite and not zero
Picture study_picture(const std::vector<Series>& series);

/// Whether study_picture() has something to show.
bool has_picture(const std::vector<Series>& series);

}  // namespace bracket::apps
