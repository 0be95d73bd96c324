// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <variant>

#include "apps/python/arrays.h"
#include "apps/python/functions.h"
#include "apps/python/module.h"
#include "apps/python/options.h"

namespace bracket::python {

namespace {

using Scene = scene::Scene<2>;
using Pair = std::array<double, 2>;

scene::Vector<2> vector_of(const Pair& pair) { return {pair[0], pair[1]}; }

std::vector<std::string> names_of(const py::object& given, const std::string& what) {
  if (py::isinstance<py::str>(given)) return {given.cast<std::string>()};
  try {
    return given.cast<std::vector<std::string>>();
  } catch (const py::cast_error&) {
    throw py::type_error(what + " must be the name of a boundary part, or a list of names");
  }
}

Scene make_scene(const std::string& title, const std::string& units, const std::string& plane) {
  Scene made;
  made.title = title;
  made.units = units;
  made.plane = option_of<scene::Plane>(plane, "plane");
  return made;
}

void set_mesh(Scene& scene, const py::object& vertices, const py::object& cells, const py::dict& bodies,
              const py::dict& parts, double merge) {
  scene::GivenMesh<2> mesh;
  mesh.vertices = points(vertices, "vertices");
  const Integers corners = integers(cells, "cells", {3});
  for (std::size_t i = 0; i < corners.rows; ++i)
    mesh.cells.push_back({corners.values[3 * i], corners.values[3 * i + 1], corners.values[3 * i + 2]});
  for (const auto& [name, members] : bodies) {
    const auto body = name.cast<std::string>();
    mesh.bodies[body] = integers(members, "bodies['" + body + "']", {1}).values;
  }
  for (const auto& [name, edges] : parts) {
    const auto part = name.cast<std::string>();
    const Integers ends = integers(edges, "parts['" + part + "']", {2});
    for (std::size_t i = 0; i < ends.rows; ++i)
      mesh.parts[part].push_back({ends.values[2 * i], ends.values[2 * i + 1]});
    mesh.parts.try_emplace(part);
  }
  scene.given = std::move(mesh);
  scene.merge = merge;
}

void add_body(Scene& scene, const std::string& name, std::optional<double> young, std::optional<double> poisson,
              const std::optional<std::array<std::array<double, 3>, 3>>& stiffness, const Pair& force) {
  if (stiffness ? young || poisson : !young || !poisson)
    throw py::value_error("the body '" + name + "' needs either E and nu, or stiffness");
  const auto material = [&] {
    if (!stiffness) return scene::isotropic<2>(*young, *poisson, scene.plane);
    scene::Elasticity<2> matrix;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) matrix(i, j) = (*stiffness)[i][j];
    return scene::anisotropic<2>(matrix);
  };
  scene::Body<2> body(material());
  body.force = vector_of(force);
  scene.bodies.insert_or_assign(name, body);
}

void set_vector(Scene& scene, scene::ConditionKind kind, const std::string& part, const py::object& x,
                const py::object& y) {
  const std::string what = scene::name(kind) + " of '" + part + "'";
  scene.boundary[part] = {kind, {function_of(x, what), function_of(y, what)}};
}

void set_number(Scene& scene, scene::ConditionKind kind, const std::string& part, const py::object& value) {
  scene.boundary[part] = {kind, {function_of(value, scene::name(kind) + " of '" + part + "'")}};
}

void add_contact(Scene& scene, const py::object& first, const py::object& second, const py::object& gap,
                 const std::string& name, int zones, const std::string& law, const py::object& value, bool lifts_off,
                 const std::optional<std::array<py::object, 2>>& jump) {
  scene::ContactPair<2> pair;
  pair.law = option_of<scene::Law>(law, "law");
  if (!value.is_none()) pair.value = function_of(value, "value");
  pair.lifts_off = lifts_off;
  pair.first = names_of(first, "first");
  if (py::isinstance<scene::LineObstacle>(second))
    pair.second = second.cast<scene::LineObstacle>();
  else if (py::isinstance<scene::CircleObstacle>(second))
    pair.second = second.cast<scene::CircleObstacle>();
  else
    pair.second = names_of(second, "second");
  if (!gap.is_none()) pair.gap = function_of(gap, "gap");
  if (jump) pair.jump = {function_of((*jump)[0], "jump"), function_of((*jump)[1], "jump")};
  pair.name = name;
  pair.zones = zones;
  scene.contact.push_back(std::move(pair));
}

void add_bond(Scene& scene, const py::object& first, const py::object& second) {
  scene.bonds.push_back({names_of(first, "first"), names_of(second, "second")});
}

void add_curve(Scene& scene, const std::string& part, const std::optional<Pair>& center, std::optional<double> radius) {
  if (center.has_value() != radius.has_value()) throw py::value_error("a circle needs both center and radius");
  scene::Curve curve;
  if (center) curve.circle = scene::Circle{vector_of(*center), *radius};
  scene.curves[part] = curve;
}

void add_quantity(Scene& scene, const std::string& name, const std::string& kind, const std::string& of,
                  const std::optional<std::variant<Pair, std::string>>& direction,
                  const std::optional<std::string>& component, const std::optional<Pair>& stretch,
                  const py::object& weight, double target, double absolute) {
  scene::Quantity<2> quantity;
  quantity.name = name;
  quantity.kind = option_of<scene::QuantityKind>(kind, "kind");
  quantity.of = of;
  using enum scene::QuantityKind;
  const bool directed = quantity.kind == displacement || quantity.kind == body || quantity.kind == reaction;
  const std::string* word = direction ? std::get_if<std::string>(&*direction) : nullptr;
  if (directed != direction.has_value() || (word != nullptr && *word != "normal"))
    throw py::value_error(
        "a direction, (x, y) or \"normal\", belongs to a displacement, a body or a reaction, which need one");
  if (direction && word == nullptr) quantity.direction = vector_of(std::get<Pair>(*direction));
  if (component.has_value() != (quantity.kind == stress) && !(component && quantity.kind == force))
    throw py::value_error(
        "a component belongs to a stress, which needs one (xx, yy, xy or mean), or a force (normal or shear)");
  if (component && quantity.kind == force)
    quantity.of_force = option_of<scene::ForceComponent>(*component, "component");
  else if (component)
    quantity.component = option_of<scene::StressComponent>(*component, "component");
  if (stretch) quantity.stretch = scene::LineStretch{(*stretch)[0], (*stretch)[1]};
  if (!weight.is_none()) quantity.weight = function_of(weight, "weight");
  quantity.target = target;
  quantity.absolute = absolute;
  scene.quantities.push_back(std::move(quantity));
}

void add_obstacles(py::module_& module) {
  py::class_<scene::LineObstacle>(module, "Line", "A straight wall that does not move, a second side of a contact.")
      .def(py::init([](const Pair& point, const Pair& normal) {
             return scene::LineObstacle{vector_of(point), vector_of(normal)};
           }),
           py::arg("point"), py::arg("normal"),
           "point: on the line. normal: to the side of the bodies, of any length.");
  py::class_<scene::CircleObstacle>(module, "Circle", "A circle that does not move, a second side of a contact.")
      .def(py::init([](const Pair& center, double radius, bool inside) {
             return scene::CircleObstacle{{vector_of(center), radius}, inside};
           }),
           py::arg("center"), py::arg("radius"), py::kw_only(), py::arg("inside") = false,
           "inside: whether the bodies are in it.");
}

void add_conditions(py::class_<Scene>& scene) {
  using enum scene::ConditionKind;
  scene
      .def(
          "set_fixed",
          [](Scene& self, const std::string& part, const py::object& x, const py::object& y) {
            set_vector(self, fixed, part, x, y);
          },
          py::arg("part"), py::arg("x"), py::arg("y"), "Prescribes the displacement of a boundary part, a length.")
      .def(
          "set_sliding",
          [](Scene& self, const std::string& part, const py::object& normal) {
            set_number(self, sliding, part, normal);
          },
          py::arg("part"), py::arg("normal"),
          "Prescribes the displacement along the outward normal, a length; there is no shear.")
      .def(
          "set_traction",
          [](Scene& self, const std::string& part, const py::object& x, const py::object& y) {
            set_vector(self, traction, part, x, y);
          },
          py::arg("part"), py::arg("x"), py::arg("y"), "Loads a boundary part, force by area.")
      .def(
          "set_pressure",
          [](Scene& self, const std::string& part, const py::object& value) {
            set_number(self, pressure, part, value);
          },
          py::arg("part"), py::arg("value"), "Loads a boundary part by a pressure, force by area; > 0 pushes.");
}

void add_parts(py::class_<Scene>& scene) {
  const auto none = py::none();
  scene
      .def(
          "add_block",
          [](Scene& self, const std::string& body, const Pair& x, const Pair& y, const std::array<int, 2>& cells,
             const std::string& name) {
            self.blocks.push_back({body, {{x, y}}, cells, "", name});
          },
          py::arg("body"), py::arg("x"), py::arg("y"), py::arg("cells"), py::kw_only(), py::arg("name") = "",
          "Adds a rectangle of cells[0] x cells[1] squares, each cut in two. x, y: (from, to), lengths. Its boundary\n"
          "parts are body.left, .right, .bottom and .top; with a name, body.name.left and so on.")
      .def("set_mesh", set_mesh, py::arg("vertices"), py::arg("cells"), py::kw_only(), py::arg("bodies") = py::dict(),
           py::arg("parts") = py::dict(), py::arg("merge") = 0.0,
           "Triangles of one's own, in place of blocks.\n\n"
           "vertices: (n, 2), lengths. cells: (m, 3), rows of `vertices`. bodies: for each name the rows of `cells`,\n"
           "(k,); without, all are one body, \"body\". parts: for each name its edges, (k, 2), rows of `vertices`.\n"
           "merge: vertices as close, a length, become one.\n"
           "Clockwise cells are turned; vertices without a cell are left out; bodies that share vertices are joined,\n"
           "but for the parts that a contact has as both sides.")
      .def(
          "add_body", add_body, py::arg("name"), py::kw_only(), py::arg("E") = none, py::arg("nu") = none,
          py::arg("stiffness") = none, py::arg("body_force") = Pair{0, 0},
          "The material of a body. E: force by area. stiffness: (3, 3), stress (xx, yy, xy) by strain (xx, yy, 2 xy).\n"
          "body_force: force by volume.")
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
      .def("add_bond", add_bond, py::arg("first"), py::arg("second"),
           "Two sides that stick, whatever pulls or shears; each a boundary part, or a list of them. They coincide "
           "node\n"
           "by node, and the mesh joins them.")
      .def("add_curve", add_curve, py::arg("part"), py::kw_only(), py::arg("center") = none, py::arg("radius") = none,
           "A boundary part that is an arc: of this circle, or of the one through its vertices.")
      .def("add_quantity", add_quantity, py::arg("name"), py::arg("kind"), py::arg("of") = "", py::kw_only(),
           py::arg("direction") = none, py::arg("component") = none, py::arg("stretch") = none,
           py::arg("weight") = none, py::arg("target") = 0.0, py::arg("absolute") = 0.0,
           "An interval for what you ask.\n\n"
           "kind, of: \"displacement\", \"rotation\" or \"reaction\" of a boundary part; \"body\", its mean\n"
           "displacement, or \"stress\", its mean, of a body; \"force\", \"opening\" or \"slip\" of a contact, by its\n"
           "name or its first part; \"energy\". direction: (x, y) or \"normal\", of displacement, body and reaction.\n"
           "component: \"xx\", \"yy\", \"xy\" or \"mean\", of stress; \"shear\", of force. stretch: (from, to) by arc "
           "length, or weight:\n"
           "a function, of force and opening. target, absolute: width to reach, relative or in the quantity's units.");
}

}  // namespace

