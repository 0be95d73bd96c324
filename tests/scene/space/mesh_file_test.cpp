// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "scene/mesh/topology.h"
#include "tests/scene/space/boxes.h"

namespace bracket::scene {
namespace {

using namespace test;

/// Gmsh 2.2 of a mesh: a physical volume for each body, a physical surface for each part; second-order nodes in the
/// middle of edges, but for one that is off its chord by `off`.
std::string gmsh_text_of(const Mesh<3>& mesh, bool second_order, double off = 0) {
  std::string text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n";
  text += fmt::format("{}\n", mesh.bodies.size() + mesh.parts.size());
  for (std::size_t b = 0; b < mesh.bodies.size(); ++b) text += fmt::format("3 {} \"{}\"\n", b + 1, mesh.bodies[b]);
  for (std::size_t p = 0; p < mesh.parts.size(); ++p) text += fmt::format("2 {} \"{}\"\n", p + 1, mesh.parts[p]);
  text += "$EndPhysicalNames\n$Nodes\n";
  const std::size_t n = mesh.vertices.size();
  text += fmt::format("{}\n", n + (second_order ? mesh.edges.size() : 0));
  for (std::size_t v = 0; v < n; ++v)
    text += fmt::format("{} {} {} {}\n", v + 1, mesh.vertices[v][0], mesh.vertices[v][1], mesh.vertices[v][2]);
  for (std::size_t e = 0; e < mesh.edges.size() && second_order; ++e) {
    const auto [a, b] = positions(mesh, mesh.edges[e]);
    const Vector<3> x = 0.5 * (a + b) + (e == 0 ? off : 0) * (b - a).unitOrthogonal();
    text += fmt::format("{} {} {} {}\n", n + e + 1, x[0], x[1], x[2]);
  }
  text += fmt::format("$EndNodes\n$Elements\n{}\n", mesh.boundary.size() + mesh.cells.size());
  int tag = 0;
  for (const auto& facet : mesh.boundary) {
    text += fmt::format("{} {} 2 {} {}", ++tag, second_order ? 9 : 2, facet.part + 1, facet.part + 1);
    for (const int v : facet.vertices) text += fmt::format(" {}", v + 1);
    const auto edges = facet_edges(mesh, facet);
    for (const int e : {2, 0, 1})
      if (second_order) text += fmt::format(" {}", n + static_cast<std::size_t>(edges[e]) + 1);
    text += "\n";
  }
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    text += fmt::format("{} {} 2 {} {}", ++tag, second_order ? 11 : 4, mesh.cell_body[c] + 1, mesh.cell_body[c] + 1);
    for (const int v : mesh.cells[c]) text += fmt::format(" {}", v + 1);
    for (const auto& [i, k] : {std::pair(0, 1), {1, 2}, {0, 2}, {0, 3}, {2, 3}, {1, 3}})
      if (second_order)
        text +=
            fmt::format(" {}", n + static_cast<std::size_t>(mesh.cell_edges[c][Simplex<3>::edge_between(i, k)]) + 1);
    text += "\n";
  }
  return text + "$EndElements\n";
}

/// Abaqus' input of a mesh: parts are surfaces of sides of elements.
std::string abaqus_text_of(const Mesh<3>& mesh, bool second_order) {
  std::string text = "*NODE\n";
  const std::size_t n = mesh.vertices.size();
  for (std::size_t v = 0; v < n; ++v)
    text += fmt::format("{}, {}, {}, {}\n", v + 1, mesh.vertices[v][0], mesh.vertices[v][1], mesh.vertices[v][2]);
  for (std::size_t e = 0; e < mesh.edges.size() && second_order; ++e) {
    const auto [a, b] = positions(mesh, mesh.edges[e]);
    const Vector<3> x = 0.5 * (a + b);
    text += fmt::format("{}, {}, {}, {}\n", n + e + 1, x[0], x[1], x[2]);
  }
  for (std::size_t body = 0; body < mesh.bodies.size(); ++body) {
    text += fmt::format("*ELEMENT, TYPE={}, ELSET={}\n", second_order ? "C3D10" : "C3D4", mesh.bodies[body]);
    for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
      if (mesh.cell_body[c] != static_cast<int>(body)) continue;
      text += fmt::format("{}", c + 1);
      for (const int v : mesh.cells[c]) text += fmt::format(", {}", v + 1);
      for (const auto& [i, k] : {std::pair(0, 1), {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}})
        if (second_order)
          text +=
              fmt::format(", {}", n + static_cast<std::size_t>(mesh.cell_edges[c][Simplex<3>::edge_between(i, k)]) + 1);
      text += "\n";
    }
  }
  constexpr std::array<int, 4> side = {3, 4, 2, 1};  // opposite to vertex k: Abaqus' S3 is 2-3-4, S4 1-3-4, S2 1-2-4
  for (std::size_t p = 0; p < mesh.parts.size(); ++p) {
    text += fmt::format("*SURFACE, NAME={}\n", mesh.parts[p]);
    for (const auto& facet : mesh.boundary)
      if (facet.part == static_cast<int>(p)) text += fmt::format("{}, S{}\n", facet.cell + 1, side[facet.local]);
  }
  return text;
}

