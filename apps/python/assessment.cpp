// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/report/assessment.h"

#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "apps/plots/pictures.h"
#include "apps/python/arrays.h"
#include "apps/python/module.h"
#include "apps/report/json.h"

namespace bracket::python {

namespace {

/// A displacement from elsewhere, and how wrong it is.
struct Judged {
  scene::Scene<2> scene;
  std::string field;  ///< what it is called
  bounds::Assessment assessment;
};

apps::AssessmentReport report_of(const Judged& self) { return {self.scene, self.field, self.assessment}; }

/// With what was chosen or mended on reading.
std::string headline(const Judged& self) {
  std::string text = apps::assessment_headline(report_of(self));
  const scene::FieldOnScene& field = self.assessment.field;
  for (const auto* notes : {&field.problem.mesh.notes, &field.given.notes})
    for (const std::string& note : *notes) text += "note: " + note + "\n";
  return text;
}

/// \param field gives the field on the mesh of the scene
template <class Field>
std::shared_ptr<Judged> judge(const scene::Scene<2>& given, const std::string& name, const Field& field,
                              const py::object& progress) {
  auto result = std::make_shared<Judged>();
  result->scene = given;
  result->field = name;
  Follower follower(result->scene, progress);
  const py::gil_scoped_release released;
  result->assessment = bounds::assess(result->scene, field(result->scene), follower.observer());
  return result;
}

std::shared_ptr<Judged> assess_file(const scene::Scene<2>& scene, const std::filesystem::path& file,
                                    const py::object& progress) {
  return judge(
      scene, file.string(), [&](const scene::Scene<2>& of) { return scene::read_field(of, file); }, progress);
}

std::shared_ptr<Judged> assess(const scene::Scene<2>& scene, const py::object& nodes, const py::object& values,
                               const py::object& cells, const std::vector<std::string>& bodies,
                               const py::object& progress) {
  scene::NodalDisplacement field{.nodes = points(nodes, "nodes"), .values = points(values, "values"), .bodies = bodies};
  if (!cells.is_none()) {
    const Integers rows = integers(cells, "cells", {3, 4, 6, 8, 9});
    for (std::size_t i = 0; i < rows.rows; ++i) {
      const auto row = rows.values.begin() + static_cast<std::ptrdiff_t>(i * rows.columns);
      field.cells.emplace_back(row, row + static_cast<std::ptrdiff_t>(rows.columns));
    }
  }
  return judge(
      scene, "arrays", [&](const scene::Scene<2>& of) { return scene::field_on_scene(of, field); }, progress);
}

std::string picture_of(const Judged& self) {
  const py::gil_scoped_release released;
  if (self.assessment.guarantee == "none") return "";
  const apps::Drawings drawings = apps::draw({apps::error_cells_picture(self.scene, self.assessment)}, false);
  return drawings.drawn.empty() ? "" : drawings.drawn.front().svg;
}

py::tuple interval(const bounds::ErrorInterval& of) { return py::make_tuple(of.lower, of.upper); }

}  // namespace

void add_assessment(py::module_& module) {
  const auto of = [](auto member) { return [member](const Judged& self) { return self.assessment.*member; }; };
  using Assessment = bounds::Assessment;
  py::class_<Judged, std::shared_ptr<Judged>>(
      module, "Assessment", "The error of a displacement from elsewhere, u_x, between two guaranteed bounds.")
      .def_property_readonly(
          "status", [](const Judged& self) { return apps::name(self.assessment.status); },
          "\"done\", \"budget_spent\" (the interval holds) or \"not_guaranteed\".")
      .def_property_readonly("guarantee", of(&Assessment::guarantee), "As `Outcome.guarantee`.")
      .def_property_readonly("reason", of(&Assessment::reason), "Of another status than done: one line.")
      .def_property_readonly(
          "error", [](const Judged& self) { return interval(self.assessment.error); },
          "(lower, upper), the energy norm of u_x - u, the root of an energy.")
      .def_property_readonly(
          "relative", [](const Judged& self) { return interval(self.assessment.relative); },
          "(lower, upper), the same by the energy norm of Bracket's own displacement; nan where that may be zero.")
      .def_property_readonly("largest", of(&Assessment::largest), "The largest displacement at a node, a length.")
      .def_property_readonly("misfit", of(&Assessment::misfit), "The largest distance from what supports prescribe.")
      .def_property_readonly("penetration", of(&Assessment::penetration), "The largest one into a contact, a length.")
      .def_property_readonly(
          "cell", [](const Judged& self) { return array_of(self.assessment.cell); },
          "(m,), what each cell of `mesh` has of the squared error, an energy.")
      .def_property_readonly(
          "mesh", [](const Judged& self) { return self.assessment.field.problem.mesh; }, "That of u_x.")
      .def_property_readonly(
          "displacement", [](const Judged& self) { return self.assessment.field.given.displacement; }, "u_x on `mesh`.")
      .def_property_readonly(
          "interpolated", [](const Judged& self) { return self.assessment.field.given.interpolated; },
          "Whether u_x was given on another mesh; what is judged is then its interpolant.")
      .def_property_readonly(
          "notes", [](const Judged& self) { return self.assessment.field.given.notes; },
          "What was chosen on reading, a line each.")
      .def("__str__", headline, "The interval in percent, and what goes with it.")
      .def(
          "text", [](const Judged& self) { return headline(self) + apps::assessment_text(report_of(self)); },
          "All that `bracket assess` prints.")
      .def(
          "json", [](const Judged& self) { return apps::assessment_json(report_of(self)); },
          "assess.json (docs/report.md).")
      .def("_repr_html_",
           [](const Judged& self) { return notebook_html(headline(self), [&] { return picture_of(self); }); })
      .def("__repr__", [](const Judged& self) {
        return fmt::format("<bracket.Assessment {}, relative error in [{}, {}]>", apps::name(self.assessment.status),
                           self.assessment.relative.lower, self.assessment.relative.upper);
      });
  module.def(
      "assess", assess, py::arg("scene"), py::arg("nodes"), py::arg("values"), py::kw_only(),
      py::arg("cells") = py::none(), py::arg("bodies") = std::vector<std::string>(), py::arg("progress") = py::none(),
      "Says between two guaranteed bounds how wrong a displacement from another program is.\n\n"
      "nodes: (n, 2), lengths. values: (n, 2), the displacements there, lengths. cells: (m, 3, 4, 6, 8 or 9), rows\n"
      "of `nodes`: corners, then, of second order, the middles of the sides from the one behind corner 0 on, then\n"
      "of quadrilaterals the node in the middle. bodies: n names, needed where bodies touch and there are no cells.\n"
      "The nodes are those of `Scene.mesh(k)` for some k, or of any mesh with cells, which is interpolated.\n"
      "progress: as of run, told of Bracket's own solution.");
  module.def("assess_file", assess_file, py::arg("scene"), py::arg("file"), py::kw_only(),
             py::arg("progress") = py::none(),
             "The same of a file: .csv (x, y, ux, uy), .vtu (VTK) or .frd (CalculiX) (docs/other-programs.md).");
}

}  // namespace bracket::python
