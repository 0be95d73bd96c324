// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/stl.h>

#include "apps/python/outcome.h"

namespace bracket::python {

namespace {

/// Rows of equal length as an array of shape (n, columns).
py::array_t<double> table(const std::vector<std::vector<double>>& rows) {
  const std::size_t columns = rows.empty() ? 0 : rows.front().size();
  std::vector<double> all;
  for (const auto& row : rows) all.insert(all.end(), row.begin(), row.end());
  return array_of(all.data(), {static_cast<py::ssize_t>(rows.size()), static_cast<py::ssize_t>(columns)});
}

}  // namespace

template <int dim> std::vector<ContactOfRun<dim>> contacts_of(const Result<dim>& self) {
  const scene::Problem<dim>& problem = self.outcome.problem;
  const auto states = bounds::contact_state(problem, self.outcome.displacement, self.outcome.stress);
  std::vector<ContactOfRun<dim>> lines;
  for (std::size_t i = 0; i < self.scene.contact.size(); ++i) {
    const scene::ContactPair<dim>& pair = self.scene.contact[i];
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
                     array_of(points.data(), {static_cast<py::ssize_t>(points.size()) / (dim * dim), dim, dim}),
                     table(pressure), table(gap)});
  }
  return lines;
}

template <int dim> void add_contact_results(py::module_& module) {
  using Contact = ContactOfRun<dim>;
  const auto array = [](auto Contact::*member) { return [member](const Contact& self) { return self.*member; }; };
  py::class_<Contact>(module, "Contact",
                      either<dim>("A contact pair. Computed, not guaranteed. Forces are by thickness.",
                                  "A contact pair. Computed, not guaranteed."))
      .def_readonly("name", &Contact::name, "As the scene has it; may be empty.")
      .def_readonly("first", &Contact::first, "The parts of the first side.")
      .def_readonly("second", &Contact::second)
      .def_property_readonly(
          "force", [](const Contact& self) { return array_of(self.result.resultant.force.data(), {dim}); },
          either<dim>("(2,), what acts on the body of the first side.",
                      "(3,), what acts on the body of the first side."))
      .def_property_readonly(
          "largest_pressure", [](const Contact& self) { return self.result.largest_pressure; }, "Force by area.")
      .def_property_readonly(
          "at", [](const Contact& self) { return array_of(self.result.at.data(), {dim}); },
          either<dim>("(2,), a vertex with the largest pressure.", "(3,), a vertex with the largest pressure."))
      .def_property_readonly(either<dim>("length", "area"), [](const Contact& self) { return self.result.length; })
      .def_property_readonly(either<dim>("pressed_length", "pressed_area"),
                             [](const Contact& self) { return self.result.pressed_length; })
      .def_property_readonly("points", array(&Contact::points),
                             either<dim>("(k, 2, 2), the ends of each edge of the first side that is in contact.",
                                         "(k, 3, 3), the vertices of each face of the first side that is in contact."))
      .def_property_readonly(
          "pressure", array(&Contact::pressure),
          either<dim>("(k, n), Bernstein coefficients from the first end on, >= 0; the first and the last are "
                      "its values at the ends.",
                      "(k, 3), its values at the vertices, linear between, >= 0."))
      .def_property_readonly(
          "gap", array(&Contact::gap),
          either<dim>(
              "(k, n), what the displacements leave of the gap, likewise.",
              "(k, 6), what the displacements leave of the gap: its values at the vertices, then the Bernstein\n"
              "coefficients of the edges opposite to them."));
}

template std::vector<ContactOfRun<2>> contacts_of(const Result<2>&);
template std::vector<ContactOfRun<3>> contacts_of(const Result<3>&);
template void add_contact_results<2>(py::module_&);
template void add_contact_results<3>(py::module_&);

}  // namespace bracket::python
