// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/commands/folder.h"

#include <fmt/format.h>

#include <cerrno>
#include <fstream>
#include <ios>
#include <system_error>

#include "scene/scene.h"

namespace bracket::apps {
namespace {

namespace fs = std::filesystem;

constexpr const char* marker = ".bracket";
constexpr const char* unfinished = ".part";  // ends the name of a file that is being written

[[noreturn]] void refuse(const fs::path& path, const std::string& reason) {
  throw scene::Error(scene::Status::input, fmt::format("{}: {}", path.string(), reason));
}

void write(const fs::path& path, std::string_view content, std::ios::openmode mode) {
  errno = 0;
  std::ofstream out(path, mode | std::ios::binary);
  out.write(content.data(), static_cast<std::streamsize>(content.size()));
  out.close();
  if (!out) refuse(path, fmt::format("cannot be written: {}", std::generic_category().message(errno)));
}

// Only plain names are taken from the list: nothing outside of the folder is touched, whatever it says.
void clear_results(const fs::path& folder) {
  std::ifstream list(folder / marker);
  std::error_code error;
  for (std::string name; std::getline(list, name);) {
    if (name.empty() || name == "." || name == ".." || fs::path(name).filename() != name) continue;
    for (const std::string& file : {name, name + unfinished}) {
      fs::remove(folder / file, error);
      if (error) refuse(folder / file, fmt::format("cannot be replaced: {}", error.message()));
    }
  }
}

}  // namespace

fs::path results_folder(const fs::path& folder, const fs::path& scene, const std::string& ending) {
  return folder.empty() ? fs::path(scene.stem().string() + ending) : folder;
}

void prepare_folder(const fs::path& folder) {
  std::error_code error;
  if (fs::exists(folder, error) && !fs::is_directory(folder, error))
    refuse(folder, "is a file; expected a folder for the results");
  fs::create_directories(folder, error);
  if (error) refuse(folder, fmt::format("cannot be created: {}", error.message()));
  const bool empty = fs::is_empty(folder, error);
  if (error) refuse(folder, fmt::format("cannot be read: {}", error.message()));
  const bool earlier_run = fs::is_regular_file(folder / marker, error);
  if (!empty && !earlier_run)
    refuse(folder, "is not empty and not from an earlier run; expected a new or empty folder (-o DIR)");
  if (earlier_run) clear_results(folder);
  write(folder / marker, "", std::ios::trunc);
}

void write_file(const fs::path& folder, const std::string& name, std::string_view content) {
  write(folder / marker, name + "\n", std::ios::app);
  const fs::path part = folder / (name + unfinished);
  write(part, content, std::ios::trunc);
  std::error_code error;
  fs::rename(part, folder / name, error);
  if (error) refuse(folder / name, fmt::format("cannot be written: {}", error.message()));
}

void write_picture(const fs::path& folder, const Picture& picture) {
  const Drawings drawings = draw({picture}, false);
  for (const Drawing& drawing : drawings.drawn) write_file(folder, drawing.name + ".svg", drawing.svg);
  for (const std::string& line : drawings.missing) fmt::print(stderr, "note: {}\n", line);
}

}  // namespace bracket::apps
