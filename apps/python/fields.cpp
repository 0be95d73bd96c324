// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/stl.h>

#include "apps/python/arrays.h"
#include "apps/python/module.h"

namespace bracket::python {

namespace {

/// By the name of each part the vertices of its facets.
template <int dim> py::dict parts_of(const scene::Mesh<dim>& mesh) {
  std::vector<std::vector<std::array<int, dim>>> facets(mesh.parts.size());
  for (const auto& facet : mesh.boundary)
    if (facet.part != -1) facets[facet.part].push_back(facet.vertices);
  py::dict parts;
  for (std::size_t i = 0; i < facets.size(); ++i) parts[py::str(mesh.parts[i])] = array_of_rows(facets[i]);
  return parts;
}

/// \param inside values for each edge or cell
template <int dim> py::array_t<double> values_inside(const std::vector<scene::Vector<dim>>& values, int inside) {
  const auto count = inside == 0 ? 0 : static_cast<py::ssize_t>(values.size()) / inside;
  return array_of(values.empty() ? nullptr : values.front().data(), {count, inside, dim});
}

template <int dim> py::array_t<double> coefficients_of(const scene::Stress<dim>& stress) {
  std::vector<double> all;
  for (const auto& cell : stress.cell)
    for (const scene::Voigt<dim>& s : cell) all.insert(all.end(), s.begin(), s.end());
  return array_of(all.data(), {static_cast<py::ssize_t>(stress.cell.size()), dim + 1,
                               scene::n_bernstein<dim>(stress.degree), scene::n_voigt<dim>});
}

template <int dim> void add_mesh(py::module_& module) {
  using Mesh = scene::Mesh<dim>;
  py::class_<Mesh>(module, "Mesh",
                   either<dim>("A triangulation of all bodies. Arrays are copies. Components share no vertices.",
                               "Tetrahedra of all bodies. Arrays are copies. Components share no vertices."))
      .def_property_readonly(
          "vertices", [](const Mesh& self) { return array_of_vectors<dim>(self.vertices); },
          either<dim>("(n, 2), lengths.", "(n, 3), lengths."))
      .def_property_readonly(
          "cells", [](const Mesh& self) { return array_of_rows(self.cells); },
          either<dim>("(m, 3), rows of `vertices`, counter-clockwise.",
                      "(m, 4), rows of `vertices`: det(x1 - x0, x2 - x0, x3 - x0) > 0."))
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
          either<dim>("(m, 3), rows of `edges`: those opposite to the cell's vertices 0, 1, 2.",
                      "(m, 6), rows of `edges`: those between the cell's vertices 1 and 2, 2 and 0, 0 and 1, 0 and 3,\n"
                      "1 and 3, 2 and 3."))
      .def_property_readonly(
          "parts", parts_of<dim>,
          either<dim>("By the name of each boundary part its edges, (k, 2), with the body to the left.",
                      "By the name of each boundary part its faces, (k, 3), counter-clockwise as seen from outside."))
      .def_readonly("notes", &Mesh::notes, "What was mended, a line each.");
}

template <int dim> void add_displacement(py::module_& module) {
  using Displacement = scene::Displacement<dim>;
  py::class_<Displacement> displacement(
      module, "Displacement",
      "u_h, on each cell a polynomial, by its values at equally spaced points, lengths. Arrays are copies.");
  displacement.def_readonly("degree", &Displacement::degree, either<dim>("1 to 4.", "1 or 2."))
      .def_property_readonly(
          "vertex", [](const Displacement& self) { return array_of_vectors<dim>(self.vertex); },
          either<dim>("(n, 2), at `Mesh.vertices`.", "(n, 3), at `Mesh.vertices`."))
      .def_property_readonly(
          "edge",
          [](const Displacement& self) { return values_inside<dim>(self.edge, scene::n_inside_edge(self.degree)); },
          either<dim>(
              "(k, degree - 1, 2), inside of `Mesh.edges`, from the lower vertex to the higher; none of degree 1.",
              "(k, degree - 1, 3), in the middle of `Mesh.edges`; none of degree 1."));
  if constexpr (dim == 2)
    displacement.def_property_readonly(
        "cell",
        [](const Displacement& self) { return values_inside<dim>(self.cell, scene::n_inside_cell(self.degree)); },
        "(m, (degree - 1)(degree - 2)/2, 2), inside of `Mesh.cells`: of degree 3 at the centroid, of degree 4\n"
        "next to the vertices 0, 1, 2; none below.");
}

template <int dim> void add_stress(py::module_& module) {
  using Stress = scene::Stress<dim>;
  py::class_<Stress>(
      module, "Stress",
      either<dim>("The stress in equilibrium, a polynomial on the three parts of each cell, which meet at its\n"
                  "centroid; part k holds the edge opposite to vertex k. Arrays are copies.",
                  "The stress in equilibrium, linear on the four parts of each cell, which meet at its centroid; part "
                  "k\nholds the face opposite to vertex k. Arrays are copies."))
      .def_readonly("degree", &Stress::degree, either<dim>("1 to 3.", "1."))
      .def_property_readonly(
          "coefficients", coefficients_of<dim>,
          either<dim>("(m, 3, (degree + 1)(degree + 2)/2, 3), Bernstein coefficients of each part, force by\n"
                      "area, (xx, yy, xy).\n"
                      "Those at 0, degree and -1 are its values at the ends of the edge, in the order of\n"
                      "`Mesh.cells` from vertex k + 1 on, and at the centroid.",
                      "(m, 4, 4, 6), the values of each part at its corners, force by area, (xx, yy, zz, yz, xz, "
                      "xy).\n"
                      "Corners of the parts 0 to 3 are the vertices (1, 2, 3), (0, 3, 2), (0, 1, 3), (0, 2, 1) of the\n"
                      "cell, then its centroid."));
}

}  // namespace

template <int dim> void add_fields(py::module_& module) {
  add_mesh<dim>(module);
  add_displacement<dim>(module);
  add_stress<dim>(module);
}

template void add_fields<2>(py::module_&);
template void add_fields<3>(py::module_&);

}  // namespace bracket::python
