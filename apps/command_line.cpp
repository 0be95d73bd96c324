// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/command_line.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>

#include "apps/commands/version.h"
#include "scene/text.h"

namespace bracket::apps {
namespace {

using scene::Error;
using scene::Status;

constexpr const char* statuses =
    "Exit status: 0 done, target reached (or none asked); 1 internal error; 2 usage\n"
    "or scene file; 3 mesh; 4 ill-posed problem; 5 budget or memory spent before the\n"
    "target, the bounds hold; 6 the bounds could not be guaranteed.";
constexpr const char* introduction =
    "Elastic bodies in contact: forces, displacements, stresses and the\n"
    "energy, each between two guaranteed bounds. bracket SCENE is bracket run SCENE.";

/// All that can be asked for.
struct Options {
  RunOptions run;  // of other commands, too, what they share with it
  MeshOptions mesh;
  AssessOptions assess;
  std::filesystem::path mesh_file, init_folder;
  std::string topic;
  bool as_json = false, no_report = false;
};

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

void add_scene(CLI::App* command, std::filesystem::path& scene, std::vector<std::string>& overrides) {
  command->add_option("SCENE", scene, "The scene file (TOML)")->type_name("")->required();
  add_overrides(command, overrides);
}

void add_folder(CLI::App* command, std::filesystem::path& folder, const std::string& otherwise) {
  command->add_option("-o", folder, fmt::format("Results (default: {})", otherwise))
      ->type_name("DIR")
      ->check([](const std::string& name) { return name.empty() ? "expected the name of a folder" : ""; });
}

void add_run(CLI::App& app, Options& options) {
  CLI::App* command = app.add_subcommand("run", "Solve a scene: what is asked for, between bounds");
  add_scene(command, options.run.scene, options.run.overrides);
  add_folder(command, options.run.folder, "the scene's name + .out");
  command->add_flag("--json", options.run.json, "Print the report as JSON alone");
  command->add_flag("--quiet", options.run.quiet, "Print the answer alone");
  command->add_flag("--all-levels", options.run.all_levels, "Quantities on all levels, not on some");
  command->add_flag("--last-level", options.run.last_level, "Write the fields of the last level only");
  command->add_flag("--png", options.run.png, "Pictures as PNG too");
  command->add_flag("--no-report", options.no_report, "Leave report, sheet and pictures out");
  command->add_option("--ranks", options.run.ranks, "Displacements by N processes (MPI), in space")
      ->type_name("N")
      ->check(CLI::Range(1, 100000));
}

void add_studies(CLI::App& app, Options& options) {
  CLI::App* study = app.add_subcommand("study", "Error against time: uniform, adaptive, degrees 1 to 4");
  add_scene(study, options.run.scene, options.run.overrides);
  add_folder(study, options.run.folder, "the scene's name + .study");
  CLI::App* extremes = app.add_subcommand("extremes", "The interval as moduli, cells, loads become extreme");
  add_scene(extremes, options.run.scene, options.run.overrides);
  add_folder(extremes, options.run.folder, "the scene's name + .extremes");
  CLI::App* paper = app.add_subcommand("paper", "The theorems of the paper of 1981 as tables");
  add_folder(paper, options.run.folder, "bracket.paper");
}

void add_mesh(CLI::App& app, MeshOptions& options) {
  CLI::App* command = app.add_subcommand("mesh", "Write a scene's mesh, for another program");
  add_scene(command, options.scene, options.overrides);
  command->add_option("-o", options.file, "The mesh file: .msh (Gmsh), .inp (Abaqus) or .vtu")
      ->type_name("FILE")
      ->required();
  command->add_option("--refine", options.refine, "Uniform refinements (default: 0)")
      ->type_name("N")
      ->check(CLI::Range(0, 30));
  command->add_option("--degree", options.degree, "Of the cells (default: the scene's)")
      ->type_name("1|2")
      ->check(CLI::Range(1, 2));
  command->add_flag("--force", options.force, "Write over a file that is there");
}

void add_assess(CLI::App& app, AssessOptions& options) {
  CLI::App* command = app.add_subcommand("assess", "How wrong another program's displacement is");
  command->add_option("SCENE", options.scene, "The scene file (TOML)")->type_name("")->required();
  command->add_option("FIELD", options.field, "Displacements: .csv, .vtu or .frd (CalculiX)")
      ->type_name("")
      ->required();
  add_folder(command, options.folder, "the scene's name + .assess");
  add_overrides(command, options.overrides);
  command->add_flag("--json", options.json, "Print the report as JSON alone");
  command->add_flag("--quiet", options.quiet, "Print the answer alone");
}

void add_the_rest(CLI::App& app, Options& options) {
  CLI::App* check = app.add_subcommand("check", "Everything short of solving: data, solvability");
  add_scene(check, options.run.scene, options.run.overrides);
  check->add_flag("--json", options.as_json, "Print it as JSON alone");
  CLI::App* info = app.add_subcommand("info", "Bodies, boundary parts and quality of a mesh file");
  info->add_option("MESH", options.mesh_file, "The mesh file (Gmsh, Abaqus, …)")->type_name("")->required();
  info->add_flag("--json", options.as_json, "Print it as JSON alone");
  CLI::App* init = app.add_subcommand("init", "Write a commented scene to start from: scene.toml");
  init->add_option("DIR", options.init_folder, "Its folder (default: the current one)")->type_name("");
  CLI::App* help = app.add_subcommand("help", "Help: of a command, or of the keys of a scene");
  help->add_option("TOPIC", options.topic, "scene, or a command")->type_name("");
}

/// The commands by name.
std::vector<std::string> names_of(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(command->get_name());
  return names;
}

/// The place of the first word that is neither an option of `command` nor the value of one; words.size(): there is
/// none.
std::size_t first_argument(const CLI::App& command, const std::vector<std::string>& words) {
  std::size_t i = 0;
  for (; i < words.size() && words[i].starts_with("-"); ++i) {
    const CLI::Option* option = command.get_option_no_throw(words[i]);
    if (option != nullptr && option->get_expected_min() > 0) ++i;  // its value is the next word
  }
  return std::min(i, words.size());
}

/// The command line with "run" in front where its first word, but for options of run, is no command: a scene to run.
/// \throw Error (input) if it cannot be one
std::vector<std::string> with_command(std::vector<std::string> words, const CLI::App& app) {
  const std::vector<std::string> known = names_of(app);
  if (words.empty())
    throw Error(Status::input,
                fmt::format("expected a command or a scene: {} (see bracket --help)", fmt::join(known, ", ")));
  const std::size_t place = first_argument(*app.get_subcommand("run"), words);
  if (place == words.size()) return words;
  const std::string first = words[place];
  if (std::ranges::find(known, first) != known.end()) return words;
  std::error_code error;
  const bool is_scene =
      std::filesystem::path(first).extension() == ".toml" || std::filesystem::is_regular_file(first, error);
  if (!is_scene)
    throw Error(Status::input, fmt::format("unknown command '{}', and no such scene file: {}", one_line(first),
                                           scene::suggestion(first, known)));
  words.insert(words.begin(), "run");
  return words;
}

/// The words of a run without --ranks and its value.
std::vector<std::string> without_ranks(const std::vector<std::string>& words) {
  std::vector<std::string> result;
  for (std::size_t i = 0; i < words.size(); ++i)
    if (words[i] == "--ranks")
      ++i;
    else if (!words[i].starts_with("--ranks="))
      result.push_back(words[i]);
  return result;
}

void print_help(const CLI::App& app, const std::string& topic) {
  if (topic == "scene") {
    std::cout << scene_keys_text();
    return;
  }
  std::vector<std::string> known = names_of(app);
  if (!topic.empty() && std::ranges::find(known, topic) == known.end()) {
    known.emplace_back("scene");
    throw Error(Status::input, fmt::format("no help of '{}': {}", one_line(topic), scene::suggestion(topic, known)));
  }
  std::cout << (topic.empty() ? app.help() : app.get_subcommand(topic)->help(app.get_name()));
}

}  // namespace

Ending perform(std::vector<std::string> words, const primal::Engine<3>* engine) {
  CLI::App app(introduction, "bracket");
  app.footer(statuses);
  app.get_formatter()->column_width(24);
  app.require_subcommand(0, 1);
  app.set_version_flag("--version", version_text(), "Print the versions of program and libraries");
  Options options;
  add_run(app, options);
  add_studies(app, options);
  add_mesh(app, options.mesh);
  add_assess(app, options.assess);
  add_the_rest(app, options);

  words = with_command(std::move(words), app);
  const std::vector<std::string> given = words;
  std::reverse(words.begin(), words.end());  // as CLI11 wants them
  try {
    app.parse(std::move(words));
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != 0) throw Error(Status::input, one_line(error.what()) + " (see bracket --help)");
    app.exit(error);  // --help or --version: prints it
    return {};
  }
  RunOptions& run = options.run;
  run.pictures = !options.no_report;
  const auto asked = [&app](const char* command) { return app.get_subcommand(command)->parsed(); };
  run.engine = engine;
  if (engine != nullptr && (!asked("run") || run.ranks > 0))
    throw Error(Status::input, "bracket-mpi is for bracket run alone, without --ranks");
  if (asked("run")) return run.ranks > 0 ? run_on_ranks(run, without_ranks(given)) : apps::run(run);
  if (asked("study")) return study(run.scene, run.overrides, run.folder);
  if (asked("extremes")) return extremes(run.scene, run.overrides, run.folder);
  if (asked("assess")) return assess(options.assess);
  if (asked("paper")) paper(run.folder);
  if (asked("mesh")) mesh(options.mesh);
  if (asked("check")) check(run.scene, run.overrides, options.as_json);
  if (asked("info")) info(options.mesh_file, options.as_json);
  if (asked("init")) init(options.init_folder);
  if (asked("help")) print_help(app, options.topic);
  return {};
}

}  // namespace bracket::apps
