// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "apps/commands/say.h"
#include "apps/program.h"
#include "primal/ranks/ranks.h"

/// bracket run by the processes of MPI: the first does all of it but for the displacements, which are all processes'.
int main(int argc, char** argv) {
  using namespace bracket;
  const primal::Processes processes(&argc, &argv);
  if (!processes.is_root()) {
    primal::serve(processes);
    return 0;
  }
  const bool quiet = std::any_of(argv, argv + argc, [](const char* word) { return word == std::string("--quiet"); });
  const primal::Ranks ranks(processes);
  std::string told;
  const primal::Engine<3> engine = [&](const auto& problem, int degree, const auto& closed) {
    if (problem.mesh.cells.size() < static_cast<std::size_t>(processes.count()))
      throw scene::Error(scene::Status::input,
                         fmt::format("{} processes are too many for the {} cells of the first mesh", processes.count(),
                                     problem.mesh.cells.size()));
    const std::string way = ranks.way(problem, degree);
    if (way != told && !quiet)
      apps::say_note(fmt::format("displacements by {}; processes: {}", way, processes.count()));
    told = way;
    return ranks.solve(problem, degree, closed);
  };
  return apps::program(argc, argv, &engine);
}
