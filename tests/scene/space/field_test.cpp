// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// Displacements of tetrahedra from files and arrays.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "scene/field/on_scene.h"
#include "scene/mesh/write.h"
#include "tests/scene/inputs.h"
#include "tests/space/scenes.h"
#include "tests/support/folder.h"

namespace bracket::scene::test {
namespace {

using bracket::tests::Folder;

using Motion3 = std::function<Vector<3>(int body, const Vector<3>& x)>;

Vector<3> linear_in_space(int body, const Vector<3>& x) {
  return {0.1 + 0.2 * x[0] - 0.3 * x[1] + body, 0.4 * x[2] + 0.5 * x[1], 0.7 * x[0] - 0.1 * body * x[2]};
}
Vector<3> quadratic_in_space(int body, const Vector<3>& x) {
  return linear_in_space(body, x) + Vector<3>(x[0] * x[1], x[1] * x[2] + body * x[0] * x[0], x[2] * x[2]);
}

/// Vertices and, of degree 2, midpoints of edges, each with the body that it belongs to.
struct SpaceNode {
  Vector<3> x;
  int body;
};
std::vector<SpaceNode> nodes_in_space(const Mesh<3>& mesh, int degree) {
  std::vector<SpaceNode> nodes(mesh.vertices.size() + (degree == 2 ? mesh.edges.size() : 0));
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) {
    for (const int vertex : mesh.cells[cell]) nodes[vertex] = {mesh.vertices[vertex], mesh.cell_body[cell]};
    for (const int edge : mesh.cell_edges[cell]) {
      if (degree == 1) continue;
      const auto& [a, b] = mesh.edges[edge];
      nodes[mesh.vertices.size() + edge] = {0.5 * (mesh.vertices[a] + mesh.vertices[b]), mesh.cell_body[cell]};
    }
  }
  return nodes;
}

double error_in_space(const Mesh<3>& mesh, const Displacement<3>& u, const Motion3& motion) {
  const auto nodes = nodes_in_space(mesh, u.degree);
  if (u.vertex.size() + u.edge.size() != nodes.size()) return 1e300;
  double error = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const std::size_t n = u.vertex.size();
    error = std::max(error, ((i < n ? u.vertex[i] : u.edge[i - n]) - motion(nodes[i].body, nodes[i].x)).norm());
  }
  return error;
}

std::string vtu_in_space(const Mesh<3>& mesh, int degree, const Motion3& motion) {
  std::string text = "<PointData>\n<DataArray type=\"Float64\" Name=\"u\" NumberOfComponents=\"3\" format=\"ascii\">\n";
  for (const SpaceNode& node : nodes_in_space(mesh, degree)) {
    const Vector<3> u = motion(node.body, node.x);
    text += fmt::format("{:.17g} {:.17g} {:.17g}\n", u[0], u[1], u[2]);
  }
  return replaced(vtu_text(mesh, degree), "</Piece>", text + "</DataArray>\n</PointData>\n</Piece>");
}

std::string csv_in_space(const Mesh<3>& mesh, int degree, const Motion3& motion, bool bodies) {
  std::string text = bodies ? "x,y,z,ux,uy,uz,body\n" : "z,y,x,ux,uy,uz\n";
  for (const SpaceNode& node : nodes_in_space(mesh, degree)) {
    const Vector<3> u = motion(node.body, node.x);
    text += bodies ? fmt::format("{:.17g},{:.17g},{:.17g}", node.x[0], node.x[1], node.x[2])
                   : fmt::format("{:.17g},{:.17g},{:.17g}", node.x[2], node.x[1], node.x[0]);
    text += fmt::format(",{:.17g},{:.17g},{:.17g}{}\n", u[0], u[1], u[2], bodies ? "," + mesh.bodies[node.body] : "");
  }
  return text;
}

Mesh<3> blocks_in_space(int n) { return build_mesh(bracket::tests::space::two_blocks(n)); }

