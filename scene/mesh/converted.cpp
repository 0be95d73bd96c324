// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
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
#include <chrono>
#include <cstring>
#include <thread>

#include "scene/mesh/readers.h"
#include "scene/text.h"

namespace bracket::scene {

namespace {

/// A folder for what the converter writes; it goes with the object.
class Folder {
 public:
  explicit Folder(const std::string& where) {
    std::string name = (std::filesystem::temp_directory_path() / "bracket-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr)
      fail(Status::input, where, fmt::format("no folder for its conversion can be made: {}", std::strerror(errno)));
    path_ = name;
  }
  ~Folder() {
    std::error_code error;
    std::filesystem::remove_all(path_, error);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::filesystem::path operator/(const char* name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

/// In the folder "bracket" beside this library, where it is built as well as where it is installed.
std::filesystem::path converter() {
  Dl_info library;
  static const int here = 0;
  if (dladdr(&here, &library) == 0 || library.dli_fname == nullptr) return "bracket-mesh-converter";
  return std::filesystem::path(library.dli_fname).parent_path() / "bracket" / "bracket-mesh-converter";
}

/// Runs a program; what it says on standard error goes to a file.
/// \return how it failed; empty: it did not
std::string failure(const std::vector<std::string>& command, const std::filesystem::path& complaints,
                    std::chrono::seconds limit) {
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
      return fmt::format("libgmsh did not end within {} s", limit.count());
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  if (WIFSIGNALED(status)) return fmt::format("libgmsh crashed: {}", strsignal(WTERMSIG(status)));
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return "";
  const std::string said = read_text(complaints);
  return "libgmsh: " + (said.empty() ? "it does not say why" : said);
}

}  // namespace

RawMesh read_by_libgmsh(const std::filesystem::path& file, std::chrono::seconds limit) {
  const std::string where = file.string();
  if (std::filesystem::is_directory(file) || access(file.c_str(), R_OK) != 0) read_text(file);  // says what is wrong
  const Folder folder(where);
  const std::filesystem::path result = folder / "mesh.msh";
  std::string ending = file.extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return std::tolower(c); });
  const std::filesystem::path source = folder / ("from" + ending).c_str();  // libgmsh looks at endings
  std::filesystem::create_symlink(std::filesystem::absolute(file), source);
  const std::string fault = failure({converter(), source, result}, folder / "said", limit);
  if (!fault.empty()) fail(Status::mesh, where, "cannot be read; " + fault);
  try {
    return read_gmsh(result);
  } catch (const Error& error) {  // the place is one of the conversion
    const std::string line = error.what();
    const std::size_t message = line.find(": ");
    fail(Status::mesh, where, "as libgmsh reads it, " + line.substr(message == std::string::npos ? 0 : message + 2));
  }
}

}  // namespace bracket::scene
