// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/python/scene.h"

#include <fmt/format.h>
#include <pybind11/stl.h>

#include "apps/python/arrays.h"
#include "apps/python/functions.h"
#include "apps/python/options.h"

namespace bracket::python {

namespace {

template <int dim> using Scene = scene::Scene<dim>;

template <int dim>
void set_mesh(Scene<dim>& scene, const py::object& vertices, const py::object& cells, const py::dict& bodies,
              const py::dict& parts, double merge) {
  scene::GivenMesh<dim> mesh;
  mesh.vertices = points<dim>(vertices, "vertices");
  const Integers corners = integers(cells, "cells", {dim + 1});
  for (std::size_t i = 0; i < corners.rows; ++i)
    std::copy_n(corners.values.begin() + static_cast<std::ptrdiff_t>((dim + 1) * i), dim + 1,
                mesh.cells.emplace_back().begin());
  for (const auto& [name, members] : bodies) {
    const auto body = name.template cast<std::string>();
    mesh.bodies[body] = integers(members, "bodies['" + body + "']", {1}).values;
  }
  for (const auto& [name, facets] : parts) {
    const auto part = name.template cast<std::string>();
    const Integers rows = integers(facets, "parts['" + part + "']", {dim});
    auto& own = mesh.parts[part];
    for (std::size_t i = 0; i < rows.rows; ++i)
      std::copy_n(rows.values.begin() + static_cast<std::ptrdiff_t>(dim * i), dim, own.emplace_back().begin());
  }
  scene.given = std::move(mesh);
  scene.merge = merge;
}

template <int dim> using Matrix = std::array<std::array<double, scene::n_voigt<dim>>, scene::n_voigt<dim>>;

template <int dim>
void add_body(Scene<dim>& scene, const std::string& name, std::optional<double> young, std::optional<double> poisson,
              const std::optional<Matrix<dim>>& stiffness, const Components<dim>& force) {
  if (stiffness ? young || poisson : !young || !poisson)
    throw py::value_error("the body '" + name + "' needs either E and nu, or stiffness");
  const auto material = [&] {
    if (!stiffness) return scene::isotropic<dim>(*young, *poisson, scene.plane);
    scene::Elasticity<dim> matrix;
    for (int i = 0; i < scene::n_voigt<dim>; ++i)
      for (int j = 0; j < scene::n_voigt<dim>; ++j) matrix(i, j) = (*stiffness)[i][j];
    return scene::anisotropic<dim>(matrix);
  };
  scene::Body<dim> body(material());
  body.force = vector_of<dim>(force);
  scene.bodies.insert_or_assign(name, body);
}

/// \param value a component each
template <int dim, class... Value>
void set_vector(Scene<dim>& scene, scene::ConditionKind kind, const std::string& part, const Value&... value) {
  const std::string what = scene::name(kind) + " of '" + part + "'";
  scene.boundary[part] = {kind, {function_of<dim>(value, what)...}};
}

template <int dim>
void set_number(Scene<dim>& scene, scene::ConditionKind kind, const std::string& part, const py::object& value) {
  scene.boundary[part] = {kind, {function_of<dim>(value, scene::name(kind) + " of '" + part + "'")}};
}

/// The methods of what needs as many functions as there are dimensions.
template <int dim>
void add_vector_condition(py::class_<Scene<dim>>& scene, const char* name, scene::ConditionKind kind, const char* doc) {
  if constexpr (dim == 2)
    scene.def(
        name,
        [kind](Scene<2>& self, const std::string& part, const py::object& x, const py::object& y) {
          set_vector<2>(self, kind, part, x, y);
        },
        py::arg("part"), py::arg("x"), py::arg("y"), doc);
  if constexpr (dim == 3)
    scene.def(
        name,
        [kind](Scene<3>& self, const std::string& part, const py::object& x, const py::object& y, const py::object& z) {
          set_vector<3>(self, kind, part, x, y, z);
        },
        py::arg("part"), py::arg("x"), py::arg("y"), py::arg("z"), doc);
}

template <int dim> void add_conditions(py::class_<Scene<dim>>& scene) {
  using enum scene::ConditionKind;
  add_vector_condition<dim>(scene, "set_fixed", fixed, "Prescribes the displacement of a boundary part, a length.");
  scene.def(
      "set_sliding",
      [](Scene<dim>& self, const std::string& part, const py::object& normal) {
        set_number(self, sliding, part, normal);
      },
      py::arg("part"), py::arg("normal"),
      "Prescribes the displacement along the outward normal, a length; there is no shear.");
  add_vector_condition<dim>(scene, "set_traction", traction, "Loads a boundary part, force by area.");
  scene.def(
      "set_pressure",
      [](Scene<dim>& self, const std::string& part, const py::object& value) {
        set_number(self, pressure, part, value);
      },
      py::arg("part"), py::arg("value"), "Loads a boundary part by a pressure, force by area; > 0 pushes.");
}

void add_block(py::class_<Scene<2>>& scene) {
  scene.def(
      "add_block",
      [](Scene<2>& self, const std::string& body, const Components<2>& x, const Components<2>& y,
         const std::array<int, 2>& cells, const std::string& name) {
        self.blocks.push_back({body, {{x, y}}, cells, "", name});
      },
      py::arg("body"), py::arg("x"), py::arg("y"), py::arg("cells"), py::kw_only(), py::arg("name") = "",
      "Adds a rectangle of cells[0] x cells[1] squares, each cut in two. x, y: (from, to), lengths. Its boundary\n"
      "parts are body.left, .right, .bottom and .top; with a name, body.name.left and so on.");
}
void add_block(py::class_<Scene<3>>& scene) {
  scene.def(
      "add_block",
      [](Scene<3>& self, const std::string& body, const Components<2>& x, const Components<2>& y,
         const Components<2>& z, const std::array<int, 3>& cells, const std::string& name) {
        self.blocks.push_back({body, {{x, y, z}}, cells, "", name});
      },
      py::arg("body"), py::arg("x"), py::arg("y"), py::arg("z"), py::arg("cells"), py::kw_only(), py::arg("name") = "",
      "Adds a box of cells[0] x cells[1] x cells[2] cuboids, each cut in six. x, y, z: (from, to), lengths. Its\n"
      "boundary parts are body.left, .right along x, .bottom, .top along y, .back and .front along z; with a name,\n"
      "body.name.left and so on.");
}

template <int dim> void add_parts(py::class_<Scene<dim>>& scene) {
  const auto none = py::none();
  add_block(scene);
  scene
      .def(
          "set_mesh", set_mesh<dim>, py::arg("vertices"), py::arg("cells"), py::kw_only(),
          py::arg("bodies") = py::dict(), py::arg("parts") = py::dict(), py::arg("merge") = 0.0,
          either<dim>(
              "Triangles of one's own, in place of blocks.\n\n"
              "vertices: (n, 2), lengths. cells: (m, 3), rows of `vertices`. bodies: for each name the rows of "
              "`cells`,\n"
              "(k,); without, all are one body, \"body\". parts: for each name its edges, (k, 2), rows of `vertices`.\n"
              "merge: vertices as close, a length, become one.\n"
              "Clockwise cells are turned; vertices without a cell are left out; bodies that share vertices are "
              "joined,\n"
              "but for the parts that a contact has as both sides.",
              "Tetrahedra of one's own, in place of blocks.\n\n"
              "vertices: (n, 3), lengths. cells: (m, 4), rows of `vertices`. bodies: for each name the rows of "
              "`cells`,\n"
              "(k,); without, all are one body, \"body\". parts: for each name its faces, (k, 3), rows of `vertices`.\n"
              "merge: vertices as close, a length, become one.\n"
              "Cells that are inside out are turned; vertices without a cell are left out; bodies that share vertices\n"
              "are joined, but for the parts that a contact has as both sides."))
      .def(
          "add_body", add_body<dim>, py::arg("name"), py::kw_only(), py::arg("E") = none, py::arg("nu") = none,
          py::arg("stiffness") = none, py::arg("body_force") = Components<dim>{},
          either<dim>(
              "The material of a body. E: force by area. stiffness: (3, 3), stress (xx, yy, xy) by strain (xx, yy, 2 "
              "xy).\n"
              "body_force: force by volume.",
              "The material of a body. E: force by area. stiffness: (6, 6), stress (xx, yy, zz, yz, xz, xy) by strain\n"
              "(xx, yy, zz, 2 yz, 2 xz, 2 xy). body_force: force by volume."))
      .def(
          "add_bond",
          [](Scene<dim>& self, const py::object& first, const py::object& second) {
            self.bonds.push_back({names_of(first, "first"), names_of(second, "second")});
          },
          py::arg("first"), py::arg("second"),
          "Two sides that stick, whatever pulls or shears; each a boundary part, or a list of them. They coincide "
          "node\n"
          "by node, and the mesh joins them.");
}

template <int dim> py::class_<Scene<dim>> scene_class(py::module_& module);
template <> py::class_<Scene<2>> scene_class(py::module_& module) {
  py::class_<Scene<2>> scene(
      module, "Scene",
      "Elastic bodies in the plane, their supports, loads and contact, in the keys of the scene\n"
      "file (docs/scene-file.md) and in units of your own. What is a function of position is a\n"
      "number, an expression in x and y (a str), or a callable f(x, y) of two floats. Callables\n"
      "are known but where they are sampled: the guarantee is then \"discretisation\".");
  scene
      .def(py::init([](const std::string& title, const std::string& units, const std::string& plane) {
             Scene<2> made;
             made.title = title;
             made.units = units;
             made.plane = option_of<scene::Plane>(plane, "plane");
             return made;
           }),
           py::kw_only(), py::arg("title") = "", py::arg("units") = "", py::arg("plane") = "strain",
           "units: a label, such as \"N, mm, MPa\". plane: \"strain\" or \"stress\".")
      .def_property_readonly("plane", [](const Scene<2>& self) { return scene::name(self.plane); });
  return scene;
}
template <> py::class_<Scene<3>> scene_class(py::module_& module) {
  py::class_<Scene<3>> scene(
      module, "Scene",
      "Elastic bodies in space, their supports, loads and contact, as `bracket.Scene` is of the\n"
      "plane. Expressions are in x, y and z, callables f(x, y, z) of three floats.");
  scene.def(py::init([](const std::string& title, const std::string& units) {
              Scene<3> made;
              made.title = title;
              made.units = units;
              return made;
            }),
            py::kw_only(), py::arg("title") = "", py::arg("units") = "", "units: a label, such as \"N, mm, MPa\".");
  return scene;
}

}  // namespace

std::vector<std::string> names_of(const py::object& given, const std::string& what) {
  if (py::isinstance<py::str>(given)) return {given.cast<std::string>()};
  try {
    return given.cast<std::vector<std::string>>();
  } catch (const py::cast_error&) {
    throw py::type_error(what + " must be the name of a boundary part, or a list of names");
  }
}

template <int dim> void add_scene(py::module_& module) {
  py::class_<Scene<dim>> scene = scene_class<dim>(module);
  scene
      .def_property_readonly(
          "dim", [](const Scene<dim>&) { return dim; }, either<dim>("2.", "3."))
      .def_readonly("file", &Scene<dim>::file, "Where it was read from; empty: made in code.")
      .def_readonly("title", &Scene<dim>::title)
      .def_readonly("units", &Scene<dim>::units)
      .def("__copy__", [](const Scene<dim>& self) { return Scene<dim>(self); })
      .def("__repr__", [](const Scene<dim>& self) {
        return fmt::format("<bracket.{}Scene {}>", either<dim>("", "space."),
                           py::repr(py::str(self.title)).template cast<std::string>());
      });
  add_parts(scene);
  add_contacts(scene);
  add_quantities(scene);
  add_conditions(scene);
  add_settings(scene);
}

template void add_scene<2>(py::module_&);
template void add_scene<3>(py::module_&);

}  // namespace bracket::python
