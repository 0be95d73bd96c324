// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>

#include "apps/commands/commands.h"
#include "apps/commands/folder.h"
#include "apps/commands/say.h"
#include "scene/process.h"

namespace bracket::apps {
namespace {

namespace fs = std::filesystem;
using scene::Error;
using scene::Status;

/// Beside this program, where it is built as well as where it is installed.
fs::path engine() {
  const fs::path path = fs::read_symlink("/proc/self/exe").parent_path() / "bracket-mpi";
  if (!fs::exists(path))
    throw Error(Status::input,
                fmt::format("--ranks needs {}, which is built where MPI, PETSc and METIS are", path.string()));
  return path;
}

/// What the processes and mpirun say on standard error.
struct Said {
  std::string reason;  ///< of the program: why it does not end as done
  std::string death;   ///< of a process: why
  std::string other;   ///< the first line of anyone else
};

/// Passes the program's notes on and sorts the rest, until nobody is left to say anything.
Said heard(int from) {
  constexpr std::string_view own = "bracket: ", note = "note: ", failure = "bracket-mpi: ",
                             noticed = "mpirun noticed that ";
  Said said;
  FILE* const stream = fdopen(from, "r");
  if (stream == nullptr) return said;
  char* buffer = nullptr;
  std::size_t size = 0;
  while (getline(&buffer, &size, stream) >= 0) {
    std::string line = buffer;
    while (!line.empty() && (line.back() == '\n' || line.back() == '\r')) line.pop_back();
    const bool is_rule = line.find_first_not_of("- ") == std::string::npos;  // mpirun frames its texts
    if (line.starts_with(own))
      said.reason = line.substr(own.size());
    else if (line.starts_with(note))
      say(line + "\n");
    else if (line.starts_with(failure))
      said.death = line.substr(failure.size());
    else if (line.starts_with(noticed) && said.death.empty())
      said.death = line.substr(noticed.size());
    else if (!is_rule && said.other.empty())
      said.other = line;
  }
  std::free(buffer);
  std::fclose(stream);
  return said;
}

volatile sig_atomic_t asked_to_end = 0;  ///< by this signal
volatile pid_t mpirun = 0;               ///< 0: not yet started

void pass_on(int signal) {
  asked_to_end = signal;
  if (mpirun > 0) kill(mpirun, SIGTERM);  // it ends its processes
}

/// From now on who asks us to end asks mpirun.
void pass_signals_on() {
  std::signal(SIGCHLD, SIG_DFL);  // who ignores it is not told how a process ended
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction action = {};
    sigaction(signal, nullptr, &action);
    if (action.sa_handler == SIG_IGN) continue;
    action.sa_handler = pass_on;
    action.sa_flags = SA_RESTART;
    sigaction(signal, &action, nullptr);
  }
}

/// When a file was written last; nothing: there is none.
std::optional<fs::file_time_type> time_of(const fs::path& file) {
  std::error_code error;
  const auto time = fs::last_write_time(file, error);
  return error ? std::nullopt : std::optional(time);
}

}  // namespace

Ending run_on_ranks(const RunOptions& options, std::vector<std::string> words) {
  for (const char* threads : {"OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS"}) setenv(threads, "1", 1);
  if (isatty(STDOUT_FILENO) == 0) setenv("NO_COLOR", "1", 1);  // the processes' own is a terminal of mpirun's
  // Not bound to a core: what the first process does by itself has threads for all of them. Who waits makes way, as
  // others may need the cores.
  std::vector<std::string> command = {"mpirun",
                                      "--allow-run-as-root",
                                      "--oversubscribe",
                                      "--bind-to",
                                      "none",
                                      "--mca",
                                      "mpi_yield_when_idle",
                                      "1",
                                      "-n",
                                      std::to_string(options.ranks),
                                      engine()};
  command.insert(command.end(), std::make_move_iterator(words.begin()), std::make_move_iterator(words.end()));
  const fs::path report = results_folder(options.folder, options.scene, ".out") / "report.json";
  const auto before = time_of(report);

  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0)
    throw Error(Status::input, fmt::format("mpirun cannot be heard: {}", std::strerror(errno)));
  const Descriptor in(open("/dev/null", O_RDONLY | O_CLOEXEC));
  pass_signals_on();
  const scene::Process process = scene::start(command, in.number(), STDOUT_FILENO, ends[1], false);
  close(ends[1]);
  if (process.error != 0) {
    close(ends[0]);
    throw Error(Status::input,
                fmt::format("mpirun cannot be started: {}; install openmpi-bin", std::strerror(process.error)));
  }
  mpirun = process.id;
  if (asked_to_end != 0) kill(mpirun, SIGTERM);  // meanwhile
  const Said said = heard(ends[0]);
  const int status = scene::status_of(process, std::chrono::steady_clock::time_point::max()).value_or(0);
  if (asked_to_end != 0) {
    std::signal(asked_to_end, SIG_DFL);
    std::raise(asked_to_end);
  }
  const int ended_with = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  if (ended_with == 0) return {};
  // With other numbers a process fell after the program had said its reason.
  const bool is_ours = ended_with > 0 && ended_with <= static_cast<int>(Status::not_guaranteed);
  if (is_ours && !said.reason.empty()) return {static_cast<Status>(ended_with), said.reason};
  const auto after = time_of(report);
  const bool level_done = after && after != before;
  const std::string& cause = said.death.empty() ? said.other : said.death;
  const std::string why = fmt::format("the processes ended early{}", cause.empty() ? "" : " (" + cause + ")");
  if (level_done) throw Error(Status::budget, fmt::format("{}; the levels before hold: {}", why, report.string()));
  throw Error(Status::not_guaranteed, why + "; no level was done");
}

}  // namespace bracket::apps
