// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <memory>
#include <variant>

#include "apps/python/module.h"

namespace bracket::python {

namespace py = pybind11;

namespace {

/// In the plane or in space.
using AnyResult = std::variant<std::shared_ptr<Result<2>>, std::shared_ptr<Result<3>>>;

AnyScene read_scene(const std::filesystem::path& file, const std::vector<std::string>& overrides) {
  if (scene::dimension_of(file, overrides) == 3) return scene::read_scene<3>(file, overrides);
  return scene::read_scene<2>(file, overrides);
}

template <int dim> std::shared_ptr<Result<dim>> run(scene::Scene<dim> scene, const py::object& progress) {
  auto result = std::make_shared<Result<dim>>();
  result->scene = std::move(scene);
  Follower<dim> follower(result->scene, progress);
  {
    const py::gil_scoped_release released;
    result->outcome = bounds::run(result->scene, follower.observer());
  }
  if (result->outcome.stress.cell.empty()) throw scene::Error(result->outcome.status, result->outcome.reason);
  return result;
}

}  // namespace

void add_functions(py::module_& module) {
  module.def("read_scene", read_scene, py::arg("file"), py::arg("overrides") = std::vector<std::string>(),
             "Reads a scene file (TOML), of the plane or of space.\n"
             "overrides: lines \"key=value\" that replace or add keys, as --set does.");
  module.def(
      "run",
      // A copy of the scene: another thread may change the one that was given.
      [](AnyScene scene, const py::object& progress) {
        return std::visit([&](auto& own) -> AnyResult { return run(std::move(own), progress); }, scene);
      },
      py::arg("scene"), py::arg("progress") = py::none(),
      "Solves a scene, refines until its target or budget is reached, and bounds its energy and quantities.\n\n"
      "progress: called after each mesh with the Outcome so far; where it returns False the run ends, with the\n"
      "status \"budget_spent\". What it raises, run raises, and KeyboardInterrupt after Ctrl-C at the next stage of\n"
      "the work. Other threads run meanwhile.");
}

}  // namespace bracket::python
