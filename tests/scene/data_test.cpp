// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <limits>

#include "scene/problem/projection.h"
#include "tests/scene/inputs.h"

namespace bracket::scene {
namespace {

using namespace test;

Problem<2> fixed(const Scene<2>& scene) { return fix_data(scene, build_mesh(scene)); }

TEST(Projection, KeepsResultantAndMoment) {
  const Vector<2> a(0.5, 1), b(2.5, 0);
  for (int degree = 0; degree <= 8; ++degree) {
    const auto power = [&](const Vector<2>& x) { return std::pow((x - a).norm() / (b - a).norm(), degree); };
    const auto [left, right] = project(power, a, b, 1, "").value.linear;
    EXPECT_NEAR((left + right) / 2, 1.0 / (degree + 1), 8 * eps) << degree;    // ∫ s^n
    EXPECT_NEAR(left / 6 + right / 3, 1.0 / (degree + 2), 8 * eps) << degree;  // ∫ s · s^n
  }
}

/// Of short coefficients: c_0 + c_1 s + c_2 s² + c_3 s³ along the edge from a to b.
Function<2> cubic_along(const Vector<2>& a, const Vector<2>& b, const std::array<double, 4>& c) {
  const Vector<2> e = (b - a) / (b - a).squaredNorm();
  return enclosed<2>([=](const auto& x) {
    const auto s = (x[0] - a[0]) * e[0] + (x[1] - a[1]) * e[1];
    return c[0] + s * (c[1] + s * (c[2] + s * c[3]));
  });
}

TEST(Projection, PolynomialsUpToTheDegreeAreKept) {
  const Vector<2> a(0.5, 1), b(2.5, 0);
  for (const int degree : {1, 2, 3})
    for (int power = 0; power <= 4; ++power) {
      std::array<double, 4> c = {0.25, 0, 0, 0};
      if (power < 4) c[power] += 1;
      const Function<2> given =
          power < 4 ? cubic_along(a, b, c) : Function<2>([&](const Vector<2>& x) { return std::pow(x[0] - 0.5, 4); });
      const EdgeLoad load = project(given, a, b, degree, "");
      for (const double s : {0.0, 0.3, 0.5, 1.0})
        if (power <= degree) {
          EXPECT_NEAR(value_at(load.value, s), given((1 - s) * a + s * b), 32 * eps) << degree << power;
        }
      if (power <= degree)
        EXPECT_LE(load.error, 32 * eps) << degree << power;
      else
        EXPECT_GT(load.error, 1e-3) << degree << power;
      if (power < 2) {
        EXPECT_EQ(load.value.higher, (std::array{0.0, 0.0}));  // to the last bit: nothing to carry
      }
      if (degree < 3) {
        EXPECT_EQ(load.value.higher[1], 0);
      }
      const EdgeLoad linear = project(given, a, b, 1, "");
      EXPECT_EQ(load.value.linear, linear.value.linear);
      EXPECT_LE(load.error, linear.error);
    }
}

// On a stretch the polynomial is the same, and in two steps what it is in one.
TEST(Projection, StretchesHaveTheSamePolynomial) {
  const EdgeCubic<double> whole = {{0.5, -1.25}, {0.75, 2.5}};
  for (const auto& [from, to] : std::vector<std::array<double, 2>>{{0, 1}, {0, 0.5}, {0.5, 1}, {0.25, 0.375}}) {
    const auto part = on_stretch<double>(whole, from, to);
    for (double t = 0; t <= 1; t += 0.125)
      EXPECT_NEAR(value_at(part, t), value_at(whole, from + t * (to - from)), 16 * eps);
    const auto twice = on_stretch<double>(part, 0.5, 0.75);
    const auto once = on_stretch<double>(whole, from + 0.5 * (to - from), from + 0.75 * (to - from));
    for (int i = 0; i < 2; ++i) {
      EXPECT_NEAR(twice.linear[i], once.linear[i], 16 * eps);
      EXPECT_NEAR(twice.higher[i], once.higher[i], 16 * eps);
    }
  }
}

TEST(Projection, ConstantsAndLinearFunctionsStayExact) {
  const Vector<2> a(0.1, 0.7), b(0.3, 1.1);
  EXPECT_EQ(project(constant(0.1), a, b, 1, "").value.linear, (std::array{0.1, 0.1}));
  EXPECT_EQ(project(constant(0.1), a, b, 1, "").error, 0);
  const Function<2> linear = [](const Vector<2>& x) { return 3 - 0.7 * x[0] + 1e3 * x[1]; };
  EXPECT_EQ(project(linear, a, b, 1, "").value.linear, (std::array{linear(a), linear(b)}));
  const Vector<2> far(1e6, -1e6);  // where the points themselves are rounded
  EXPECT_EQ(project(linear, a + far, b + far, 1, "").value.linear, (std::array{linear(a + far), linear(b + far)}));
}

TEST(Projection, AJumpAtAnEndDoesNotMatter) {
  const Function<2> jump = [](const Vector<2>& x) { return x[0] < 0.5 ? -0.1 : 0.09; };
  EXPECT_EQ(project(jump, {0.25, 0}, {0.5, 0}, 1, "").value.linear, (std::array{-0.1, -0.1}));
  EXPECT_EQ(project(jump, {0.5, 0}, {0.75, 0}, 1, "").value.linear, (std::array{0.09, 0.09}));
  const Function<2> ramp = [](const Vector<2>& x) { return x[0] < 0.5 ? x[0] : 7.0; };
  const auto [left, right] = project(ramp, {0.25, 0}, {0.5, 0}, 1, "").value.linear;
  EXPECT_NEAR(left, 0.25, 8 * eps);
  EXPECT_NEAR(right, 0.5, 8 * eps);
  const Function<2> pole = [](const Vector<2>& x) { return std::sin(x[0]) / x[0]; };  // not a number at 0 only
  EXPECT_NEAR(project(pole, {0, 0}, {1e-3, 0}, 1, "").value.linear[0], 1, 1e-7);
}

TEST(Projection, AJumpInsideIsReported) {
  const Function<2> jump = [](const Vector<2>& x) { return x[0] < 0.5 ? -1.0 : 1.0; };
  const EdgeLoad values = project(jump, {0, 0}, {1, 0}, 1, "");
  EXPECT_NEAR(values.value.linear[1], 1.5, 1e-14);  // 3 ∫ |2s − 1| = 3/2; the panels meet at the jump
  EXPECT_GT(values.error, 0.9);
  EXPECT_EQ(values.largest, 1);
}

TEST(Interpolation, QuadraticIsExactForQuadraticFunctions) {
  const Function<2> gap = [](const Vector<2>& x) { return 0.5 * x[0] * x[0] - x[1]; };
  const FacetValues<3> values = interpolate_quadratic(gap, {-1, 0}, {3, 1}, "");
  EXPECT_EQ(values.value, (std::array{0.5, 3.5, 0.0}));
  EXPECT_LE(values.error, 16 * eps);
  EXPECT_GT(interpolate_quadratic([](const Vector<2>& x) { return std::pow(x[0], 3); }, {0, 0}, {1, 0}, "").error,
            0.01);
}

TEST(Data, ReachTheFacetsTheyAreGivenFor) {
  const auto x = enclosed<2>([](const auto& at) { return at[0]; });
  Scene<2> scene = stacked(4, {{"a.bottom", {ConditionKind::fixed, {constant(0), x}, ""}},
                               {"a.left", {ConditionKind::traction, {constant(2), constant(0.1)}, ""}},
                               {"b.right", {ConditionKind::pressure, {constant(0.3)}, ""}},
                               {"b.left", {ConditionKind::sliding, {constant(-0.2)}, ""}}});
  scene.contact[0].gap = enclosed<2>([](const auto& at) { return at[0] * at[0]; });
  const Problem<2> problem = fixed(scene);
  EXPECT_NEAR(problem.length_scale, std::sqrt(5.0), 1e-15);
  for (std::size_t i = 0; i < problem.facets.size(); ++i) {
    const auto& facet = problem.mesh.boundary[i];
    const auto& data = problem.facets[i];
    const std::string& part = problem.mesh.parts[facet.part];
    for (int end = 0; end < 2; ++end) {
      const Vector<2>& at = problem.mesh.vertices[facet.vertices[end]];
      if (part == "a.bottom") {
        EXPECT_EQ(data.support, Support::fixed);
        EXPECT_EQ(data.displacement[end], Vector<2>(0, at[0]));
      } else if (part == "b.left") {
        EXPECT_EQ(data.support, Support::sliding);
        EXPECT_EQ(data.normal_displacement[end], -0.2);
      } else {
        EXPECT_EQ(data.support, part == "a.top" || part == "b.bottom" ? Support::contact : Support::traction);
        EXPECT_EQ(data.displacement[end], Vector<2>(0, 0));
        EXPECT_EQ(data.traction[end], part == "a.left" ? Vector<2>(2, 0.1) : Vector<2>(0, 0)) << part;
        EXPECT_EQ(data.pressure[end], part == "b.right" ? 0.3 : 0) << part;
      }
    }
  }
  ASSERT_EQ(problem.contact.size(), 4u);
  for (const ContactFacet& facet : problem.contact) {
    const auto& [a, b] = problem.mesh.boundary[facet.first].vertices;
    const double from = problem.mesh.vertices[a][0], to = problem.mesh.vertices[b][0];
    EXPECT_EQ(facet.lower, (std::array{from * from, from * to, to * to}));
    EXPECT_EQ(facet.upper, facet.lower);
  }
  EXPECT_LE(problem.oscillation.traction, 4 * eps);
  EXPECT_LE(problem.oscillation.displacement, 4 * eps);
  EXPECT_LE(problem.oscillation.gap, 4 * eps);
}

// For x² on an edge of length h interpolation errs by h²/4 at the middle, and by no more.
TEST(Data, OscillationIsTheLargestErrorByTheLargestValue) {
  const Function<2> square = [](const Vector<2>& at) { return 3 * at[0] * at[0]; };
  const Problem<2> problem = fixed(stacked(
      4, {{"a.bottom", {ConditionKind::sliding, {square}, ""}}, {"b.top", {ConditionKind::pressure, {square}, ""}}}));
  EXPECT_GT(problem.oscillation.displacement, 0.98 / 64);
  EXPECT_LE(problem.oscillation.displacement, 1.001 / 64);
  EXPECT_GT(problem.oscillation.traction, 0.9 / 96);  // L2: h²/6 at the ends
  EXPECT_LE(problem.oscillation.traction, 1.0 / 90);
  EXPECT_EQ(problem.oscillation.gap, 0);
}

// With degree 4 cubic loads are what they are written to be, with 3 what is beside quadratics moves them.
TEST(Data, CubicLoadsAreKeptByDegree4) {
  const auto cubic = enclosed<2>([](const auto& at) { return at[0] * at[0] * (1 + at[0]); });
  const auto other = enclosed<2>([](const auto& at) { return at[1] * (at[1] - 2) * at[1]; });
  double before = 1;
  for (const int degree : {2, 3, 4}) {
    Scene<2> scene = stacked(4, {{"b.top", {ConditionKind::pressure, {cubic}, ""}},
                                 {"a.left", {ConditionKind::traction, {other, cubic}, ""}}});
    scene.solve.degree = degree;
    const Problem<2> problem = fixed(scene);
    EXPECT_EQ(degree_of_loads(problem), degree - 1);
    EXPECT_LT(problem.oscillation.traction, 0.2 * before);
    before = problem.oscillation.traction;
    // Every facet of a refined mesh has the same function, its load the same resultant.
    const std::vector<char> all(problem.mesh.cells.size(), 1);
    const Problem<2> fine = refine(refine(problem, all).problem, std::vector<char>(4 * all.size(), 1)).problem;
    for (std::size_t f = 0; f < fine.facets.size(); ++f) {
      const auto [of, corner] = piece_of_facet(fine, static_cast<int>(f));
      for (const double t : {0.0, 0.25, 1.0}) {
        const double s = corner[0][0] + t * (corner[1][0] - corner[0][0]);
        EXPECT_NEAR(pressure_at(fine.facets[f], t), pressure_at(problem.facets[of], s), 16 * eps);
        EXPECT_LE((traction_at(fine.facets[f], t) - traction_at(problem.facets[of], s)).norm(), 16 * eps);
      }
    }
  }
  EXPECT_LE(before, 16 * eps);
}

/// What is prescribed along x at each vertex of y = 0, up to the sign of a normal.
std::map<int, std::vector<double>> prescribed_at_base(const Problem<2>& problem) {
  std::map<int, std::vector<double>> prescribed;
  for (std::size_t i = 0; i < problem.facets.size(); ++i) {
    const auto& vertices = problem.mesh.boundary[i].vertices;
    for (int end = 0; end < 2; ++end) {
      if (problem.mesh.vertices[vertices[end]][1] != 0) continue;
      if (problem.facets[i].support == Support::fixed) {
        prescribed[vertices[end]].push_back(problem.facets[i].displacement[end][0]);
      } else if (problem.facets[i].support == Support::sliding) {
        prescribed[vertices[end]].push_back(std::abs(problem.facets[i].normal_displacement[end]));
      }
    }
  }
  return prescribed;
}

// Two parts may say the same about a corner with different rounding; then they are made to agree.
TEST(Data, CornersAgreeToTheLastBit) {
  const double third = 1.0 / 3, more = third * (1 + 1e-12), less = third * (1 - 1e-12);
  const auto held = [](double x) { return Condition<2>{ConditionKind::fixed, {constant(x), constant(1)}, ""}; };
  const auto guided = [](double x) { return Condition<2>{ConditionKind::sliding, {constant(x)}, ""}; };
  for (const auto& [left, right] : {std::pair(held(more), guided(less)), std::pair(guided(-more), held(less))}) {
    const Problem<2> problem = fixed(stacked(2, {{"a.bottom", held(third)}, {"a.left", left}, {"a.right", right}}));
    const auto prescribed = prescribed_at_base(problem);
    ASSERT_EQ(prescribed.size(), 3u);
    for (const auto& [vertex, values] : prescribed) {
      ASSERT_EQ(values.size(), 2u);
      EXPECT_EQ(values[0], values[1]);
    }
  }
}

// Sliding sides at a right angle prescribe different components: nothing to agree on.
TEST(Data, SlidingSidesMayDifferAtACorner) {
  EXPECT_NO_THROW(fixed(stacked(2, {{"a.bottom", {ConditionKind::sliding, {constant(0)}, ""}},
                                    {"a.left", {ConditionKind::sliding, {constant(5)}, ""}}})));
}

// 0.1 + 0.2 exceeds 0.3 by rounding; where both sides are prescribed nothing could give way.
TEST(Data, GapsThatRoundingClosesAreRaised) {
  const auto held = [](double y) { return Condition<2>{ConditionKind::fixed, {constant(0), constant(y)}, ""}; };
  const auto gaps = [&](int cells, double gap) {
    Scene<2> scene = stacked(
        cells, {{"a.left", held(0.1)}, {"a.right", held(0.1)}, {"b.left", held(-0.2)}, {"b.right", held(-0.2)}});
    scene.contact[0].gap = constant(gap);
    std::vector<std::array<double, 3>> result;
    for (const ContactFacet& facet : fixed(scene).contact) {
      EXPECT_EQ(facet.upper, facet.lower);
      result.push_back(facet.lower);
    }
    return result;
  };
  const long double approach = static_cast<long double>(0.1) + 0.2;
  const auto has_room = [&](double gap) { return gap >= approach && gap <= 0.3 + 2 * eps; };
  for (const int cells : {1, 3}) {
    int raised = 0;
    for (const auto& gap : gaps(cells, 0.3))
      for (const double value : gap) raised += value == 0.3 ? 0 : has_room(value) ? 1 : 100;
    EXPECT_EQ(raised, 2) << cells;  // the ends of the contact line
  }
  for (const double kept : {0.4, 0.3 + eps, 0.3 - 1e-13})  // enough, and too little for rounding
    for (const auto& gap : gaps(2, kept)) EXPECT_EQ(gap, (std::array{kept, kept, kept}));
}

struct Bad {
  Scene<2> scene;
  std::vector<std::string> named;
};

TEST(Data, ContradictionsAreRefused) {
  const auto scene_with = [](std::map<std::string, Condition<2>> boundary) { return stacked(2, std::move(boundary)); };
  const Function<2> root = [](const Vector<2>& at) { return std::sqrt(at[0] - 0.5); };
  const Condition<2> fixed_here = {ConditionKind::fixed, {constant(1), constant(0)}, "here"};
  const Condition<2> pressed = {ConditionKind::pressure, {constant(1)}, "there"};
  const auto pressed_by = [&](double p) {  // from a formula, which is no number in the scene file
    return scene_with({{"a.left", {ConditionKind::pressure, {[p](const Vector<2>& x) { return p * x[1]; }}, "here"}}});
  };
  Scene<2> odd_gap = scene_with({}), unknown_side = scene_with({}), unknown_wall = scene_with({});
  odd_gap.contact[0].gap = root;
  odd_gap.contact[0].where = "here";
  unknown_side.contact[0].second = "b.botom";
  unknown_wall.contact[0].second = "rigd";
  Scene<2> no_body = scene_with({}), other_body = scene_with({});
  no_body.file = "the scene";
  no_body.bodies.erase("b");
  other_body.bodies.emplace("c", other_body.bodies.at("a"));
  other_body.bodies.at("c").where = "here";
  const std::map<std::string, Bad> cases = {
      {"unknown part", {scene_with({{"a.botom", fixed_here}}), {"here:", "'a.botom'", "'a.bottom'", "b.top"}}},
      {"unknown contact side", {unknown_side, {"'b.botom'", "'b.bottom'"}}},
      {"unknown wall", {unknown_wall, {"'rigd'", "did you mean 'rigid'", "b.bottom"}}},
      {"contact and pressure", {scene_with({{"b.bottom", pressed}}), {"'b.bottom'", "contact", "there"}}},
      {"body without material", {no_body, {"the scene:", "'b'"}}},
      {"material without body", {other_body, {"here:", "'c'", "did you mean 'a'"}}},
      {"fixed and fixed",
       {scene_with(
            {{"a.bottom", fixed_here}, {"a.left", {ConditionKind::fixed, {constant(1.001), constant(0)}, "there"}}}),
        {"'a.bottom'", "'a.left'", "(0, 0)", "contradict"}}},
      {"fixed and sliding",
       {scene_with({{"a.bottom", fixed_here}, {"a.right", {ConditionKind::sliding, {constant(-1)}, "there"}}}),
        {"'a.bottom'", "'a.right'", "(1, 0)"}}},
      {"not finite",
       {scene_with({{"a.bottom", {ConditionKind::pressure, {root}, "here"}}}), {"here:", "(", "not finite"}}},
      {"not finite, fixed",
       {scene_with({{"a.bottom", {ConditionKind::sliding, {root}, "here"}}}), {"here:", "not finite"}}},
      {"gap not finite", {odd_gap, {"here:", "not finite"}}},
      {"far too large", {pressed_by(1e200), {"here:", "e+199", "1e+50"}}},
      {"far too small", {pressed_by(1e-200), {"the largest traction", "e-201", "1e-50"}}},
  };
  for (const auto& [name, bad] : cases) {
    const auto error = error_of([&] { fixed(bad.scene); });
    ASSERT_TRUE(error.has_value()) << name;
    EXPECT_EQ(error->status(), Status::input) << name;
    for (const std::string& part : bad.named) {
      EXPECT_NE(std::string(error->what()).find(part), std::string::npos) << name << ": " << error->what();
    }
  }
}

// A part of that name would be taken for a wall without a word.
TEST(Data, PartNamedRigidIsRefusedWhereAWallIsMeant) {
  Scene<2> scene = stacked(2, {});
  Mesh<2> mesh = build_mesh(scene);
  std::replace(mesh.parts.begin(), mesh.parts.end(), std::string("b.top"), std::string("rigid"));
  EXPECT_NO_THROW(fix_data(scene, mesh));
  scene.contact[0].second = "rigid";
  scene.contact[0].where = "here";
  const auto error = error_of([&] { fix_data(scene, mesh); });
  ASSERT_TRUE(error.has_value());
  EXPECT_EQ(error->status(), Status::input);
  EXPECT_EQ(std::string(error->what()).find("here: 'rigid'"), 0u) << error->what();
}

TEST(Motion, IsDescribedWithoutTheRoundingOfItsCoordinates) {
  EXPECT_EQ(describe<2>({{1e-17, 1}, 0, {2, 3}}), "moving it by (0, 1)");
  // The pole is centre + (−t_y, t_x) / rotation.
  EXPECT_EQ(describe<2>({{0, 1 + eps}, 1, {1, 1.5}}), "turning it counter-clockwise about (0, 1.5)");
  EXPECT_EQ(describe<2>({{0, 0}, -1e6, {3e-7, 1e-7}}), "turning it clockwise about (3e-07, 1e-07)");  // a small body
}

// Two collinear sliding parts meet at a vertex: there they prescribe the same component.
TEST(Data, CollinearSlidingPartsMustAgree) {
  const Folder folder;
  GmshContent content = two_squares();
  content.nodes = {{0, 0}, {1, 0}, {2, 0}, {1, 1}};
  content.triangles = {{1, {0, 1, 3}}, {1, {1, 2, 3}}};
  content.lines = {{5, {0, 1}}, {6, {1, 2}}};
  Scene<2> scene;
  scene.mesh_file = folder.write("a.msh", gmsh_2(content));
  scene.bodies = {{"lower", isotropic<2>(1, 0, Plane::strain)}};
  scene.boundary = {{"base", {ConditionKind::sliding, {constant(0.5)}, "one"}},
                    {"joint below", {ConditionKind::sliding, {constant(0.5 * (1 + 1e-11))}, "other"}}};
  const Problem<2> problem = fixed(scene);
  EXPECT_EQ(problem.facets[facet_at(problem.mesh, "joint below", {1.5, 0})].normal_displacement[0], 0.5);
  scene.boundary.at("base").value[0] = constant(0.51);
  const auto error = error_of([&] { fixed(scene); });
  ASSERT_TRUE(error.has_value());
  EXPECT_NE(std::string(error->what()).find("(1, 0)"), std::string::npos) << error->what();
  // With a kink there the two are different components.
  content.nodes[1] = {1, -0.01};
  folder.write("a.msh", gmsh_2(content));
  EXPECT_NO_THROW(fixed(scene));
}

}  // namespace
}  // namespace bracket::scene