TEST(SpaceField, IsReadByCellsAndByPlaces) {
  const Folder folder;
  const Mesh<3> mesh = blocks_in_space(2);
  for (const int degree : {1, 2}) {
    for (const auto& file : {folder.write("a.vtu", vtu_in_space(mesh, degree, quadratic_in_space)),
                             folder.write("a.csv", csv_in_space(mesh, degree, quadratic_in_space, true))}) {
      const GivenDisplacementOf<3> given = read_field(file, mesh);
      EXPECT_EQ(given.displacement.degree, degree);
      EXPECT_FALSE(given.interpolated);
      EXPECT_EQ(given.off, 0);
      EXPECT_EQ(error_in_space(mesh, given.displacement, quadratic_in_space), 0);
    }
    const auto same = [](int, const Vector<3>& x) { return quadratic_in_space(0, x); };  // needs no names of bodies
    const auto given = read_field(folder.write("b.csv", csv_in_space(mesh, degree, same, false)), mesh);
    EXPECT_EQ(error_in_space(mesh, given.displacement, same), 0);
  }
}

TEST(SpaceField, OfAnotherMeshIsInterpolated) {
  const Folder folder;
  const Mesh<3> from = blocks_in_space(4), mesh = blocks_in_space(2);
  for (const auto& [on, of] : {std::pair(&from, &mesh), std::pair(&mesh, &from)}) {
    const auto linear = read_field(folder.write("a.vtu", vtu_in_space(*on, 1, linear_in_space)), *of);
    EXPECT_TRUE(linear.interpolated);
    EXPECT_EQ(linear.displacement.degree, 2);
    EXPECT_LE(error_in_space(*of, linear.displacement, linear_in_space), 1e-14);
    const auto quadratic = read_field(folder.write("b.vtu", vtu_in_space(*on, 2, quadratic_in_space)), *of);
    EXPECT_TRUE(quadratic.interpolated);
    EXPECT_LE(error_in_space(*of, quadratic.displacement, quadratic_in_space), 1e-14);
  }
}

TEST(SpaceField, IsThatOfARefinedMeshOfTheScene) {
  const Folder folder;
  Scene<3> scene = bracket::tests::space::two_blocks(2);
  Problem<3> problem = fix_data(scene, build_mesh(scene));
  for (int times = 0; times < 2; ++times) {
    for (const int degree : {1, 2}) {
      const auto file = folder.write("a.vtu", vtu_in_space(problem.mesh, degree, quadratic_in_space));
      const FieldOnSceneOf<3> found = read_field(scene, file);
      EXPECT_EQ(found.refinements, times);
      EXPECT_EQ(found.given.displacement.degree, degree);
      EXPECT_EQ(error_in_space(found.problem.mesh, found.given.displacement, quadratic_in_space), 0);
    }
    problem = refine(problem, std::vector<char>(problem.mesh.cells.size(), 1)).problem;
  }
  scene.refine.max_cells = 100;
  const auto file = folder.write("a.vtu", vtu_in_space(problem.mesh, 1, quadratic_in_space));
  EXPECT_TRUE(read_field(scene, file).given.interpolated);
}

TEST(SpaceField, OfArraysIsMatchedLikeThatOfAFile) {
  const Scene<3> scene = bracket::tests::space::two_blocks(2);
  const Mesh<3> mesh = build_mesh(scene);
  for (const int degree : {1, 2}) {
    NodalDisplacementOf<3> field;
    for (const SpaceNode& node : nodes_in_space(mesh, degree)) {
      field.nodes.push_back(node.x);
      field.values.push_back(quadratic_in_space(node.body, node.x));
    }
    for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) {
      auto& nodes = field.cells.emplace_back(mesh.cells[cell].begin(), mesh.cells[cell].end());
      for (const auto& [a, b] : edges_in_files<3>())
        if (degree == 2)
          nodes.push_back(static_cast<int>(mesh.vertices.size()) +
                          mesh.cell_edges[cell][Simplex<3>::edge_between(a, b)]);
    }
    std::ranges::reverse(field.cells);
    const FieldOnSceneOf<3> found = field_on_scene(scene, field);
    EXPECT_EQ(error_in_space(found.problem.mesh, found.given.displacement, quadratic_in_space), 0);
  }
}

