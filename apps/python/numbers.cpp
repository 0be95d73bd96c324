// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <pybind11/stl.h>

#include "apps/python/module.h"
#include "apps/report/json.h"

namespace bracket::python {

namespace py = pybind11;

void add_numbers(py::module_& module) {
  using bounds::Level;
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

  using Quantity = bounds::QuantityInterval;
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
}

}  // namespace bracket::python
