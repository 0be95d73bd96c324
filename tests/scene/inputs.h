// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <random>

#include "scene/scene.h"
#include "tests/support/folder.h"

/// Files and scenes for the tests of this folder.
namespace bracket::scene::test {

using bracket::tests::Folder;

inline constexpr double eps = std::numeric_limits<double>::epsilon();

using Random = std::mt19937;
inline double uniform(Random& random, double from, double to) {
  return std::uniform_real_distribution<double>(from, to)(random);
}

/// The Error that an action throws, if it does; anything else it throws goes through.
std::optional<Error> error_of(const std::function<void()>& action);

/// `text` with the one occurrence of `from` replaced. \throw std::logic_error if there is not exactly one
std::string replaced(const std::string& text, const std::string& from, const std::string& to);

/// A valid scene of two blocks in contact, with every section.
std::string two_blocks();

/// What a small .msh file holds; tags are places + 1.
struct GmshContent {
  struct Element {
    int physical;
    std::vector<int> nodes;
  };
  std::vector<std::array<double, 2>> nodes;
  std::vector<Element> lines;
  std::vector<Element> triangles;
  std::string names;  ///< lines of $PhysicalNames
};
/// Two unit squares, the second a body of its own on top of the first; parts "base", "joint below", "joint above"; the
/// rest is in no physical curve.
GmshContent two_squares();
std::string gmsh_2(const GmshContent& content);
std::string gmsh_4(const GmshContent& content);

Function<2> constant(double value);

/// A unit square "a" (cells × cells) below one "b", both of E = 1, ν = 0, in contact, with the given conditions.
Scene<2> stacked(int cells, std::map<std::string, Condition<2>> boundary);

/// The place of the facet of `part` whose midpoint is nearest to x.
int facet_at(const Mesh<2>& mesh, const std::string& part, const Vector<2>& x);

/// The scene of a mesh file: a material for each of `bodies`, a fixed displacement on each of `fixed` ("scene:" +
/// part).
Scene<2> scene_of(const std::filesystem::path& file, const std::vector<std::string>& bodies,
                  const std::vector<std::string>& fixed = {});

double area(const Mesh<2>& mesh, const std::string& body);
double length_of(const Mesh<2>& mesh, const std::string& part);

/// Expects one note that holds `part`.
void expect_note(const Mesh<2>& mesh, const std::string& part);
/// Expects an error of one line that holds all of `named`.
void expect_error(const std::function<void()>& action, Status status, const std::vector<std::string>& named);

}  // namespace bracket::scene::test
