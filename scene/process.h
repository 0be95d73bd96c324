// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <chrono>
#include <optional>
#include <string>
#include <vector>

/// Other programs, which may take only so long.
namespace bracket::scene {

struct Process {
  pid_t id = 0;
  int error = 0;       ///< of starting it, as errno; 0: it was started
  bool group = false;  ///< whether it leads a process group of its own
};

/// Starts a program with these descriptors as its standard streams. It dies of the signals that we may ignore.
/// \param command the program, looked for in PATH where it is named without a folder, and its arguments
/// \param group whether it gets a process group of its own, so that what it starts ends with it
Process start(std::vector<std::string> command, int in, int out, int complaints, bool group);

/// Waits for a process that was started, and kills it, with its group, when the time is up.
/// \return its status as waitpid() has it; nothing: it was killed
std::optional<int> status_of(const Process& process, std::chrono::steady_clock::time_point end);

}  // namespace bracket::scene
