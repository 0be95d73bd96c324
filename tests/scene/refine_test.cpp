// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "tests/scene/refine_cases.h"

namespace bracket::scene {
namespace {

using namespace test;

constexpr double epsilon = std::numeric_limits<double>::epsilon();

double size_of(const Mesh<2>& mesh) {
  double size = 0;
  for (const Vector<2>& x : mesh.vertices) size = std::max(size, x.cwiseAbs().maxCoeff());
  return size;
}

/// Euler's characteristic; per body its area; per part its length; per body ∮ n ds, which vanishes.
struct Invariants {
  std::ptrdiff_t euler;
  std::vector<double> area, length;
  std::vector<Vector<2>> closing;
};
Invariants invariants(const Mesh<2>& mesh) {
  Invariants result;
  result.euler = static_cast<std::ptrdiff_t>(mesh.vertices.size() + mesh.cells.size() - mesh.edges.size());
  result.area.resize(mesh.bodies.size(), 0);
  result.length.resize(mesh.parts.size() + 1, 0);
  result.closing.resize(mesh.bodies.size(), Vector<2>::Zero());
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) {
    result.area[mesh.cell_body[cell]] += volume(mesh, static_cast<int>(cell));
  }
  for (int facet = 0; facet < static_cast<int>(mesh.boundary.size()); ++facet) {
    result.length[mesh.boundary[facet].part + 1] += length(mesh, facet);
    result.closing[mesh.cell_body[mesh.boundary[facet].cell]] += length(mesh, facet) * normal(mesh, facet);
  }
  return result;
}

/// The second side of each contact facet lies on the first to the last bit and runs the other way.
void expect_pairs_matched(const Problem<2>& problem) {
  const Mesh<2>& mesh = problem.mesh;
  const auto ends = [&](int facet, int end) { return mesh.vertices[mesh.boundary[facet].vertices[end]]; };
  std::vector<int> uses(mesh.boundary.size(), 0);
  for (const ContactFacet& pair : problem.contact) {
    ++uses[pair.first];
    if (pair.second == -1) continue;
    ++uses[pair.second];
    EXPECT_EQ(ends(pair.first, 0), ends(pair.second, 1));
    EXPECT_EQ(ends(pair.first, 1), ends(pair.second, 0));
  }
  for (std::size_t facet = 0; facet < uses.size(); ++facet) {
    EXPECT_EQ(uses[facet], problem.facets[facet].support == Support::contact ? 1 : 0);
  }
}

/// Children of a cell lie in it and fill it; a marked cell has four of a quarter each.
void expect_children(const Mesh<2>& old, const std::vector<char>& marked, const Refined<2>& refined) {
  const Mesh<2>& mesh = refined.problem.mesh;
  ASSERT_EQ(refined.cell_parent.size(), mesh.cells.size());
  EXPECT_TRUE(std::is_sorted(refined.cell_parent.begin(), refined.cell_parent.end()));
  std::vector<std::vector<double>> areas(old.cells.size());
  for (std::size_t i = 0; i < mesh.cells.size(); ++i) {
    const int parent = refined.cell_parent[i];
    const auto& [a, b, c] = old.cells[parent];
    for (const int vertex : mesh.cells[i]) {
      const Vector<2>& x = mesh.vertices[vertex];
      const auto middle = [&](int p, int q) { return x == Vector<2>(0.5 * (old.vertices[p] + old.vertices[q])); };
      const bool corner = vertex == a || vertex == b || vertex == c;
      EXPECT_TRUE(corner || middle(a, b) || middle(b, c) || middle(c, a));
    }
    EXPECT_EQ(mesh.cell_body[i], old.cell_body[parent]);
    areas[parent].push_back(volume(mesh, static_cast<int>(i)));
  }
  for (std::size_t i = 0; i < old.cells.size(); ++i) {
    const auto& [a, b, c] = old.cells[i];
    const double sides = (old.vertices[b] - old.vertices[a]).norm() + (old.vertices[c] - old.vertices[a]).norm();
    const double rounding = 8 * epsilon * size_of(old) * sides;  // of the coordinates, and of a product of sides
    const double whole = volume(old, static_cast<int>(i));
    EXPECT_NEAR(std::accumulate(areas[i].begin(), areas[i].end(), 0.0), whole, 4 * rounding);
    EXPECT_LE(areas[i].size(), 4u);
    if (!marked[i]) continue;
    EXPECT_EQ(areas[i].size(), 4u);
    for (const double area : areas[i]) EXPECT_NEAR(area, whole / 4, rounding);
  }
  for (std::size_t i = 0; i < old.vertices.size(); ++i) EXPECT_EQ(mesh.vertices[i], old.vertices[i]);
}

/// Each facet or its two halves have its normal to the last bit; they come in its order.
void expect_inherited_normals(const Problem<2>& old, const Problem<2>& problem) {
  std::size_t child = 0;
  for (std::size_t i = 0; i < old.facets.size(); ++i) {
    bool ended = false;
    for (int half = 0; half < 2 && !ended; ++half, ++child) {
      ASSERT_LT(child, problem.facets.size());
      EXPECT_EQ(problem.facets[child].normal, old.facets[i].normal);
      ended = problem.mesh.boundary[child].vertices[1] == old.mesh.boundary[i].vertices[1];
    }
    ASSERT_TRUE(ended);
  }
}

/// A piece of a polynomial stays the polynomial that it was given as.
void expect_polynomial_data(const Problem<2>& problem, int rounds) {
  const Mesh<2>& mesh = problem.mesh;
  // Each round adds a rounding or two of the largest term of a value, and of the coordinates.
  const double size = 1 + size_of(mesh);
  const double tolerance = 16 * (rounds + 1) * epsilon * size * size;
  for (std::size_t i = 0; i < mesh.boundary.size(); ++i) {
    const int part = mesh.boundary[i].part;
    const std::string name = part == -1 ? "" : mesh.parts[part];
    const FacetData<2>& data = problem.facets[i];
    const bool is_fixed = name == "a.bottom" || name == "base";
    EXPECT_EQ(data.support == Support::fixed, is_fixed);
    EXPECT_EQ(data.support == Support::sliding, name == "b.left");
    const Vector<2> n = normal(mesh, static_cast<int>(i));
    const double turned = 4 * epsilon * size / length(mesh, static_cast<int>(i));  // what rounding does to n
    for (int end = 0; end < 2; ++end) {
      const Vector<2>& x = mesh.vertices[mesh.boundary[i].vertices[end]];
      Vector<2> traction = Vector<2>::Zero(), displacement = Vector<2>::Zero();
      const Vector<2> acting = load(problem, static_cast<int>(i))[end] / length(mesh, static_cast<int>(i));
      if (name == "b.top") traction = {other_linear(x), linear(x)};
      if (name == "c.right") traction = -linear(x) * n;
      if (is_fixed) displacement = {linear(x), other_linear(x)};
      EXPECT_LE((acting - traction).norm(), tolerance + traction.norm() * turned) << name;
      EXPECT_LE((data.displacement[end] - displacement).norm(), tolerance) << name;
      EXPECT_NEAR(data.normal_displacement[end], name == "b.left" ? linear(x) : 0, tolerance) << name;
    }
  }
  for (const ContactFacet& facet : problem.contact) {
    const Vector<2>& a = mesh.vertices[mesh.boundary[facet.first].vertices[0]];
    const Vector<2>& b = mesh.vertices[mesh.boundary[facet.first].vertices[1]];
    for (const auto& gap : {facet.lower, facet.upper}) {
      EXPECT_NEAR(gap[0], quadratic(a), tolerance);
      EXPECT_NEAR(gap[2], quadratic(b), tolerance);
      EXPECT_NEAR(at_middle(gap), quadratic(0.5 * (a + b)), tolerance);
    }
  }
}

TEST(Refine, RandomMarksKeepTheMeshSound) {
  std::mt19937 random(1);
  for (const auto& [name, coarse] : refine_cases()) {
    SCOPED_TRACE(name);
    const Invariants before = invariants(coarse.mesh);
    Problem<2> problem = coarse;
    int rounds = 0;
    for (; problem.mesh.cells.size() < 6000; ++rounds) {
      const std::vector<char> marked = some(problem.mesh, random, 7);
      Refined<2> refined = refine(problem, marked);
      expect_children(problem.mesh, marked, refined);
      expect_inherited_normals(problem, refined.problem);
      problem = std::move(refined.problem);
      expect_conforming(problem.mesh);
      expect_pairs_matched(problem);
    }
    expect_polynomial_data(problem, rounds);
    const Invariants after = invariants(problem.mesh);
    EXPECT_EQ(after.euler, before.euler);
    const double size = size_of(coarse.mesh);
    const double rounding = epsilon * size * static_cast<double>(problem.mesh.edges.size());
    for (std::size_t body = 0; body < before.area.size(); ++body) {
      EXPECT_NEAR(after.area[body], before.area[body], rounding * coarse.length_scale);
      EXPECT_LE(after.closing[body].norm(), rounding);
    }
    for (std::size_t part = 0; part < before.length.size(); ++part) {
      EXPECT_NEAR(after.length[part], before.length[part], rounding);
    }
  }
}

TEST(Refine, KeepsNamesBodiesAndNotes) {
  std::mt19937 random(2);
  for (auto& [name, problem] : refine_cases()) {
    SCOPED_TRACE(name);
    problem.mesh.notes = {"mended"};
    problem.oscillation = {0.1, 0.2, 0.3};
    const Problem<2> fine = refine(problem, some(problem.mesh, random, 3)).problem;
    EXPECT_EQ(fine.mesh.bodies, problem.mesh.bodies);
    EXPECT_EQ(fine.mesh.parts, problem.mesh.parts);
    EXPECT_EQ(fine.mesh.notes, problem.mesh.notes);
    EXPECT_EQ(fine.length_scale, problem.length_scale);
    EXPECT_EQ(fine.oscillation.traction, 0.1);
    EXPECT_EQ(fine.oscillation.displacement, 0.2);
    EXPECT_EQ(fine.oscillation.gap, 0.3);
    ASSERT_EQ(fine.bodies.size(), problem.bodies.size());
    for (std::size_t body = 0; body < problem.bodies.size(); ++body) {
      EXPECT_EQ(fine.bodies[body].material.stiffness(), problem.bodies[body].material.stiffness());
      EXPECT_EQ(fine.bodies[body].material.compliance(), problem.bodies[body].material.compliance());
      EXPECT_EQ(fine.bodies[body].force, problem.bodies[body].force);
    }
  }
}

// Whatever the gaps are, each child carries its half of the parent's parabola.
TEST(Refine, HalvesAnyGap) {
  Problem<2> problem = refine_cases()[1].problem;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> anything(-1, 1);
  for (ContactFacet& facet : problem.contact)
    facet.lower = facet.upper = {anything(random), anything(random), anything(random)};
  const auto at = [](const std::array<double, 3>& gap, double t) {
    return (1 - t) * ((1 - t) * gap[0] + 2 * t * gap[1]) + t * t * gap[2];
  };
  for (int round = 0; round < 4; ++round) {
    Refined<2> refined = refine(problem, some(problem.mesh, random, 4));
    const auto& contact = refined.problem.contact;
    ASSERT_EQ(refined.contact_parent.size(), contact.size());
    EXPECT_TRUE(std::is_sorted(refined.contact_parent.begin(), refined.contact_parent.end()));
    std::vector<double> covered(problem.contact.size(), 0);
    for (std::size_t i = 0; i < contact.size(); ++i) {
      const ContactFacet& parent = problem.contact[refined.contact_parent[i]];
      EXPECT_EQ(contact[i].pair, parent.pair);
      const auto& ends = problem.mesh.boundary[parent.first].vertices;
      const Vector<2> begin = problem.mesh.vertices[ends[0]];
      const Vector<2> along = problem.mesh.vertices[ends[1]] - begin;
      const auto place = [&](int end) {  // 0, ½ or 1
        const int vertex = refined.problem.mesh.boundary[contact[i].first].vertices[end];
        const Vector<2> x = refined.problem.mesh.vertices[vertex];
        return std::round(2 * along.dot(x - begin) / along.squaredNorm()) / 2;
      };
      const double from = place(0), to = place(1);
      EXPECT_EQ(covered[refined.contact_parent[i]], from);
      covered[refined.contact_parent[i]] = to;
      for (const double t : {0.0, 0.2, 0.5, 0.7, 1.0}) {
        EXPECT_NEAR(at(contact[i].lower, t), at(parent.lower, from + t * (to - from)), 32 * epsilon);
        EXPECT_NEAR(at(contact[i].upper, t), at(parent.upper, from + t * (to - from)), 32 * epsilon);
      }
    }
    for (const double end : covered) EXPECT_EQ(end, 1);
    problem = std::move(refined.problem);
  }
}

TEST(Refine, AllCellsMarkedGiveFourEach) {
  for (const auto& [name, problem] : refine_cases()) {
    const Mesh<2> once = refine(problem, std::vector<char>(problem.mesh.cells.size(), true)).problem.mesh;
    EXPECT_EQ(once.cells.size(), 4 * problem.mesh.cells.size()) << name;
    EXPECT_EQ(once.edges.size(), 2 * problem.mesh.edges.size() + 3 * problem.mesh.cells.size()) << name;
    EXPECT_EQ(once.boundary.size(), 2 * problem.mesh.boundary.size()) << name;
  }
}

TEST(Refine, NoCellMarkedChangesNothing) {
  for (const auto& [name, problem] : refine_cases()) {
    const Refined<2> same = refine(problem, std::vector<char>(problem.mesh.cells.size(), false));
    EXPECT_EQ(same.problem.mesh.vertices, problem.mesh.vertices) << name;
    EXPECT_EQ(same.problem.mesh.cells, problem.mesh.cells) << name;
    EXPECT_EQ(same.problem.mesh.edges, problem.mesh.edges) << name;
    EXPECT_EQ(same.problem.mesh.refinement_edge, problem.mesh.refinement_edge) << name;
    EXPECT_EQ(same.problem.contact.size(), problem.contact.size()) << name;
  }
}

}  // namespace
}  // namespace bracket::scene
