// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <iostream>
#include <system_error>

#include "apps/commands/commands.h"
#include "apps/commands/folder.h"
#include "apps/report/lines.h"
#include "embedded/start_scene.h"

namespace bracket::apps {

void init(const std::filesystem::path& folder) {
  std::error_code error;
  if (!folder.empty()) std::filesystem::create_directories(folder, error);
  const std::filesystem::path file = folder / "scene.toml";
  if (error)
    throw scene::Error(scene::Status::input,
                       fmt::format("{}: the folder cannot be made: {}", folder.string(), error.message()));
  if (std::filesystem::exists(std::filesystem::symlink_status(file, error)))
    throw scene::Error(scene::Status::input,
                       fmt::format("{}: is there already and stays as it is; take another folder", file.string()));
  write_new_file(file, start_scene, false);
  std::cout << within_columns(
      fmt::format("{0}: a scene to change into yours\nSolve it: bracket run {0}\n", file.string()));
}

}  // namespace bracket::apps
