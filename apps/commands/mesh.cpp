// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <iostream>

#include "apps/commands/commands.h"
#include "apps/commands/dimension.h"
#include "apps/commands/folder.h"
#include "apps/commands/say.h"
#include "apps/report/words.h"
#include "scene/mesh/write.h"

namespace bracket::apps {
namespace {

/// The problem on the mesh that a run with uniform refinement computes on after so many steps.
template <int dim> scene::Problem<dim> refined(const scene::Scene<dim>& scene, int times) {
  scene::Problem<dim> problem = scene::fix_data(scene, scene::build_mesh(scene));
  for (int i = 0; i < times; ++i) {
    const std::size_t cells = problem.mesh.cells.size(), limit = scene.refine.max_cells;
    if (dim == 2 && 4 * cells > limit)
      throw scene::Error(scene::Status::input,
                         fmt::format("--refine {}: after {} the mesh has {} cells, after {} four times as many, more "
                                     "than refine.max_cells = {}; --set refine.max_cells={} allows them",
                                     times, i, cells, i + 1, limit, 4 * cells));
    const std::vector<char> all(cells, 1);
    std::vector<std::string> notes = std::move(problem.mesh.notes);
    if constexpr (dim == 2) {
      problem = scene.curves.empty() ? scene::refine(problem, all).problem
                                     : scene::fix_data(scene, scene::finer_mesh(scene, problem, all));
    } else {
      problem = scene::refine(problem, all).problem;
    }
    problem.mesh.notes = std::move(notes);
    if (const std::size_t finer = problem.mesh.cells.size(); dim == 3 && finer > limit)
      throw scene::Error(scene::Status::input,
                         fmt::format("--refine {}: after {} the mesh has {} cells, after {} {}, more than "
                                     "refine.max_cells = {}; --set refine.max_cells={} allows them",
                                     times, i, cells, i + 1, finer, limit, finer));
  }
  return problem;
}

/// Of what kind the file is to be, by the ending of its name.
std::string ending_of(const std::filesystem::path& file) {
  const std::string ending = file.extension().string();
  if (ending != ".msh" && ending != ".inp" && ending != ".vtu")
    throw scene::Error(scene::Status::input,
                       fmt::format("{}: expected a name that ends with .msh (Gmsh), .inp (Abaqus, CalculiX) or .vtu "
                                   "(ParaView)",
                                   file.string()));
  return ending;
}

template <int dim> void write_mesh(const MeshOptions& options, const std::string& ending) {
  const scene::Scene<dim> scene = scene::read_scene<dim>(options.scene, options.overrides);
  const scene::Mesh<dim> mesh = refined(scene, options.refine).mesh;
  const int degree = options.degree == 0 ? std::min(scene.solve.degree, 2) : options.degree;  // what the formats have
  write_new_file(options.file,
                 ending == ".msh"   ? scene::gmsh_text(mesh, degree)
                 : ending == ".inp" ? scene::abaqus_text(mesh, degree, scene.plane)
                                    : scene::vtu_text(mesh, degree),
                 options.force);
  for (const std::string& note : mesh.notes) say_note(note);
  const std::size_t nodes = mesh.vertices.size() + (degree == 2 ? mesh.edges.size() : 0);
  std::cout << fmt::format("{}: {} {} {}, {} nodes; bodies {}; boundary parts {}\n", options.file.string(),
                           mesh.cells.size(), degree == 2 ? "quadratic" : "linear", Words<dim>::cells, nodes,
                           fmt::join(mesh.bodies, ", "), fmt::join(mesh.parts, ", "));
}

}  // namespace

void mesh(const MeshOptions& options) {
  const std::string ending = ending_of(options.file);
  is_in_space(options.scene, options.overrides) ? write_mesh<3>(options, ending) : write_mesh<2>(options, ending);
}

}  // namespace bracket::apps
