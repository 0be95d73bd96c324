// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of space: what is seen has the size that it must have.
#include "apps/plots/space/pictures.h"

#include <cmath>
#include <regex>

#include "tests/apps/command.h"
#include "tests/apps/space/scenes.h"

namespace bracket::apps::tests {
namespace {

double area(const std::vector<Tessera>& pieces) {
  double sum = 0;
  for (const Tessera& piece : pieces)
    for (std::size_t i = 2; i < piece.corner.size(); ++i) {
      const scene::Vector<2> b = piece.corner[i - 1] - piece.corner[0], c = piece.corner[i] - piece.corner[0];
      sum += std::abs(b.x() * c.y() - b.y() * c.x()) / 2;
    }
  return sum;
}

/// A box of the size 1 × 2 × 3 without displacements and stresses.
bounds::Outcome<3> box(int degree) {
  scene::Scene<3> scene;
  scene.blocks = {{"box", {{{0, 1}, {0, 2}, {0, 3}}}, {2, 3, 2}, ""}};
  scene.bodies.emplace("box", scene::isotropic<3>(1, 0.3));
  scene.boundary["box.bottom"] = {scene::ConditionKind::fixed, {0.0, 0.0, 0.0}};
  bounds::Outcome<3> outcome;
  outcome.problem = scene::fix_data(scene, scene::build_mesh(scene));
  const scene::Mesh<3>& mesh = outcome.problem.mesh;
  outcome.displacement.degree = degree;
  outcome.displacement.vertex.assign(mesh.vertices.size(), scene::Vector<3>::Zero());
  if (degree == 2) outcome.displacement.edge.assign(mesh.edges.size(), scene::Vector<3>::Zero());
  outcome.stress.cell.assign(mesh.cells.size(), std::vector<scene::Voigt<3>>(16, scene::Voigt<3>::Zero()));
  outcome.indicator.cell.assign(mesh.cells.size(), 1.0);
  return outcome;
}

// Of a convex body half of the surface is seen: its projection has the area Σ |d_k| A_k.
TEST(PicturesInSpace, ABoxIsSeenOnce) {
  for (const int degree : {1, 2})
    for (const scene::Vector<3>& from :
         {scene::Vector<3>(0.5, 0.4, 1), scene::Vector<3>(-0.5, -0.4, -1), scene::Vector<3>(1, 0.1, 0.01)}) {
      const bounds::Outcome<3> run = box(degree);
      const Eye eye(from);
      const scene::Vector<3> d = eye.to_eye.cwiseAbs();
      const double expected = d.x() * 6 + d.y() * 3 + d.z() * 2;
      for (const SurfaceColour& colour : {by_von_mises(run), by_density(run.problem.mesh, run.indicator.cell)})
        EXPECT_NEAR(area(surface(run.problem, run.displacement, drawn_shape(run.problem, 1), eye, colour)), expected,
                    1e-12 * expected);
    }
}

// A slice of a box is a rectangle, also where it runs along faces of cells.
TEST(PicturesInSpace, ASliceIsARectangle) {
  const bounds::Outcome<3> run = box(2);
  const DrawnShapeOf<3> shape = drawn_shape(run.problem, 1);
  for (const double at : {0.0, 0.1, 0.5, 0.77, 1.0}) EXPECT_NEAR(area(slice(run, shape, 0, at, {2, 1})), 6, 1e-12);
  for (const double at : {0.0, 0.1, 1.5, 1.77, 3.0}) EXPECT_NEAR(area(slice(run, shape, 2, at, {0, 1})), 2, 1e-12);
  EXPECT_TRUE(slice(run, shape, 1, 2.5, {0, 2}).empty());
}

TEST(PicturesInSpace, ColoursAndLengthsAreOnTheScale) {
  Sketch sketch;
  sketch.pieces = {{.corner = {{0, 0}, {10, 0}, {0, 10}}, .value = 0},
                   {.corner = {{10, 0}, {10, 10}, {0, 10}}, .value = 4}};
  sketch.colours = {.lowest = 0, .highest = 4, .label = "s [<unit>]"};
  sketch.axes = {scene::Vector<2>(1, 0), scene::Vector<2>(0, 1), scene::Vector<2>::Zero()};
  sketch.length_unit = " mm";
  const std::string drawn = svg(sketch);
  EXPECT_NE(drawn.find("fill=\"#440154\" stroke=\"#440154\""), std::string::npos);
  EXPECT_NE(drawn.find("fill=\"#fde725\" stroke=\"#fde725\""), std::string::npos);
  EXPECT_NE(drawn.find("s [&lt;unit&gt;]"), std::string::npos);
  std::smatch triangle, bar;  // the first triangle's lower side is 10 mm long; the bar tells the same scale
  ASSERT_TRUE(std::regex_search(drawn, triangle, std::regex(R"(d="M([0-9.]+) [0-9.]+L([0-9.]+) )")));
  ASSERT_TRUE(std::regex_search(drawn, bar, std::regex(R"re(v-6v3h([0-9.]+)v-3v6"/>\s*<text[^>]*>([0-9.]+) mm)re")));
  EXPECT_NEAR((std::stod(triangle[2]) - std::stod(triangle[1])) / 10, std::stod(bar[1]) / std::stod(bar[2]), 0.1);
}

class HtmlInSpace : public Command {};

TEST_F(HtmlInSpace, TellsWhatIsMagnifiedAndFromWhere) {
  write("boxes.toml", two_boxes);
  ASSERT_EQ(shell("bracket run boxes.toml --set contact.0.gap=0.001").status, 0);
  const std::string html = read("boxes.out/report.html");
  for (const char* told : {"three dimensions", "displacements and gaps times", "seen from the direction",
                           "slice z = ", "tetrahedra", "pressed area"})
    EXPECT_NE(html.find(told), std::string::npos) << told;
  EXPECT_EQ(html.find("triangles"), std::string::npos);
  for (const char* name : {"stress.svg", "stress_behind.svg", "slice.svg", "mesh.svg"})
    EXPECT_EQ(read(std::string("boxes.out/") + name).find("<svg"), 0u) << name;
}

}  // namespace
}  // namespace bracket::apps::tests
