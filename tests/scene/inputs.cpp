// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/scene/inputs.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>

namespace bracket::scene::test {

std::optional<Error> error_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    return error;
  }
  return std::nullopt;
}

std::string replaced(const std::string& text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  if (at == std::string::npos || text.find(from, at + 1) != std::string::npos) {
    throw std::logic_error("not exactly once in the text: " + from);
  }
  return text.substr(0, at) + to + text.substr(at + from.size());
}

std::string two_blocks() {
  return R"(schema = 1
title = "Two blocks"
units = "N, mm, MPa"
plane = "strain"
[[mesh.block]]
body = "lower"
x = [0, 1]
y = [0, 1]
cells = [4, 4]
[[mesh.block]]
body = "upper"
x = [0, 1]
y = [1, 2]
cells = [4, 4]
[bodies.lower]
E = 1.0
nu = 0.3
[bodies.upper]
stiffness = [[3, 1, 0], [1, 2, 0], [0, 0, 1]]
body_force = [0.5, -1.0]
[boundary."lower.bottom"]
fixed = [0.0, 0.0]
[boundary."upper.left"]
sliding = 0.0
[boundary."upper.top"]
traction = ["0", "x < 0.5 ? -0.1 : 0.09"]
[[contact]]
first = "upper.bottom"
second = "lower.top"
gap = "0.01*x^2"
[refine]
strategy = "none"
target = 1e-3
bulk = 0.7
max_levels = 3
max_cells = 1000
max_seconds = 60
[solve]
degree = 1
dual = "hybrid"
)";
}

GmshContent two_squares() {
  GmshContent content;
  content.nodes = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 1}, {1, 1}, {1, 2}, {0, 2}};
  content.lines = {{5, {0, 1}}, {6, {2, 3}}, {7, {4, 5}}};
  content.triangles = {{1, {0, 1, 2}}, {1, {0, 2, 3}}, {2, {4, 5, 6}}, {2, {4, 6, 7}}};
  content.names = "1 5 \"base\"\n1 6 \"joint below\"\n1 7 \"joint above\"\n2 1 \"lower\"\n2 2 \"upper\"\n";
  return content;
}

namespace {

std::string physical_names(const GmshContent& content) {
  return fmt::format("$PhysicalNames\n{}\n{}$EndPhysicalNames\n",
                     std::count(content.names.begin(), content.names.end(), '\n'), content.names);
}

std::string places(const std::vector<int>& nodes) {
  std::string text;
  for (const int node : nodes) text += fmt::format(" {}", node + 1);
  return text + "\n";
}

}  // namespace

std::string gmsh_2(const GmshContent& content) {
  std::string text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n" + physical_names(content);
  text += fmt::format("$Nodes\n{}\n", content.nodes.size());
  for (std::size_t i = 0; i < content.nodes.size(); ++i) {
    text += fmt::format("{} {} {} 0\n", i + 1, content.nodes[i][0], content.nodes[i][1]);
  }
  text += fmt::format("$EndNodes\n$Elements\n{}\n", content.lines.size() + content.triangles.size());
  int tag = 0;
  for (const auto& line : content.lines) text += fmt::format("{} 1 2 {} 3{}", ++tag, line.physical, places(line.nodes));
  for (const auto& cell : content.triangles) {
    text += fmt::format("{} 2 2 {} 4{}", ++tag, cell.physical, places(cell.nodes));
  }
  return text + "$EndElements\n";
}

