// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/stl.h>

#include "apps/python/functions.h"
#include "apps/python/options.h"
#include "apps/python/scene.h"

namespace bracket::python {

namespace {

/// A second side: one of these obstacles, or boundary parts.
template <class... Obstacle> scene::Side second_side(const py::object& given) {
  scene::Side side;
  const bool is_obstacle = ((py::isinstance<Obstacle>(given) && (side = given.cast<Obstacle>(), true)) || ...);
  if (!is_obstacle) side = names_of(given, "second");
  return side;
}

/// What pairs have in the plane and in space.
template <int dim>
scene::ContactPair<dim> pair_of(const py::object& first, scene::Side second, const py::object& gap,
                                const std::string& name, const std::string& law) {
  scene::ContactPair<dim> pair;
  pair.law = option_of<scene::Law>(law, "law");
  pair.first = names_of(first, "first");
  pair.second = std::move(second);
  if (!gap.is_none()) pair.gap = function_of<dim>(gap, "gap");
  pair.name = name;
  return pair;
}

void add_contact(scene::Scene<2>& scene, const py::object& first, const py::object& second, const py::object& gap,
                 const std::string& name, int zones, const std::string& law, const py::object& value, bool lifts_off,
                 const std::optional<std::array<py::object, 2>>& jump) {
  auto pair = pair_of<2>(first, second_side<scene::LineObstacle, scene::CircleObstacle>(second), gap, name, law);
  if (!value.is_none()) pair.value = function_of<2>(value, "value");
  pair.lifts_off = lifts_off;
  if (jump) pair.jump = {function_of<2>((*jump)[0], "jump"), function_of<2>((*jump)[1], "jump")};
  pair.zones = zones;
  scene.contact.push_back(std::move(pair));
}

void add_contact_in_space(scene::Scene<3>& scene, const py::object& first, const py::object& second,
                          const py::object& gap, const std::string& name, const std::string& law) {
  scene.contact.push_back(pair_of<3>(first, second_side<scene::PlaneObstacle>(second), gap, name, law));
}

void add_curve(scene::Scene<2>& scene, const std::string& part, const std::optional<Components<2>>& center,
               std::optional<double> radius) {
  if (center.has_value() != radius.has_value()) throw py::value_error("a circle needs both center and radius");
  scene::Curve curve;
  if (center) curve.circle = scene::Circle{vector_of<2>(*center), *radius};
  scene.curves[part] = curve;
}

}  // namespace

void add_obstacles(py::module_& module, py::module_& space) {
  py::class_<scene::LineObstacle>(module, "Line", "A straight wall that does not move, a second side of a contact.")
      .def(py::init([](const Components<2>& point, const Components<2>& normal) {
             return scene::LineObstacle{vector_of<2>(point), vector_of<2>(normal)};
           }),
           py::arg("point"), py::arg("normal"),
           "point: on the line. normal: to the side of the bodies, of any length.");
  py::class_<scene::CircleObstacle>(module, "Circle", "A circle that does not move, a second side of a contact.")
      .def(py::init([](const Components<2>& center, double radius, bool inside) {
             return scene::CircleObstacle{{vector_of<2>(center), radius}, inside};
           }),
           py::arg("center"), py::arg("radius"), py::kw_only(), py::arg("inside") = false,
           "inside: whether the bodies are in it.");
  py::class_<scene::PlaneObstacle>(space, "Plane", "A flat wall that does not move, a second side of a contact.")
      .def(py::init([](const Components<3>& point, const Components<3>& normal) {
             return scene::PlaneObstacle{vector_of<3>(point), vector_of<3>(normal)};
           }),
           py::arg("point"), py::arg("normal"),
           "point: on the plane. normal: to the side of the bodies, of any length.");
}

void add_contacts(py::class_<scene::Scene<2>>& scene) {
  const auto none = py::none();
  scene
      .def("add_contact", add_contact, py::arg("first"), py::arg("second"), py::arg("gap") = none, py::kw_only(),
           py::arg("name") = "", py::arg("zones") = 0, py::arg("law") = "frictionless", py::arg("value") = none,
           py::arg("lifts_off") = true, py::arg("jump") = none,
           "Contact of two sides. first: a boundary part, or a list of them. second: likewise, or\n"
           "\"rigid\", a wall along the first, a Line or a Circle. gap: a length, < 0 for interference;\n"
           "None: as drawn. zones: equally long stretches whose forces are wanted as intervals.\n"
           "law: \"bilateral\", without lift-off; \"winkler\", springs of modulus `value`, force by area and length;\n"
           "\"tresca\", friction up to a shear `value`, force by area; \"coulomb\", up to `value`\n"
           "times the pressure, which has intervals of its last step only. lifts_off: whether the sides of these two "
           "part.")
      .def("add_curve", add_curve, py::arg("part"), py::kw_only(), py::arg("center") = none, py::arg("radius") = none,
           "A boundary part that is an arc: of this circle, or of the one through its vertices.");
}

void add_contacts(py::class_<scene::Scene<3>>& scene) {
  scene.def("add_contact", add_contact_in_space, py::arg("first"), py::arg("second"), py::arg("gap") = py::none(),
            py::kw_only(), py::arg("name") = "", py::arg("law") = "frictionless",
            "Contact of two sides that coincide node by node. first: a boundary part, or a list of them. second:\n"
            "likewise, or \"rigid\", a wall along the first, or a Plane. gap: a length, < 0 for interference;\n"
            "None: as drawn. law: \"bilateral\", without lift-off.");
}

}  // namespace bracket::python
