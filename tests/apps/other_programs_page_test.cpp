// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// docs/other-programs.md: what it says to type works and prints what it says; the other programs run where they are
// installed, and give the files of tests/fields.
#include <regex>

#include "scene/field/field.h"
#include "tests/apps/command.h"
#include "tests/apps/page.h"
#include "tests/support/scenes.h"

namespace bracket::apps::tests {
namespace {

class OtherProgramsPage : public Command {
 protected:
  OtherProgramsPage() {
    shell("mkdir -p docs apps/scenes tests; cp -r '" BRACKET_FIELDS "' tests; cp -r '" BRACKET_DOCS
          "/other-programs' docs; cp '" BRACKET_DOCS "/../apps/scenes/two_blocks.toml' apps/scenes");
  }
  /// FreeFem++ with its plugin for Gmsh, which is a package of its own.
  bool installed(const std::string& program) const {
    const std::string found = "command -v " + program;
    return shell(program == "FreeFem++-nw" ? found + " && ls /usr/lib/freefem++/gmsh.so" : found).status == 0;
  }
};

/// On the mesh that the page has them computed on.
scene::Displacement<2> displacement(const std::filesystem::path& file) {
  scene::Problem<2> problem = bracket::tests::problem(bracket::tests::two_blocks(4));
  for (int i = 0; i < 2; ++i) problem = refine(problem, std::vector<char>(problem.mesh.cells.size(), 1)).problem;
  const scene::GivenDisplacement given = scene::read_field(file, problem.mesh);
  EXPECT_FALSE(given.interpolated);
  return given.displacement;
}

/// The same words, and numbers that differ by a hundredth at most: which cells are refined, of several that are alike,
/// hangs on the processor.
void expect_alike(const std::string& printed, const std::string& said) {
  const std::regex number("[0-9]+(\\.[0-9]+)?(e[-+][0-9]+)?");
  EXPECT_EQ(std::regex_replace(printed, number, "#"), std::regex_replace(said, number, "#"));
  const std::sregex_iterator none;
  std::sregex_iterator one(printed.begin(), printed.end(), number), other(said.begin(), said.end(), number);
  for (; one != none && other != none; ++one, ++other) {
    const double expected = std::stod(other->str());
    EXPECT_NEAR(std::stod(one->str()), expected, 0.01 * expected + 1e-5) << printed << said;
  }
}

TEST_F(OtherProgramsPage, ItsCommandsRunAndPrintWhatItSays) {
  const std::vector<Block> all = blocks(BRACKET_DOCS "/other-programs.md");
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].language != "sh") continue;
    bool runs = true;
    for (const std::string program : {"ccx", "FreeFem++-nw"})
      runs = runs && (all[i].text.find("\n" + program) == std::string::npos || installed(program)) &&
             (all[i].text.find(" " + program) == std::string::npos || installed(program));
    if (!runs) continue;
    const Ended ended = shell("cd docs/other-programs && " + all[i].text);
    EXPECT_EQ(ended.status, 0) << all[i].text << ended.err;
    if (i + 1 < all.size() && all[i + 1].language == "text") expect_alike(ended.out, all[i + 1].text);
  }
  for (const auto& [program, result, kept] :
       {std::tuple("ccx", "blocks.frd", "calculix.frd"), std::tuple("FreeFem++-nw", "blocks.vtu", "freefem.vtu")}) {
    if (!installed(program)) continue;
    const auto fresh = displacement(directory / "docs/other-programs" / result);
    const auto known = displacement(std::filesystem::path(BRACKET_FIELDS) / kept);
    for (std::size_t vertex = 0; vertex < known.vertex.size(); ++vertex)
      EXPECT_LE((fresh.vertex[vertex] - known.vertex[vertex]).norm(), 1e-6);  // of values up to 0.07
  }
}

}  // namespace
}  // namespace bracket::apps::tests
