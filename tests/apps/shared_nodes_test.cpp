// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// Bodies of a mesh file that share nodes, or whose nodes coincide, to the end.
#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/apps/command.h"

namespace bracket::apps::tests {
namespace {

/// A column 1 wide of two squares, E = 1 below and E = 2 above, ν = 0, on a shear-free base, pressed by p = 0.01: the
/// stress is uniform and L(u) = −½ p² (1/1 + 1/2) on every mesh.
class SharedNodes : public Command {
 protected:
  SharedNodes() {
    write("shared.msh", mesh("", "4 1 2 5 3 3 4\n", {3, 4}));
    write("doubled.msh", mesh("7 1 1 0\n8 0 1 0\n", "4 1 2 5 3 3 4\n9 1 2 6 4 7 8\n", {7, 8}));
  }

  /// The upper square begins at the two nodes `joint`.
  static std::string mesh(const std::string& nodes, const std::string& lines, std::array<int, 2> joint) {
    const auto count = [](const std::string& text) { return std::count(text.begin(), text.end(), '\n'); };
    const auto [right, left] = joint;
    return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n7\n1 1 \"base\"\n1 2 \"top\"\n1 3 \"side\"\n"
           "1 5 \"joint\"\n1 6 \"other\"\n2 1 \"lower\"\n2 2 \"upper\"\n$EndPhysicalNames\n" +
           fmt::format("$Nodes\n{}\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n5 1 2 0\n6 0 2 0\n{}$EndNodes\n",
                       6 + count(nodes), nodes) +
           fmt::format(
               "$Elements\n{}\n1 1 2 1 1 1 2\n2 1 2 2 2 5 6\n3 1 2 3 4 1 4\n{}5 2 2 1 1 1 2 3\n6 2 2 1 1 1 3 4\n"
               "7 2 2 2 2 {} {} 5\n8 2 2 2 2 {} 5 6\n$EndElements\n",
               7 + count(lines), lines, left, right, left);
  }

  void expect_energy(const std::string& mesh_keys, const std::string& more) const {
    write("scene.toml",
          "schema = 1\n[mesh]\n" + mesh_keys +
              "[bodies.lower]\nE = 1\nnu = 0\n[bodies.upper]\nE = 2\nnu = 0\n"
              "[boundary.base]\nsliding = 0\n[boundary.side]\nsliding = 0\n[boundary.top]\npressure = 0.01\n" +
              more);
    const Ended ended = shell("bracket run scene.toml --no-report --json");
    ASSERT_EQ(ended.status, 0) << ended.err;
    const auto energy = nlohmann::json::parse(ended.out)["energy"];
    const double exact = -0.5 * 1e-4 * 1.5;
    EXPECT_LE(energy["lower"], exact) << more;
    EXPECT_GE(energy["upper"], exact) << more;
    EXPECT_LE(energy["upper"].get<double>() - energy["lower"].get<double>(), 1e-11 * std::abs(exact)) << more;
  }
};

TEST_F(SharedNodes, AreOnePieceOfTwoMaterials) { expect_energy("file = \"shared.msh\"\n", ""); }

TEST_F(SharedNodes, AreSeparatedAlongALineThatAContactNames) {
  expect_energy("file = \"shared.msh\"\n", "[[contact]]\nfirst = \"joint\"\nsecond = \"joint\"\n");
}

TEST_F(SharedNodes, ThatCoincideAreMergedOrInContact) {
  expect_energy("file = \"doubled.msh\"\nmerge = 1e-6\n", "");
  expect_energy("file = \"doubled.msh\"\n", "[[contact]]\nfirst = \"joint\"\nsecond = \"other\"\n");
}

}  // namespace
}  // namespace bracket::apps::tests
