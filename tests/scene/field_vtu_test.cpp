// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// Displacements as VTK's unstructured grids: matched by cells, or interpolated.
#include <gtest/gtest.h>

#include "tests/scene/field_files.h"

namespace bracket::scene {
namespace {

using namespace test;

/// The two blocks refined here and there.
Mesh<2> refined(int n) {
  Problem<2> problem = bracket::tests::problem(bracket::tests::two_blocks(n));
  for (int level = 0; level < 3; ++level) {
    std::vector<char> marked(problem.mesh.cells.size(), 0);
    for (std::size_t cell = level; cell < marked.size(); cell += 4) marked[cell] = 1;
    problem = refine(problem, marked).problem;
  }
  return problem.mesh;
}

TEST(VtuField, InEachEncodingIsTheSame) {
  const Mesh<2> mesh = two_blocks_mesh(2);
  for (const char* name : {"ascii", "base64", "base64_zlib", "appended_base64", "appended_base64_zlib", "appended_raw",
                           "appended_raw_zlib", "meshio", "quadratic", "single"}) {
    const GivenDisplacement given = read_field(given_file(std::string(name) + ".vtu"), mesh);
    EXPECT_EQ(given.displacement.degree, name == std::string("quadratic") ? 2 : 1) << name;
    EXPECT_FALSE(given.interpolated) << name;
    EXPECT_EQ(given.off, 0) << name;
    EXPECT_LE(error_in(mesh, given.displacement, linear_motion), name == std::string("single") ? 2e-7 : 1e-15) << name;
  }
}

TEST(VtuField, OfTheMeshIsMatchedByCells) {
  const Folder folder;
  const Mesh<2> mesh = refined(3);
  for (const int degree : {1, 2}) {
    const GivenDisplacement given = read_field(folder.write("a.vtu", vtu_of(mesh, degree, quadratic_motion)), mesh);
    EXPECT_EQ(given.displacement.degree, degree);
    EXPECT_FALSE(given.interpolated);
    EXPECT_EQ(error_in(mesh, given.displacement, quadratic_motion), 0);
  }
}

TEST(VtuField, OfAnotherMeshIsInterpolatedBodyByBody) {
  const Folder folder;
  for (const int n : {1, 2, 3, 5}) {
    const Mesh<2> from = refined(n), mesh = two_blocks_mesh(4);
    const GivenDisplacement first = read_field(folder.write("a.vtu", vtu_of(from, 1, linear_motion)), mesh);
    EXPECT_TRUE(first.interpolated);
    EXPECT_EQ(first.displacement.degree, 2);
    EXPECT_LE(error_in(mesh, first.displacement, linear_motion), 1e-14) << n;
    const GivenDisplacement second = read_field(folder.write("a.vtu", vtu_of(from, 2, quadratic_motion)), mesh);
    EXPECT_TRUE(second.interpolated);
    EXPECT_LE(error_in(mesh, second.displacement, quadratic_motion), 1e-14) << n;
  }
}

/// Squares of n × n on one block, the inner corners moved, each with 4, 8 or 9 nodes. \param curved moves the middles
/// of inner sides as well
std::string quadrilaterals(int n, int nodes, const Motion& motion, bool curved) {
  std::vector<Vector<2>> points;
  std::vector<std::string> cells;
  const auto corner = [&](int i, int j) {
    const double by = i > 0 && i < n && j > 0 && j < n ? 0.2 / n * ((i + 2 * j) % 3 - 1) : 0;
    return Vector<2>(static_cast<double>(i) / n + by, static_cast<double>(j) / n - by);
  };
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const std::array<Vector<2>, 4> x = {corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)};
      std::vector<Vector<2>> all(x.begin(), x.end());
      for (int k = 0; k < 4; ++k) {
        all.push_back(0.5 * (x[k] + x[(k + 1) % 4]));
        const bool inner = all.back().minCoeff() > 1e-9 && all.back().maxCoeff() < 1 - 1e-9;
        if (curved && inner) all.back() += Vector<2>(0.05 / n, -0.03 / n);
      }
      all.push_back(0.25 * (x[0] + x[1] + x[2] + x[3]));
      std::string cell;
      for (int k = 0; k < nodes; ++k) cell += fmt::format("{} ", points.size() + static_cast<std::size_t>(k));
      cells.push_back(cell);
      points.insert(points.end(), all.begin(), all.begin() + nodes);
    }
  std::vector<std::string> places, moved, offsets, types;
  for (const Vector<2>& x : points) {
    places.push_back(fmt::format("{:.17g} {:.17g} 0", x[0], x[1]));
    moved.push_back(fmt::format("{:.17g} {:.17g} 0", motion(0, x)[0], motion(0, x)[1]));
  }
  for (std::size_t cell = 1; cell <= cells.size(); ++cell) {
    offsets.push_back(std::to_string(cell * static_cast<std::size_t>(nodes)));
    types.push_back(nodes == 4 ? "9" : nodes == 8 ? "23" : "28");
  }
  const auto whole = [](std::string text) { return replaced(text, "Float64", "Int64"); };
  return fmt::format(
      "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\"><UnstructuredGrid>\n<Piece NumberOfPoints=\"{}\" "
      "NumberOfCells=\"{}\">\n<Points>{}</Points>\n<Cells>{}{}{}</Cells>\n<PointData>{}</PointData>\n</Piece>\n"
      "</UnstructuredGrid></VTKFile>\n",
      points.size(), cells.size(), array("Points", 3, places), whole(array("connectivity", 1, cells)),
      whole(array("offsets", 1, offsets)), whole(array("types", 1, types)), array("u", 3, moved));
}

