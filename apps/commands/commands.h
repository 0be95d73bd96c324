// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "primal/primal.h"
#include "scene/scene.h"

/// The program: commands, reports and plots. Each command prints its results to standard output, notes and progress to
/// standard error.
namespace bracket::apps {

/// How a command ended.
struct Ending {
  scene::Status status = scene::Status::done;
  std::string reason;  ///< one line where the status is not done
};

struct RunOptions {
  std::filesystem::path scene;
  std::filesystem::path folder;        ///< for the results; empty: the scene's stem + ".out" in the current directory
  std::vector<std::string> overrides;  ///< "key=value"
  bool json = false;                   ///< print the report as JSON alone
  bool quiet = false;                  ///< print the answer alone
  bool all_levels = false;             ///< quantities on all levels
  bool last_level = false;             ///< write the fields of the last level only
  bool pictures = true;                ///< draw pictures, write report.html and the sheet
  bool png = false;                    ///< pictures as PNG too
  int ranks = 0;                       ///< processes that share the displacements; 0: the program itself has them
  const primal::Engine<3>* engine = nullptr;  ///< who has them; null: the program itself
};

/// Solves a scene, prints a line of each level as it is done, then the answer and the report. The folder holds the
/// results of each level as soon as it is done. Ctrl-C ends the run after the level that it is in. \return as
/// bounds::run ended \throw scene::Error; input also where the folder is refused or cannot take the first level,
/// not_guaranteed where one
///        of the formulations found no fields or the memory did not suffice for them
Ending run(const RunOptions& options);

/// Has bracket-mpi do these words, a run, on options.ranks processes of MPI, each with one thread of BLAS. What mpirun
/// itself says is left out. \param words without --ranks
/// \return as that run ended
/// \throw scene::Error (input) if there is no bracket-mpi or no mpirun; where one of the processes died: budget if a
///        level was done, else not_guaranteed
Ending run_on_ranks(const RunOptions& options, std::vector<std::string> words);

/// Solves a scene uniformly and adaptively, with degree 1 and 2, each until the budget of its [refine], and compares
/// what accuracy costs: a table, study.csv, study.json and study.svg. Ctrl-C ends it after the level that it is in.
/// A target ends none of them.
/// \param folder for the results; empty: the scene's stem + ".study" in the current directory
/// \return done; budget if it was stopped, or there is a target that none of them reached; not_guaranteed if one was
/// \throw scene::Error as run()
Ending study(const std::filesystem::path& scene, const std::vector<std::string>& overrides,
             const std::filesystem::path& folder);

/// Drives what makes a scene hard to its limits: units, loads, moduli, Poisson's ratio, slivers, thin bodies, contact
/// ends, the edge of solvability. Prints a table of the intervals found on the first mesh, and writes extremes.csv,
/// extremes.json and extremes.svg. What is refused on the way is a row of the table with its status and reason. Ctrl-C
/// ends it after the solve that it is in.
/// \param folder for the results; empty: the scene's stem + ".extremes" in the current directory
/// \return done; budget if it was stopped; not_guaranteed if two intervals of one energy exclude each other
/// \throw scene::Error as run(), for the scene as it is
Ending extremes(const std::filesystem::path& scene, const std::vector<std::string>& overrides,
                const std::filesystem::path& folder);

/// Prints what Haslinger & Hlaváček 1981 state beside what is measured, a table for each theorem, and writes paper.json
/// and paper.svg.
/// \param folder for the results; empty: "bracket.paper" in the current directory
/// \throw scene::Error (input) where the folder is refused or cannot be written
void paper(const std::filesystem::path& folder);

/// Prints all that is known of a scene short of solving it: data, mesh quality, matching of the contact sides,
/// solvability.
/// \param as_json as JSON alone (docs/report.md); so below
/// \throw scene::Error as run()
void check(const std::filesystem::path& scene, const std::vector<std::string>& overrides, bool as_json);

struct MeshOptions {
  std::filesystem::path scene;
  std::filesystem::path file;  ///< to be written: .msh, .inp or .vtu
  std::vector<std::string> overrides;
  int refine = 0;      ///< uniform refinements, ≥ 0
  int degree = 0;      ///< of the triangles, 1 or 2; 0: the scene's
  bool force = false;  ///< write over a file that is there
};

/// Writes the mesh that a run of the scene computes on, uniformly refined, for another program.
/// \throw scene::Error as fix_data() and refine(); input also where the file is there or cannot be written, or the mesh
///        would have more than refine.max_cells
void mesh(const MeshOptions& options);

struct AssessOptions {
  std::filesystem::path scene;
  std::filesystem::path field;   ///< displacements of another program: .csv, .vtu or .frd
  std::filesystem::path folder;  ///< for the results; empty: the scene's stem + ".assess" in the current directory
  std::vector<std::string> overrides;  ///< "key=value"
  bool json = false;                   ///< print the report as JSON alone
  bool quiet = false;                  ///< print what is first alone
};

/// Prints the error of a displacement between its bounds, and writes assess.json, assess.vtu and error.svg. Ctrl-C ends
/// it after the level that it is in.
/// \return as bounds::assess() ended
/// \throw scene::Error as scene::read_field() and bounds::assess()
Ending assess(const AssessOptions& options);

/// Writes scene.toml, a commented scene to start from. What is there stays.
/// \param folder is made where it is not there; empty: the current directory
/// \throw scene::Error (input) if the file is there or cannot be written
void init(const std::filesystem::path& folder);

/// The keys of a scene file, as docs/scene-file.md has them, for a terminal.
std::string scene_keys_text();

/// Prints bodies, boundary parts and quality of a mesh file.
/// \throw scene::Error (input, mesh)
void info(const std::filesystem::path& mesh, bool as_json);

}  // namespace bracket::apps
