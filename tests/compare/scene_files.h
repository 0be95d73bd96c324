// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "scene/scene.h"
#include "tests/support/sanitized.h"

namespace bracket::tests {

/// All scenes of apps/scenes, by name; under sanitizers but for that of the most cells, which arcs_test.cpp has
/// coarser.
inline std::vector<std::filesystem::path> scene_files() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(BRACKET_SCENES))
    if (entry.path().extension() == ".toml" && !(sanitized && entry.path().stem() == "press_fit"))
      files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

/// The one with this name.
inline scene::Scene<2> from_file(const std::string& name, const std::vector<std::string>& overrides = {}) {
  return scene::read_scene<2>(std::filesystem::path(BRACKET_SCENES) / (name + ".toml"), overrides);
}

}  // namespace bracket::tests
