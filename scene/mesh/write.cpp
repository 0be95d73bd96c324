// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/mesh/write.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <iterator>

#include "scene/mesh/abaqus_cards.h"
#include "scene/text.h"

namespace bracket::scene {

namespace {

using Text = fmt::memory_buffer;

template <class... Values> void add(Text& text, fmt::format_string<Values...> format, Values&&... values) {
  fmt::format_to(std::back_inserter(text), format, std::forward<Values>(values)...);
}

/// The nodes: vertices and, of degree 2, midpoints of edges.
template <int dim> std::vector<Vector<dim>> nodes_of(const Mesh<dim>& mesh, int degree) {
  std::vector<Vector<dim>> nodes = mesh.vertices;
  if (degree == 2)
    for (const auto& [a, b] : mesh.edges) nodes.push_back(0.5 * (mesh.vertices[a] + mesh.vertices[b]));
  return nodes;
}

/// The edges at whose middles a quadratic cell or facet has its nodes behind the vertices, in the order that all
/// formats have, but for the last two of a tetrahedron in Gmsh: as Simplex<d>::edges has them.
template <int d>
constexpr auto edge_order = [] {
  if constexpr (d == 1) return std::array<int, 1>{0};
  if constexpr (d == 2) return std::array<int, 3>{2, 0, 1};
  if constexpr (d == 3) return std::array<int, 6>{2, 0, 1, 3, 4, 5};
}();

/// The nodes of a cell, from 0: its vertices, then the middles of its edges.
template <int dim> std::vector<int> nodes_of_cell(const Mesh<dim>& mesh, int degree, int cell) {
  std::vector<int> nodes(mesh.cells[cell].begin(), mesh.cells[cell].end());
  if (degree == 2)
    for (const int edge : edge_order<dim>)
      nodes.push_back(static_cast<int>(mesh.vertices.size()) + mesh.cell_edges[cell][edge]);
  return nodes;
}

template <int dim>
std::vector<int> nodes_of_facet(const Mesh<dim>& mesh, int degree, const typename Mesh<dim>::Facet& facet) {
  std::vector<int> nodes(facet.vertices.begin(), facet.vertices.end());
  const auto edges = facet_edges<dim>(mesh, facet);
  if (degree == 2)
    for (const int edge : edge_order<dim - 1>) nodes.push_back(static_cast<int>(mesh.vertices.size()) + edges[edge]);
  return nodes;
}

template <int dim> constexpr int n_nodes(int degree) { return degree == 2 ? Simplex<dim>::n_quadratic : dim + 1; }

void refuse_name(const std::string& name, const char* program, const std::string& why) {
  fail(Status::input, "", fmt::format("the name '{}' cannot be written for {}: {}", name, program, why));
}

bool holds(const std::string& name, std::string_view characters) {
  return name.find_first_of(characters) != std::string::npos;
}

/// The coordinates of a node, with a third one in the plane.
std::string coordinates(const Vector<2>& x) { return fmt::format("{:.17g} {:.17g} 0", x[0], x[1]); }
std::string coordinates(const Vector<3>& x) { return fmt::format("{:.17g} {:.17g} {:.17g}", x[0], x[1], x[2]); }

// ---- Gmsh -----------------------------------------------------------------------------------------------------------

/// Nodes of a cell, in Gmsh's order.
std::vector<int> in_gmsh(std::vector<int> nodes) {
  if (nodes.size() == 10) std::swap(nodes[8], nodes[9]);
  return nodes;
}

void add_element(Text& text, std::size_t tag, int type, int physical, const std::vector<int>& nodes) {
  add(text, "{} {} 2 {} {}", tag, type, physical, physical);
  for (const int node : nodes) add(text, " {}", node + 1);
  add(text, "\n");
}

/// Gmsh's numbers of segments, triangles and tetrahedra.
template <int d> constexpr int gmsh_type(int degree) {
  constexpr std::array<int, 3> linear = {1, 2, 4}, quadratic = {8, 9, 11};
  return degree == 2 ? quadratic[d - 1] : linear[d - 1];
}

// ---- Abaqus ---------------------------------------------------------------------------------------------------------

/// The shortest text that reads back to the same number. CalculiX cuts it off after 20 characters, which must not take
/// an exponent away.
std::string abaqus_number(double x) {
  constexpr std::ptrdiff_t read_by_calculix = 20;
  std::array<char, 400> text;
  auto end = std::to_chars(text.begin(), text.end(), x).ptr;
  if (end - text.begin() > read_by_calculix)
    end = std::to_chars(text.begin(), text.end(), x, std::chars_format::fixed).ptr;
  std::string number(text.begin(), end);
  if (!holds(number, ".en")) number += '.';
  return number;
}

template <int dim> void add_node(Text& text, std::size_t number, const Vector<dim>& x) {
  add(text, "{}", number);
  for (const double coordinate : x) add(text, ", {}", abaqus_number(coordinate));
  add(text, "\n");
}

/// Refuses names that would not be read as they are, or not be told apart.
void check_abaqus_names(const std::vector<std::string>& names) {
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string& name = names[i];
    constexpr const char* program = "Abaqus and CalculiX";
    if (holds(name, "\"\n\r")) refuse_name(name, program, "it has a quote or does not fit on one line");
    if (name.empty() || name.front() == ' ' || name.back() == ' ')
      refuse_name(name, program, "it begins or ends with a blank");
    if (name.size() > 80) refuse_name(name, program, "it has more than 80 characters");
    for (std::size_t j = 0; j < i; ++j)
      if (capitals(name) == capitals(names[j]))
        refuse_name(name, program, fmt::format("they take it for '{}', as they do not tell capitals", names[j]));
  }
}

std::string abaqus_name(const std::string& name) { return holds(name, ",") ? '"' + name + '"' : name; }

/// The number of the side that is facet k: of a triangle side 1 is that from corner 1 to corner 2; those of a
/// tetrahedron are 1-2-3, 1-4-2, 2-4-3, 3-4-1.
template <int dim>
constexpr auto abaqus_side = [] {
  if constexpr (dim == 2) return std::array<int, 3>{2, 3, 1};
  if constexpr (dim == 3) return std::array<int, 4>{3, 4, 2, 1};
}();

/// Numbers from 1, sixteen a line.
void add_numbers(Text& text, const std::vector<int>& places) {
  for (std::size_t i = 0; i < places.size(); ++i)
    add(text, "{}{}", places[i] + 1, i + 1 == places.size() || i % 16 == 15 ? "\n" : ", ");
}

template <int dim> void add_abaqus_part(Text& text, const Mesh<dim>& mesh, int degree, int part) {
  const std::string name = abaqus_name(mesh.parts[part]);
  std::vector<int> nodes;
  add(text, "*SURFACE, TYPE=ELEMENT, NAME={}\n", name);
  for (const auto& facet : mesh.boundary) {
    if (facet.part != part) continue;
    add(text, "{}, S{}\n", facet.cell + 1, abaqus_side<dim>[facet.local]);
    const std::vector<int> of_facet = nodes_of_facet(mesh, degree, facet);
    nodes.insert(nodes.end(), of_facet.begin(), of_facet.end());
  }
  std::ranges::sort(nodes);
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  add(text, "*NSET, NSET={}\n", name);
  add_numbers(text, nodes);
}

// ---- VTK ------------------------------------------------------------------------------------------------------------

template <int dim> constexpr int vtk_type(int degree) {
  return dim == 2 ? (degree == 2 ? 22 : 5) : (degree == 2 ? 24 : 10);
}

void begin_array(Text& text, const char* type, const char* name, const char* more = "") {
  add(text, "<DataArray type=\"{}\" Name=\"{}\"{} format=\"ascii\">\n", type, name, more);
}

}  // namespace

