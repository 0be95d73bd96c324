// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <utility>

#include "apps/commands.h"
#include "apps/folder.h"
#include "apps/report.h"
#include "apps/vtk.h"

namespace bracket::apps {
namespace {

constexpr const char* clear_line = "\r\033[K";

bounds::Outcome<2> solve(const scene::Scene<2>& scene, bool show_progress) {
  if (!show_progress) return bounds::run(scene);
  struct ClearOnReturn {
    ~ClearOnReturn() { std::fputs(clear_line, stderr); }
  } const clear;
  bounds::Observer<2> observer;
  observer.stage = [](const std::string& stage) { fmt::print(stderr, "{}{} …", clear_line, stage); };
  return bounds::run(scene, observer);
}

void write_results(const std::filesystem::path& folder, const Report& report, const std::string& json) {
  const bounds::Outcome<2>& outcome = report.outcome;
  std::vector<std::string> plots = {"solution_0.vtu"};
  write_file(folder, plots[0], solution_vtu(outcome.problem, outcome.displacement, outcome.stress, outcome.indicator));
  if (!outcome.problem.contact.empty()) {
    plots.push_back("contact_0.vtu");
    write_file(folder, plots[1], contact_vtu(outcome.problem, report.contact, outcome.indicator));
  }
  write_file(folder, "solution.pvd", collection_pvd(plots));
  write_file(folder, "history.csv", history_csv(report));
  write_file(folder, "report.json", json);
}

std::string emphasised(std::string line) {
  const bool colour = isatty(STDOUT_FILENO) && std::getenv("NO_COLOR") == nullptr;
  if (!colour) return line;
  line.insert(line.size() - 1, "\033[0m");  // before the end of the line
  return "\033[1m" + line;
}

}  // namespace

scene::Status run(const RunOptions& options) {
  const scene::Scene<2> scene = scene::read_scene<2>(options.scene, options.overrides);
  const std::filesystem::path folder =
      options.folder.empty() ? std::filesystem::path(options.scene.stem().string() + ".out") : options.folder;
  prepare_folder(folder);  // before the work, so that a folder that cannot be used is known at once

  Report report{scene, solve(scene, isatty(STDERR_FILENO) && !options.quiet), {}};
  const bounds::Outcome<2>& outcome = report.outcome;
  if (outcome.stress.cell.empty()) throw scene::Error(outcome.status, outcome.reason);  // no fields, nothing to report
  report.contact = bounds::contact_state(outcome.problem, outcome.displacement, outcome.stress);
  if (!options.quiet)
    for (const std::string& note : outcome.problem.mesh.notes) fmt::print(stderr, "note: {}\n", note);

  const std::string json = report_json(report);
  write_results(folder, report, json);
  if (options.json) {
    std::cout << json;
  } else {
    std::cout << emphasised(headline(report));
    if (!options.quiet)
      std::cout << report_text(report)
                << fmt::format("Report: {}, for ParaView: {}\n", (folder / "report.json").string(),
                               (folder / "solution.pvd").string());
  }
  return outcome.status;
}

}  // namespace bracket::apps
