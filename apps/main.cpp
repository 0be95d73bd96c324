// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <exception>
#include <iostream>
#include <new>

#include "apps/commands/blas.h"
#include "apps/commands/commands.h"
#include "apps/commands/say.h"
#include "apps/commands/version.h"
#include "apps/report/report.h"

namespace {

using bracket::apps::Ending;
using bracket::scene::Error;
using bracket::scene::Status;

constexpr const char* statuses =
    "Exit status: 0 done, target reached (or none asked); 1 internal error; 2 usage or scene file; 3 mesh;\n"
    "4 ill-posed problem; 5 budget or memory spent before the target, the bounds hold; 6 the bounds could not be\n"
    "guaranteed.";

// CLI11's messages may span lines; a diagnostic is one.
std::string one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

void add_overrides(CLI::App* command, std::vector<std::string>& overrides) {
  command->add_option("--set", overrides, "Override a key of the scene; may be repeated")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
}

void add_folder(CLI::App* command, std::filesystem::path& folder, const std::string& otherwise) {
  command->add_option("-o", folder, fmt::format("Folder for the results (default: {})", otherwise))
      ->type_name("DIR")
      ->check([](const std::string& name) { return name.empty() ? "expected the name of a folder" : ""; });
}

/// The command mesh, which fills the options.
CLI::App* add_mesh(CLI::App& app, bracket::apps::MeshOptions& options) {
  CLI::App* command = app.add_subcommand("mesh", "Write a scene's mesh, for another program");
  command->add_option("SCENE", options.scene, "The scene file (TOML)")->required();
  command->add_option("-o", options.file, "The mesh file: .msh (Gmsh), .inp (Abaqus, CalculiX) or .vtu (ParaView)")
      ->type_name("FILE")
      ->required();
  command->add_option("--refine", options.refine, "Uniform refinements (default: 0)")
      ->type_name("N")
      ->check(CLI::Range(0, 30));
  command->add_option("--degree", options.degree, "Linear or quadratic triangles (default: the scene's solve.degree)")
      ->type_name("1|2")
      ->check(CLI::Range(1, 2));
  add_overrides(command, options.overrides);
  command->add_flag("--force", options.force, "Write over a file that is there");
  return command;
}

/// The command assess, which fills the options.
CLI::App* add_assess(CLI::App& app, bracket::apps::AssessOptions& options) {
  CLI::App* command = app.add_subcommand("assess", "The error of another program's displacement, between two bounds");
  command->add_option("SCENE", options.scene, "The scene file (TOML)")->required();
  command->add_option("FIELD", options.field, "Nodal displacements: .csv (x, y, ux, uy), .vtu (VTK) or .frd (CalculiX)")
      ->required();
  add_folder(command, options.folder, "the scene's name + .assess");
  add_overrides(command, options.overrides);
  command->add_flag("--json", options.json, "Print the report as JSON alone");
  command->add_flag("--quiet", options.quiet, "Print the interval and what goes with it alone");
  return command;
}

Ending perform(int argc, char** argv) {
  CLI::App app("Energies of elastic bodies in frictionless contact between two guaranteed bounds.", "bracket");
  app.footer(statuses);
  app.require_subcommand(0, 1);  // none is refused below: CLI11 would blame a misspelt command on its absence
  app.set_version_flag("--version", bracket::apps::version_text(), "Print the versions of program and libraries");

  bracket::apps::RunOptions options;
  const auto add_scene = [&options](CLI::App* command) {
    command->add_option("SCENE", options.scene, "The scene file (TOML)")->required();
    add_overrides(command, options.overrides);
  };
  CLI::App* run = app.add_subcommand("run", "Solve a scene and report the energy between its bounds");
  add_scene(run);
  add_folder(run, options.folder, "the scene's name + .out");
  run->add_flag("--json", options.json, "Print the report as JSON alone");
  run->add_flag("--quiet", options.quiet, "Print the interval alone");
  run->add_flag("--all-levels", options.all_levels, "Quantities on all levels, not on the last and some before");
  run->add_flag("--png", options.png, "Pictures as PNG too");
  run->add_flag("!--no-report", options.pictures, "Leave report.html and the pictures out");

  CLI::App* study = app.add_subcommand("study", "Error against run time: uniform and adaptive, degree 1 and 2");
  add_scene(study);
  add_folder(study, options.folder, "the scene's name + .study");

  CLI::App* extremes = app.add_subcommand("extremes", "The interval as moduli, cells, units, loads become extreme");
  add_scene(extremes);
  add_folder(extremes, options.folder, "the scene's name + .extremes");

  CLI::App* paper = app.add_subcommand("paper", "The theorems of Haslinger & Hlavacek 1981 as tables");
  add_folder(paper, options.folder, "bracket.paper");

  CLI::App* check = app.add_subcommand("check", "Everything short of solving: data, mesh quality, solvability");
  add_scene(check);
  bool as_json = false;
  check->add_flag("--json", as_json, "Print it as JSON alone");

  bracket::apps::MeshOptions to_write;
  CLI::App* write = add_mesh(app, to_write);

  bracket::apps::AssessOptions to_assess;
  CLI::App* assess = add_assess(app, to_assess);

  std::filesystem::path mesh;
  CLI::App* info = app.add_subcommand("info", "Bodies, boundary parts and quality of a mesh file");
  info->add_option("MESH", mesh, "The mesh file (Gmsh, Abaqus, …)")->required();
  info->add_flag("--json", as_json, "Print it as JSON alone");

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != 0) throw Error(Status::input, one_line(error.what()) + " (see bracket --help)");
    app.exit(error);  // --help or --version: prints it
    return {};
  }
  if (run->parsed()) return bracket::apps::run(options);
  if (study->parsed()) return bracket::apps::study(options.scene, options.overrides, options.folder);
  if (extremes->parsed()) return bracket::apps::extremes(options.scene, options.overrides, options.folder);
  if (paper->parsed()) bracket::apps::paper(options.folder);
  if (check->parsed()) bracket::apps::check(options.scene, options.overrides, as_json);
  if (write->parsed()) bracket::apps::mesh(to_write);
  if (assess->parsed()) return bracket::apps::assess(to_assess);
  if (info->parsed()) bracket::apps::info(mesh, as_json);
  if (app.get_subcommands().empty())
    throw Error(Status::input,
                "expected a command: run, study, extremes, paper, check, mesh, assess or info (see bracket --help)");
  return {};
}

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

int main(int argc, char** argv) {
  occupy_standard_streams();
  for (const int signal : {SIGPIPE, SIGXFSZ}) std::signal(signal, SIG_IGN);  // writing fails instead
  const bool as_json = std::any_of(argv + std::min(argc, 1), argv + argc,
                                   [](const char* word) { return word == std::string("--json"); });
  try {
    bracket::apps::choose_blas_kernels();
    const Ending ending = perform(argc, argv);
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
