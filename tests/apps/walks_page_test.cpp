// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// docs/start.md and docs/exercises.md: what they say to type works, and the intervals that they tell meet those
// printed.
#include <map>
#include <regex>
#include <sstream>

#include "tests/apps/command.h"
#include "tests/apps/page.h"

namespace bracket::apps::tests {
namespace {

struct Told {
  double lower, upper;
};

/// Of the lines "● NAME LOWER … UPPER". Which cells are refined, of several that are alike, hangs on the processor,
/// so that digits may differ; intervals of one value meet.
std::map<std::string, Told> told(const std::string& text) {
  const std::regex line(R"(^● (.*\S) +(\S+) … (\S+).*$)");
  std::map<std::string, Told> result;
  std::istringstream stream(text);
  std::smatch match;
  for (std::string one; std::getline(stream, one);)
    if (std::regex_match(one, match, line)) result[match[1]] = {std::stod(match[2]), std::stod(match[3])};
  return result;
}

class WalksPage : public Command {
 protected:
  /// Runs what the page says to type in a copy of the folder of its name. Returns how many of its intervals were met.
  int walk(const std::string& name) const {
    shell("cp '" BRACKET_DOCS "/" + name + "'/* .");
    const std::vector<Block> all = blocks(BRACKET_DOCS "/" + name + ".md");
    int met = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (all[i].language != "sh") continue;
      if (all[i].text.starts_with("gmsh") && shell("command -v gmsh").status != 0) continue;  // the mesh is kept
      const Ended ended = shell(all[i].text);
      EXPECT_EQ(ended.status, 0) << all[i].text << ended.err;
      if (i + 1 == all.size() || all[i + 1].language != "text") continue;
      const auto printed = told(ended.out);
      for (const auto& [quantity, said] : told(all[i + 1].text)) {
        const auto one = printed.find(quantity);
        const bool meets = one != printed.end() && one->second.lower <= said.upper && said.lower <= one->second.upper;
        EXPECT_TRUE(meets) << quantity << ", " << all[i].text << ended.out;
        met += meets;
      }
    }
    return met;
  }
};

TEST_F(WalksPage, StartToAnInterval) { EXPECT_EQ(walk("start"), 6); }

TEST_F(WalksPage, TheSceneAndTheNamesOfStartAreThoseOfItsFiles) {
  shell("cp '" BRACKET_DOCS "'/start/* .");
  int found = 0;
  for (const Block& block : blocks(BRACKET_DOCS "/start.md")) {
    if (block.language == "toml") found += read("clamp.toml").ends_with("\n" + block.text);
    if (block.text.starts_with("Physical")) found += read("clamp.geo").ends_with("\n" + block.text);
  }
  EXPECT_EQ(found, 2);
}

TEST_F(WalksPage, ExercisesHaveTheirAnswers) { EXPECT_EQ(walk("exercises"), 13); }

}  // namespace
}  // namespace bracket::apps::tests
