// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/field/on_scene.h"

#include <fmt/format.h>

#include <algorithm>

#include "scene/field/raw_field.h"
#include "scene/text.h"

namespace bracket::scene {

namespace {

/// A mesh of the scene, and what the file has on it.
struct Trial {
  Problem<2> problem;
  int refinements = 0;
  std::optional<GivenDisplacement> given = {};
  std::optional<Error> refused = {};
};

Trial on_mesh(Problem<2> problem, int refinements, const RawField& field) {
  Trial trial{std::move(problem), refinements};
  try {
    trial.given = matched(field, trial.problem.mesh);
  } catch (const Error& error) {
    trial.refused = error;
  }
  return trial;
}

std::optional<Trial> finer(const Trial& trial, std::size_t max_cells, const RawField& field) {
  const Mesh<2>& mesh = trial.problem.mesh;
  if (4 * mesh.cells.size() > max_cells) return {};
  return on_mesh(refine(trial.problem, std::vector<char>(mesh.cells.size(), 1)).problem, trial.refinements + 1, field);
}

/// Whether the file's nodes are those of the mesh.
bool fits(const Trial& trial) { return trial.given && !trial.given->interpolated; }

/// Whether points alone could as well be the vertices of the next mesh.
bool may_be_linear(const Trial& trial, const RawField& field) {
  return field.cells.empty() && trial.given->displacement.degree == 2;
}

/// The first mesh that fits; else the first with as many nodes that the file can be interpolated on.
Trial best(const Scene<2>& scene, const RawField& field) {
  const std::size_t count = field.nodes.size(), max_cells = scene.refine.max_cells;
  std::optional<Trial> interpolated;
  Trial trial = on_mesh(fix_data(scene, build_mesh(scene)), 0, field);
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
Trial as_asked(Trial trial, const Scene<2>& scene, const RawField& field) {
  if (!fits(trial) || !may_be_linear(trial, field)) return trial;
  const std::size_t cells = trial.problem.mesh.cells.size();
  if (scene.solve.degree == 1)
    if (auto next = finer(trial, scene.refine.max_cells, field); next && fits(*next)) trial = std::move(*next);
  trial.given->notes.push_back(
      trial.given->displacement.degree == 1
          ? fmt::format("{}: taken as linear on {} triangles, as solve.degree = 1; the points are also the nodes of "
                        "{} quadratic ones",
                        field.file, trial.problem.mesh.cells.size(), cells)
          : fmt::format("{}: taken as quadratic on {} triangles; the points are also the vertices of {} linear ones: "
                        "--set solve.degree=1 takes them so",
                        field.file, cells, 4 * cells));
  return trial;
}

FieldOnScene on_scene(const Scene<2>& scene, const RawField& field) {
  if (!scene.curves.empty())
    fail(Status::input, scene.file,
         "has arcs ([curves]): each of its meshes is another polygon, on which no displacement of another program can "
         "be judged yet");
  Trial trial = as_asked(best(scene, field), scene, field);
  // The data are fixed on the file's own mesh, on whose edges its displacement is quadratic, for fields of that degree.
  Mesh<2> mesh = trial.problem.mesh;
  Scene<2> quadratic = scene;
  quadratic.solve.degree = std::min(scene.solve.degree, 2);
  FieldOnScene result{fix_data(quadratic, std::move(mesh)), std::move(*trial.given), trial.refinements};
  if (result.problem.mesh.vertices != trial.problem.mesh.vertices ||
      result.problem.mesh.cells != trial.problem.mesh.cells)
    fail(Status::mesh, scene.file, "its contact sides would be cut anew on the refined mesh of the displacement");
  return result;
}

}  // namespace

FieldOnScene read_field(const Scene<2>& scene, const std::filesystem::path& file) {
  return on_scene(scene, read_raw_field(file));
}

FieldOnScene field_on_scene(const Scene<2>& scene, const NodalDisplacement& field) {
  const std::string name = "the displacement";
  try {
    return on_scene(scene, raw_field_of(field, name));
  } catch (const Error& error) {
    if (error.where() == name) throw Error(error.status(), error.what());  // arrays are no place
    throw;
  }
}

}  // namespace bracket::scene
