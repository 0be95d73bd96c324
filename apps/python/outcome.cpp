// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <pybind11/stl.h>

#include "apps/plots/pictures.h"
#include "apps/python/arrays.h"
#include "apps/python/module.h"
#include "apps/report/json.h"
#include "bounds/results.h"

namespace bracket::python {

namespace {

using Level = bounds::Level;
using Quantity = bounds::QuantityInterval;

/// A contact pair and what the fields have on it.
struct ContactLine {
  std::string name, first, second;
  bounds::ContactResult<2> result;
  py::array_t<double> points, pressure, gap;
};

/// Rows of equal length as an array of shape (n, columns).
py::array_t<double> table(const std::vector<std::vector<double>>& rows) {
  const std::size_t columns = rows.empty() ? 0 : rows.front().size();
  std::vector<double> all;
  for (const auto& row : rows) all.insert(all.end(), row.begin(), row.end());
  return array_of(all.data(), {static_cast<py::ssize_t>(rows.size()), static_cast<py::ssize_t>(columns)});
}

std::vector<ContactLine> contacts_of(const Result& self) {
  const scene::Problem<2>& problem = self.outcome.problem;
  const auto states = bounds::contact_state(problem, self.outcome.displacement, self.outcome.stress);
  std::vector<ContactLine> lines;
  for (std::size_t i = 0; i < self.scene.contact.size(); ++i) {
    const scene::ContactPair<2>& pair = self.scene.contact[i];
    std::vector<double> points;
    std::vector<std::vector<double>> pressure, gap;
    for (std::size_t k = 0; k < problem.contact.size(); ++k) {
      if (problem.contact[k].pair != static_cast<int>(i)) continue;
      for (const auto& x : scene::positions(problem.mesh, problem.mesh.boundary[problem.contact[k].first].vertices))
        points.insert(points.end(), x.begin(), x.end());
      pressure.push_back(states[k].pressure);
      gap.push_back(states[k].gap_left);
    }
    lines.push_back({pair.name, scene::name(pair.first), scene::name(pair.second),
                     bounds::contact_result(problem, self.outcome.stress, static_cast<int>(i)),
                     array_of(points.data(), {static_cast<py::ssize_t>(points.size()) / 4, 2, 2}), table(pressure),
                     table(gap)});
  }
  return lines;
}

py::tuple values_at(const Result& self, const py::object& where) {
  constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();
  const std::vector<scene::Vector<2>> at = points(where, "points");
  std::vector<double> displacement(2 * at.size(), nowhere), stress(3 * at.size(), nowhere);
  {
    const py::gil_scoped_release released;
    const auto& [problem, u, lambda] = std::tie(self.outcome.problem, self.outcome.displacement, self.outcome.stress);
    for (std::size_t i = 0; i < at.size(); ++i) {
      const auto values = bounds::values_at<2>(problem, u, lambda, at[i]);
      if (!values) continue;
      std::ranges::copy(values->displacement, displacement.begin() + 2 * static_cast<std::ptrdiff_t>(i));
      std::ranges::copy(values->stress, stress.begin() + 3 * static_cast<std::ptrdiff_t>(i));
    }
  }
  const auto count = static_cast<py::ssize_t>(at.size());
  return py::make_tuple(array_of(displacement.data(), {count, 2}), array_of(stress.data(), {count, 3}));
}

py::tuple resultant_on(const Result& self, const std::string& part, const std::array<double, 2>& about) {
  const auto resultant = bounds::resultant<2>(self.outcome.problem, self.outcome.stress, part, {about[0], about[1]});
  return py::make_tuple(array_of(resultant.force.data(), {2}), resultant.moment);
}

apps::Report report_of(const Result& self) { return apps::report(self.scene, self.outcome); }

bool has_pictures(const Result& self) { return self.outcome.guarantee != "none"; }

std::string report_html(const Result& self) {
  const py::gil_scoped_release released;
  apps::Report report = report_of(self);
  apps::Drawings drawings;
  if (has_pictures(self)) drawings = apps::draw(apps::pictures(report), false);
  report.missing = drawings.missing;
  return apps::report_html(report, drawings.drawn);
}

/// The first picture; empty: there is none, or it cannot be drawn.
std::string first_picture(const Result& self) {
  const py::gil_scoped_release released;
  std::vector<apps::Picture> pictures;
  if (has_pictures(self)) pictures = apps::pictures(report_of(self));
  if (pictures.empty()) return "";
  pictures.resize(1);
  const apps::Drawings drawings = apps::draw(pictures, false);
  return drawings.drawn.empty() ? "" : drawings.drawn.front().svg;
}

void add_parts(py::module_& module) {
  py::class_<Level>(module, "Level", "What one mesh gave.")
      .def_readonly("cells", &Level::cells)
      .def_property_readonly(
          "lower", [](const Level& self) { return self.bracket.lower; }, "Bound of the energy.")
      .def_property_readonly(
          "upper", [](const Level& self) { return self.bracket.upper; }, "Bound of the energy.")
      .def_property_readonly("relative_error_bound",
                             [](const Level& self) { return self.bracket.relative_error_bound; })
      .def_property_readonly(
          "primal_dofs", [](const Level& self) { return self.primal.unknowns; }, "Unknown displacements.")
      .def_property_readonly(
          "dual_dofs", [](const Level& self) { return self.dual.unknowns; }, "Unknowns of the stresses.")
      .def_property_readonly(
          "seconds", [](const Level& self) { return self.seconds.total; }, "Wall clock.");

  py::class_<Quantity>(module, "Quantity", "A quantity between two guaranteed bounds, in the units of the scene.")
      .def_readonly("name", &Quantity::name)
      .def_property_readonly("kind", [](const Quantity& self) { return scene::name(self.kind); })
      .def_readonly("lower", &Quantity::lower, "-inf: no bound on that side.")
      .def_readonly("upper", &Quantity::upper, "inf: no bound on that side.")
      .def_readonly("relative_width", &Quantity::relative_width, "By the larger bound's size; nan where 0 is inside.")
      .def_readonly("target_reached", &Quantity::target_reached, "Or none was asked.")
      .def_readonly("weighted", &Quantity::weighted, "Near an end where supports or contacts meet it falls to zero.")
      .def_readonly("reason", &Quantity::reason, "If a bound is missing: one line.")
      .def_readonly("contact", &Quantity::contact, "Of a force or an opening: place in `Outcome.contacts`; else -1.")
      .def_readonly("zone", &Quantity::zone, "Which of the contact's zones; -1: asked for by name.")
      .def("__repr__", [](const Quantity& self) {
        return fmt::format("<bracket.Quantity {} in [{}, {}]>", py::repr(py::str(self.name)).cast<std::string>(),
                           self.lower, self.upper);
      });

  const auto array = [](auto ContactLine::*member) {
    return [member](const ContactLine& self) { return self.*member; };
  };
  py::class_<ContactLine>(module, "Contact", "A contact pair. Computed, not guaranteed. Forces are by thickness.")
      .def_readonly("name", &ContactLine::name, "As the scene has it; may be empty.")
      .def_readonly("first", &ContactLine::first, "The parts of the first side.")
      .def_readonly("second", &ContactLine::second)
      .def_property_readonly(
          "force", [](const ContactLine& self) { return array_of(self.result.resultant.force.data(), {2}); },
          "(2,), what acts on the body of the first side.")
      .def_property_readonly(
          "largest_pressure", [](const ContactLine& self) { return self.result.largest_pressure; }, "Force by area.")
      .def_property_readonly(
          "at", [](const ContactLine& self) { return array_of(self.result.at.data(), {2}); },
          "(2,), a vertex with the largest pressure.")
      .def_property_readonly("length", [](const ContactLine& self) { return self.result.length; })
      .def_property_readonly("pressed_length", [](const ContactLine& self) { return self.result.pressed_length; })
      .def_property_readonly("points", array(&ContactLine::points),
                             "(k, 2, 2), the ends of each edge of the first side that is in contact.")
      .def_property_readonly("pressure", array(&ContactLine::pressure),
                             "(k, n), Bernstein coefficients from the first end on, >= 0; the first and the last are "
                             "its values at the ends.")
      .def_property_readonly("gap", array(&ContactLine::gap),
                             "(k, n), what the displacements leave of the gap, likewise.");
}

void add_reports(py::class_<Result, std::shared_ptr<Result>>& outcome) {
  outcome
      .def(
          "__str__", [](const Result& self) { return apps::headline(report_of(self)); },
          "The first lines of the report: each quantity, the energy, what is guaranteed.")
      .def(
          "text",
          [](const Result& self) {
            const apps::Report report = report_of(self);
            return apps::headline(report) + apps::report_text(report);
          },
          "The report as the program prints it.")
      .def(
          "json", [](const Result& self) { return apps::report_json(report_of(self)); },
          "report.json (docs/report.md).")
      .def("html", report_html, "report.html with its pictures, for which it needs gnuplot; a few seconds.")
      .def("_repr_html_",
           [](const Result& self) {
             return notebook_html(apps::headline(report_of(self)), [&] { return first_picture(self); });
           })
      .def("__repr__", [](const Result& self) {
        return fmt::format("<bracket.Outcome {}, energy in [{}, {}]>", apps::name(self.outcome.status),
                           self.outcome.lower, self.outcome.upper);
      });
}

std::shared_ptr<Result> run(const scene::Scene<2>& given, const py::object& progress) {
  auto result = std::make_shared<Result>();
  result->scene = given;  // another thread may change the one that was given
  Follower follower(result->scene, progress);
  {
    const py::gil_scoped_release released;
    result->outcome = bounds::run(result->scene, follower.observer());
  }
  if (result->outcome.stress.cell.empty()) throw scene::Error(result->outcome.status, result->outcome.reason);
  return result;
}

}  // namespace

void add_outcome(py::module_& module) {
  add_parts(module);
  // Members of the outcome, by a copy where they are plain values.
  const auto of = [](auto member) { return [member](const Result& self) { return self.outcome.*member; }; };
  using Outcome = bounds::Outcome<2>;
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
      .def_property_readonly("lower", of(&Outcome::lower),
                             "Guaranteed bound of the energy, force * length by thickness.")
      .def_property_readonly("upper", of(&Outcome::upper),
                             "Guaranteed bound of the energy, force * length by thickness.")
      .def_property_readonly("relative_error_bound", of(&Outcome::relative_error_bound),
                             "Guaranteed: sqrt(2 (upper - lower)) by the energy norm of the displacements.")
      .def_property_readonly("quantities", of(&Outcome::quantities),
                             "Those of the scene in their order, then the zones of its contacts.")
      .def(
          "quantity",
          [](const Result& self, const std::string& name) {
            for (const Quantity& one : self.outcome.quantities)
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
      .def_property_readonly("contacts", contacts_of,
                             "A Contact for each contact of the scene. Computed, not guaranteed.")
      .def("values_at", values_at, py::arg("points"),
           "Displacements (n, 2) and stresses in equilibrium (n, 3) (xx, yy, xy) at points (n, 2); nan outside of all\n"
           "bodies. Computed, not guaranteed. Looks through all cells for each point.")
      .def("resultant", resultant_on, py::arg("part"), py::arg("about") = std::array<double, 2>{0, 0},
           "Force (2,) and moment, counter-clockwise, of the stress in equilibrium on a boundary part: what\n"
           "acts there on its body, by thickness. Computed, not guaranteed.");
  add_reports(outcome);
  module.def(
      "run", run, py::arg("scene"), py::arg("progress") = py::none(),
      "Solves a scene, refines until its target or budget is reached, and bounds its energy and quantities.\n\n"
      "progress: called after each mesh with the Outcome so far; where it returns False the run ends, with the\n"
      "status \"budget_spent\". What it raises, run raises, and KeyboardInterrupt after Ctrl-C at the next stage of\n"
      "the work. Other threads run meanwhile.");
}

}  // namespace bracket::python