void expect_same_mesh(const Mesh<3>& read, const Mesh<3>& written) {
  EXPECT_EQ(read.vertices.size(), written.vertices.size());
  EXPECT_EQ(read.edges, written.edges);
  EXPECT_EQ(read.cell_edges, written.cell_edges);
  ASSERT_EQ(read.boundary.size(), written.boundary.size());
  for (std::size_t f = 0; f < read.boundary.size(); ++f) {
    EXPECT_EQ(read.boundary[f].vertices, written.boundary[f].vertices);
    EXPECT_EQ(read.parts.at(read.boundary[f].part), written.parts.at(written.boundary[f].part));
  }
  for (std::size_t c = 0; c < read.cells.size(); ++c)
    EXPECT_EQ(read.bodies[read.cell_body[c]], written.bodies[written.cell_body[c]]);
}

Scene<3> scene_of_file(const std::filesystem::path& file) {
  Scene<3> scene = unit_boxes(1);
  scene.blocks.clear();
  scene.mesh_file = file;
  return scene;
}

TEST(MeshFilesInSpace, OfGmshAndAbaqusAreRead) {
  const Folder folder;
  Random random(3);
  const Mesh<3> mesh = shaken(build_mesh(unit_boxes(2)), random, 0.1);
  for (const bool second_order : {false, true}) {
    for (const auto& file : {folder.write("a.msh", gmsh_text_of(mesh, second_order)),
                             folder.write("a.inp", abaqus_text_of(mesh, second_order))}) {
      EXPECT_EQ(dimension_of_mesh(file), 3);
      expect_same_mesh(read_mesh<3>(file), mesh);
      const Problem<3> problem = fix_data(scene_of_file(file), build_mesh(scene_of_file(file)));
      EXPECT_EQ(problem.contact.size(), 8u);
      expect_error([&] { read_mesh<2>(file); }, Status::mesh, {"3D", "dim = 3"});
    }
  }
  const Mesh<3> curved = read_mesh<3>(folder.write("b.msh", gmsh_text_of(mesh, true, 0.01)));
  EXPECT_TRUE(std::ranges::any_of(curved.notes, [](const std::string& note) {
    return note.find("96 cells of second order straightened") != std::string::npos &&
           note.find("above a chord is 0.01") != std::string::npos;
  }));
}

// Bodies that share their nodes are one piece, or two where a contact names the surface between them.
TEST(MeshFilesInSpace, JoinBodiesOrSeparateThem) {
  const Folder folder;
  Scene<3> bonded = unit_boxes(2);
  bonded.contact.clear();
  bonded.bonds = {{"upper.bottom", "lower.top", ""}};
  Mesh<3> mesh = build_mesh(bonded);
  ASSERT_EQ(mesh.components.size(), 1u);
  const int joint = static_cast<int>(mesh.parts.size());
  mesh.parts.push_back("joint");
  std::map<int, std::array<int, 2>> first;  // facets between bodies
  std::vector<Mesh<3>::Facet> between;
  for (std::size_t c = 0; c < mesh.cells.size(); ++c)
    for (int k = 0; k < 4; ++k) {
      const auto [known, fresh] =
          first.try_emplace(cell_facets(mesh, static_cast<int>(c))[k], std::array{static_cast<int>(c), k});
      if (!fresh && mesh.cell_body[known->second[0]] != mesh.cell_body[c])
        between.push_back({facet_vertices(mesh, static_cast<int>(c), k), static_cast<int>(c), k, -1, joint});
    }
  ASSERT_EQ(between.size(), 8u);
  Mesh<3> with_joint = mesh;
  with_joint.boundary.insert(with_joint.boundary.end(), between.begin(), between.end());
  const auto file = folder.write("joint.msh", gmsh_text_of(with_joint, false));
  Scene<3> scene = scene_of_file(file);
  scene.contact.clear();
  EXPECT_EQ(build_mesh(scene).components.size(), 1u);
  scene.contact = {{"joint", "joint", 0.0, ""}};
  const Mesh<3> separated = build_mesh(scene);
  EXPECT_EQ(separated.components.size(), 2u);
  EXPECT_EQ(separated.vertices.size(), mesh.vertices.size() + 9);
  scene.mesh_file.clear();
  const Scene<3> from_code = given(with_joint, scene);
  EXPECT_EQ(build_mesh(from_code).components.size(), 2u);
  const Problem<3> problem = fix_data(scene, separated);
  ASSERT_EQ(problem.contact.size(), 8u);
  for (const ContactFacetOf<3>& pair : problem.contact) {
    EXPECT_EQ(problem.facets[pair.first].normal, Vector<3>(0, 1, 0));
    for (int i = 0; i < 3; ++i)
      EXPECT_EQ(problem.mesh.vertices[problem.mesh.boundary[pair.first].vertices[i]],
                problem.mesh.vertices[problem.mesh.boundary[pair.second].vertices[pair.meets[i]]]);
  }
}

TEST(MeshFilesInSpace, ThatAreNoneAreRefused) {
  const Folder folder;
  const Mesh<3> mesh = build_mesh(unit_boxes(1));
  const std::string text = gmsh_text_of(mesh, false);
  const std::string hexahedron =
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n0\n$EndNodes\n$Elements\n1\n1 5 0 1 2 3 4 5 6 7 8\n$EndElements\n";
  expect_error([&] { read_mesh<3>(folder.write("a.inp", "*NODE\n1, 0, 0, 0\n*ELEMENT, TYPE=C3D8\n1, 1\n")); },
               Status::mesh, {"a.inp:3:", "C3D8", "only tetrahedra"});
  Scene<3> scene = scene_of_file(folder.write("b.msh", text));
  scene.boundary["lower.botom"] = {ConditionKind::pressure, {1.0}};
  expect_error([&] { build_mesh(scene); }, Status::input, {"did you mean 'lower.bottom'"});
}

}  // namespace
}  // namespace bracket::scene
