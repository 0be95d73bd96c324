// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "tests/compare/admissible.h"
#include "tests/compare/exact.h"
#include "tests/scene/inputs.h"
#include "tests/support/scenes.h"

namespace bracket::tests {
namespace {

/// Where a scene is put: turned about the origin, then shifted; coordinates are rounded to `digits` behind the point.
struct Place {
  double angle = 0;
  Vector<2> shift = Vector<2>::Zero();
  int digits = 8;

  Eigen::Matrix2d turn() const { return Eigen::Rotation2Dd(angle).toRotationMatrix(); }
  Vector<2> there(const Vector<2>& x) const {
    const double units = std::pow(10, digits);
    return ((turn() * x + shift) * units).array().round() / units;
  }
  Vector<2> back(const Vector<2>& x) const { return turn().transpose() * (x - shift); }
  scene::Function<2> there(const scene::Function<2>& f) const {
    return [f, place = *this](const Vector<2>& x) { return f(place.back(x)); };
  }
  /// A displacement or traction.
  std::vector<scene::Function<2>> there(const std::vector<scene::Function<2>>& f) const {
    const auto component = [f, place = *this](int c) {
      return [=](const Vector<2>& x) {
        const Vector<2> at = place.back(x);
        return place.turn().row(c).dot(Vector<2>(f[0](at), f[1](at)));
      };
    };
    return {component(0), component(1)};
  }
  /// Of coordinates in floating point, for bodies of size 2.
  double rounding() const { return 2 * std::numeric_limits<double>::epsilon() * (shift.cwiseAbs().maxCoeff() + 2); }
  /// What rounding of its vertices does to a cell of height h, as a displacement gradient: two ends move by √½ each.
  double gradient(double h) const { return 2 * std::sqrt(0.5) * (std::pow(10, -digits) + rounding()) / h; }
};

/// The scene there: its blocks as a mesh file in `folder`, its conditions, gaps and weights.
/// \pre isotropic materials
scene::Scene<2> placed(scene::Scene<2> scene, const Place& place, const scene::test::Folder& folder) {
  const scene::Mesh<2> mesh = scene::build_mesh(scene);
  scene::test::GmshContent content;
  for (std::size_t b = 0; b < mesh.bodies.size(); ++b)
    content.names += "2 " + std::to_string(b + 1) + " \"" + mesh.bodies[b] + "\"\n";
  for (std::size_t p = 0; p < mesh.parts.size(); ++p)
    content.names += "1 " + std::to_string(p + 1) + " \"" + mesh.parts[p] + "\"\n";
  for (const Vector<2>& x : mesh.vertices) content.nodes.push_back({place.there(x)[0], place.there(x)[1]});
  for (std::size_t c = 0; c < mesh.cells.size(); ++c)
    content.triangles.push_back({mesh.cell_body[c] + 1, {mesh.cells[c].begin(), mesh.cells[c].end()}});
  for (const auto& facet : mesh.boundary)
    content.lines.push_back({facet.part + 1, {facet.vertices.begin(), facet.vertices.end()}});
  scene.blocks.clear();
  scene.mesh_file = folder.write("placed.msh", scene::test::gmsh_2(content));
  for (auto& [name, body] : scene.bodies) body.force = place.turn() * body.force;
  for (auto& [name, condition] : scene.boundary) {
    if (condition.value.size() == 2)
      condition.value = place.there(condition.value);
    else
      condition.value = {place.there(condition.value[0])};
  }
  for (auto& pair : scene.contact) pair.gap = place.there(*pair.gap);
  return scene;
}

const std::vector<Place> places = {{.angle = 0.5},
                                   {.angle = -2.2, .digits = 7},
                                   {.shift = {1e6, -1e6}},
                                   {.shift = {-1e8, 1e8}},
                                   {.angle = 0.5, .shift = {1e3, 1e3}},
                                   {.angle = 1, .shift = {1e4, 0}, .digits = 10},
                                   {.angle = 0.5, .shift = {1e6, 1e6}},
                                   {.angle = 0.5, .shift = {1e8, 1e8}}};

/// To first order a gradient ε of the map between two bodies changes areas by 2 ε, strains and stresses by ε each times
/// Korn's constant, directions by ε; the energies, which are minima, by as much as their integrals.
constexpr double sensitivity = 10;

/// Upper bounds do not rise, but for what the rounding of new midpoints makes of bodies of size 1.
void expect_falling(const bounds::Outcome<2>& outcome, const Place& place) {
  for (std::size_t i = 1; i < outcome.levels.size(); ++i) {
    const double before = outcome.levels[i - 1].bracket.upper;
    EXPECT_LE(outcome.levels[i].bracket.upper, before + sensitivity * place.rounding() * std::abs(before));
  }
}

scene::Scene<2> heavy_blocks(double weight) {
  scene::Scene<2> scene = two_blocks(4);
  for (auto& [name, body] : scene.bodies) body.force = {0, -weight};
  return scene;
}

TEST(RoundedCoordinates, keep_the_interval_of_two_blocks) {
  const scene::test::Folder folder;
  for (const double weight : {0.0, 0.02}) {
    const auto straight = bounds::run(heavy_blocks(weight)).levels[0].bracket;
    for (const Place& place : places) {
      SCOPED_TRACE(testing::Message() << weight << ", " << place.angle << ", " << place.shift.transpose());
      scene::Scene<2> scene = placed(heavy_blocks(weight), place, folder);
      scene.refine = {.strategy = scene::Strategy::adaptive, .target = 0.01};
      const auto outcome = bounds::run(scene);
      EXPECT_EQ(outcome.status, scene::Status::done) << outcome.reason;
      ASSERT_FALSE(outcome.levels.empty());
      expect_admissible(outcome);
      expect_falling(outcome, place);
      const double slack = sensitivity * place.gradient(0.25 * std::sqrt(0.5)) * std::abs(straight.lower);
      EXPECT_NEAR(outcome.levels[0].bracket.lower, straight.lower, slack);
      EXPECT_NEAR(outcome.levels[0].bracket.upper, straight.upper, slack);
      if (weight > 0) continue;
      EXPECT_LE(outcome.lower, -0.00156588566432 + slack);
      EXPECT_GE(outcome.upper, -0.00156588569415 - slack);
    }
  }
}

// Sideways nothing holds the bodies: the pressure on the top and those in the contact and on the base must have one
// direction, or they would drift off. The bounds meet on every level; rounded midpoints must not make them cross.
TEST(RoundedCoordinates, keep_floating_bodies_in_balance) {
  const LinearPressure p;
  const double exact = linear_pressure_energy(p.p0, p.c, {p.t_lower, plane_modulus(p.young_lower, p.poisson)},
                                              {p.t_upper, plane_modulus(p.young_upper, p.poisson)});
  const scene::test::Folder folder;
  for (const Place& place : places) {
    SCOPED_TRACE(testing::Message() << place.angle << ", " << place.shift.transpose());
    scene::Scene<2> scene = placed(linear_pressure(p, 4, 2), place, folder);
    scene.refine = {.strategy = scene::Strategy::uniform, .max_levels = 4};
    const auto outcome = bounds::run(scene);
    EXPECT_EQ(outcome.status, scene::Status::done) << outcome.reason;
    EXPECT_EQ(outcome.levels.size(), 4u);
    expect_admissible(outcome);
    expect_falling(outcome, place);
    EXPECT_LE(outcome.lower, outcome.upper);
    const double slack = sensitivity * place.gradient(0.2) * std::abs(exact);
    EXPECT_NEAR(outcome.lower, exact, slack);
    EXPECT_NEAR(outcome.upper, exact, slack);
  }
}

// Coordinates of 1e13 are multiples of 2⁻⁹: cells are halved until they have no more digits, and the bounds still hold.
TEST(RoundedCoordinates, end_refinement_where_they_resolve_no_more) {
  const scene::test::Folder folder;
  scene::Scene<2> scene = placed(two_blocks(4), {.shift = {1e13, 1e13}, .digits = 2}, folder);
  scene.refine = {.strategy = scene::Strategy::adaptive, .target = 1e-6};
  const auto outcome = bounds::run(scene);
  EXPECT_EQ(outcome.status, scene::Status::budget);
  EXPECT_NE(outcome.reason.find("cannot be refined any further"), std::string::npos) << outcome.reason;
  expect_admissible(outcome);
  EXPECT_LE(outcome.lower, -0.00156588566432);
  EXPECT_GE(outcome.upper, -0.00156588569415);
  EXPECT_LT(outcome.relative_error_bound, 0.02);
}

// A block is moved along the wall that it stands on, by what is no multiple of the wall's direction in floating point:
// what is prescribed closes the gap by less than the rounding of products in extended precision.
TEST(RoundedCoordinates, keep_room_for_motions_along_a_wall) {
  const scene::test::Folder folder;
  for (int i = 1; i <= 20; ++i) {
    const Place place{.angle = 0.0731 * i, .digits = 15};
    const Vector<2> along = place.turn() * Vector<2>(0.01, 0), down = place.turn() * Vector<2>(0, -0.1);
    scene::Scene<2> scene;
    scene.blocks = {{"block", {{{0, 1}, {0, 1}}}, {2, 2}}};
    scene.bodies.emplace("block", scene::isotropic<2>(1, 0.3, scene::Plane::strain));
    scene.contact = {{"block.bottom", "rigid", 0.0, ""}};
    scene.boundary = {{"block.left", {ConditionKind::fixed, {0.0, 0.0}, ""}},
                      {"block.top", {ConditionKind::traction, {0.0, 0.0}, ""}}};
    scene = placed(scene, place, folder);
    scene.contact[0].gap = 0.0;
    scene.boundary.at("block.left").value = {along[0], along[1]};
    scene.boundary.at("block.top").value = {down[0], down[1]};
    const auto outcome = bounds::run(scene);
    EXPECT_EQ(outcome.guarantee, "rounding-safe") << place.angle << ": " << outcome.reason;
  }
}

}  // namespace
}  // namespace bracket::tests
