// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>

#include <filesystem>
#include <functional>
#include <optional>

#include "scene/field/field.h"
#include "scene/mesh/write.h"
#include "tests/scene/inputs.h"
#include "tests/support/scenes.h"

/// Files of displacements for tests.
namespace bracket::scene::test {

/// A file of tests/fields.
inline std::filesystem::path given_file(const std::string& name) {
  return std::filesystem::path(BRACKET_FIELDS) / name;
}

/// A displacement of each body, by its number and place.
using Motion = std::function<Vector<2>(int body, const Vector<2>& x)>;

/// Linear in each body; tests/fields/make.py has the same.
inline Vector<2> linear_motion(int body, const Vector<2>& x) {
  if (body == 0) return {0.1 + 0.2 * x[0] - 0.3 * x[1], 0.4 * x[0] + 0.5 * x[1]};
  return {1 - 0.7 * x[0] + 0.11 * x[1], -2 + 0.13 * x[0] + 0.17 * x[1]};
}
inline Vector<2> quadratic_motion(int body, const Vector<2>& x) {
  return linear_motion(body, x) + Vector<2>(x[0] * x[1] + body * x[1] * x[1], 0.5 * x[0] * x[0] - x[1]);
}

/// Two blocks of n × n squares each, one on the other.
inline Mesh<2> two_blocks_mesh(int n) { return build_mesh(bracket::tests::two_blocks(n)); }

/// Nodes of a mesh: vertices and, of degree 2, midpoints of edges, each with the body that it belongs to.
struct Node {
  Vector<2> x;
  int body;
};
inline std::vector<Node> nodes_of(const Mesh<2>& mesh, int degree) {
  std::vector<Node> nodes(mesh.vertices.size() + (degree == 2 ? mesh.edges.size() : 0));
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) {
    for (const int vertex : mesh.cells[cell]) nodes[vertex] = {mesh.vertices[vertex], mesh.cell_body[cell]};
    if (degree == 1) continue;
    for (const int edge : mesh.cell_edges[cell]) {
      const auto& [a, b] = mesh.edges[edge];
      nodes[mesh.vertices.size() + edge] = {0.5 * (mesh.vertices[a] + mesh.vertices[b]), mesh.cell_body[cell]};
    }
  }
  return nodes;
}

/// An array of a vtu file. \param values one text for each point
inline std::string array(const std::string& name, int components, const std::vector<std::string>& values) {
  std::string text = fmt::format(
      "<DataArray type=\"Float64\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"ascii\">\n", name, components);
  for (const std::string& value : values) text += value + "\n";
  return text + "</DataArray>\n";
}
inline std::string with_point_data(const std::string& vtu, const std::string& arrays) {
  return replaced(vtu, "</Piece>", "<PointData>\n" + arrays + "</PointData>\n</Piece>");
}

/// The values of a motion at the nodes, with `third` behind each.
inline std::vector<std::string> values(const Mesh<2>& mesh, int degree, const Motion& motion,
                                       const std::string& third = " 0") {
  std::vector<std::string> result;
  for (const Node& node : nodes_of(mesh, degree)) {
    const Vector<2> u = motion(node.body, node.x);
    result.push_back(fmt::format("{:.17g} {:.17g}{}", u[0], u[1], third));
  }
  return result;
}
inline std::string vtu_of(const Mesh<2>& mesh, int degree, const Motion& motion) {
  return with_point_data(vtu_text(mesh, degree), array("u", 3, values(mesh, degree, motion)));
}

/// By how much a displacement differs from a motion at most.
inline double error_in(const Mesh<2>& mesh, const Displacement<2>& displacement, const Motion& motion) {
  const std::vector<Node> nodes = nodes_of(mesh, displacement.degree);
  if (displacement.vertex.size() + displacement.edge.size() != nodes.size()) return 1e300;
  double error = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const std::size_t vertices = displacement.vertex.size();
    const Vector<2> u = i < vertices ? displacement.vertex[i] : displacement.edge[i - vertices];
    error = std::max(error, (u - motion(nodes[i].body, nodes[i].x)).norm());
  }
  return error;
}

/// Expects one line of an Error (input) that holds all of `named`.
inline void expect_refused(const std::filesystem::path& file, const Mesh<2>& mesh,
                           const std::vector<std::string>& named) {
  expect_error([&] { read_field(file, mesh); }, Status::input, named);
}

}  // namespace bracket::scene::test
