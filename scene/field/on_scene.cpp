// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/field/on_scene.h"

#include <fmt/format.h>

#include <algorithm>

#include "scene/field/raw_field.h"
#include "scene/text.h"

namespace bracket::scene {

namespace {

template <int dim> constexpr const char* cell_word = dim == 2 ? "triangles" : "tetrahedra";

/// A mesh of the scene, and what the file has on it.
template <int dim> struct Trial {
  Problem<dim> problem;
  int refinements = 0;
  std::optional<GivenDisplacementOf<dim>> given = {};
  std::optional<Error> refused = {};
};

template <int dim> Trial<dim> on_mesh(Problem<dim> problem, int refinements, const RawField<dim>& field) {
  Trial<dim> trial{std::move(problem), refinements};
  try {
    trial.given = matched(field, trial.problem.mesh);
  } catch (const Error& error) {
    trial.refused = error;
  }
  return trial;
}

template <int dim>
std::optional<Trial<dim>> finer(const Trial<dim>& trial, std::size_t max_cells, const RawField<dim>& field) {
  const Mesh<dim>& mesh = trial.problem.mesh;
  if (4 * mesh.cells.size() > max_cells) return {};
  Problem<dim> refined = refine(trial.problem, std::vector<char>(mesh.cells.size(), 1)).problem;
  if (refined.mesh.cells.size() > max_cells) return {};
  return on_mesh(std::move(refined), trial.refinements + 1, field);
}

/// Whether the file's nodes are those of the mesh.
template <int dim> bool fits(const Trial<dim>& trial) { return trial.given && !trial.given->interpolated; }

/// Whether points alone could as well be the vertices of the next mesh.
template <int dim> bool may_be_linear(const Trial<dim>& trial, const RawField<dim>& field) {
  return field.cells.empty() && trial.given->displacement.degree == 2;
}

/// The first mesh that fits; else the first with as many nodes that the file can be interpolated on.
template <int dim> Trial<dim> best(const Scene<dim>& scene, const RawField<dim>& field) {
  const std::size_t count = field.nodes.size(), max_cells = scene.refine.max_cells;
  std::optional<Trial<dim>> interpolated;
  Trial<dim> trial = on_mesh(fix_data(scene, build_mesh(scene)), 0, field);
  while (!fits(trial)) {
    const std::size_t vertices = trial.problem.mesh.vertices.size();
    if (trial.given && !interpolated && vertices + trial.problem.mesh.edges.size() >= count) interpolated = trial;
    // Where bodies touch two vertices may be one point; the next mesh has about four times as many.
    if (2 * vertices > 5 * count) break;
    auto next = finer(trial, max_cells, field);
    if (!next && trial.given) return trial;
    if (!next)
      fail(Status::input, trial.refused->where(),
           fmt::format("{}; finer meshes of the scene have more cells than refine.max_cells = {}",
                       trial.refused->message(), max_cells));
    trial = std::move(*next);
  }
  if (fits(trial)) return trial;
  if (interpolated) return *interpolated;
  throw *trial.refused;
}

/// The same points as those of linear triangles, where the scene asks for these.
template <int dim> Trial<dim> as_asked(Trial<dim> trial, const Scene<dim>& scene, const RawField<dim>& field) {
  if (!fits(trial) || !may_be_linear(trial, field)) return trial;
  const std::size_t cells = trial.problem.mesh.cells.size();
  std::size_t linear = 4 * cells;
  if (dim == 3 || scene.solve.degree == 1) {  // in space the next mesh may have other points
    auto next = finer(trial, scene.refine.max_cells, field);
    const bool both = next && fits(*next);
    if (dim == 3 && !both) return trial;
    if (both) linear = next->problem.mesh.cells.size();
    if (both && scene.solve.degree == 1) trial = std::move(*next);
  }
  trial.given->notes.push_back(
      trial.given->displacement.degree == 1
          ? fmt::format("{}: taken as linear on {} {}, as solve.degree = 1; the points are also the nodes of "
                        "{} quadratic ones",
                        field.file, linear, cell_word<dim>, cells)
          : fmt::format("{}: taken as quadratic on {} {}; the points are also the vertices of {} linear ones: "
                        "--set solve.degree=1 takes them so",
                        field.file, cells, cell_word<dim>, linear));
  return trial;
}

template <int dim> FieldOnSceneOf<dim> on_scene(const Scene<dim>& scene, const RawField<dim>& field) {
  if (!scene.curves.empty())
    fail(Status::input, scene.file,
         "has arcs ([curves]): each of its meshes is another polygon, on which no displacement of another program can "
         "be judged yet");
  Trial<dim> trial = as_asked(best(scene, field), scene, field);
  // The data are fixed on the file's own mesh, on whose edges its displacement is quadratic, for fields of that degree.
  Mesh<dim> mesh = trial.problem.mesh;
  Scene<dim> quadratic = scene;
  quadratic.solve.degree = std::min(scene.solve.degree, 2);
  FieldOnSceneOf<dim> result{fix_data(quadratic, std::move(mesh)), std::move(*trial.given), trial.refinements};
  if (result.problem.mesh.vertices != trial.problem.mesh.vertices ||
      result.problem.mesh.cells != trial.problem.mesh.cells)
    fail(Status::mesh, scene.file, "its contact sides would be cut anew on the refined mesh of the displacement");
  return result;
}

}  // namespace

template <int dim> FieldOnSceneOf<dim> read_field(const Scene<dim>& scene, const std::filesystem::path& file) {
  return on_scene(scene, read_raw_field<dim>(file));
}

template <int dim> FieldOnSceneOf<dim> field_on_scene(const Scene<dim>& scene, const NodalDisplacementOf<dim>& field) {
  const std::string name = "the displacement";
  try {
    return on_scene(scene, raw_field_of(field, name));
  } catch (const Error& error) {
    if (error.where() == name) throw Error(error.status(), error.what());  // arrays are no place
    throw;
  }
}

template FieldOnSceneOf<2> read_field(const Scene<2>&, const std::filesystem::path&);
template FieldOnSceneOf<3> read_field(const Scene<3>&, const std::filesystem::path&);
template FieldOnSceneOf<2> field_on_scene(const Scene<2>&, const NodalDisplacementOf<2>&);
template FieldOnSceneOf<3> field_on_scene(const Scene<3>&, const NodalDisplacementOf<3>&);

}  // namespace bracket::scene
