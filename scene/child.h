// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <filesystem>
#include <string>

#include "scene/types.h"

/// Programs of our own that read files by libraries whose faults must not be ours: one converts a file into another.
namespace bracket::scene {

/// A temporary folder; it goes with the object.
class TemporaryFolder {
 public:
  /// \throw Error (input), at `where`, if it cannot be made
  explicit TemporaryFolder(const std::string& where);
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// A program that is called with the file that it reads and the one that it writes, and says on standard error why it
/// cannot.
struct Converter {
  std::string program;  ///< lies in the folder "bracket" beside this library
  std::string reader;   ///< the library that it runs, for messages
  std::string result;   ///< the name of the file that it writes
  Status status;        ///< of a file that cannot be read
};

/// Runs a converter, for `limit` at most. \return the file that it wrote, in `folder`
/// \throw Error (input: no such file; converter.status: it cannot be read, with what the converter says)
std::filesystem::path converted(const std::filesystem::path& file, const TemporaryFolder& folder,
                                const Converter& converter, std::chrono::seconds limit);

}  // namespace bracket::scene
