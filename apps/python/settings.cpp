// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <pybind11/stl.h>

#include <limits>
#include <optional>
#include <string>
#include <variant>

#include "apps/python/module.h"
#include "apps/python/options.h"

namespace bracket::python {

namespace py = pybind11;

namespace {

void set_refine(scene::Scene<2>& scene, const std::optional<std::string>& strategy, std::optional<double> target,
                std::optional<double> bulk, std::optional<int> max_levels, std::optional<int> max_cells,
                std::optional<double> max_seconds, const std::optional<std::string>& goal,
                std::optional<bool> all_levels) {
  const auto set = [](auto& setting, const auto& given) {
    if (given) setting = *given;
  };
  scene::Refine& refine = scene.refine;
  if (strategy) refine.strategy = option_of<scene::Strategy>(*strategy, "strategy");
  set(refine.target, target);
  set(refine.bulk, bulk);
  set(refine.max_levels, max_levels);
  set(refine.max_cells, max_cells);
  set(refine.max_seconds, max_seconds);
  set(refine.goal, goal);
  set(refine.all_levels, all_levels);
}

void set_solve(scene::Scene<2>& scene, const std::optional<std::variant<int, std::string>>& degree,
               const std::optional<std::string>& dual, const std::optional<int>& sweeps) {
  if (sweeps) scene.solve.sweeps = sweeps;
  if (dual) scene.solve.dual = option_of<scene::Dual>(*dual, "dual");
  if (!degree) return;
  if (const int* number = std::get_if<int>(&*degree)) {
    scene.solve.degree = *number;
    return;
  }
  if (const std::string& word = std::get<std::string>(*degree); word != "auto")
    throw py::value_error(fmt::format("degree must be an integer from 1 to 4 or \"auto\", is \"{}\"", word));
  scene::Refine& refine = scene.refine;
  const bool bulk_is_default = refine.bulk == scene::bulk_for(scene.solve.degree);
  const bool linear_stresses = scene.solve.dual != scene::Dual::hybrid || scene::has_coulomb(scene);
  scene.solve.degree = linear_stresses ? 2 : scene::degree_for(refine.target, scene::cells_of(scene));
  if (bulk_is_default) refine.bulk = scene::bulk_for(scene.solve.degree);
}

/// The mesh that `bracket mesh` writes: contact sides cut alike, refined uniformly.
scene::Mesh<2> mesh_of(const scene::Scene<2>& given, int refinements) {
  if (refinements < 0) throw py::value_error(fmt::format("refinements must not be negative, is {}", refinements));
  const scene::Scene<2> scene = given;
  const py::gil_scoped_release released;
  scene::Problem<2> problem = scene::fix_data(scene, scene::build_mesh(scene));
  for (int i = 0; i < refinements; ++i) {
    if (4 * problem.mesh.cells.size() > static_cast<std::size_t>(scene.refine.max_cells))
      throw scene::Error(scene::Status::input, scene.file,
                         fmt::format("{} refinements make more cells than refine.max_cells = {}", refinements,
                                     scene.refine.max_cells));
    const std::vector<char> all(problem.mesh.cells.size(), 1);
    problem = scene::refine(problem, all).problem;
  }
  return problem.mesh;
}

}  // namespace

void add_settings(py::class_<scene::Scene<2>>& scene) {
  const auto none = py::none();
  scene
      .def("set_refine", set_refine, py::kw_only(), py::arg("strategy") = none, py::arg("target") = none,
           py::arg("bulk") = none, py::arg("max_levels") = none, py::arg("max_cells") = none,
           py::arg("max_seconds") = none, py::arg("goal") = none, py::arg("all_levels") = none,
           "Sets what is given and leaves the rest. strategy: \"adaptive\", \"uniform\" or \"none\", which is the\n"
           "default. target: relative error bound to reach. goal: name of the quantity to refine for. all_levels:\n"
           "quantities on each mesh.")
      .def(
          "set_solve", set_solve, py::kw_only(), py::arg("degree") = none, py::arg("dual") = none,
          py::arg("sweeps") = none,
          "degree: of the displacements, 1 to 4, or \"auto\": the one that comes to the target, on the mesh, that the\n"
          "scene has by now at about the least cost. dual: \"hybrid\", \"uzawa\" or \"local\".\n"
          "sweeps: of \"local\" stresses; left out, as the shape of the cells asks.")
      .def("check", scene::check<2>, "Raises Error for the first fault that can be seen without the mesh.")
      .def("mesh", mesh_of, py::arg("refinements") = 0,
           "The mesh that runs begin with, for another program, as `bracket mesh` writes it: contact sides are cut\n"
           "alike, bodies that touch have vertices of their own. refinements: uniform ones.");
}

}  // namespace bracket::python
