// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/program.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <exception>
#include <iostream>
#include <new>

#include "apps/command_line.h"
#include "apps/commands/blas.h"
#include "apps/commands/say.h"
#include "apps/report/report.h"

namespace {

using bracket::apps::Ending;
using bracket::scene::Error;
using bracket::scene::Status;

int fail(Status status, const std::string& line) {
  bracket::apps::say("bracket: " + line + "\n");
  return static_cast<int>(status);
}

/// As fail(), of a command that has printed nothing. \param as_json whoever asked for JSON gets it
int fail_without_report(Status status, const std::string& line, bool as_json) {
  if (as_json) std::cout << bracket::apps::error_json(status, line) << std::flush;
  return fail(status, line);
}

/// A standard stream that is closed must not become the first file that is opened.
void occupy_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (fcntl(stream, F_GETFD) < 0) open("/dev/null", stream == STDERR_FILENO ? O_WRONLY : O_RDONLY);
}

}  // namespace

int bracket::apps::program(int argc, char** argv, const primal::Engine<3>* engine) {
  occupy_standard_streams();
  for (const int signal : {SIGPIPE, SIGXFSZ}) std::signal(signal, SIG_IGN);  // writing fails instead
  const bool as_json = std::any_of(argv + std::min(argc, 1), argv + argc,
                                   [](const char* word) { return word == std::string("--json"); });
  try {
    bracket::apps::choose_blas_kernels();
    const Ending ending = bracket::apps::perform({argv + std::min(argc, 1), argv + argc}, engine);
    std::cout.flush();
    if (!std::cout || std::fflush(stdout) != 0) return fail(Status::input, "cannot write to standard output");
    return ending.status == Status::done ? 0 : fail(ending.status, ending.reason);
  } catch (const Error& error) {
    return fail_without_report(error.status(), error.what(), as_json);
  } catch (const std::bad_alloc&) {
    return fail_without_report(Status::not_guaranteed, "the memory did not suffice; try fewer cells", as_json);
  } catch (const std::exception& error) {
    return fail_without_report(Status::internal, fmt::format("internal error: {}", error.what()), as_json);
  }
}
