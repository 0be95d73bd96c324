// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include "scene/child.h"

namespace bracket::tests {

/// An empty temporary folder that is there as long as the object is.
class Folder {
 public:
  /// Writes a file into it, in the place of any of that name. \return its path
  std::filesystem::path write(const std::string& name, const std::string& content) const {
    std::filesystem::remove(path() / name);  // some file systems wait for the disk when a file is written over
    std::ofstream(path() / name, std::ios::binary) << content;
    return path() / name;
  }
  const std::filesystem::path& path() const { return folder_.path(); }

 private:
  scene::TemporaryFolder folder_{"a test"};
};

}  // namespace bracket::tests
