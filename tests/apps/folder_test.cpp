// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/apps/command.h"

namespace bracket::apps::tests {
namespace {

namespace fs = std::filesystem;

class Folder : public Command {
 protected:
  Folder() {
    write("contact.toml", two_blocks);
    write("bending.toml", bending);
  }

  void expect_refused(const std::string& command, const std::string& part) const {
    const Ended ended = shell(command);
    EXPECT_EQ(ended.status, 2);
    EXPECT_EQ(ended.out, "");
    EXPECT_EQ(ended.err.rfind("bracket: ", 0), 0u) << ended.err;
    EXPECT_NE(ended.err.find(part), std::string::npos) << ended.err;
    EXPECT_EQ(ended.err.find('\n'), ended.err.size() - 1) << ended.err;
  }
};

TEST_F(Folder, IsNamedAfterTheSceneAndMadeInTheCurrentDirectory) {
  const Ended ended = shell("mkdir elsewhere && cd elsewhere && bracket run ../contact.toml");
  ASSERT_EQ(ended.status, 0) << ended.err;
  for (const char* name : {"report.json", "history.csv", "solution_0.vtu", "contact_0.vtu", "solution.pvd"})
    EXPECT_TRUE(fs::exists(directory / "elsewhere/contact.out" / name)) << name;
  EXPECT_NE(ended.out.find("contact.out/report.json"), std::string::npos);
}

TEST_F(Folder, OfAnEarlierRunIsReplaced) {
  ASSERT_EQ(shell("bracket run contact.toml -o a/b").status, 0);
  const std::string first = read("a/b/report.json");
  write("a/b/mine.txt", "mine");
  ASSERT_EQ(shell("bracket run bending.toml -o a/b").status, 0);
  EXPECT_NE(read("a/b/report.json"), first);
  EXPECT_FALSE(fs::exists(directory / "a/b/contact_0.vtu"));  // nothing stale: bending has no contact
  EXPECT_EQ(read("a/b/mine.txt"), "mine");                    // and nothing lost that was not bracket's
  EXPECT_EQ(shell("ls a/b").out.find(".part"), std::string::npos);
}

TEST_F(Folder, OfAnEarlierRunOutlivesASceneThatIsWrong) {
  ASSERT_EQ(shell("bracket run contact.toml").status, 0);
  const std::string report = read("contact.out/report.json");
  EXPECT_EQ(shell("bracket run contact.toml --set bodies.lower.E=0").status, 2);
  EXPECT_EQ(read("contact.out/report.json"), report);
}

TEST_F(Folder, ThatIsEmptyIsUsed) {
  EXPECT_EQ(shell("mkdir empty && bracket run bending.toml -o empty").status, 0);
  EXPECT_TRUE(fs::exists(directory / "empty/report.json"));
}

TEST_F(Folder, ThatHoldsOtherThingsIsRefusedAndLeftAlone) {
  shell("mkdir full && echo mine > full/report.json");
  expect_refused("bracket run bending.toml -o full", "full: is not empty");
  expect_refused("bracket run bending.toml -o .", "is not empty");
  EXPECT_EQ(shell("ls -A full; cat full/report.json").out, "report.json\nmine\n");
}

TEST_F(Folder, NothingOutsideIsTouchedWhateverItsListSays) {
  shell("mkdir a && echo mine > mine && printf '../mine\n..\n%s/mine\n' \"$PWD\" > a/.bracket");
  EXPECT_EQ(shell("bracket run bending.toml -o a").status, 0);
  EXPECT_EQ(read("mine"), "mine\n");
}

TEST_F(Folder, ThatCannotBeIsRefused) {
  expect_refused("bracket run bending.toml -o bending.toml", "bending.toml: is a file");
  expect_refused("bracket run bending.toml -o bending.toml/out", "bending.toml/out");
  expect_refused("bracket run bending.toml -o /proc/out", "/proc/out");
}

TEST_F(Folder, AFullDiskIsTold) {
  // No file may grow beyond 1024 bytes: the marker fits, the plot does not.
  expect_refused("trap '' XFSZ; ulimit -f 2; bracket run bending.toml",
                 "solution_0.vtu.part: cannot be written: File too large");
  EXPECT_FALSE(fs::exists(directory / "bending.out/report.json"));
  EXPECT_FALSE(fs::exists(directory / "bending.out/solution_0.vtu"));
}

TEST_F(Folder, AnOutputThatCannotBeWrittenIsTold) {
  expect_refused("bracket run bending.toml >/dev/full", "standard output");
  expect_refused("bracket check bending.toml >/dev/full", "standard output");
  expect_refused("bracket --version >/dev/full", "standard output");
}

}  // namespace
}  // namespace bracket::apps::tests
