// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// docs/verification.md and docs/against-others.md: what is known, and what another program finds, lies in the
// intervals of this version, and the pages say so.
#include <regex>

#include "tests/apps/command.h"

namespace bracket::apps::tests {
namespace {

class VerificationPage : public Command {};

/// The page without its intervals, which say as many digits as other versions may tell them with.
std::string without_intervals(const std::string& page) {
  return std::regex_replace(page, std::regex(R"(\[-?[0-9.e+-]+, -?[0-9.e+-]+\])"), "[]");
}

TEST_F(VerificationPage, IsWhatItsCommandWritesAndEveryValueIsInside) {
  const Ended ended = shell("sh '" BRACKET_DOCS "/verification/make.sh' '" BRACKET_PROGRAM "' page.md");
  const std::string page = read("page.md");
  EXPECT_EQ(ended.status, 0) << ended.out << ended.err << page;
  EXPECT_EQ(page.find("OUTSIDE"), std::string::npos);
  shell("cp '" BRACKET_DOCS "/verification.md' committed.md");
  EXPECT_EQ(without_intervals(page), without_intervals(read("committed.md")));
}

TEST_F(VerificationPage, ASecondRunChangesNothing) {
  shell("mkdir cases && cd '" BRACKET_DOCS
        "/verification' && cp make.sh case.awk head.md bending.toml lever.toml two-blocks.toml '" +
        (directory / "cases'").string());
  for (const char* page : {"once.md", "twice.md"})
    EXPECT_EQ(shell(std::string("sh cases/make.sh '" BRACKET_PROGRAM "' ") + page).status, 0);
  EXPECT_EQ(read("once.md"), read("twice.md"));
}

TEST_F(VerificationPage, AValueThatLeavesItsIntervalIsAnError) {
  shell("mkdir cases && cd '" BRACKET_DOCS "/verification' && cp make.sh case.awk head.md gap-closes.toml '" +
        (directory / "cases'").string());
  EXPECT_EQ(shell("sh cases/make.sh '" BRACKET_PROGRAM "' page.md").status, 0);
  shell("sed -i 's/^# Exact: force = .*/# Exact: force = 2.00001/' cases/gap-closes.toml");
  EXPECT_EQ(shell("sh cases/make.sh '" BRACKET_PROGRAM "' page.md").status, 1);
  EXPECT_NE(read("page.md").find("OUTSIDE"), std::string::npos);
}

/// As without_intervals(), without the cells of adaptive meshes and the verdict, which the last digits decide.
std::string without_mine(const std::string& page) {
  return std::regex_replace(without_intervals(page), std::regex(R"(\[\] \| [0-9]+ \| (inside|near) \|)"), "[]");
}

// A value of the other program may be as far outside as its last refinement moved it.
TEST_F(VerificationPage, WhatAnotherProgramFindsIsInside) {
  const Ended ended = shell("sh '" BRACKET_DOCS "/verification/others/make.sh' '" BRACKET_PROGRAM "' page.md");
  const std::string page = read("page.md");
  EXPECT_EQ(ended.status, 0) << ended.out << ended.err << page;
  EXPECT_EQ(page.find("OUTSIDE"), std::string::npos);
  shell("cp '" BRACKET_DOCS "/against-others.md' committed.md");
  EXPECT_EQ(without_mine(page), without_mine(read("committed.md")));
}

TEST_F(VerificationPage, AValueOfAnotherProgramThatIsFartherOutsideThanItsErrorIsAnError) {
  shell("mkdir -p cases/others && cd '" BRACKET_DOCS "/verification' && cp case.awk '" +
        (directory / "cases'").string() +
        " && cd others && cp make.sh other.awk head.md foundation-slides.toml foundation.txt '" +
        (directory / "cases/others'").string());
  const std::string make = "sh cases/others/make.sh '" BRACKET_PROGRAM "' page.md";
  EXPECT_EQ(shell(make).status, 0);
  shell(
      "sed -i 's/^# Other: energy = .*/# Other: energy = foundation.txt, 1, 3, FreeFEM/' "
      "cases/others/foundation-slides.toml");
  EXPECT_EQ(shell(make).status, 1);
  EXPECT_NE(read("page.md").find("OUTSIDE"), std::string::npos);
  shell("sed -i 's/^# Other: energy = .*/# Other: energy = foundation.txt/' cases/others/foundation-slides.toml");
  EXPECT_EQ(shell(make).status, 1);  // no value is passed over
}

}  // namespace
}  // namespace bracket::apps::tests
