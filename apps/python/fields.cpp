// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/stl.h>

#include "apps/python/arrays.h"
#include "apps/python/module.h"

namespace bracket::python {

namespace {

using Mesh = scene::Mesh<2>;
using Displacement = scene::Displacement<2>;
using Stress = scene::Stress<2>;

/// By the name of each part the vertices of its edges.
py::dict parts_of(const Mesh& mesh) {
  std::vector<std::vector<std::array<int, 2>>> edges(mesh.parts.size());
  for (const Mesh::Facet& facet : mesh.boundary)
    if (facet.part != -1) edges[facet.part].push_back(facet.vertices);
  py::dict parts;
  for (std::size_t i = 0; i < edges.size(); ++i) parts[py::str(mesh.parts[i])] = array_of_rows(edges[i]);
  return parts;
}

/// \param inside values for each edge or cell
py::array_t<double> values_inside(const std::vector<scene::Vector<2>>& values, int inside) {
  const auto count = inside == 0 ? 0 : static_cast<py::ssize_t>(values.size()) / inside;
  return array_of(values.empty() ? nullptr : values.front().data(), {count, inside, 2});
}

py::array_t<double> coefficients_of(const Stress& stress) {
  std::vector<double> all;
  for (const auto& cell : stress.cell)
    for (const scene::Voigt<2>& s : cell) all.insert(all.end(), s.begin(), s.end());
  return array_of(all.data(), {static_cast<py::ssize_t>(stress.cell.size()), 3, scene::n_bernstein(stress.degree), 3});
}

}  // namespace

void add_fields(py::module_& module) {
  py::class_<Mesh>(module, "Mesh", "A triangulation of all bodies. Arrays are copies. Components share no vertices.")
      .def_property_readonly(
          "vertices", [](const Mesh& self) { return array_of(self.vertices); }, "(n, 2), lengths.")
      .def_property_readonly(
          "cells", [](const Mesh& self) { return array_of_rows(self.cells); },
          "(m, 3), rows of `vertices`, counter-clockwise.")
      .def_property_readonly(
          "cell_body",
          [](const Mesh& self) {
            return array_of(self.cell_body.data(), {static_cast<py::ssize_t>(self.cell_body.size())});
          },
          "(m,), places in `bodies`.")
      .def_readonly("bodies", &Mesh::bodies, "Names.")
      .def_property_readonly(
          "edges", [](const Mesh& self) { return array_of_rows(self.edges); }, "(k, 2), the lower vertex first.")
      .def_property_readonly(
          "cell_edges", [](const Mesh& self) { return array_of_rows(self.cell_edges); },
          "(m, 3), rows of `edges`: those opposite to the cell's vertices 0, 1, 2.")
      .def_property_readonly("parts", parts_of,
                             "By the name of each boundary part its edges, (k, 2), with the body to the left.")
      .def_readonly("notes", &Mesh::notes, "What was mended, a line each.");

  py::class_<Displacement>(module, "Displacement",
                           "u_h, on each cell a polynomial, by its values at equally spaced points, lengths. Arrays "
                           "are copies.")
      .def_readonly("degree", &Displacement::degree, "1 to 4.")
      .def_property_readonly(
          "vertex", [](const Displacement& self) { return array_of(self.vertex); }, "(n, 2), at `Mesh.vertices`.")
      .def_property_readonly(
          "edge", [](const Displacement& self) { return values_inside(self.edge, scene::n_inside_edge(self.degree)); },
          "(k, degree - 1, 2), inside of `Mesh.edges`, from the lower vertex to the higher; none of degree 1.")
      .def_property_readonly(
          "cell", [](const Displacement& self) { return values_inside(self.cell, scene::n_inside_cell(self.degree)); },
          "(m, (degree - 1)(degree - 2)/2, 2), inside of `Mesh.cells`: of degree 3 at the centroid, of degree 4\n"
          "next to the vertices 0, 1, 2; none below.");

  py::class_<Stress>(module, "Stress",
                     "The stress in equilibrium, a polynomial on the three parts of each cell, which meet at its\n"
                     "centroid; part k holds the edge opposite to vertex k. Arrays are copies.")
      .def_readonly("degree", &Stress::degree, "1 to 3.")
      .def_property_readonly("coefficients", coefficients_of,
                             "(m, 3, (degree + 1)(degree + 2)/2, 3), Bernstein coefficients of each part, force by\n"
                             "area, (xx, yy, xy).\n"
                             "Those at 0, degree and -1 are its values at the ends of the edge, in the order of\n"
                             "`Mesh.cells` from vertex k + 1 on, and at the centroid.");
}

}  // namespace bracket::python
