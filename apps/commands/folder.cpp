// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/commands/folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <fstream>
#include <system_error>
#include <vector>

#include "apps/commands/say.h"
#include "scene/scene.h"

namespace bracket::apps {
namespace {

namespace fs = std::filesystem;

constexpr const char* marker = ".bracket";
constexpr const char* unfinished = ".part";  // ends the name of a file that is being written

[[noreturn]] void refuse(const fs::path& path, const std::string& reason) {
  throw scene::Error(scene::Status::input, fmt::format("{}: {}", path.string(), reason));
}

[[noreturn]] void refuse(const fs::path& path, const char* what, int error) {
  refuse(path, fmt::format("{}: {}", what, std::generic_category().message(error)));
}

// Results are never written through a link that someone has put there.
Descriptor open(const fs::path& path, int mode) {
  const int number = ::open(path.c_str(), mode | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC, 0666);
  if (number < 0) refuse(path, "cannot be written", errno);
  return Descriptor(number);
}

void write(const fs::path& path, const Descriptor& file, std::string_view content) {
  while (!content.empty()) {
    const ssize_t written = ::write(file.number(), content.data(), content.size());
    if (written < 0 && errno != EINTR) refuse(path, "cannot be written", errno);
    if (written > 0) content.remove_prefix(static_cast<std::size_t>(written));
  }
}

std::vector<std::string> listed(const fs::path& folder) {
  std::ifstream list(folder / marker);
  std::vector<std::string> names;
  for (std::string name; std::getline(list, name);) names.push_back(name);
  return names;
}

bool may_be_result(const fs::path& name) {
  const fs::path whole = name.extension() == unfinished ? name.stem() : name;
  constexpr std::array endings = {".json", ".csv", ".vtu", ".pvd", ".svg", ".png", ".html"};
  return std::ranges::find(endings, whole.extension()) != endings.end();
}

// What a run would replace must not lead elsewhere.
void refuse_links(const fs::path& folder) {
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
    if (entry.is_symlink(error) && (entry.path().filename() == marker || may_be_result(entry.path().filename())))
      refuse(entry.path(), "is a symbolic link; expected a file of an earlier run or none (remove it, or take -o DIR)");
}

// Some file systems have no locks: there nothing keeps two runs apart.
Descriptor lock(const fs::path& folder) {
  Descriptor file = open(folder / marker, O_RDWR | O_CREAT);
  if (flock(file.number(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
    refuse(folder, "is in use by another run; wait for its end, or take another folder (-o DIR)");
  return file;
}

// Only plain names are taken from the list: nothing outside of the folder is touched, whatever it says.
void clear_results(const fs::path& folder) {
  std::error_code error;
  for (const std::string& name : listed(folder)) {
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

Descriptor::~Descriptor() {
  if (number_ >= 0) close(number_);
}

Descriptor prepare_folder(const fs::path& folder) {
  std::error_code error;
  if (fs::exists(folder, error) && !fs::is_directory(folder, error))
    refuse(folder, "is a file; expected a folder for the results");
  fs::create_directories(folder, error);
  if (error) refuse(folder, fmt::format("cannot be created: {}", error.message()));
  const bool empty = fs::is_empty(folder, error);
  if (error) refuse(folder, fmt::format("cannot be read: {}", error.message()));
  refuse_links(folder);
  const bool earlier_run = fs::is_regular_file(folder / marker, error);
  if (!empty && !earlier_run)
    refuse(folder, "is not empty and not from an earlier run; expected a new or empty folder (-o DIR)");
  Descriptor marked = lock(folder);
  clear_results(folder);
  if (ftruncate(marked.number(), 0) != 0) refuse(folder / marker, "cannot be written", errno);
  return marked;
}

void write_file(const fs::path& folder, const std::string& name, std::string_view content) {
  const fs::path list = folder / marker, part = folder / (name + unfinished);
  const std::vector<std::string> names = listed(folder);
  if (std::ranges::find(names, name) == names.end()) write(list, open(list, O_WRONLY | O_APPEND), name + "\n");
  std::error_code error;
  fs::remove(part, error);
  try {
    write(part, open(part, O_WRONLY | O_CREAT | O_EXCL), content);
  } catch (const scene::Error&) {
    fs::remove(part, error);
    throw;
  }
  fs::rename(part, folder / name, error);
  if (error) refuse(folder / name, fmt::format("cannot be written: {}", error.message()));
}

void write_new_file(const fs::path& file, std::string_view content, bool replace) {
  std::error_code error;
  const bool there = fs::exists(fs::symlink_status(file, error));
  if (there && !replace) refuse(file, "is there already; --force writes over it");
  if (there && !fs::is_regular_file(fs::symlink_status(file, error)))
    refuse(file, "is no file that could be written over; take another name");
  const fs::path part = file.string() + unfinished;
  Descriptor descriptor = open(part, O_WRONLY | O_CREAT | O_EXCL);
  try {
    write(part, descriptor, content);
    // Linked rather than renamed where nothing may be written over: what was put there meanwhile stays.
    if (replace)
      fs::rename(part, file);
    else
      fs::create_hard_link(part, file);
  } catch (const fs::filesystem_error& failure) {
    fs::remove(part, error);
    refuse(file, fmt::format("cannot be written: {}", failure.code().message()));
  } catch (const scene::Error&) {
    fs::remove(part, error);
    throw;
  }
  fs::remove(part, error);
}

void write_picture(const fs::path& folder, const Picture& picture) {
  const Drawings drawings = draw({picture}, false);
  for (const Drawing& drawing : drawings.drawn) write_file(folder, drawing.name + ".svg", drawing.svg);
  for (const std::string& line : drawings.missing) say_note(line);
}

}  // namespace bracket::apps
