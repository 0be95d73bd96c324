// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/child.h"

#include <dlfcn.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <thread>

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

/// Runs a program; what it says on standard error goes to a file.
/// \param reader the library that it runs, for messages   \return how it failed; empty: it did not
std::string failure(const std::vector<std::string>& command, const std::string& reader,
                    const std::filesystem::path& complaints, std::chrono::seconds limit) {
  posix_spawn_file_actions_t streams;
  posix_spawn_file_actions_init(&streams);
  posix_spawn_file_actions_addopen(&streams, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&streams, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&streams, STDERR_FILENO, complaints.c_str(), O_WRONLY | O_CREAT, 0600);
  posix_spawnattr_t manners;  // it dies of the signals that we may ignore
  posix_spawnattr_init(&manners);
  sigset_t ignored;
  sigemptyset(&ignored);
  sigaddset(&ignored, SIGPIPE);
  sigaddset(&ignored, SIGXFSZ);
  posix_spawnattr_setsigdefault(&manners, &ignored);
  posix_spawnattr_setflags(&manners, POSIX_SPAWN_SETSIGDEF);
  std::vector<std::string> words = command;
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  pid_t id = 0;
  const int error = posix_spawn(&id, arguments[0], &streams, &manners, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&streams);
  posix_spawnattr_destroy(&manners);
  if (error != 0) return fmt::format("{} cannot be started: {}", command[0], std::strerror(error));

  const auto end = std::chrono::steady_clock::now() + limit;
  int status = 0;
  for (pid_t ended; (ended = waitpid(id, &status, WNOHANG)) == 0 || (ended < 0 && errno == EINTR);) {
    if (std::chrono::steady_clock::now() >= end) {
      kill(id, SIGKILL);
      while (waitpid(id, &status, 0) < 0 && errno == EINTR) {
      }
      return fmt::format("{} did not end within {} s", reader, limit.count());
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  if (WIFSIGNALED(status)) return fmt::format("{} crashed: {}", reader, strsignal(WTERMSIG(status)));
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return "";
  const std::string said = read_text(complaints);
  return reader + ": " + (said.empty() ? "it does not say why" : said);
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
