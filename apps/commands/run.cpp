// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>
#include <ctime>
#include <iostream>
#include <new>
#include <utility>

#include "apps/commands/commands.h"
#include "apps/commands/dimension.h"
#include "apps/commands/folder.h"
#include "apps/commands/say.h"
#include "apps/commands/watch.h"
#include "apps/plots/pictures.h"
#include "apps/report/lines.h"
#include "apps/report/sha256.h"
#include "apps/report/sheet.h"
#include "apps/report/vtk.h"
#include "contact/clock.h"
#include "scene/text.h"

namespace bracket::apps {
namespace {

/// Keeps the folder of results up to date while a run is going on: it tells of `around.size()` levels.
template <int dim> struct Results {
  const scene::Scene<dim>& scene;
  const RunOptions& options;
  std::filesystem::path folder;
  Clock clock;      // of the command
  double read = 0;  // seconds
  Given given = {};
  std::vector<LevelSeconds> around = {};
  std::vector<std::string> missing = {};  ///< what could not be written of levels after the first, and why
};

template <int dim> ReportOf<dim> report_of(const Results<dim>& results, const bounds::Outcome<dim>& outcome) {
  ReportOf<dim> report = apps::report(results.scene, outcome);
  report.read = results.read;
  report.around = results.around;
  report.missing = results.missing;
  return report;
}

// The fields of the last level, and the collection of all that are written.
template <int dim> void write_fields(const Results<dim>& results, const ReportOf<dim>& report) {
  const std::filesystem::path& folder = results.folder;
  const bounds::Outcome<dim>& outcome = report.outcome;
  const int level = static_cast<int>(outcome.levels.size()) - 1;
  const bool contact = !outcome.problem.contact.empty();
  write_file(folder, fmt::format("solution_{}.vtu", level), solution_vtu(report));
  if (contact) write_file(folder, fmt::format("contact_{}.vtu", level), contact_vtu(report));
  write_file(folder, "solution.pvd", collection_pvd(results.options.last_level ? level : 0, level + 1, contact));
  write_file(folder, "view.py", paraview_view(report));
}

/// The report of a run whose last level has just been done.
template <int dim> ReportOf<dim> report_so_far(Results<dim>& results, const bounds::Outcome<dim>& outcome) {
  results.around.push_back({.elapsed = results.clock.seconds(), .write = 0});
  ReportOf<dim> so_far = report_of(results, outcome);
  so_far.running = true;
  return so_far;
}

template <int dim> void write_level(Results<dim>& results, ReportOf<dim>& so_far) {
  const Clock clock;
  if (!results.options.last_level) write_fields(results, so_far);
  write_file(results.folder, "history.csv", history_csv(so_far));
  write_file(results.folder, "contact.csv", findings_csv(so_far));
  if (!so_far.outcome.quantities.empty()) write_file(results.folder, "quantities.csv", quantities_csv(so_far));
  so_far.around.back().write = results.around.back().write = clock.seconds();
  write_file(results.folder, "report.json", report_json(so_far));
}

/// A disk that cannot take the first level is the user's to mend. Later the interval counts more than the files.
template <int dim> void write_level_if_it_fits(Results<dim>& results, ReportOf<dim>& so_far) {
  try {
    write_level(results, so_far);
  } catch (const scene::Error& error) {
    if (so_far.outcome.levels.size() == 1) throw;
    results.missing.emplace_back(error.what());
  }
}

/// Prints a line of each level as it is done.
template <int dim> bounds::Outcome<dim> solve(Results<dim>& results) {
  const RunOptions& options = results.options;
  Watch watch(!options.quiet);
  primal::Engine<dim> engine;
  if constexpr (dim == 3)
    if (options.engine != nullptr) engine = *options.engine;
  const auto observer = watch.observer<dim>("", [&](const bounds::Outcome<dim>& outcome) {
    watch.show("writing");
    ReportOf<dim> so_far = report_so_far(results, outcome);
    write_level_if_it_fits(results, so_far);
    watch.clear();
    if (options.quiet || options.json) return;
    if (outcome.levels.size() == 1) std::cout << scene_text(results.scene) << "\n" << level_names(results.scene);
    std::cout << level_line(so_far) << std::flush;
  });
  return bounds::run(results.scene, observer, engine);
}

std::string now() { return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr))); }

/// A file that has been read; its digest only if it can be read again.
FileRead file_read(const std::filesystem::path& file) {
  std::error_code error;
  const bool is_file = std::filesystem::is_regular_file(file, error);
  return {file.string(), is_file ? sha256(scene::read_text(file)) : ""};
}

/// \pre the scene has just been read
template <int dim> Given given(const RunOptions& options, const scene::Scene<dim>& scene) {
  Given result{.files = {file_read(options.scene)}, .overrides = options.overrides, .ended = ""};
  if (!scene.mesh_file.empty()) result.files.push_back(file_read(scene.mesh_file));
  return result;
}

