// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/child.h"

#include <dlfcn.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>

#include "scene/process.h"
#include "scene/text.h"

namespace bracket::scene {

namespace {

/// In the folder "bracket" beside this library, where it is built as well as where it is installed.
std::filesystem::path path_of(const std::string& program) {
  Dl_info library;
  static const int here = 0;
  if (dladdr(&here, &library) == 0 || library.dli_fname == nullptr) return program;
  return std::filesystem::path(library.dli_fname).parent_path() / "bracket" / program;
}

/// A descriptor, closed with the object.
struct Opened {
  int number;
  Opened(const char* path, int mode) : number(open(path, mode | O_CLOEXEC, 0600)) {}
  Opened(const Opened&) = delete;
  Opened& operator=(const Opened&) = delete;
  ~Opened() {
    if (number >= 0) close(number);
  }
};

/// Runs a program; what it says on standard error goes to a file.
/// \param reader the library that it runs, for messages   \return how it failed; empty: it did not
std::string failure(const std::vector<std::string>& command, const std::string& reader,
                    const std::filesystem::path& complaints, std::chrono::seconds limit) {
  const Opened in("/dev/null", O_RDONLY), out("/dev/null", O_WRONLY), said(complaints.c_str(), O_WRONLY | O_CREAT);
  const bool opened = in.number >= 0 && out.number >= 0 && said.number >= 0;
  const int fault = errno;
  const Process process = opened ? start(command, in.number, out.number, said.number, false) : Process{.error = fault};
  if (process.error != 0) return fmt::format("{} cannot be started: {}", command[0], std::strerror(process.error));
  const std::optional<int> status = status_of(process, std::chrono::steady_clock::now() + limit);
  if (!status) return fmt::format("{} did not end within {} s", reader, limit.count());
  if (WIFSIGNALED(*status)) return fmt::format("{} crashed: {}", reader, strsignal(WTERMSIG(*status)));
  if (WIFEXITED(*status) && WEXITSTATUS(*status) == 0) return "";
  const std::string reason = read_text(complaints);
  return reader + ": " + (reason.empty() ? "it does not say why" : reason);
}

}  // namespace

TemporaryFolder::TemporaryFolder(const std::string& where) {
  std::string name = (std::filesystem::temp_directory_path() / "bracket-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr)
    fail(Status::input, where, fmt::format("no folder for its conversion can be made: {}", std::strerror(errno)));
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code error;
  std::filesystem::remove_all(path_, error);
}

std::filesystem::path converted(const std::filesystem::path& file, const TemporaryFolder& folder,
                                const Converter& converter, std::chrono::seconds limit) {
  if (std::filesystem::is_directory(file) || access(file.c_str(), R_OK) != 0) read_text(file);  // says what is wrong
  const std::filesystem::path result = folder.path() / converter.result;
  std::string ending = file.extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return std::tolower(c); });
  const std::filesystem::path source = folder.path() / ("from" + ending);  // libraries look at endings
  std::filesystem::create_symlink(std::filesystem::absolute(file), source);
  const std::string fault =
      failure({path_of(converter.program), source, result}, converter.reader, folder.path() / "said", limit);
  if (!fault.empty()) fail(converter.status, file.string(), "cannot be read; " + fault);
  return result;
}

}  // namespace bracket::scene
