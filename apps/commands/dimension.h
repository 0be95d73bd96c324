// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scene/scene.h"

/// What is not known in space is refused before anything is solved.
namespace bracket::apps {

/// Whether a scene is one of space. \throw scene::Error (input) as scene::dimension_of()
bool is_in_space(const std::filesystem::path& scene, const std::vector<std::string>& overrides);

/// \throw scene::Error (input) if the scene is one of space   \param command that knows the plane alone
void refuse_space(const std::filesystem::path& scene, const std::vector<std::string>& overrides, const char* command);

}  // namespace bracket::apps
