// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

#include "apps/plots/picture.h"

namespace bracket::apps {

/// `folder`, or where it is empty the scene's stem + `ending` in the current directory.
std::filesystem::path results_folder(const std::filesystem::path& folder, const std::filesystem::path& scene,
                                     const std::string& ending);

/// A file descriptor, closed at the end.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor();
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&&) = delete;
  int number() const { return number_; }

 private:
  int number_;
};

/// Makes `folder` ready for the results of a run: creates it, or clears it of the files that an earlier run wrote there
/// (a folder of results lists them in its file `.bracket`).
/// \return as long as it lives the folder is this run's, and refused to others
/// \throw scene::Error (input) if it is not a folder, is in use by another run, holds files but no `.bracket`, or
///        symbolic links in the place of results, or cannot be written
[[nodiscard]] Descriptor prepare_folder(const std::filesystem::path& folder);

/// Writes a file of results, under another name first, so that it is there as a whole or not at all. Symbolic links are
/// not followed.
/// \pre prepare_folder(folder)
/// \throw scene::Error (input) if it cannot be written
void write_file(const std::filesystem::path& folder, const std::string& name, std::string_view content);

/// Writes a file that is no result of a run, as a whole or not at all. Symbolic links are not followed.
/// \param replace whether it may be there; a file that is must not be touched otherwise
/// \throw scene::Error (input) if it is there and must not, or cannot be written
void write_new_file(const std::filesystem::path& file, std::string_view content, bool replace);

/// Draws a picture and writes it as SVG; where that cannot be, a note on standard error says why.
/// \throw as write_file()
void write_picture(const std::filesystem::path& folder, const Picture& picture);

}  // namespace bracket::apps
