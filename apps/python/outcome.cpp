// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/python/outcome.h"

#include <fmt/format.h>
#include <pybind11/stl.h>

#include "apps/plots/pictures.h"
#include "apps/plots/space/pictures.h"
#include "apps/python/arrays.h"
#include "apps/python/scene.h"
#include "apps/report/json.h"
#include "bounds/results.h"

namespace bracket::python {

namespace {

template <int dim> py::tuple values_at(const Result<dim>& self, const py::object& where) {
  constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();
  constexpr int n = scene::n_voigt<dim>;
  const std::vector<scene::Vector<dim>> at = points<dim>(where, "points");
  std::vector<double> displacement(dim * at.size(), nowhere), stress(n * at.size(), nowhere);
  {
    const py::gil_scoped_release released;
    const auto& [problem, u, lambda] = std::tie(self.outcome.problem, self.outcome.displacement, self.outcome.stress);
    for (std::size_t i = 0; i < at.size(); ++i) {
      const auto values = bounds::values_at<dim>(problem, u, lambda, at[i]);
      if (!values) continue;
      std::ranges::copy(values->displacement, displacement.begin() + dim * static_cast<std::ptrdiff_t>(i));
      std::ranges::copy(values->stress, stress.begin() + n * static_cast<std::ptrdiff_t>(i));
    }
  }
  const auto count = static_cast<py::ssize_t>(at.size());
  return py::make_tuple(array_of(displacement.data(), {count, dim}), array_of(stress.data(), {count, n}));
}

template <int dim>
py::tuple resultant_on(const Result<dim>& self, const std::string& part, const Components<dim>& about) {
  const auto resultant = bounds::resultant<dim>(self.outcome.problem, self.outcome.stress, part, vector_of<dim>(about));
  const auto force = array_of(resultant.force.data(), {dim});
  if constexpr (dim == 2) return py::make_tuple(force, resultant.moment);
  if constexpr (dim == 3) return py::make_tuple(force, array_of(resultant.moment.data(), {3}));
}

template <int dim> apps::ReportOf<dim> report_of(const Result<dim>& self) {
  return apps::report(self.scene, self.outcome);
}

template <int dim> bool has_pictures(const Result<dim>& self) { return self.outcome.guarantee != "none"; }

template <int dim> std::string report_html(const Result<dim>& self) {
  const py::gil_scoped_release released;
  apps::ReportOf<dim> report = report_of(self);
  apps::Drawings drawings;
  if (has_pictures(self)) drawings = apps::drawn(report, false);
  report.missing = drawings.missing;
  return apps::report_html(report, drawings.drawn);
}

/// The first picture; empty: there is none, or it cannot be drawn.
std::string first_picture(const Result<2>& self) {
  std::vector<apps::Picture> pictures = apps::pictures(report_of(self));
  if (pictures.empty()) return "";
  pictures.resize(1);
  const apps::Drawings drawings = apps::draw(pictures, false);
  return drawings.drawn.empty() ? "" : drawings.drawn.front().svg;
}
std::string first_picture(const Result<3>& self) { return apps::space_pictures(report_of(self)).front().svg; }

template <int dim> void add_reports(py::class_<Result<dim>, std::shared_ptr<Result<dim>>>& outcome) {
  using Result = python::Result<dim>;
  outcome
      .def(
          "__str__", [](const Result& self) { return apps::headline(report_of(self)); },
          "The first lines of the report: each quantity, the energy, what is guaranteed.")
      .def(
          "text",
          [](const Result& self) {
            const apps::ReportOf<dim> report = report_of(self);
            return apps::headline(report) + apps::report_text(report);
          },
          "The report as the program prints it.")
      .def(
          "json", [](const Result& self) { return apps::report_json(report_of(self)); },
          "report.json (docs/report.md).")
      .def("html", report_html<dim>,
           either<dim>("report.html with its pictures, for which it needs gnuplot; a few seconds.",
                       "report.html with its pictures; for those of levels it needs gnuplot; a few seconds."))
      .def("_repr_html_",
           [](const Result& self) {
             return notebook_html(apps::headline(report_of(self)), [&]() -> std::string {
               const py::gil_scoped_release released;
               return has_pictures(self) ? first_picture(self) : "";
             });
           })
      .def("__repr__", [](const Result& self) {
        return fmt::format("<bracket.{}Outcome {}, energy in [{}, {}]>", either<dim>("", "space."),
                           apps::name(self.outcome.status), self.outcome.lower, self.outcome.upper);
      });
}

}  // namespace

template <int dim> void add_outcome(py::module_& module) {
  add_contact_results<dim>(module);
  using Result = python::Result<dim>;
  // Members of the outcome, by a copy where they are plain values.
  const auto of = [](auto member) { return [member](const Result& self) { return self.outcome.*member; }; };
  using Outcome = bounds::Outcome<dim>;
  const char* unit = either<dim>("Guaranteed bound of the energy, force * length by thickness.",
                                 "Guaranteed bound of the energy, force * length.");
  py::class_<Result, std::shared_ptr<Result>> outcome(module, "Outcome",
                                                      "What a run has found. Fields are those of its last mesh.");
  outcome
      .def_property_readonly(
          "status", [](const Result& self) { return apps::name(self.outcome.status); },
          "\"done\", \"budget_spent\" (the bounds hold), \"not_guaranteed\" or \"ill_posed\".")
      .def_property_readonly(
          "guarantee", of(&Outcome::guarantee),
          "\"rounding-safe\"; \"discretisation\": as that, for data known but where callables were\n"
          "sampled; \"tresca-step\": for the friction bound of the last of Coulomb's steps; \"none\".")
      .def_property_readonly("reason", of(&Outcome::reason), "Of another status than done: one line.")
      .def_property_readonly("lower", of(&Outcome::lower), unit)
      .def_property_readonly("upper", of(&Outcome::upper), unit)
      .def_property_readonly("relative_error_bound", of(&Outcome::relative_error_bound),
                             "Guaranteed: sqrt(2 (upper - lower)) by the energy norm of the displacements.")
      .def_property_readonly("quantities", of(&Outcome::quantities),
                             either<dim>("Those of the scene in their order, then the zones of its contacts.",
                                         "Those of the scene in their order."))
      .def(
          "quantity",
          [](const Result& self, const std::string& name) {
            for (const bounds::QuantityInterval& one : self.outcome.quantities)
              if (one.name == name) return one;
            throw py::key_error(name);
          },
          py::arg("name"), "The quantity of that name.")
      .def_property_readonly("levels", of(&Outcome::levels))
      .def_property_readonly("skipped", of(&Outcome::skipped), "Stages that the scene did not need.")
      .def_property_readonly("mesh", [](const Result& self) { return self.outcome.problem.mesh; })
      .def_property_readonly("displacement", of(&Outcome::displacement))
      .def_property_readonly("stress", of(&Outcome::stress))
      .def_property_readonly(
          "indicator", [](const Result& self) { return array_of(self.outcome.indicator.cell); },
          "(m,), what each cell has of the width upper - lower, an energy.")
      .def_property_readonly("contacts", contacts_of<dim>,
                             "A Contact for each contact of the scene. Computed, not guaranteed.")
      .def(
          "values_at", values_at<dim>, py::arg("points"),
          either<dim>(
              "Displacements (n, 2) and stresses in equilibrium (n, 3) (xx, yy, xy) at points (n, 2); nan outside of "
              "all\n"
              "bodies. Computed, not guaranteed. Looks through all cells for each point.",
              "Displacements (n, 3) and stresses in equilibrium (n, 6) (xx, yy, zz, yz, xz, xy) at points (n, 3); nan\n"
              "outside of all bodies. Computed, not guaranteed. Looks through all cells for each point."))
      .def("resultant", resultant_on<dim>, py::arg("part"), py::arg("about") = Components<dim>{},
           either<dim>(
               "Force (2,) and moment, counter-clockwise, of the stress in equilibrium on a boundary part: what\n"
               "acts there on its body, by thickness. Computed, not guaranteed.",
               "Force (3,) and moment (3,) about a point of the stress in equilibrium on a boundary part: what acts\n"
               "there on its body. Computed, not guaranteed."));
  add_reports(outcome);
}

template void add_outcome<2>(py::module_&);
template void add_outcome<3>(py::module_&);

}  // namespace bracket::python
