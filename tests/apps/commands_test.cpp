// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>

#include "tests/apps/command.h"

namespace bracket::apps::tests {
namespace {

/// What helps whoever types: init, help, completion, the manual, words for what is misspelt.
class Commands : public Command {
 protected:
  Commands() { write("scene.toml", two_blocks); }

  std::set<std::string> names() const { return matches(shell("bracket --help").out, "\n  ([a-z]+) {2,}"); }
  static std::set<std::string> matches(const std::string& text, const std::string& pattern) {
    const std::regex regex(pattern);
    std::set<std::string> all;
    for (std::sregex_iterator found(text.begin(), text.end(), regex), none; found != none; ++found)
      all.insert((*found)[1]);
    return all;
  }
};

TEST_F(Commands, ASceneAloneIsRun) {
  const Ended alone = shell("bracket scene.toml --quiet --set refine.max_levels=1");
  EXPECT_EQ(alone.status, 0) << alone.err;
  EXPECT_EQ(alone.out, shell("bracket run scene.toml --quiet --set refine.max_levels=1").out);
}

TEST_F(Commands, OptionsMayComeBeforeASceneAlone) {
  const std::string answer = shell("bracket run scene.toml --quiet --set refine.max_levels=1").out;
  for (const char* words :
       {"--quiet --set refine.max_levels=1 scene.toml", "--quiet -o there scene.toml", "-o run --quiet scene.toml",
        "--set=refine.max_levels=1 --quiet scene.toml -o there", "--quiet -- scene.toml"}) {
    const Ended ended = shell(std::string("bracket ") + words);
    EXPECT_EQ(ended.status, 0) << words << ended.err;
    EXPECT_EQ(ended.out, answer) << words;
  }
  EXPECT_EQ(shell("ls").out, "run\nscene.out\nscene.toml\nthere\n");
  for (const auto& [words, by] : {std::pair("--quiet rum", "unknown command 'rum'"),
                                  {"--quiet", "--quiet"},
                                  {"--fast scene.toml", "--fast"},
                                  {"-o", "-o"}}) {
    const Ended ended = shell(std::string("bracket ") + words);
    EXPECT_EQ(ended.status, 2) << words;
    EXPECT_NE(ended.err.find(by), std::string::npos) << ended.err;
  }
}

TEST_F(Commands, MisspeltOnesAreAnsweredByTheNearest) {
  const auto answered = [&](const std::string& words, const std::string& by) {
    const Ended ended = shell("bracket " + words);
    EXPECT_EQ(ended.status, 2);
    EXPECT_EQ(ended.out, "");
    EXPECT_NE(ended.err.find(by), std::string::npos) << ended.err;
    EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 1) << ended.err;
  };
  answered("rum scene.toml", "unknown command 'rum', and no such scene file: did you mean 'run'?");
  answered("stuyd scene.toml", "did you mean 'study'?");
  answered("help scen", "did you mean 'scene'?");
  answered("nowhere.toml", "nowhere.toml");
}

TEST_F(Commands, InitWritesASceneThatRunsAndNeverOverOne) {
  const Ended made = shell("bracket init there/deep");
  EXPECT_EQ(made.status, 0) << made.err;
  const Ended run = shell("bracket there/deep/scene.toml --no-report");
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_NE(run.out.find("● force of the foot"), std::string::npos) << run.out;
  EXPECT_LE(widest(read("there/deep/scene.toml")), 80u);
  const Ended again = shell("bracket init");
  EXPECT_EQ(again.status, 2);
  EXPECT_NE(again.err.find("scene.toml: is there already"), std::string::npos) << again.err;
  EXPECT_EQ(read("scene.toml"), two_blocks);
  EXPECT_EQ(shell("ln -s nowhere linked && mkdir l && ln -s /nowhere l/scene.toml && bracket init l").status, 2);
}

// The reader tells what it knows when it meets what it does not.
TEST_F(Commands, HelpHasEveryKeyThatTheReaderKnows) {
  write("scene.toml",
        std::string(two_blocks) + "[[quantity]]\nenergy = true\n[curves]\n'lower.top' = { circle = 'detect' }\n");
  const Ended help = shell("bracket help scene");
  EXPECT_EQ(help.status, 0);
  EXPECT_LE(widest(help.out), 80u) << help.out;
  const auto keys = matches(help.out, "\n  ([A-Za-z_]+) ");
  int known = 0;
  for (const std::string place : {"", "mesh.", "mesh.block.0.", "bodies.lower.", "boundary.lower.bottom.", "contact.0.",
                                  "quantity.0.", "refine.", "solve.", "curves.lower.top."}) {
    const Ended refused = shell("bracket check scene.toml --set " + place + "zzz=1");
    const std::size_t at = refused.err.find("nown: ");
    ASSERT_NE(at, std::string::npos) << place << refused.err;
    for (const std::string& key : matches(refused.err.substr(at), "([A-Za-z_]+)(?=[,\n])")) {
      ++known;
      EXPECT_TRUE(keys.contains(key)) << place << key;
    }
  }
  EXPECT_GT(known, 40);
}

TEST_F(Commands, WhatSceneFilesLackIsSaid) {
  const std::vector<std::array<const char*, 2>> expected = {{"friction", "law = { tresca = g }"},
                                                            {"contact.0.friction", "law = { tresca = g }"},
                                                            {"bodies.lower.friction", "tresca = g"},
                                                            {"contact.0.mu", "{ coulomb = mu }"},
                                                            {"springs", "law = { winkler = k, tension"},
                                                            {"boundary.lower.bottom.spring", "winkler = k"},
                                                            {"points", "short boundary part"}};
  for (const auto& [key, way_out] : expected) {
    const Ended ended = shell(std::string("bracket check scene.toml --set ") + key + "=0.3");
    EXPECT_EQ(ended.status, 2);
    EXPECT_NE(ended.err.find(way_out), std::string::npos) << ended.err;
  }
  std::string scene = two_blocks;
  scene.erase(scene.find("schema = 1"), 10);
  write("scene.toml", scene);
  EXPECT_NE(shell("bracket check scene.toml").err.find("write schema = 1"), std::string::npos);
}

TEST_F(Commands, ATargetWithoutAStrategyIsReachedAdaptively) {
  std::string scene = two_blocks;
  scene.replace(scene.find("strategy = \"none\""), 17, "target = 0.05");
  write("scene.toml", scene);
  const Ended ended = shell("bracket scene.toml --no-report");
  EXPECT_EQ(ended.status, 0) << ended.err;
  const auto report = nlohmann::json::parse(read("scene.out/report.json"));
  EXPECT_GT(report["levels"].size(), 1u);
  EXPECT_LT(report["levels"][1]["cells"], 4 * report["levels"][0]["cells"].get<int>());
  EXPECT_EQ(shell("bracket scene.toml --no-report --set refine.strategy=none").status, 5);
}

TEST_F(Commands, HelpFitsATerminalAndHasNoBraces) {
  EXPECT_GE(names().size(), 10u);
  for (const std::string& name : names()) {
    const Ended help = shell("bracket " + name + " --help");
    EXPECT_EQ(help.status, 0);
    EXPECT_LE(widest(help.out), 80u) << help.out;
    EXPECT_EQ(help.out.find('{'), std::string::npos) << help.out;
    EXPECT_EQ(help.out, shell("bracket help " + name).out);
  }
  EXPECT_LE(widest(shell("bracket --help; bracket --version").out), 80u);
}

TEST_F(Commands, ManualAndCompletionHaveEachOfThem) {
  const std::string manual = shell("sed 's/\\\\//g' '" BRACKET_SHARE "/bracket.1'").out;
  const auto completed = [&](const std::string& words, int place) {
    const Ended ended =
        shell("bash -c '. \"" BRACKET_SHARE "/bracket.bash\"; COMP_WORDS=(bracket " + words +
              "); COMP_CWORD=" + std::to_string(place) + "; _bracket; printf \"%s\\n\" \"${COMPREPLY[@]}\"'");
    return "\n" + ended.out;
  };
  const std::string commands = completed("\"\"", 1);
  EXPECT_NE(commands.find("\nscene.toml\n"), std::string::npos) << commands;
  for (const std::string& name : names()) {
    EXPECT_NE(manual.find(name), std::string::npos) << name;
    EXPECT_NE(commands.find("\n" + name + "\n"), std::string::npos) << commands;
    const std::string options = completed(name + " -", 2);
    for (const std::string& option : matches(shell("bracket " + name + " --help").out, "\n  (-[-a-z]+)[ \n]")) {
      EXPECT_NE(manual.find(option), std::string::npos) << option;
      EXPECT_NE(options.find("\n" + option + "\n"), std::string::npos) << name << option << options;
    }
  }
}

}  // namespace
}  // namespace bracket::apps::tests
