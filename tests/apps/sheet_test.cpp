// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// The sheet for a quality file: sheet.html and sheet.json.
#include <cmath>
#include <nlohmann/json.hpp>
#include <regex>

#include "apps/report/sha256.h"
#include "apps/report/sheet_parts.h"
#include "tests/apps/command.h"

namespace bracket::apps::tests {
namespace {

using Json = nlohmann::json;

class Sheet : public Command {
 protected:
  Sheet() { write("scene.toml", std::string(two_blocks) + "max_levels = 3\n" + asked); }
  void run(const std::string& arguments) const {
    const Ended ended = shell("bracket run scene.toml " + arguments);
    ASSERT_EQ(ended.status, 0) << ended.err;
  }
  Json json() const { return Json::parse(read("scene.out/sheet.json")); }
  /// What is left of sheet.html without its marks and style.
  std::string text() const {
    const std::string html = read("scene.out/sheet.html");
    return std::regex_replace(html.substr(html.find("<body>")), std::regex("<[^<>]{1,80}>"), "|");
  }
  static constexpr const char* asked =
      "[[quantity]]\nname = \"force\"\nforce = \"upper.bottom\"\n"
      "[[quantity]]\nname = \"lift\"\ndisplacement = \"upper.top\"\ndirection = [0, 1]\n";
};

const std::string adaptively = "--set refine.strategy=adaptive ";

TEST_F(Sheet, TellsTheSameAsTheReport) {
  run(adaptively + "--set bodies.lower.E=1.5");
  const Json sheet = json(), report = Json::parse(read("scene.out/report.json"));
  EXPECT_EQ(sheet["schema"], 1);
  EXPECT_EQ(sheet["version"], report["version"]);
  EXPECT_TRUE(std::regex_match(sheet["ended"].get<std::string>(), std::regex(R"(\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ)")));
  EXPECT_EQ(sheet["problem"]["overrides"].back(), "bodies.lower.E=1.5");
  const Json& verification = sheet["verification_of_the_calculation"];
  EXPECT_EQ(verification["guarantee"], report["guarantee"]);
  EXPECT_EQ(verification["relative_error_bound"], report["relative_error_bound"]);
  ASSERT_EQ(verification["levels"].size(), report["levels"].size());
  for (std::size_t i = 0; i < report["levels"].size(); ++i)
    for (const auto& [key, value] : verification["levels"][i].items())
      EXPECT_EQ(value, report["levels"][i][key]) << key;
  ASSERT_EQ(sheet["intervals"].size(), 3u);
  for (std::size_t i = 0; i < 2; ++i)
    for (const char* key : {"name", "kind", "lower", "upper"})
      EXPECT_EQ(sheet["intervals"][i][key], report["quantities"][i][key]) << key;
  EXPECT_EQ(sheet["intervals"][0]["unit"], "N/mm");
  EXPECT_EQ(sheet["intervals"][2]["lower"], report["energy"]["lower"]);
  EXPECT_EQ(sheet["intervals"][2]["upper"], report["energy"]["upper"]);
  EXPECT_EQ(sheet["data_and_geometry"]["data_oscillation"], report["checks"]["data_oscillation"]);
  for (const Json& found : sheet["findings"]) {
    if (found["of"] != "" || found["standing"] != "computed") continue;
    EXPECT_EQ(found["computed"], report["bodies"][found["what"].get<std::string>()]);
  }
}

TEST_F(Sheet, UncertaintyReachesBothEndsOfEachInterval) {
  run(adaptively);
  for (const Json& one : json()["intervals"]) {
    const double value = one["value"], reach = one["numerical_uncertainty"];
    EXPECT_LE(value - reach, one["lower"]);
    EXPECT_GE(value + reach, one["upper"]);
    EXPECT_LE(reach, 0.5000001 * (one["upper"].get<double>() - one["lower"].get<double>()));
  }
  for (const auto& [lower, upper] : {std::pair(0.1, std::nextafter(0.1, 1)), {-1e300, 1e300}, {1.0, 1 + 1e-15}}) {
    const auto middle = uncertain(lower, upper);
    ASSERT_TRUE(middle);
    EXPECT_LE(static_cast<long double>(middle->value) - middle->uncertainty, lower);
    EXPECT_GE(static_cast<long double>(middle->value) + middle->uncertainty, upper);
  }
  EXPECT_EQ(uncertain(2, 2)->uncertainty, 0);
  EXPECT_FALSE(uncertain(0, INFINITY));
}

TEST_F(Sheet, NamesTheFilesByTheirDigests) {
  shell("cp '" BRACKET_SCENES "'/l_shape.* .");
  const Ended ended = shell("bracket run l_shape.toml -o scene.out --set refine.max_levels=1 --set refine.target=0");
  ASSERT_EQ(ended.status, 0) << ended.err;
  const Json files = json()["problem"]["files"];
  ASSERT_EQ(files.size(), 2u);
  for (const Json& one : files)
    EXPECT_EQ(shell("sha256sum " + one["file"].get<std::string>()).out.substr(0, 64), one["sha256"]);
  EXPECT_NE(text().find(files[1]["sha256"].get<std::string>()), std::string::npos);
}

TEST_F(Sheet, AnOrderTakesThreeMeshes) {
  run(adaptively + "--set refine.max_levels=2");
  EXPECT_TRUE(json()["verification_of_the_calculation"]["observed_order"].is_null());
  EXPECT_NE(text().find("three meshes or more"), std::string::npos);
  run("--set refine.strategy=uniform --set refine.max_levels=3");
  const Json verification = json()["verification_of_the_calculation"];
  const auto log = [&](int level, const char* key) {
    return std::log(verification["levels"][level][key].get<double>());
  };
  // The last half of three levels are two.
  const double slope =
      (log(2, "relative_error_bound") - log(1, "relative_error_bound")) / (log(2, "cells") - log(1, "cells"));
  EXPECT_NEAR(verification["observed_order"]["by_cells"], slope, 1e-9);
  EXPECT_NEAR(verification["observed_order"]["by_size"], -2 * slope, 1e-9);
}

TEST_F(Sheet, OnePageHoldsTheFirstOfManyAndOnlyText) {
  std::string many = two_blocks;
  for (int i = 0; i < 40; ++i)
    many +=
        "[[quantity]]\nname = \"lift " + std::to_string(i) + "\"\ndisplacement = \"upper.top\"\ndirection = [0, 1]\n";
  write("scene.toml", many);
  std::string arguments = "--set 'title=\"<script>alert(1)</script>" + std::string(3000, 'x') + "\"'";
  for (int i = 0; i < 20; ++i) arguments += " --set bodies.lower.E=1";
  run(arguments);
  const std::string html = read("scene.out/sheet.html");
  EXPECT_EQ(html.find("<script"), std::string::npos);
  const std::string page = text();
  EXPECT_LT(page.size(), 9000u);  // a page of A4 in this type
  for (const char* part : {"lift 6|", "33 more in sheet.json", "19 more in sheet.json"})
    EXPECT_NE(page.find(part), std::string::npos) << part << page;
  EXPECT_EQ(page.find("lift 7|"), std::string::npos);
  EXPECT_EQ(json()["intervals"].size(), 41u);
  for (const char* name : {"<link", "<img", "href", "src="}) EXPECT_EQ(html.find(name), std::string::npos) << name;
}

TEST_F(Sheet, SaysWhatItDoesNotSay) {
  run("");
  for (const char* part :
       {"Verification of the calculation (ASME V&amp;V 10)", "Numerical uncertainty (ASME V&amp;V 20)",
        "validation||not done", "uncertainty of the input||not assessed", "contact without friction: one pair"})
    EXPECT_NE(std::regex_replace(text(), std::regex("\n"), "").find(part), std::string::npos) << part << text();
}

TEST_F(Sheet, IsLeftOutWithTheReport) {
  run("--no-report");
  EXPECT_EQ(shell("ls scene.out/sheet.*").out, "");
}

TEST(Sha256, OfThePublishedExamples) {
  // FIPS 180-2, B.1 to B.3.
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(sha256(std::string(1000000, 'a')), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

class Sha256Ends : public Command {};

TEST_F(Sha256Ends, AreThoseOfSha256sumAtEveryLengthOfABlock) {
  std::string bytes;
  for (int n = 0; n < 130; ++n) {
    bytes += static_cast<char>(37 * n);
    if (n % 64 > 2 && n % 64 < 53) continue;
    write("bytes", bytes);
    EXPECT_EQ(shell("sha256sum bytes").out.substr(0, 64), sha256(bytes)) << n;
  }
}

}  // namespace
}  // namespace bracket::apps::tests