std::string gmsh_4(const GmshContent& content) {
  std::string text = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n" + physical_names(content);
  std::set<int> curves, surfaces;  // an entity 10 + p for each physical group p
  for (const auto& line : content.lines) curves.insert(line.physical);
  for (const auto& cell : content.triangles) surfaces.insert(cell.physical);
  text += fmt::format("$Entities\n1 {} {} 0\n1 0 0 0 0\n", curves.size(), surfaces.size());
  for (const int p : curves) text += fmt::format("{} 0 0 0 1 1 0 1 {} 2 1 -1\n", 10 + p, p);
  for (const int p : surfaces) text += fmt::format("{} 0 0 0 1 1 0 1 {} 0\n", 10 + p, p);
  const std::size_t n = content.nodes.size();
  text += fmt::format("$EndEntities\n$Nodes\n2 {0} 1 {0}\n0 1 0 1\n1\n{1} {2} 0\n2 11 1 {3}\n", n, content.nodes[0][0],
                      content.nodes[0][1], n - 1);
  for (std::size_t i = 1; i < n; ++i) text += fmt::format("{}\n", i + 1);
  for (std::size_t i = 1; i < n; ++i) {  // with parameters u, v, which are to be skipped
    text += fmt::format("{} {} 0 0.25 0.75\n", content.nodes[i][0], content.nodes[i][1]);
  }
  const std::size_t elements = content.lines.size() + content.triangles.size();
  text += fmt::format("$EndNodes\n$Elements\n{0} {0} 1 {0}\n", elements);
  int tag = 0;
  for (const auto& line : content.lines) {
    text += fmt::format("1 {} 1 1\n{}{}", 10 + line.physical, ++tag, places(line.nodes));
  }
  for (const auto& cell : content.triangles) {
    text += fmt::format("2 {} 2 1\n{}{}", 10 + cell.physical, ++tag, places(cell.nodes));
  }
  return text + "$EndElements\n";
}

Function<2> constant(double value) { return value; }

Scene<2> stacked(int cells, std::map<std::string, Condition<2>> boundary) {
  Scene<2> scene;
  scene.blocks = {{"a", {{{0, 1}, {0, 1}}}, {cells, cells}, ""}, {"b", {{{0, 1}, {1, 2}}}, {cells, cells}, ""}};
  scene.bodies = {{"a", isotropic<2>(1, 0, Plane::strain)}, {"b", isotropic<2>(1, 0, Plane::strain)}};
  scene.boundary = std::move(boundary);
  scene.contact = {{"a.top", "b.bottom", constant(0), ""}};
  return scene;
}

int facet_at(const Mesh<2>& mesh, const std::string& part, const Vector<2>& x) {
  int best = -1;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t facet = 0; facet < mesh.boundary.size(); ++facet) {
    const auto& [vertices, cell, local, edge, own] = mesh.boundary[facet];
    if (own == -1 || mesh.parts[own] != part) continue;
    const double distance = (0.5 * (mesh.vertices[vertices[0]] + mesh.vertices[vertices[1]]) - x).norm();
    if (distance < nearest) {
      nearest = distance;
      best = static_cast<int>(facet);
    }
  }
  return best;
}

Scene<2> scene_of(const std::filesystem::path& file, const std::vector<std::string>& bodies,
                  const std::vector<std::string>& fixed) {
  Scene<2> scene;
  scene.mesh_file = file;
  for (const std::string& name : bodies) scene.bodies.emplace(name, isotropic<2>(1, 0, Plane::strain));
  for (const std::string& part : fixed)
    scene.boundary[part] = {ConditionKind::fixed, {constant(0), constant(0)}, "scene:" + part};
  return scene;
}

double area(const Mesh<2>& mesh, const std::string& body) {
  double sum = 0;
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
    if (mesh.bodies[mesh.cell_body[cell]] == body) sum += volume(mesh, static_cast<int>(cell));
  return sum;
}

double length_of(const Mesh<2>& mesh, const std::string& part) {
  double sum = 0;
  for (std::size_t facet = 0; facet < mesh.boundary.size(); ++facet)
    if (const int own = mesh.boundary[facet].part; own != -1 && mesh.parts[own] == part)
      sum += length(mesh, static_cast<int>(facet));
  return sum;
}

void expect_note(const Mesh<2>& mesh, const std::string& part) {
  const auto holds = [&](const std::string& note) { return note.find(part) != std::string::npos; };
  EXPECT_EQ(std::ranges::count_if(mesh.notes, holds), 1) << part << ": " << testing::PrintToString(mesh.notes);
}

void expect_error(const std::function<void()>& action, Status status, const std::vector<std::string>& named) {
  const auto error = error_of(action);
  ASSERT_TRUE(error.has_value()) << named[0];
  EXPECT_EQ(error->status(), status) << error->what();
  EXPECT_EQ(std::string(error->what()).find('\n'), std::string::npos);
  for (const std::string& part : named)
    EXPECT_NE(std::string(error->what()).find(part), std::string::npos) << part << ": " << error->what();
}

}  // namespace bracket::scene::test
