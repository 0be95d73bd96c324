// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/process.h"

#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <thread>

namespace bracket::scene {

Process start(std::vector<std::string> command, int in, int out, int complaints, bool group) {
  posix_spawn_file_actions_t streams;
  posix_spawn_file_actions_init(&streams);
  posix_spawn_file_actions_adddup2(&streams, in, STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&streams, out, STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&streams, complaints, STDERR_FILENO);
  posix_spawnattr_t manners;
  posix_spawnattr_init(&manners);
  sigset_t ignored;
  sigemptyset(&ignored);
  sigaddset(&ignored, SIGPIPE);
  sigaddset(&ignored, SIGXFSZ);
  posix_spawnattr_setsigdefault(&manners, &ignored);
  posix_spawnattr_setpgroup(&manners, 0);
  posix_spawnattr_setflags(&manners, static_cast<short>(POSIX_SPAWN_SETSIGDEF | (group ? POSIX_SPAWN_SETPGROUP : 0)));
  std::vector<char*> arguments;
  for (std::string& word : command) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  Process process{.group = group};
  process.error = posix_spawnp(&process.id, arguments[0], &streams, &manners, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&streams);
  posix_spawnattr_destroy(&manners);
  return process;
}

std::optional<int> status_of(const Process& process, std::chrono::steady_clock::time_point end) {
  int status = 0;
  for (pid_t ended; (ended = waitpid(process.id, &status, WNOHANG)) == 0 || (ended < 0 && errno == EINTR);) {
    if (std::chrono::steady_clock::now() >= end) {
      kill(process.group ? -process.id : process.id, SIGKILL);
      while (waitpid(process.id, &status, 0) < 0 && errno == EINTR) {
      }
      return {};
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return status;
}

}  // namespace bracket::scene