template <int dim> std::string gmsh_text(const Mesh<dim>& mesh, int degree) {
  for (const auto* names : {&mesh.bodies, &mesh.parts})
    for (const std::string& name : *names)
      if (holds(name, "\"\n\r")) refuse_name(name, "Gmsh", "it has a quote or does not fit on one line");
  Text text;
  add(text, "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n{}\n", mesh.bodies.size() + mesh.parts.size());
  for (std::size_t i = 0; i < mesh.parts.size(); ++i) add(text, "{} {} \"{}\"\n", dim - 1, i + 1, mesh.parts[i]);
  for (std::size_t i = 0; i < mesh.bodies.size(); ++i) add(text, "{} {} \"{}\"\n", dim, i + 1, mesh.bodies[i]);
  const std::vector<Vector<dim>> nodes = nodes_of(mesh, degree);
  add(text, "$EndPhysicalNames\n$Nodes\n{}\n", nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) add(text, "{} {}\n", i + 1, coordinates(nodes[i]));
  const auto of_parts = std::ranges::count_if(mesh.boundary, [](const auto& facet) { return facet.part != -1; });
  add(text, "$EndNodes\n$Elements\n{}\n", static_cast<std::size_t>(of_parts) + mesh.cells.size());
  std::size_t tag = 0;
  for (const auto& facet : mesh.boundary)
    if (facet.part != -1)
      add_element(text, ++tag, gmsh_type<dim - 1>(degree), facet.part + 1, nodes_of_facet(mesh, degree, facet));
  for (int cell = 0; cell < static_cast<int>(mesh.cells.size()); ++cell)
    add_element(text, ++tag, gmsh_type<dim>(degree), mesh.cell_body[cell] + 1,
                in_gmsh(nodes_of_cell(mesh, degree, cell)));
  add(text, "$EndElements\n");
  return fmt::to_string(text);
}