/// What CalculiX writes of tetrahedra: six digits.
std::string frd_in_space(const Mesh<3>& mesh, int degree, const Motion3& motion, int type) {
  const auto nodes = nodes_in_space(mesh, degree);
  std::string text = "    1C\n    2C" + std::string(18, ' ') + "1\n";
  for (std::size_t i = 0; i < nodes.size(); ++i)
    text += fmt::format(" -1{:10}{:12.5E}{:12.5E}{:12.5E}\n", i + 1, nodes[i].x[0], nodes[i].x[1], nodes[i].x[2]);
  text += " -3\n    3C" + std::string(18, ' ') + "1\n";
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) {
    text += fmt::format(" -1{:10}{:5}{:5}{:5}\n -2", cell + 1, type, 0, 1);
    for (const int v : mesh.cells[cell]) text += fmt::format("{:10}", v + 1);
    for (const auto& [a, b] : edges_in_files<3>())
      if (degree == 2)
        text += fmt::format("{:10}", mesh.vertices.size() + 1 + mesh.cell_edges[cell][Simplex<3>::edge_between(a, b)]);
    text += "\n";
  }
  text += " -3\n  100CL  101 1.000000000           1                     0    1           1\n -4  DISP        4    1\n";
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const Vector<3> u = motion(nodes[i].body, nodes[i].x);
    text += fmt::format(" -1{:10}{:12.5E}{:12.5E}{:12.5E}\n", i + 1, u[0], u[1], u[2]);
  }
  return text + " -3\n 9999\n";
}

TEST(SpaceField, OfCalculixIsReadToItsDigits) {
  const Folder folder;
  const Mesh<3> mesh = blocks_in_space(2);
  for (const int degree : {1, 2}) {
    const auto given =
        read_field(folder.write("a.frd", frd_in_space(mesh, degree, quadratic_in_space, degree == 1 ? 3 : 6)), mesh);
    EXPECT_EQ(given.displacement.degree, degree);
    EXPECT_LE(error_in_space(mesh, given.displacement, quadratic_in_space), 2e-5);
  }
}

TEST(SpaceField, ThatDoesNotFitIsRefusedInOneLine) {
  const Folder folder;
  const Mesh<3> mesh = blocks_in_space(2), other = [] {
    Scene<3> scene = bracket::tests::space::two_blocks(2);
    scene.blocks[1].range[0] = {0, 1.5};
    return build_mesh(scene);
  }();
  const auto refused = [&](const char* name, const std::string& text, const std::vector<std::string>& named) {
    const auto file = folder.write(name, text);
    expect_error([&] { read_field(file, mesh); }, Status::input, named);
  };
  const std::string csv = csv_in_space(mesh, 1, quadratic_in_space, true);
  refused("a.csv", replaced(csv, ",uz", ""), {"a.csv:1", "'uz'", "x, y, z, ux, uy, uz"});
  refused("a.csv", csv_in_space(mesh, 1, quadratic_in_space, false), {"another displacement", "body"});
  refused("a.csv", csv.substr(0, csv.rfind("\n", csv.size() - 2) + 1), {"no displacement at 1 of the"});
  refused("a.csv", csv + "0.3,0.4,0.1,0,0,0,lower\n", {"no vertex", "(0.3, 0.4, 0.1)"});
  refused("a.vtu", vtu_in_space(other, 1, quadratic_in_space), {"outside of the mesh"});
  refused("a.frd", frd_in_space(mesh, 1, quadratic_in_space, 9), {"another displacement"});  // plane cells are none
}

}  // namespace
}  // namespace bracket::scene::test
