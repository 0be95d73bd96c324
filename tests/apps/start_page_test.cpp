// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// docs/start.md: what it says to type works, and what it says is known meets what is printed.
#include <map>
#include <regex>
#include <sstream>

#include "tests/apps/command.h"
#include "tests/apps/page.h"

namespace bracket::apps::tests {
namespace {

class StartPage : public Command {
 protected:
  StartPage() { shell("cp '" BRACKET_DOCS "'/start/* ."); }
};

struct Interval {
  double lower, upper;
};

/// Of the lines "NAME in [LOWER, UPPER]": which cells are refined, of several that are alike, hangs on the processor,
/// so that digits may differ; intervals of one value meet.
std::map<std::string, Interval> intervals(const std::string& text) {
  const std::regex line(R"(^(.*\S) +in \[(\S+), (\S+)\].*$)");
  std::map<std::string, Interval> result;
  std::istringstream stream(text);
  std::smatch match;
  for (std::string one; std::getline(stream, one);)
    if (std::regex_match(one, match, line)) result[match[1]] = {std::stod(match[2]), std::stod(match[3])};
  return result;
}

TEST_F(StartPage, ItsCommandsRunAndItsIntervalsMeetTheirs) {
  const std::vector<Block> all = blocks(BRACKET_DOCS "/start.md");
  int met = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].language != "sh") continue;
    if (all[i].text.starts_with("gmsh") && shell("command -v gmsh").status != 0) continue;  // the mesh is kept
    const Ended ended = shell(all[i].text);
    EXPECT_EQ(ended.status, 0) << all[i].text << ended.err;
    if (i + 1 == all.size() || all[i + 1].language != "text") continue;
    const auto printed = intervals(ended.out);
    for (const auto& [name, said] : intervals(all[i + 1].text)) {
      ASSERT_TRUE(printed.contains(name)) << name << ended.out;
      EXPECT_LE(printed.at(name).lower, said.upper) << name;
      EXPECT_LE(said.lower, printed.at(name).upper) << name;
      ++met;
    }
  }
  EXPECT_EQ(met, 6);
}

TEST_F(StartPage, ItsSceneAndNamesAreThoseOfTheFiles) {
  int found = 0;
  for (const Block& block : blocks(BRACKET_DOCS "/start.md")) {
    if (block.language == "toml") found += read("clamp.toml").ends_with("\n" + block.text);
    if (block.text.starts_with("Physical")) found += read("clamp.geo").ends_with("\n" + block.text);
  }
  EXPECT_EQ(found, 2);
}

}  // namespace
}  // namespace bracket::apps::tests