void add_scene(py::module_& module) {
  add_obstacles(module);
  py::class_<Scene> scene(module, "Scene",
                          "Elastic bodies in the plane, their supports, loads and contact, in the keys of the scene\n"
                          "file (docs/scene-file.md) and in units of your own. What is a function of position is a\n"
                          "number, an expression in x and y (a str), or a callable f(x, y) of two floats. Callables\n"
                          "are known but where they are sampled: the guarantee is then \"discretisation\".");
  scene
      .def(py::init(&make_scene), py::kw_only(), py::arg("title") = "", py::arg("units") = "",
           py::arg("plane") = "strain", "units: a label, such as \"N, mm, MPa\". plane: \"strain\" or \"stress\".")
      .def_readonly("file", &Scene::file, "Where it was read from; empty: made in code.")
      .def_readonly("title", &Scene::title)
      .def_readonly("units", &Scene::units)
      .def_property_readonly("plane", [](const Scene& self) { return scene::name(self.plane); })
      .def("__copy__", [](const Scene& self) { return Scene(self); })
      .def("__repr__", [](const Scene& self) {
        return fmt::format("<bracket.Scene {}>", py::repr(py::str(self.title)).cast<std::string>());
      });
  add_parts(scene);
  add_conditions(scene);
  add_settings(scene);
  module.def(
      "read_scene",
      [](const std::filesystem::path& file, const std::vector<std::string>& overrides) {
        return scene::read_scene<2>(file, overrides);
      },
      py::arg("file"), py::arg("overrides") = std::vector<std::string>(),
      "Reads a scene file (TOML). overrides: lines \"key=value\" that replace or add keys, as --set does.");
}

}  // namespace bracket::python