TEST(VtuField, OfQuadrilateralsAndCurvedSidesLinearFieldsAreReproduced) {
  const Folder folder;
  Scene<2> scene;
  scene.blocks = {bracket::tests::block("b", 0, 1, 0, 1, 3, 3)};
  scene.bodies = {{"b", isotropic<2>(1, 0.3, Plane::strain)}};
  const Mesh<2> mesh = build_mesh(scene);
  for (const int nodes : {4, 8, 9})
    for (const bool curved : {false, true}) {
      const GivenDisplacement given =
          read_field(folder.write("a.vtu", quadrilaterals(4, nodes, linear_motion, curved)), mesh);
      EXPECT_TRUE(given.interpolated);
      EXPECT_LE(error_in(mesh, given.displacement, linear_motion), 1e-14) << nodes << curved;
    }
}

TEST(VtuField, ArraysAreTakenByTheirNamesOrBecauseThereIsNoOther) {
  const Folder folder;
  const Mesh<2> mesh = two_blocks_mesh(2);
  const std::vector<std::string> right = values(mesh, 1, linear_motion), wrong = values(mesh, 1, quadratic_motion);
  const std::vector<std::string> scalar(mesh.vertices.size(), "1");
  const auto with = [&](const std::string& arrays) {
    return folder.write("a.vtu", with_point_data(vtu_text(mesh, 1), arrays));
  };
  for (const std::string& arrays :
       {array("forces", 3, wrong) + array("U", 3, right), array("f", 3, wrong) + array("Displacement", 3, right),
        array("p", 1, scalar) + array("some thing", 3, right),
        array("f", 2, values(mesh, 1, linear_motion, "")) + array("T", 1, scalar)})
    EXPECT_EQ(error_in(mesh, read_field(with(arrays), mesh).displacement, linear_motion), 0) << arrays;
  expect_refused(with(""), mesh, {"has no displacement", "there are: none"});
  expect_refused(with(array("p", 1, scalar)), mesh, {"has no displacement", "'p' (1)"});
  expect_refused(with(array("a", 3, right) + array("b", 3, right)), mesh, {"several", "'a' (3), 'b' (3)"});
}

