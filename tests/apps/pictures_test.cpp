// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <chrono>
#include <nlohmann/json.hpp>

#include "tests/apps/command.h"

namespace bracket::apps::tests {
namespace {

namespace fs = std::filesystem;

class Pictures : public Command {
 protected:
  Pictures() {
    write("contact.toml", two_blocks);
    write("bending.toml", bending);
  }
  bool there(const std::string& name) const { return fs::exists(directory / name); }

  // Whole, of its size, and with curves: gnuplot draws each as a group of its own.
  void expect_drawn(const std::string& name, const std::string& last_curve) const {
    ASSERT_TRUE(there(name)) << name;
    const std::string svg = read(name);
    EXPECT_EQ(svg.rfind("<?xml", 0), 0u) << name;
    EXPECT_NE(svg.find("</svg>"), std::string::npos) << name;
    EXPECT_NE(svg.find("gnuplot_plot_" + last_curve), std::string::npos) << name;
    EXPECT_LT(svg.size(), 3'000'000u) << name;
  }
};

const std::string on_four_levels = " --set refine.strategy=adaptive --set refine.max_levels=4";

TEST_F(Pictures, OfARefinedContact) {
  const Ended ended = shell("bracket run contact.toml" + on_four_levels);
  ASSERT_EQ(ended.status, 0) << ended.err;
  EXPECT_EQ(ended.err, "");
  expect_drawn("contact.out/closing.svg", "4");
  expect_drawn("contact.out/error.svg", "1");
  expect_drawn("contact.out/mesh.svg", "4");
  expect_drawn("contact.out/stress.svg", "9");
  expect_drawn("contact.out/shear.svg", "3");
  expect_drawn("contact.out/contact.svg", "4");
  for (const char* text : {"pressed", "open", "upper.top", "lower.bottom", "x [mm]", "von Mises [MPa]"})
    EXPECT_NE(read("contact.out/stress.svg").find(text), std::string::npos) << text;
  EXPECT_FALSE(there("contact.out/mesh.png"));
}

TEST_F(Pictures, ThatHaveNothingToShowAreLeftOut) {
  ASSERT_EQ(shell("bracket run bending.toml").status, 0);
  expect_drawn("bending.out/stress.svg", "3");
  EXPECT_NE(read("bending.out/report.html").find("The error is rounding: there is no picture"), std::string::npos);
  for (const char* name : {"closing", "error", "contact", "mesh"})
    EXPECT_FALSE(there("bending.out/" + std::string(name) + ".svg")) << name;
}

TEST_F(Pictures, AsPngOnRequest) {
  ASSERT_EQ(shell("bracket run contact.toml --png" + on_four_levels).status, 0);
  for (const char* name : {"closing", "error", "mesh", "stress", "shear", "contact"})
    EXPECT_EQ(read("contact.out/" + std::string(name) + ".png").substr(0, 8), "\x89PNG\r\n\x1a\n") << name;
}

TEST_F(Pictures, WithoutGnuplotTheRunSucceedsAndSaysSo) {
  const Ended ended = shell("PATH=/nowhere; bracket run contact.toml");
  EXPECT_EQ(ended.status, 0);
  EXPECT_EQ(ended.err, "note: pictures: gnuplot is not installed\n");
  EXPECT_FALSE(there("contact.out/mesh.svg"));
  EXPECT_NE(read("contact.out/report.html").find("gnuplot is not installed"), std::string::npos);
  EXPECT_EQ(nlohmann::json::parse(read("contact.out/report.json"))["missing"][0], "pictures: gnuplot is not installed");
}

TEST_F(Pictures, WhereGnuplotFailsTheRunSucceedsAndSaysSo) {
  shell(
      "mkdir bin && printf '#!/bin/sh\\necho no such terminal >&2\\nexit 1\\n' > bin/gnuplot && chmod +x bin/gnuplot");
  const Ended ended = shell("PATH=\"$PWD/bin:$PATH\"; bracket run bending.toml");
  EXPECT_EQ(ended.status, 0);
  EXPECT_EQ(ended.err,
            "note: stress.svg: gnuplot failed: no such terminal\nnote: shear.svg: gnuplot failed: no such terminal\n");
}

TEST_F(Pictures, AreLeftOutWithTheReportOnRequest) {
  const Ended ended = shell("bracket run contact.toml --no-report");
  EXPECT_EQ(ended.status, 0);
  EXPECT_EQ(ended.out.find("report.html"), std::string::npos);
  EXPECT_EQ(shell("ls contact.out").out,
            "contact.csv\ncontact_0.vtu\nhistory.csv\nreport.json\nsolution.pvd\nsolution_0.vtu\nview.py\n");
}

TEST_F(Pictures, NamesAreDrawnAsTheyAre) {
  std::string named = two_blocks;  // marks of gnuplot's own, of strings and of SVG
  named.replace(named.find("second ="), 0, "name = \"a_b^c{d} \\\\n \\\" <e> & 'f' \xc3\xbc `touch g`\"\n");
  write("contact.toml", named);
  const Ended ended = shell("bracket run contact.toml");
  EXPECT_EQ(ended.status, 0);
  EXPECT_EQ(ended.err, "");
  const std::string svg = read("contact.out/contact.svg");
  EXPECT_NE(svg.find("a_b^c{d} \\n \" &lt;e> &amp; 'f' \xc3\xbc `touch g`"), std::string::npos);
  EXPECT_FALSE(there("g"));
}

#ifdef NDEBUG
TEST_F(Pictures, OfAFineMeshAreSmallAndFast) {
  std::string fine = two_blocks;  // 33 800 cells
  for (std::size_t at; (at = fine.find("[4, 4]")) != std::string::npos;) fine.replace(at, 6, "[92, 92]");
  write("contact.toml", fine);
  ASSERT_EQ(shell("bracket run contact.toml").status, 0);
  expect_drawn("contact.out/mesh.svg", "4");
  expect_drawn("contact.out/stress.svg", "9");
  expect_drawn("contact.out/contact.svg", "4");
  EXPECT_LT(nlohmann::json::parse(read("contact.out/report.json"))["seconds"]["pictures"], 5);
}
#endif

}  // namespace
}  // namespace bracket::apps::tests
