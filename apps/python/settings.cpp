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

template <int dim>
void set_refine(scene::Scene<dim>& scene, const std::optional<std::string>& strategy, std::optional<double> target,
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

template <int dim>
void set_solve(scene::Scene<dim>& scene, const std::optional<std::variant<int, std::string>>& degree,
               const std::optional<std::string>& dual, const std::optional<int>& sweeps) {
  if (sweeps) scene.solve.sweeps = sweeps;
  if (dual) scene.solve.dual = option_of<scene::Dual>(*dual, "dual");
  if (!degree) return;
  if (const int* number = std::get_if<int>(&*degree)) {
    scene.solve.degree = *number;
    return;
  }
  if (const std::string& word = std::get<std::string>(*degree); word != "auto")
    throw py::value_error(fmt::format("degree must be an integer from 1 to {} or \"auto\", is \"{}\"",
                                      scene::largest_degree_in<dim>(), word));
  scene::Refine& refine = scene.refine;
  const bool bulk_is_default = refine.bulk == scene::bulk_for(scene.solve.degree);
  const bool linear_stresses = dim == 3 || scene.solve.dual != scene::Dual::hybrid || scene::has_coulomb(scene);
  scene.solve.degree = linear_stresses ? 2 : scene::degree_for(refine.target, scene::cells_of(scene));
  if (bulk_is_default) refine.bulk = scene::bulk_for(scene.solve.degree);
}

/// The mesh that `bracket mesh` writes: contact sides cut alike, refined uniformly.
template <int dim> scene::Mesh<dim> mesh_of(const scene::Scene<dim>& given, int refinements) {
  if (refinements < 0) throw py::value_error(fmt::format("refinements must not be negative, is {}", refinements));
  const scene::Scene<dim> scene = given;
  const py::gil_scoped_release released;
  scene::Problem<dim> problem = scene::fix_data(scene, scene::build_mesh(scene));
  const auto keep_within = [&](std::size_t cells) {
    if (cells > static_cast<std::size_t>(scene.refine.max_cells))
      throw scene::Error(scene::Status::input, scene.file,
                         fmt::format("{} refinements make more cells than refine.max_cells = {}", refinements,
                                     scene.refine.max_cells));
  };
  for (int i = 0; i < refinements; ++i) {
    if (dim == 2) keep_within(4 * problem.mesh.cells.size());
    const std::vector<char> all(problem.mesh.cells.size(), 1);
    problem = scene::refine(problem, all).problem;
    if (dim == 3) keep_within(problem.mesh.cells.size());  // how many is not known before
  }
  return problem.mesh;
}

}  // namespace

template <int dim> void add_settings(py::class_<scene::Scene<dim>>& scene) {
  const auto none = py::none();
  scene
      .def("set_refine", set_refine<dim>, py::kw_only(), py::arg("strategy") = none, py::arg("target") = none,
           py::arg("bulk") = none, py::arg("max_levels") = none, py::arg("max_cells") = none,
           py::arg("max_seconds") = none, py::arg("goal") = none, py::arg("all_levels") = none,
           "Sets what is given and leaves the rest. strategy: \"adaptive\", \"uniform\" or \"none\", which is the\n"
           "default. target: relative error bound to reach. goal: name of the quantity to refine for. all_levels:\n"
           "quantities on each mesh.")
      .def("set_solve", set_solve<dim>, py::kw_only(), py::arg("degree") = none, py::arg("dual") = none,
           py::arg("sweeps") = none,
           either<dim>("degree: of the displacements, 1 to 4, or \"auto\": the one that comes to the target, on the "
                       "mesh, that the\n"
                       "scene has by now at about the least cost. dual: \"hybrid\", \"uzawa\" or \"local\".\n"
                       "sweeps: of \"local\" stresses; left out, as the shape of the cells asks.",
                       "degree: of the displacements, 1 or 2, which \"auto\" is. dual: \"local\". sweeps: of the "
                       "stresses; left\n"
                       "out, as the shape of the cells asks."))
      .def("check", scene::check<dim>, "Raises Error for the first fault that can be seen without the mesh.")
      .def(
          "mesh", mesh_of<dim>, py::arg("refinements") = 0,
          either<dim>("The mesh that runs begin with, for another program, as `bracket mesh` writes it: contact sides\n"
                      "are cut alike, bodies that touch have vertices of their own. refinements: uniform ones.",
                      "The mesh that runs begin with, for another program, as `bracket mesh` writes it: bodies that\n"
                      "touch have vertices of their own. refinements: uniform ones."));
}

template void add_settings<2>(py::class_<scene::Scene<2>>&);
template void add_settings<3>(py::class_<scene::Scene<3>>&);

}  // namespace bracket::python
