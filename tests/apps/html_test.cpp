// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "apps/report/quantities.h"
#include "tests/apps/command.h"

namespace bracket::apps::tests {
namespace {

class Html : public Command {
 protected:
  Html() { write("scene.toml", two_blocks); }
  std::string page(const std::string& arguments = "") const {
    const Ended ended =
        shell("bracket run scene.toml --set refine.strategy=adaptive --set refine.max_levels=3" + arguments);
    EXPECT_EQ(ended.status, 0) << ended.err;
    return read("scene.out/report.html");
  }
};

std::vector<std::string> all(const std::string& text, const char* pattern) {
  const std::regex regex(pattern);
  std::vector<std::string> found;
  for (std::sregex_iterator i(text.begin(), text.end(), regex), none; i != none; ++i) found.push_back((*i)[1]);
  return found;
}

TEST_F(Html, RefersToNothingOutsideOfItself) {
  const std::string html = page();
  for (const std::string& target : all(html, R"re((?:href|src)=['"]([^'"]{1,12}))re"))
    EXPECT_TRUE(target[0] == '#' || target.rfind("data:image/", 0) == 0) << target;
  for (const char* name : {"<script", "<link", "<img", "<iframe", "@import", "url(http"})
    EXPECT_EQ(html.find(name), std::string::npos) << name;
  // The names of the pictures' pieces are their own, and those that are used are there.
  std::set<std::string> ids;
  for (const std::string& id : all(html, R"re( id=['"]([^'"]*)['"])re")) EXPECT_TRUE(ids.insert(id).second) << id;
  for (const std::string& id : all(html, R"re(href=['"]#([^'"]*)['"])re")) EXPECT_TRUE(ids.contains(id)) << id;
  EXPECT_EQ(all(html, "(<svg)").size(), 6u);
}

TEST_F(Html, TellsWhatPicturesAndTablesAre) {
  const std::string html = page();
  const std::size_t pictures = all(html, "(<svg)").size();
  EXPECT_EQ(all(html, R"re(<svg role="img" aria-label="([^"]{20,})")re").size(), pictures);
  EXPECT_EQ(all(html.substr(html.find("<body>")), "(<title)").size(), 0u);  // gnuplot's, shown at a pointer
  const std::size_t tables = all(html, "(<table)").size();
  EXPECT_GE(tables, 7u);
  EXPECT_EQ(all(html, "(<caption>)[^<]").size(), tables);
  EXPECT_EQ(all(html, R"re((<th)[ >])re").size(), all(html, R"re(<th scope="(col|row)")re").size());
  EXPECT_EQ(all(html, "(N, mm, MPa)").size(), 1u);
}

TEST_F(Html, TellsTheIntervalTheChecksAndTheScene) {
  const std::string html = page();
  const std::string text = std::regex_replace(html.substr(html.find("<body>")), std::regex("<[^<>]{1,80}>"), "");
  const nlohmann::json json = nlohmann::json::parse(read("scene.out/report.json"));
  const Decimals energy = enclosed_in_decimals(json["energy"]["lower"], json["energy"]["upper"]);
  const std::string &lower = energy.lower, &upper = energy.upper;
  ASSERT_NE(text.find("energy at least" + lower), std::string::npos) << lower;
  EXPECT_LT(text.find("energy at least" + lower), text.find("energy at most" + upper));
  EXPECT_LT(text.find("energy at most" + upper), text.find("Not guaranteed"));
  for (const char* part :
       {"gap identity", "E = 2, ν = 0.3", "fixed: displacement (0, 0)", "sliding: normal displacement 0",
        "traction (0, -0.1 … 0.09)", "refine.bulk0.5", "refine.max_cells200000", "no body force"})
    EXPECT_NE(text.find(part), std::string::npos) << part;
}

TEST_F(Html, AnisotropicBodiesShowTheirStiffness) {
  std::string scene = two_blocks;
  scene.replace(scene.find("E = 2.0\nnu = 0.3"), 16, "stiffness = [[3,1,0.5],[1,2.5,0],[0.5,0,1.25]]");
  write("scene.toml", scene);
  EXPECT_NE(page().find("c₁₁ = 3, c₂₂ = 2.5, c₁₂ = 1, c₁₆ = 0.5, c₂₆ = 0, c₆₆ = 1.25"), std::string::npos);
}

TEST_F(Html, TextOfTheSceneStaysText) {
  const std::string html = page(" --set 'title=\"<script>alert(1)</script> & \\\"b\\\"\"'");
  EXPECT_EQ(html.find("<script"), std::string::npos);
  EXPECT_NE(html.find("<h1>&lt;script&gt;alert(1)&lt;/script&gt; &amp; &quot;b&quot;</h1>"), std::string::npos);
}

}  // namespace
}  // namespace bracket::apps::tests
