// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/commands/dimension.h"

#include <fmt/format.h>

namespace bracket::apps {

bool is_in_space(const std::filesystem::path& scene, const std::vector<std::string>& overrides) {
  return scene::dimension_of(scene, overrides) == 3;
}

void refuse_space(const std::filesystem::path& scene, const std::vector<std::string>& overrides, const char* command) {
  if (is_in_space(scene, overrides))
    throw scene::Error(
        scene::Status::input, scene.string(),
        fmt::format("bracket {} knows plane scenes only; in space there are run, check, info, mesh and assess",
                    command));
}

}  // namespace bracket::apps