template <int dim> std::string abaqus_text(const Mesh<dim>& mesh, int degree, Plane plane) {
  check_abaqus_names(mesh.bodies);
  check_abaqus_names(mesh.parts);
  Text text;
  add(text, "*NODE\n");
  const std::vector<Vector<dim>> nodes = nodes_of(mesh, degree);
  for (std::size_t i = 0; i < nodes.size(); ++i) add_node(text, i + 1, nodes[i]);
  add(text, "*ELEMENT, TYPE={}{}\n", dim == 3 ? "C3D" : plane == Plane::strain ? "CPE" : "CPS", n_nodes<dim>(degree));
  std::vector<std::vector<int>> of_body(mesh.bodies.size());
  for (int cell = 0; cell < static_cast<int>(mesh.cells.size()); ++cell) {
    add(text, "{}", cell + 1);
    for (const int node : nodes_of_cell(mesh, degree, cell)) add(text, ", {}", node + 1);
    add(text, "\n");
    of_body[mesh.cell_body[cell]].push_back(cell);
  }
  for (std::size_t body = 0; body < mesh.bodies.size(); ++body) {
    add(text, "*ELSET, ELSET={}\n", abaqus_name(mesh.bodies[body]));
    add_numbers(text, of_body[body]);
  }
  for (int part = 0; part < static_cast<int>(mesh.parts.size()); ++part) add_abaqus_part(text, mesh, degree, part);
  return fmt::to_string(text);
}

template <int dim> std::string vtu_text(const Mesh<dim>& mesh, int degree) {
  const std::vector<Vector<dim>> nodes = nodes_of(mesh, degree);
  Text text;
  add(text,
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
      "<UnstructuredGrid>\n<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n<Points>\n",
      nodes.size(), mesh.cells.size());
  begin_array(text, "Float64", "Points", " NumberOfComponents=\"3\"");
  for (const Vector<dim>& node : nodes) add(text, "{}\n", coordinates(node));
  add(text, "</DataArray>\n</Points>\n<Cells>\n");
  begin_array(text, "Int32", "connectivity");
  for (int cell = 0; cell < static_cast<int>(mesh.cells.size()); ++cell)
    add(text, "{}\n", fmt::join(nodes_of_cell(mesh, degree, cell), " "));
  add(text, "</DataArray>\n");
  begin_array(text, "Int32", "offsets");
  for (std::size_t cell = 1; cell <= mesh.cells.size(); ++cell)
    add(text, "{}\n", cell * static_cast<std::size_t>(n_nodes<dim>(degree)));
  add(text, "</DataArray>\n");
  begin_array(text, "UInt8", "types");
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) add(text, "{}\n", vtk_type<dim>(degree));
  add(text, "</DataArray>\n</Cells>\n<CellData Scalars=\"body\">\n");
  begin_array(text, "Int32", "body");
  for (const int body : mesh.cell_body) add(text, "{}\n", body);
  add(text, "</DataArray>\n</CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n");
  return fmt::to_string(text);
}

#define INSTANTIATE(dim)                                               \
  template std::string gmsh_text(const Mesh<dim>& mesh, int degree);   \
  template std::string abaqus_text(const Mesh<dim>& mesh, int, Plane); \
  template std::string vtu_text(const Mesh<dim>& mesh, int degree);
INSTANTIATE(2)
INSTANTIATE(3)
#undef INSTANTIATE

}  // namespace bracket::scene
