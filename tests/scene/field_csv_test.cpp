// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// Displacements as CSV: points are taken for nodes by their place.
#include <gtest/gtest.h>

#include "tests/scene/field_files.h"

namespace bracket::scene {
namespace {

using namespace test;

/// \param number how coordinates and values are written
std::string csv_of(const Mesh<2>& mesh, int degree, const Motion& motion, bool bodies, const char* number = "{:.17g}") {
  std::string text = bodies ? "x,y,ux,uy,body\n" : "x,y,ux,uy\n";
  for (const Node& node : nodes_of(mesh, degree)) {
    const Vector<2> u = motion(node.body, node.x);
    for (double value : {node.x[0], node.x[1], u[0], u[1]}) text += fmt::format(fmt::runtime(number), value) + ",";
    text.pop_back();
    text += bodies ? "," + mesh.bodies[node.body] + "\n" : "\n";
  }
  return text;
}

Vector<2> one_for_all(int, const Vector<2>& x) { return linear_motion(0, x); }

TEST(CsvField, OfTheMeshsNodesIsReadExactly) {
  const Folder folder;
  const Mesh<2> mesh = two_blocks_mesh(3);
  for (const int degree : {1, 2}) {
    const GivenDisplacement given =
        read_field(folder.write("a.csv", csv_of(mesh, degree, quadratic_motion, true)), mesh);
    EXPECT_EQ(given.displacement.degree, degree);
    EXPECT_EQ(error_in(mesh, given.displacement, quadratic_motion), 0);
    EXPECT_FALSE(given.interpolated);
    EXPECT_EQ(given.off, 0);
  }
}

TEST(CsvField, WithoutBodiesOneDisplacementAtAPlaceHoldsForAllThatTouchThere) {
  const Folder folder;
  const Mesh<2> mesh = two_blocks_mesh(2);
  const std::string text = csv_of(mesh, 2, one_for_all, false);
  EXPECT_EQ(error_in(mesh, read_field(folder.write("a.csv", text), mesh).displacement, one_for_all), 0);
  expect_refused(folder.write("a.csv", csv_of(mesh, 2, linear_motion, false)), mesh,
                 {"a.csv:", "another displacement", "column 'body'"});
}

TEST(CsvField, ColumnsStandInAnyOrderAndAThirdCoordinateIsZero) {
  const Folder folder;
  const Mesh<2> mesh = build_mesh(stacked(1, {}));
  std::string text = "\xef\xbb\xbf\"uy\", UX ,z,x,y,uz\r\n";
  for (const Vector<2>& x : mesh.vertices)
    text += fmt::format("{},{},0,{},+{},0.0\r\n\r\n", one_for_all(0, x)[1], one_for_all(0, x)[0], x[0], x[1]);
  EXPECT_EQ(error_in(mesh, read_field(folder.write("a.csv", text), mesh).displacement, one_for_all), 0);
}

TEST(CsvField, DigitsDecideWhatIsOnePlace) {
  const Folder folder;
  const Mesh<2> mesh = two_blocks_mesh(3);  // thirds
  const std::string six = csv_of(mesh, 2, linear_motion, true, "{:.6g}");
  const GivenDisplacement given = read_field(folder.write("a.csv", six), mesh);
  EXPECT_LE(error_in(mesh, given.displacement, linear_motion), 1e-5);
  EXPECT_GT(given.off, 1e-7);
  EXPECT_LE(given.off, 1e-5);
  // Four digits are not taken for rounding: thirds are elsewhere.
  expect_refused(folder.write("a.csv", csv_of(mesh, 2, linear_motion, true, "{:.4g}")), mesh, {"a.csv:", "no vertex"});
  // Between nodes that six digits do not tell apart nothing is decided.
  Mesh<2> small = mesh;
  for (Vector<2>& x : small.vertices) x = 1e-6 * x + Vector<2>(1, 1. / 3);
  expect_refused(folder.write("a.csv", csv_of(small, 2, linear_motion, true, "{:.6g}")), small, {"too few digits"});
}

TEST(CsvField, WhatIsWrongIsOneLine) {
  const Folder folder;
  const Mesh<2> mesh = two_blocks_mesh(2);
  const std::string good = csv_of(mesh, 1, linear_motion, true);
  const auto refused = [&](const std::string& text, const std::vector<std::string>& named) {
    expect_refused(folder.write("a.csv", text), mesh, named);
  };
  const auto with_line = [&](const std::string& line) {
    return replaced(good, "0,0,0.10000000000000001,0,lower", line);
  };
  refused("", {"a.csv: is empty"});
  refused("x,y,ux\n", {"a.csv:1: there is no column 'uy'"});
  refused("x,y,ux,uy,p\n", {"a.csv:1: the column 'p' is not known", "body"});
  refused("x,y,ux,uy,ux\n", {"'ux' is there twice"});
  refused("x,y,ux,uy\n", {"has no displacements"});
  refused(with_line("0,0,0,nan,lower"), {"a.csv:2: ", "(0, 0)", "displacement", "nan"});
  refused(with_line("0,0,inf,0,lower"), {"a.csv:2: ", "inf"});
  refused(with_line("0,inf,0,0,lower"), {"a.csv:2: ", "coordinate inf"});
  refused(with_line("0,0,a,0,lower"), {"a.csv:2: 'a' is not a number"});
  refused(with_line("0,0,0"), {"a.csv:2: there are 3 values, and 5 columns"});
  refused(with_line("0,0,0,0,lowr"), {"a.csv:2: ", "'lowr'", "did you mean 'lower'"});
  refused(with_line("0,0,0,0,upper"), {"a.csv:2: ", "no node of the body 'upper'"});
  refused(with_line("0.1,0,0,0,lower"), {"a.csv:2: the point (0.1, 0) is no vertex", "bracket mesh"});
  refused(replaced(good, "0,0,0.10000000000000001,0,lower\n", ""),
          {"no displacement at 1 of the 18 vertices", "(0, 0)"});
  refused(good + "0.25,0,0,0,lower\n", {"of the 50 vertices and midpoints"});
  refused(good + "0,0,7,0,lower\n", {"another displacement than that of the line 2", "'lower'"});
  refused(good.substr(0, good.size() / 2), {"a.csv"});
  refused("x,y,ux,uy,uz\n0,0,0,0,1\n", {"a.csv:2: ", "out of the plane"});
  refused("x,y,z,ux,uy\n0,0,0,0,1\n1,0,1,0,0\n", {"a.csv:3: ", "z = 1"});
  expect_refused(folder.path() / "none.csv", mesh, {"none.csv: no such file"});
  expect_refused(folder.write("a.txt", good), mesh, {"a.txt: is of no kind that is read", ".csv", ".vtu", ".frd"});
}

}  // namespace
}  // namespace bracket::scene
