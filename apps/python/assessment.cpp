// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/report/assessment.h"

#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <variant>

#include "apps/plots/pictures.h"
#include "apps/plots/space/pictures.h"
#include "apps/python/arrays.h"
#include "apps/python/module.h"
#include "apps/report/json.h"

namespace bracket::python {

namespace {

/// A displacement from elsewhere, and how wrong it is.
template <int dim> struct Judged {
  scene::Scene<dim> scene;
  std::string field;  ///< what it is called
  bounds::AssessmentOf<dim> assessment;
};
/// In the plane or in space.
using AnyJudged = std::variant<std::shared_ptr<Judged<2>>, std::shared_ptr<Judged<3>>>;

template <int dim> apps::AssessmentReportOf<dim> report_of(const Judged<dim>& self) {
  return {self.scene, self.field, self.assessment};
}

/// With what was chosen or mended on reading.
template <int dim> std::string headline(const Judged<dim>& self) {
  std::string text = apps::assessment_headline(report_of(self));
  const auto& field = self.assessment.field;
  for (const auto* notes : {&field.problem.mesh.notes, &field.given.notes})
    for (const std::string& note : *notes) text += "note: " + note + "\n";
  return text;
}

/// \param field gives the field on the mesh of the scene
template <int dim, class Field>
std::shared_ptr<Judged<dim>> judge(scene::Scene<dim> given, const std::string& name, const Field& field,
                                   const py::object& progress) {
  auto result = std::make_shared<Judged<dim>>();
  result->scene = std::move(given);
  result->field = name;
  Follower<dim> follower(result->scene, progress);
  const py::gil_scoped_release released;
  result->assessment = bounds::assess<dim>(result->scene, field(result->scene), follower.observer());
  return result;
}

template <int dim>
std::shared_ptr<Judged<dim>> judge_arrays(scene::Scene<dim> scene, const py::object& nodes, const py::object& values,
                                          const py::object& cells, const std::vector<std::string>& bodies,
                                          const py::object& progress) {
  const std::vector<std::size_t> known =
      dim == 2 ? std::vector<std::size_t>{3, 4, 6, 8, 9} : std::vector<std::size_t>{4, 10};
  scene::NodalDisplacementOf<dim> field{
      .nodes = points<dim>(nodes, "nodes"), .values = points<dim>(values, "values"), .bodies = bodies};
  if (!cells.is_none()) {
    const Integers rows = integers(cells, "cells", known);
    for (std::size_t i = 0; i < rows.rows; ++i) {
      const auto row = rows.values.begin() + static_cast<std::ptrdiff_t>(i * rows.columns);
      field.cells.emplace_back(row, row + static_cast<std::ptrdiff_t>(rows.columns));
    }
  }
  return judge<dim>(
      std::move(scene), "arrays", [&](const scene::Scene<dim>& of) { return scene::field_on_scene(of, field); },
      progress);
}

AnyJudged assess(AnyScene scene, const py::object& nodes, const py::object& values, const py::object& cells,
                 const std::vector<std::string>& bodies, const py::object& progress) {
  return std::visit(
      [&](auto& own) -> AnyJudged { return judge_arrays(std::move(own), nodes, values, cells, bodies, progress); },
      scene);
}

AnyJudged assess_file(AnyScene scene, const std::filesystem::path& file, const py::object& progress) {
  const auto field = [&](const auto& of) { return scene::read_field(of, file); };
  return std::visit([&](auto& own) -> AnyJudged { return judge(std::move(own), file.string(), field, progress); },
                    scene);
}

std::string drawn(const scene::Scene<2>& scene, const bounds::AssessmentOf<2>& assessment) {
  const apps::Drawings drawings = apps::draw({apps::error_cells_picture(scene, assessment)}, false);
  return drawings.drawn.empty() ? "" : drawings.drawn.front().svg;
}
std::string drawn(const scene::Scene<3>& scene, const bounds::AssessmentOf<3>& assessment) {
  return apps::error_cells_pictures(scene, assessment).front().svg;
}

template <int dim> std::string picture_of(const Judged<dim>& self) {
  const py::gil_scoped_release released;
  return self.assessment.guarantee == "none" ? "" : drawn(self.scene, self.assessment);
}

py::tuple interval(const bounds::ErrorInterval& of) { return py::make_tuple(of.lower, of.upper); }

}  // namespace

template <int dim> void add_assessment(py::module_& module) {
  using Own = Judged<dim>;
  const auto of = [](auto member) { return [member](const Own& self) { return self.assessment.*member; }; };
  using Assessment = bounds::AssessmentOf<dim>;
  py::class_<Own, std::shared_ptr<Own>>(
      module, "Assessment", "The error of a displacement from elsewhere, u_x, between two guaranteed bounds.")
      .def_property_readonly(
          "status", [](const Own& self) { return apps::name(self.assessment.status); },
          "\"done\", \"budget_spent\" (the interval holds) or \"not_guaranteed\".")
      .def_property_readonly("guarantee", of(&Assessment::guarantee), "As `Outcome.guarantee`.")
      .def_property_readonly("reason", of(&Assessment::reason), "Of another status than done: one line.")
      .def_property_readonly(
          "error", [](const Own& self) { return interval(self.assessment.error); },
          "(lower, upper), the energy norm of u_x - u, the root of an energy.")
      .def_property_readonly(
          "relative", [](const Own& self) { return interval(self.assessment.relative); },
          "(lower, upper), the same by the energy norm of Bracket's own displacement; nan where that may be zero.")
      .def_property_readonly("largest", of(&Assessment::largest), "The largest displacement at a node, a length.")
      .def_property_readonly("misfit", of(&Assessment::misfit), "The largest distance from what supports prescribe.")
      .def_property_readonly("penetration", of(&Assessment::penetration), "The largest one into a contact, a length.")
      .def_property_readonly(
          "cell", [](const Own& self) { return array_of(self.assessment.cell); },
          "(m,), what each cell of `mesh` has of the squared error, an energy.")
      .def_property_readonly(
          "mesh", [](const Own& self) { return self.assessment.field.problem.mesh; }, "That of u_x.")
      .def_property_readonly(
          "displacement", [](const Own& self) { return self.assessment.field.given.displacement; }, "u_x on `mesh`.")
      .def_property_readonly(
          "interpolated", [](const Own& self) { return self.assessment.field.given.interpolated; },
          "Whether u_x was given on another mesh; what is judged is then its interpolant.")
      .def_property_readonly(
          "notes", [](const Own& self) { return self.assessment.field.given.notes; },
          "What was chosen on reading, a line each.")
      .def("__str__", headline<dim>, "The interval in percent, and what goes with it.")
      .def(
          "text", [](const Own& self) { return headline(self) + apps::assessment_text(report_of(self)); },
          "All that `bracket assess` prints.")
      .def(
          "json", [](const Own& self) { return apps::assessment_json(report_of(self)); },
          "assess.json (docs/report.md).")
      .def("_repr_html_",
           [](const Own& self) { return notebook_html(headline(self), [&] { return picture_of(self); }); })
      .def("__repr__", [](const Own& self) {
        return fmt::format("<bracket.{}Assessment {}, relative error in [{}, {}]>", either<dim>("", "space."),
                           apps::name(self.assessment.status), self.assessment.relative.lower,
                           self.assessment.relative.upper);
      });
}

template void add_assessment<2>(py::module_&);
template void add_assessment<3>(py::module_&);

void add_assess(py::module_& module) {
  module.def(
      "assess", assess, py::arg("scene"), py::arg("nodes"), py::arg("values"), py::kw_only(),
      py::arg("cells") = py::none(), py::arg("bodies") = std::vector<std::string>(), py::arg("progress") = py::none(),
      "Says between two guaranteed bounds how wrong a displacement from another program is.\n\n"
      "nodes: (n, 2), in space (n, 3), lengths. values: the displacements there, likewise, lengths. cells: (m, 3, 4,\n"
      "6, 8 or 9), rows of `nodes`: corners, then, of second order, the middles of the sides from the one behind\n"
      "corner 0 on, then of quadrilaterals the node in the middle; in space (m, 4 or 10): corners, then the middles\n"
      "of the edges 01, 12, 20, 03, 13, 23. bodies: n names, needed where bodies touch and there are no cells.\n"
      "The nodes are those of `Scene.mesh(k)` for some k, or of any mesh with cells, which is interpolated.\n"
      "progress: as of run, told of Bracket's own solution.");
  module.def("assess_file", assess_file, py::arg("scene"), py::arg("file"), py::kw_only(),
             py::arg("progress") = py::none(),
             "The same of a file: .csv (x, y, ux, uy, in space z and uz, too), .vtu (VTK) or .frd (CalculiX) "
             "(docs/other-programs.md).");
}

}  // namespace bracket::python
