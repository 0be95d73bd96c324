// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// Planar: cells are triangles, what bounds them are lines.
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
std::vector<Vector<2>> nodes_of(const Mesh<2>& mesh, int degree) {
  std::vector<Vector<2>> nodes = mesh.vertices;
  if (degree == 2)
    for (const auto& [a, b] : mesh.edges) nodes.push_back(0.5 * (mesh.vertices[a] + mesh.vertices[b]));
  return nodes;
}

/// The nodes of a cell, from 0: its vertices, then the middles of its sides from the first vertex on, as all formats
/// have them.
std::vector<int> nodes_of_cell(const Mesh<2>& mesh, int degree, int cell) {
  std::vector<int> nodes(mesh.cells[cell].begin(), mesh.cells[cell].end());
  if (degree == 2)
    for (const int side : {2, 0, 1})  // side k is opposite to vertex k
      nodes.push_back(static_cast<int>(mesh.vertices.size()) + mesh.cell_edges[cell][side]);
  return nodes;
}

std::vector<int> nodes_of_facet(const Mesh<2>& mesh, int degree, const Mesh<2>::Facet& facet) {
  std::vector<int> nodes(facet.vertices.begin(), facet.vertices.end());
  if (degree == 2) nodes.push_back(static_cast<int>(mesh.vertices.size()) + facet.edge);
  return nodes;
}

void refuse_name(const std::string& name, const char* program, const std::string& why) {
  fail(Status::input, "", fmt::format("the name '{}' cannot be written for {}: {}", name, program, why));
}

bool holds(const std::string& name, std::string_view characters) {
  return name.find_first_of(characters) != std::string::npos;
}

// ---- Gmsh -----------------------------------------------------------------------------------------------------------

void add_element(Text& text, std::size_t tag, int type, int physical, const std::vector<int>& nodes) {
  add(text, "{} {} 2 {} {}", tag, type, physical, physical);
  for (const int node : nodes) add(text, " {}", node + 1);
  add(text, "\n");
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

/// Numbers from 1, sixteen a line.
void add_numbers(Text& text, const std::vector<int>& places) {
  for (std::size_t i = 0; i < places.size(); ++i)
    add(text, "{}{}", places[i] + 1, i + 1 == places.size() || i % 16 == 15 ? "\n" : ", ");
}

void add_abaqus_part(Text& text, const Mesh<2>& mesh, int degree, int part) {
  const std::string name = abaqus_name(mesh.parts[part]);
  std::vector<int> nodes;
  add(text, "*SURFACE, TYPE=ELEMENT, NAME={}\n", name);
  for (const auto& facet : mesh.boundary) {
    if (facet.part != part) continue;
    add(text, "{}, S{}\n", facet.cell + 1, (facet.local + 1) % 3 + 1);  // side 1 is that from corner 1 to corner 2
    const std::vector<int> of_facet = nodes_of_facet(mesh, degree, facet);
    nodes.insert(nodes.end(), of_facet.begin(), of_facet.end());
  }
  std::ranges::sort(nodes);
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  add(text, "*NSET, NSET={}\n", name);
  add_numbers(text, nodes);
}

// ---- VTK ------------------------------------------------------------------------------------------------------------

void begin_array(Text& text, const char* type, const char* name, const char* more = "") {
  add(text, "<DataArray type=\"{}\" Name=\"{}\"{} format=\"ascii\">\n", type, name, more);
}

}  // namespace

std::string gmsh_text(const Mesh<2>& mesh, int degree) {
  for (const auto* names : {&mesh.bodies, &mesh.parts})
    for (const std::string& name : *names)
      if (holds(name, "\"\n\r")) refuse_name(name, "Gmsh", "it has a quote or does not fit on one line");
  Text text;
  add(text, "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n{}\n", mesh.bodies.size() + mesh.parts.size());
  for (std::size_t i = 0; i < mesh.parts.size(); ++i) add(text, "1 {} \"{}\"\n", i + 1, mesh.parts[i]);
  for (std::size_t i = 0; i < mesh.bodies.size(); ++i) add(text, "2 {} \"{}\"\n", i + 1, mesh.bodies[i]);
  const std::vector<Vector<2>> nodes = nodes_of(mesh, degree);
  add(text, "$EndPhysicalNames\n$Nodes\n{}\n", nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) add(text, "{} {:.17g} {:.17g} 0\n", i + 1, nodes[i][0], nodes[i][1]);
  const auto of_parts = std::ranges::count_if(mesh.boundary, [](const auto& facet) { return facet.part != -1; });
  add(text, "$EndNodes\n$Elements\n{}\n", static_cast<std::size_t>(of_parts) + mesh.cells.size());
  std::size_t tag = 0;
  for (const auto& facet : mesh.boundary)
    if (facet.part != -1)
      add_element(text, ++tag, degree == 2 ? 8 : 1, facet.part + 1, nodes_of_facet(mesh, degree, facet));
  for (int cell = 0; cell < static_cast<int>(mesh.cells.size()); ++cell)
    add_element(text, ++tag, degree == 2 ? 9 : 2, mesh.cell_body[cell] + 1, nodes_of_cell(mesh, degree, cell));
  add(text, "$EndElements\n");
  return fmt::to_string(text);
}

std::string abaqus_text(const Mesh<2>& mesh, int degree, Plane plane) {
  check_abaqus_names(mesh.bodies);
  check_abaqus_names(mesh.parts);
  Text text;
  add(text, "*NODE\n");
  const std::vector<Vector<2>> nodes = nodes_of(mesh, degree);
  for (std::size_t i = 0; i < nodes.size(); ++i)
    add(text, "{}, {}, {}\n", i + 1, abaqus_number(nodes[i][0]), abaqus_number(nodes[i][1]));
  add(text, "*ELEMENT, TYPE={}{}\n", plane == Plane::strain ? "CPE" : "CPS", degree == 2 ? 6 : 3);
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

std::string vtu_text(const Mesh<2>& mesh, int degree) {
  const std::vector<Vector<2>> nodes = nodes_of(mesh, degree);
  Text text;
  add(text,
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
      "<UnstructuredGrid>\n<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n<Points>\n",
      nodes.size(), mesh.cells.size());
  begin_array(text, "Float64", "Points", " NumberOfComponents=\"3\"");
  for (const Vector<2>& node : nodes) add(text, "{:.17g} {:.17g} 0\n", node[0], node[1]);
  add(text, "</DataArray>\n</Points>\n<Cells>\n");
  begin_array(text, "Int32", "connectivity");
  for (int cell = 0; cell < static_cast<int>(mesh.cells.size()); ++cell)
    add(text, "{}\n", fmt::join(nodes_of_cell(mesh, degree, cell), " "));
  add(text, "</DataArray>\n");
  begin_array(text, "Int32", "offsets");
  for (std::size_t cell = 1; cell <= mesh.cells.size(); ++cell) add(text, "{}\n", cell * (degree == 2 ? 6 : 3));
  add(text, "</DataArray>\n");
  begin_array(text, "UInt8", "types");
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) add(text, "{}\n", degree == 2 ? 22 : 5);
  add(text, "</DataArray>\n</Cells>\n<CellData Scalars=\"body\">\n");
  begin_array(text, "Int32", "body");
  for (const int body : mesh.cell_body) add(text, "{}\n", body);
  add(text, "</DataArray>\n</CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n");
  return fmt::to_string(text);
}

}  // namespace bracket::scene