/// Draws the pictures and writes them, report.html and the sheet; tells the report what is missing.
template <int dim> void write_pictures(Results<dim>& results, ReportOf<dim>& report, bool png) {
  const Clock clock;
  Drawings drawings;
  if (report.outcome.guarantee != "none") drawings = drawn(report, png);
  for (const Drawing& drawing : drawings.drawn) {
    write_file(results.folder, drawing.name + ".svg", drawing.svg);
    if (!drawing.png.empty()) write_file(results.folder, drawing.name + ".png", drawing.png);
  }
  report.missing.insert(report.missing.end(), drawings.missing.begin(), drawings.missing.end());
  report.pictures = clock.seconds();
  write_file(results.folder, "report.html", report_html(report, drawings.drawn));
  results.given.ended = now();
  write_file(results.folder, "sheet.html", sheet_html(report, results.given));
  write_file(results.folder, "sheet.json", sheet_json(report, results.given));
}

/// Writes what the run has found, over what says that it is going on.
/// \return what could not be written, and why
template <int dim> std::vector<std::string> write_end(const Results<dim>& results, const ReportOf<dim>& report) {
  std::vector<std::string> missing;
  std::vector<std::pair<const char*, std::string>> files = {{"history.csv", history_csv(report)},
                                                            {"contact.csv", findings_csv(report)},
                                                            {"report.json", report_json(report)}};
  if (!report.outcome.quantities.empty()) files.emplace_back("quantities.csv", quantities_csv(report));
  for (const auto& [name, content] : files) {
    try {
      write_file(results.folder, name, content);
    } catch (const scene::Error& error) {
      missing.emplace_back(error.what());
    }
  }
  return missing;
}

/// As write_end(); where the disk is full the files that say that the run is going on make room, and do not stay.
template <int dim> void write_first_end(const Results<dim>& results, const ReportOf<dim>& report) {
  if (write_end(results, report).empty()) return;
  std::error_code error;
  for (const char* name : {"report.json", "history.csv"}) std::filesystem::remove(results.folder / name, error);
  write_end(results, report);
}

/// The fields of a run that has written none; where they cannot be, the report tells why.
template <int dim> void try_last_fields(const Results<dim>& results, ReportOf<dim>& report) {
  try {
    write_fields(results, report);
  } catch (const scene::Error& error) {
    report.missing.emplace_back(error.what());
  }
}

/// Pictures, report.html and the sheet; where they cannot be, the report tells why.
template <int dim> void try_pictures(Results<dim>& results, ReportOf<dim>& report, bool png) {
  try {
    write_pictures(results, report, png);
  } catch (const scene::Error& error) {
    report.missing.emplace_back(error.what());
  } catch (const std::bad_alloc&) {
    report.missing.emplace_back("pictures: the memory did not suffice");
  }
}

void print_notes(const std::vector<std::string>& lines) {
  for (const std::string& line : lines) say_note(line);
}

std::string emphasised(std::string line) {
  const bool colour = isatty(STDOUT_FILENO) && std::getenv("NO_COLOR") == nullptr;
  if (!colour) return line;
  line.insert(line.size() - 1, "\033[0m");  // before the end of the line
  return "\033[1m" + line;
}

std::string where(const std::filesystem::path& folder) {
  const bool with_pictures = std::filesystem::exists(folder / "report.html");
  return within_columns(fmt::format("Report: {}{}, for ParaView: {}\n",
                                    with_pictures ? (folder / "report.html").string() + ", " : "",
                                    (folder / "report.json").string(), (folder / "solution.pvd").string()));
}

template <int dim> Ending run_in(const RunOptions& options, const Clock& clock) {
  scene::Scene<dim> scene = scene::read_scene<dim>(options.scene, options.overrides);
  scene.refine.all_levels = options.all_levels;
  Results<dim> results{.scene = scene,
                       .options = options,
                       .folder = results_folder(options.folder, options.scene, ".out"),
                       .clock = clock,
                       .read = clock.seconds(),
                       .given = given(options, scene)};
  // Before the work, so that a folder that cannot be used is known at once.
  const Descriptor in_use = prepare_folder(results.folder);

  const bounds::Outcome<dim> outcome = solve(results);
  const bool has_rows = !results.around.empty();
  if (outcome.stress.cell.empty()) throw scene::Error(outcome.status, outcome.reason);  // no fields, nothing to report
  if (results.around.size() < outcome.levels.size()) {  // of a level that failed its checks
    ReportOf<dim> failed = report_so_far(results, outcome);
    write_level_if_it_fits(results, failed);
  }
  ReportOf<dim> report = report_of(results, outcome);
  write_first_end(results, report);  // before the pictures, which may fill the disk
  if (options.last_level) try_last_fields(results, report);
  if (options.pictures) try_pictures(results, report, options.png);
  const std::vector<std::string> unwritten = write_end(results, report);

  if (!options.quiet) {
    print_notes(outcome.problem.mesh.notes);
    print_notes(report.missing);
    print_notes(unwritten);
  }
  if (options.json) {
    std::cout << report_json(report);
  } else {
    if (!options.quiet) std::cout << (has_rows ? "" : scene_text(scene)) << "\n";
    std::cout << emphasised(headline(report));
    if (!options.quiet) std::cout << report_text(report) << where(results.folder);
  }
  return {outcome.status, outcome.reason};
}

}  // namespace

Ending run(const RunOptions& options) {
  const Clock clock;
  if (options.engine != nullptr && !is_in_space(options.scene, options.overrides))
    throw scene::Error(scene::Status::input, options.scene.string(),
                       "several processes solve scenes in space only (dim = 3): run it without --ranks");
  return is_in_space(options.scene, options.overrides) ? run_in<3>(options, clock) : run_in<2>(options, clock);
}

}  // namespace bracket::apps
