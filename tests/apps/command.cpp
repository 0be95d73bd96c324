// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/apps/command.h"

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <regex>
#include <sstream>
#include <stdexcept>
#include <thread>

#include "apps/report/lines.h"

namespace bracket::apps::tests {

namespace fs = std::filesystem;

Ended Command::shell(const std::string& command) const {
  // Outside of the directory, which commands may fill or examine.
  const std::string out = directory.string() + ".out", err = directory.string() + ".err";
  const std::string line = "cd '" + directory.string() + "' && { bracket() { '" BRACKET_PROGRAM "' \"$@\"; }; " +
                           command + "\n} >'" + out + "' 2>'" + err + "'";
  const int status = std::system(line.c_str());
  Ended ended{WIFEXITED(status) ? WEXITSTATUS(status) : -1, read(out), read(err)};
  fs::remove(out);
  fs::remove(err);
  return ended;
}

Ended Command::signalled(const std::string& arguments, const std::string& name, int lines, int signal) const {
  const std::string out = directory.string() + ".out", err = directory.string() + ".err";
  const std::string line =
      "cd '" + directory.string() + "' && exec '" BRACKET_PROGRAM "' " + arguments + " >'" + out + "' 2>'" + err + "'";
  const pid_t id = fork();
  if (id == 0) {
    ::signal(SIGINT, SIG_DFL);  // whatever the tests themselves are run by
    execl("/bin/sh", "sh", "-c", line.c_str(), nullptr);
    _exit(127);
  }
  const auto there = [&] {
    if (!fs::exists(directory / name)) return false;
    const std::string content = read(name);
    return std::ranges::count(content, '\n') >= lines;
  };
  int status = 0;
  while (waitpid(id, &status, WNOHANG) == 0 && !there()) std::this_thread::sleep_for(std::chrono::milliseconds(2));
  kill(id, signal);
  waitpid(id, &status, 0);
  Ended ended{WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status), read(out), read(err)};
  fs::remove(out);
  fs::remove(err);
  return ended;
}

std::string Command::read(const std::string& name) const {
  std::ifstream file(directory / name, std::ios::binary);
  if (!file) throw std::runtime_error("no file " + name);
  std::ostringstream content;
  content << file.rdbuf();
  return content.str();
}

std::pair<double, double> told_of(const std::string& name, const std::string& out) {
  const std::regex line("● " + name + " +(\\S+)( … (\\S+))?");
  std::smatch found;
  if (!std::regex_search(out, found, line)) throw std::runtime_error("nothing is told of " + name + ": " + out);
  const double lower = std::stod(found[1]);
  return {lower, found[3].matched ? std::stod(found[3]) : lower};
}

std::string unbroken(const std::string& text) { return std::regex_replace(text, std::regex("\n +"), " "); }

std::size_t widest(const std::string& text) {
  std::size_t largest = 0;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) largest = std::max(largest, columns_of(line));
  return largest;
}

const char* const endlessly =
    " --set refine.strategy=adaptive --set refine.max_levels=1000 --set refine.max_cells=100000000";

const char* const two_blocks = R"(
schema = 1
title = "Two blocks"
units = "N, mm, MPa"
plane = "strain"
[[mesh.block]]
body = "lower"
x = [0, 1]
y = [0, 1]
cells = [4, 4]
[[mesh.block]]
body = "upper"
x = [0, 1]
y = [1, 2]
cells = [4, 4]
[bodies.lower]
E = 1.0
nu = 0.3
[bodies.upper]
E = 2.0
nu = 0.3
[boundary."lower.bottom"]
fixed = [0.0, 0.0]
[boundary."upper.left"]
sliding = 0.0
[boundary."upper.top"]
traction = ["0", "x < 0.5 ? -0.1 : 0.09"]
[[contact]]
first = "upper.bottom"
second = "lower.top"
gap = 0.0
[refine]
strategy = "none"
)";

const char* const bending = R"(
schema = 1
title = "Bending"
plane = "strain"
[[mesh.block]]
body = "beam"
x = [0, 2]
y = [-0.5, 0.5]
cells = [5, 3]
[bodies.beam]
E = 3.0
nu = 0.25
[boundary."beam.left"]
sliding = 0.0
[boundary."beam.right"]
traction = ["y", "0"]
[refine]
strategy = "none"
)";

}  // namespace bracket::apps::tests