TEST(VtuField, WhatIsNoDisplacementOfTheseBodiesIsOneLine) {
  const Folder folder;
  const Mesh<2> mesh = two_blocks_mesh(2);
  const auto refused = [&](const std::string& text, const std::vector<std::string>& named) {
    expect_refused(folder.write("a.vtu", text), mesh, named);
  };
  const std::string good = vtu_of(mesh, 1, linear_motion);
  std::vector<std::string> moved = values(mesh, 1, linear_motion);
  for (const std::string bad : {"nan 0 0", "0 inf 0", "0 0 1"}) {
    moved[3] = bad;
    refused(with_point_data(vtu_text(mesh, 1), array("u", 3, moved)),
            {"a.vtu: the point 3 at ", bad == "0 0 1" ? "out of the plane by 1" : "displacement"});
  }
  refused(good.substr(0, good.size() / 2), {"a.vtu: cannot be read; VTK: "});
  refused("hello", {"a.vtu: cannot be read; VTK: "});
  refused("", {"a.vtu"});
  refused("<VTKFile type=\"PolyData\"></VTKFile>", {"a.vtu: cannot be read; VTK: ", "UnstructuredGrid"});
  // Another domain: larger, smaller, elsewhere, or one body alone.
  for (const double by : {2., 0.5, 0.999}) {
    Mesh<2> other = two_blocks_mesh(3);
    for (Vector<2>& x : other.vertices) x *= by;
    refused(vtu_of(other, 1, linear_motion), {"a.vtu: ", "the same bodies"});
  }
  Scene<2> lower = bracket::tests::two_blocks(2);
  lower.blocks.pop_back();
  lower.contact.clear();
  lower.bodies.erase("upper");
  lower.boundary.erase("upper.left");
  lower.boundary.erase("upper.top");
  refused(vtu_of(build_mesh(lower), 1, linear_motion), {"a.vtu: has 8 of the 16 cells of the mesh"});
  lower.blocks[0].cells = {3, 3};
  refused(vtu_of(build_mesh(lower), 1, linear_motion), {"a.vtu: no cell of 'upper' holds"});
  refused(replaced(quadrilaterals(1, 4, linear_motion, false),
                   "Name=\"types\" NumberOfComponents=\"1\" format=\"ascii\">\n9",
                   "Name=\"types\" NumberOfComponents=\"1\" format=\"ascii\">\n10"),
          {"a.vtu: has cells of VTK's type 10 with 4 points"});
}

TEST(VtuField, ThatJumpsWithinABodyIsRefused) {
  const Folder folder;
  Scene<2> scene;
  scene.blocks = {bracket::tests::block("b", 0, 1, 0, 1, 2, 2)};
  scene.bodies = {{"b", isotropic<2>(1, 0.3, Plane::strain)}};
  const Motion torn = [](int, const Vector<2>& x) { return Vector<2>(std::floor(3 * x[0] + 1e-9), 0); };
  const std::string text = quadrilaterals(2, 4, torn, false);
  EXPECT_TRUE(read_field(folder.write("a.vtu", text), build_mesh(scene)).interpolated);  // a place has one value
  std::string two = text;
  two.replace(two.rfind("1 0 0", two.find("</PointData>")), 5, "9 0 0");
  expect_refused(folder.write("a.vtu", two), build_mesh(scene), {"jumps at", "'b'"});
}

// DOLFINx computes the places of its nodes, which are then off by some last places.
TEST(VtuField, OfDolfinxIsMatched) {
  Scene<2> scene;
  scene.blocks = {bracket::tests::block("b", 0, 1, 0, 1, 3, 3)};
  scene.bodies = {{"b", isotropic<2>(1, 0.3, Plane::strain)}};
  for (const int degree : {1, 2}) {
    const Mesh<2> mesh = build_mesh(scene);
    const GivenDisplacement given = read_field(given_file(fmt::format("dolfinx_{}.vtu", degree)), mesh);
    EXPECT_FALSE(given.interpolated);
    EXPECT_EQ(given.displacement.degree, degree);
    EXPECT_LE(given.off, 1e-15);
    EXPECT_LE(error_in(mesh, given.displacement, linear_motion), 1e-15);
  }
}

TEST(VtuField, OfFreeFemIsMatchedOnTheMeshThatItComputedOn) {
  Problem<2> problem = bracket::tests::problem(bracket::tests::two_blocks(4));
  for (int i = 0; i < 2; ++i) problem = refine(problem, std::vector<char>(problem.mesh.cells.size(), 1)).problem;
  const GivenDisplacement freefem = read_field(given_file("freefem.vtu"), problem.mesh);
  const GivenDisplacement calculix = read_field(given_file("calculix.frd"), problem.mesh);
  double largest = 0, difference = 0;
  for (const GivenDisplacement* given : {&freefem, &calculix}) {
    EXPECT_FALSE(given->interpolated);
    EXPECT_EQ(given->displacement.degree, 1);
    EXPECT_LE(given->off, 2e-6);
  }
  for (std::size_t vertex = 0; vertex < problem.mesh.vertices.size(); ++vertex) {
    largest = std::max(largest, freefem.displacement.vertex[vertex].norm());
    difference =
        std::max(difference, (freefem.displacement.vertex[vertex] - calculix.displacement.vertex[vertex]).norm());
  }
  EXPECT_LE(difference, 2e-5 * largest);  // two penalties of one size, six digits
  EXPECT_TRUE(read_field(given_file("freefem.vtu"), two_blocks_mesh(4)).interpolated);
}

}  // namespace
}  // namespace bracket::scene
