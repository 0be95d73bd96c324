// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// Contact laws in scene files and in code: what is read, fixed on meshes, inherited and refused.
#include <gtest/gtest.h>

#include "scene/problem/law.h"
#include "scene/problem/stretch.h"
#include "tests/scene/inputs.h"
#include "tests/support/scenes.h"

namespace bracket::scene {
namespace {

using namespace test;
using tests::constant;

/// Two blocks with a line for their contact.
std::string with_line(const std::string& line) {
  std::string text = two_blocks();
  const std::string contact = "[[contact]]\n";
  text.insert(text.find(contact) + contact.size(), line + "\n");
  return text;
}

ContactPair<2> read_pair(const std::string& line) {
  const Folder folder;
  const Scene<2> s = read_scene<2>(folder.write("scene.toml", with_line(line)));
  return s.contact.at(0);
}

TEST(ContactLaws, AreRead) {
  EXPECT_EQ(read_pair("").law, Law::frictionless);
  EXPECT_EQ(read_pair("law = \"bilateral\"").law, Law::bilateral);
  EXPECT_TRUE(is_two_sided(read_pair("law = \"bilateral\"")));
  const auto springs = read_pair("law = { winkler = \"2 + x\" }");
  EXPECT_EQ(springs.law, Law::winkler);
  EXPECT_EQ((*springs.value)({3, 0}), 5);
  EXPECT_FALSE(is_two_sided(springs));
  EXPECT_TRUE(is_two_sided(read_pair("law = { winkler = 2, tension = true }")));
  const auto friction = read_pair("law = { tresca = 0.5 }");
  EXPECT_EQ(friction.law, Law::tresca);
  EXPECT_FALSE(is_two_sided(friction));
  EXPECT_TRUE(is_two_sided(read_pair("law = { tresca = 0.5, liftoff = false }")));
}

TEST(ContactLaws, AreRefusedWithTheWayOut) {
  const std::vector<std::pair<std::string, std::vector<std::string>>> wrong = {
      {"law = \"winkler\"", {"needs its value", "law = { winkler = … }"}},
      {"law = \"tresca\"", {"law = { tresca = … }"}},
      {"law = \"bilatreal\"", {"bilatreal", "'bilateral'"}},
      {"law = { coulomb = 0.3, tresca = 1 }", {"'tresca' does not belong to 'coulomb'"}},
      {"law = \"coulomb\"", {"law = { coulomb = … }"}},
      {"law = { winkler = 1, tresca = 2 }", {"'winkler' does not belong to 'tresca'"}},
      {"law = { winkler = 1, liftoff = true }", {"'liftoff' does not belong to 'winkler'"}},
      {"law = { tresca = 1, tension = true }", {"'tension' does not belong to 'tresca'"}},
      {"law = { tension = true }", {"'winkler' is missing"}},
      {"law = { winkler = 1, tensoin = true }", {"tensoin", "'tension'"}},
      {"law = { winkler = 1, tension = 1 }", {"contact.law.tension must be true or false"}},
      {"law = \"bilateral\"\nzones = 2", {"cannot lift off", "no zones"}},
      {"jump = [0, 1]", {"contact.jump is of sides that keep together", "write contact.gap"}},
      {"law = { tresca = 1 }\njump = [0, 1]", {"liftoff = false"}},
      {"law = \"bilateral\"\njump = [0, 1]", {"leave one of them out"}},
      {"law = \"bilateral\"\njump = [1]", {"contact.jump"}},
      {"law = \"bonded\"\njump = [0, 1]", {"bonded sides are one piece", "tresca"}},
  };
  const Folder folder;
  for (const auto& [line, named] : wrong) {
    const auto error = error_of([&] { read_scene<2>(folder.write("scene.toml", with_line(line))); });
    ASSERT_TRUE(error.has_value()) << line;
    EXPECT_EQ(error->status(), Status::input) << line;
    for (const std::string& part : named)
      EXPECT_NE(std::string(error->what()).find(part), std::string::npos) << line << ": " << error->what();
  }
}

Scene<2> blocks(Law law, std::optional<Function<2>> value, bool lifts_off = true) {
  Scene<2> s = tests::two_blocks(4);
  s.contact[0].law = law;
  s.contact[0].value = std::move(value);
  s.contact[0].lifts_off = lifts_off;
  return s;
}

TEST(ContactLaws, InCodeAreCheckedLikeInFiles) {
  Scene<2> uzawa = blocks(Law::bilateral, {});
  uzawa.solve.dual = Dual::uzawa;
  Scene<2> local = blocks(Law::tresca, constant(1));
  local.solve.dual = Dual::local;
  const std::vector<std::pair<Scene<2>, std::string>> wrong = {
      {local, "\"frictionless\" and \"bilateral\" only; for 'tresca' write solve.dual = \"hybrid\""},
      {uzawa, "frictionless contact only; for 'bilateral' write solve.dual = \"hybrid\""},
      {blocks(Law::bonded, {}), "cannot be bonded"},
      {blocks(Law::winkler, {}), "has no value"},
      {blocks(Law::bilateral, constant(1)), "has a value"},
      {blocks(Law::bilateral, {}, false), "are \"bilateral\""},
      {blocks(Law::winkler, constant(0)), "must be positive, is 0"},
      {blocks(Law::winkler, enclosed<2>([](const auto& x) { return x[0] - 0.5; })), "must be positive, is -0.5"},
      {blocks(Law::tresca, constant(-1)), "must not be negative, is -1"},
      {blocks(Law::tresca, enclosed<2>([](const auto& x) { return x[0] * x[0]; })), "must be linear on each edge"},
      {blocks(Law::winkler, Function<2>([](const Vector<2>& x) { return 1 + x[0] * x[0]; })), "must be linear"},
  };
  for (const auto& [s, part] : wrong) {
    const auto error = error_of([&, &of = s] { tests::problem(of); });
    ASSERT_TRUE(error.has_value()) << part;
    EXPECT_NE(std::string(error->what()).find(part), std::string::npos) << error->what();
  }
}

// A quadratic is kept to rounding; else the values at the ends and the midpoint are the function's, and what is told of
// the rest bounds it.
TEST(ContactLaws, GapsOfSidesThatKeepTogetherAreInterpolated) {
  const auto parabola = enclosed<2>([](const auto& x) { return 0.01 * x[0] * x[0]; });
  const auto wave = enclosed<2>([](const auto& x) {
    using std::cos;
    return 0.01 * cos(4 * x[0]);
  });
  for (const auto& gap : {parabola, wave})
    for (const int degree : {1, 2}) {
      Scene<2> s = blocks(Law::bilateral, {});
      s.contact[0].gap = gap;
      s.solve.degree = degree;
      const Problem<2> p = tests::problem(s);
      ASSERT_EQ(p.contact.size(), 4);
      double error = 0, largest = 0;
      for (const ContactFacet& facet : p.contact) {
        const auto [a, b] = positions(p.mesh, p.mesh.boundary[facet.first].vertices);
        EXPECT_NEAR(facet.lower[0], gap(a), 1e-17);
        EXPECT_NEAR(facet.lower[2], gap(b), 1e-17);
        EXPECT_NEAR(at_middle(facet.lower), degree == 2 ? gap(0.5 * (a + b)) : 0.5 * gap(a) + 0.5 * gap(b), 1e-17);
        for (int i = 0; i <= 64; ++i) {
          const double t = i / 64.0, value = gap((1 - t) * a + t * b);
          error = std::max(error, std::abs(value - scene::on_stretch(facet.upper, t, t)[0]));
          largest = std::max(largest, std::abs(value));
        }
      }
      const double told = p.oscillation.gap * largest;
      EXPECT_LE(error, told + 1e-16);
      EXPECT_LE(told, 1.1 * error + 1e-16) << degree;
    }
}

TEST(ContactLaws, FrictionNeedsSidesThatCoincide) {
  Scene<2> s = blocks(Law::tresca, constant(1));
  s.blocks[1].range[1] = {1.01, 2};
  const auto error = error_of([&] { tests::problem(s); });
  ASSERT_TRUE(error.has_value());
  EXPECT_EQ(error->status(), Status::input);
  EXPECT_NE(std::string(error->what()).find("do not coincide"), std::string::npos) << error->what();
}

TEST(ContactLaws, AreInheritedFromTheFirstMesh) {
  const auto linear = enclosed<2>([](const auto& x) { return 1 + 2 * x[0]; });
  for (const Law law : {Law::winkler, Law::tresca}) {
    Problem<2> p = tests::problem(blocks(law, linear, false));
    for (int level = 0; level < 3; ++level) {
      for (const ContactFacet& facet : p.contact) {
        EXPECT_TRUE(facet.law.two_sided);
        EXPECT_EQ(has_springs(facet.law), law == Law::winkler);
        EXPECT_EQ(has_friction(facet.law), law == Law::tresca);
        for (int i = 0; i < 2; ++i) {
          const auto& x = p.mesh.vertices[p.mesh.boundary[facet.first].vertices[i]];
          EXPECT_NEAR((law == Law::winkler ? facet.law.modulus : facet.law.friction)[i], 1 + 2 * x[0], 1e-15);
        }
      }
      p = refine(p, std::vector<char>(p.mesh.cells.size(), 1)).problem;
    }
  }
}

TEST(Shortening, IsNowhereBelowTheApproachAndSavesEnergy) {
  const std::array<double, 2> k = {1, 3};
  const auto energy = [&](const std::vector<double>& s) {
    return bernstein_product(bernstein_times<double>(s, s), std::vector<double>{k[0], k[1]});
  };
  for (const std::vector<double>& c :
       {std::vector<double>{1, -1, -3}, {-1, 0.5, 2, -4}, {-2, -1, -0.5}, {1, 2, 0}, {-3, 1, -3}, {1, -8, 1, 1, -2}}) {
    const auto s = shortening(k, c);
    std::vector<double> positive;
    for (std::size_t i = 0; i < c.size(); ++i) {
      EXPECT_GE(s[i], c[i]);
      positive.push_back(std::max(c[i], 0.0));
    }
    EXPECT_LE(energy(s), energy(positive));
    // Not below what is bounded: ∫ k (r − g)₊², by many points.
    double exact = 0;
    constexpr int n = 20000;
    for (int i = 0; i < n; ++i) {
      const double t = (i + 0.5) / n, r = std::max(value_on_segment(c, t), 0.0);
      exact += (k[0] + t * (k[1] - k[0])) * r * r / n;
    }
    EXPECT_GE(energy(s), exact - 1e-7);
  }
}

}  // namespace
}  // namespace bracket::scene
