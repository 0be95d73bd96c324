// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/report/quantities.h"

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <random>
#include <regex>
#include <sstream>

#include "apps/report/shares.h"
#include "tests/apps/command.h"

namespace bracket::apps::tests {
namespace {

using Json = nlohmann::json;
using Rational = boost::multiprecision::cpp_rational;

/// The number that a decimal text stands for, exactly.
Rational value(std::string text) {
  const bool negative = text[0] == '-';
  if (negative) text.erase(0, 1);
  int exponent = 0;
  if (const std::size_t e = text.find('e'); e != std::string::npos) {
    exponent = std::stoi(text.substr(e + 1));
    text.resize(e);
  }
  if (const std::size_t point = text.find('.'); point != std::string::npos) {
    exponent -= static_cast<int>(text.size() - point) - 1;
    text.erase(point, 1);
  }
  text.erase(0, std::min(text.find_first_not_of('0'), text.size() - 1));
  Rational result{boost::multiprecision::cpp_int(text)};
  for (; exponent > 0; --exponent) result *= 10;
  for (; exponent < 0; ++exponent) result /= 10;
  return negative ? Rational(-result) : result;
}

void expect_enclosed(double lower, double upper) {
  const Decimals decimals = enclosed_in_decimals(lower, upper);
  const Rational below = value(decimals.lower), above = value(decimals.upper), low(lower), high(upper);
  EXPECT_LE(below, low) << decimals.lower << " " << decimals.upper;
  EXPECT_GE(above, high) << decimals.lower << " " << decimals.upper;
  // By a tenth of the width on each side, or the fifteenth digit of the larger.
  const Rational size = std::max(abs(low), abs(high)), slack = (high - low) / 10 + size / 100000000000000;
  const bool three_digits = high - low > size / 10;
  EXPECT_LE(low - below, three_digits ? Rational(size / 100) : slack) << decimals.lower << " " << decimals.upper;
  EXPECT_LE(above - high, three_digits ? Rational(size / 100) : slack) << decimals.lower << " " << decimals.upper;
}

TEST(Decimals, enclose_the_interval) {
  std::mt19937_64 generator(1);
  std::uniform_real_distribution<double> mantissa(-10, 10), power(-40, 40), width(-16, 1);
  for (int trial = 0; trial < 3000; ++trial) {
    const double lower = mantissa(generator) * std::pow(10, power(generator));
    const double upper = lower + std::abs(lower) * std::pow(10, width(generator));
    if (lower <= upper) expect_enclosed(lower, upper);
  }
  for (const auto& [lower, upper] : {std::pair(412.314, 412.376),
                                     {0.0, 1.61e-6},
                                     {-1e-16, 1e-16},
                                     {0.1, 0.1},
                                     {9.9999999, 10.0},
                                     {-10.0, -9.9999999},
                                     {1.0, 1.0},
                                     {-0.5, 2e7},
                                     {999999.9, 1000000.1}})
    expect_enclosed(lower, upper);
}

TEST(Decimals, as_people_write_them) {
  const auto text = [](double lower, double upper) {
    const auto [low, high] = enclosed_in_decimals(lower, upper);
    return low + " " + high;
  };
  EXPECT_EQ(text(412.3141, 412.3759), "412.314 412.376");
  EXPECT_EQ(text(0, 0), "0 0");
  EXPECT_EQ(text(0.5, 0.75), "0.500 0.750");
  EXPECT_EQ(text(-0.5, -0.25), "-0.500 -0.250");
  EXPECT_EQ(text(0x1p-20, 0x1.8p-20), "9.5e-07 1.44e-06");
}

const std::string asked = R"(
[[quantity]]
name = "lift"
displacement = "upper.top"
direction = [0, 1]
target = 0.5
[[quantity]]
force = "upper.bottom"
[[quantity]]
energy = true
)";

class Quantities : public Command {
 protected:
  Quantities() { write("scene.toml", two_blocks + asked); }
};

TEST_F(Quantities, come_first_and_are_rounded_outward) {
  const Ended ended = shell("bracket run scene.toml --set refine.strategy=adaptive --set refine.target=0.05");
  ASSERT_EQ(ended.status, 0) << ended.err;
  const Json report = Json::parse(read("scene.out/report.json"));
  ASSERT_EQ(report["quantities"].size(), 3u);
  for (const Json& quantity : report["quantities"]) {
    std::smatch found;
    const std::string name = quantity["name"];
    ASSERT_TRUE(std::regex_search(ended.out, found, std::regex("\n● " + name + "  +(\\S+) … (\\S+) (N|mm).*   ±")))
        << ended.out;
    EXPECT_LE(value(found[1]), Rational(quantity["lower"].get<double>()));
    EXPECT_GE(value(found[2]), Rational(quantity["upper"].get<double>()));
    EXPECT_LT(ended.out.find("● guaranteed error"), ended.out.find("● " + name));
    EXPECT_LT(ended.out.find("● " + name), ended.out.find("● energy "));
    EXPECT_FALSE(quantity["levels"].empty());
    EXPECT_EQ(quantity["levels"].back()["cells"], report["levels"].back()["cells"]);
    EXPECT_TRUE(quantity["target_reached"].get<bool>());
    for (const Json& level : quantity["levels"]) {
      EXPECT_LE(level["lower"], quantity["lower"]);
      EXPECT_GE(level["upper"], quantity["upper"]);
    }
  }
  const std::string csv = read("scene.out/quantities.csv");
  std::size_t expected = 1;
  for (const Json& quantity : report["quantities"]) expected += quantity["levels"].size();
  EXPECT_EQ(std::ranges::count(csv, '\n'), static_cast<std::ptrdiff_t>(expected));
}

TEST_F(Quantities, a_target_that_is_not_reached_is_status_5) {
  const Ended ended = shell("bracket run scene.toml --quiet --no-report --set quantity.0.target=1e-9");
  EXPECT_EQ(ended.status, 5);
  EXPECT_NE(ended.err.find("the target of 'lift' is not reached"), std::string::npos) << ended.err;
}

TEST_F(Quantities, all_levels) {
  const Ended ended = shell(
      "bracket run scene.toml --quiet --no-report --all-levels --set refine.strategy=uniform "
      "--set refine.max_levels=3");
  ASSERT_EQ(ended.status, 0) << ended.err;
  for (const Json& quantity : Json::parse(read("scene.out/report.json"))["quantities"])
    EXPECT_EQ(quantity["levels"].size(), 3u);
}

TEST_F(Quantities, zones_of_a_contact) {
  const Ended ended = shell(
      "bracket run scene.toml --no-report --set contact.0.zones=2 --set refine.strategy=uniform "
      "--set refine.max_levels=3");
  ASSERT_EQ(ended.status, 0) << ended.err;
  const Json zones = Json::parse(read("scene.out/report.json"))["contact"][0]["zones"];
  ASSERT_EQ(zones.size(), 2u);
  for (const Json& zone : zones) EXPECT_LE(zone["lower"], zone["upper"]);
  EXPECT_TRUE(std::regex_search(ended.out, std::regex("● guaranteed +force of zone 2 +\\S+ … "))) << ended.out;
}

TEST(Share, encloses_the_ratio_of_any_two_forces_of_the_intervals) {
  std::mt19937_64 generator(3);
  std::uniform_real_distribution<double> uniform(0, 1), power(-6, 0);
  const auto interval = [](double lower, double upper) {
    bounds::QuantityInterval result;
    result.lower = lower;
    result.upper = upper;
    return result;
  };
  for (int trial = 0; trial < 1000; ++trial) {
    const double total = 100 * uniform(generator), part = uniform(generator) * total;
    const double about_part = std::pow(10, power(generator)), about_total = std::pow(10, power(generator));
    const auto of_part = interval(part * (1 - about_part), part * (1 + about_part));
    const auto of_all = interval(total * (1 - about_total), total * (1 + about_total));
    const auto [lower, upper] = share(of_part, of_all);
    EXPECT_LE(Rational(lower) * Rational(of_all.upper), Rational(of_part.lower));
    EXPECT_GE(Rational(upper) * Rational(of_all.lower), std::min(Rational(of_part.upper), Rational(of_all.lower)));
    EXPECT_LE(lower, upper);
    EXPECT_NEAR(lower, of_part.lower / of_all.upper, 1e-15);
    EXPECT_NEAR(upper, std::min(1.0, of_part.upper / of_all.lower), 1e-15);
  }
  const double infinite = std::numeric_limits<double>::infinity();
  const auto expect = [](const Share& found, double lower, double upper) {
    EXPECT_DOUBLE_EQ(found.lower, lower);
    EXPECT_DOUBLE_EQ(found.upper, upper);
  };
  expect(share(interval(0.5, infinite), interval(1, 2)), 0.25, 1);
  expect(share(interval(0.5, 0.75), interval(1, infinite)), 0, 0.75);
  expect(share(interval(-1e-9, 1e-9), interval(-1e-9, 1e-9)), 0, 1);
  expect(share(interval(-1, 0), interval(1, 2)), 0, 0);
}

TEST_F(Quantities, forces_of_stretches_by_the_total) {
  write("shares.toml", std::string(two_blocks) + R"(
[[quantity]]
force = "upper.bottom"
name  = "all"
[[quantity]]
force = "upper.bottom"
name  = "left"
from  = 0.5
to    = 1
[[quantity]]
opening = "upper.bottom"
name    = "gap"
)");
  const std::string refined = " --set refine.strategy=uniform --set refine.max_levels=3";
  const Ended ended = shell("bracket run shares.toml --set contact.0.zones=2" + refined);
  ASSERT_EQ(ended.status, 0) << ended.err;
  const Json report = Json::parse(read("shares.out/report.json"));
  const Json &all = report["quantities"][0], &left = report["quantities"][1], &gap = report["quantities"][2];
  EXPECT_TRUE(all["share"].is_null());
  EXPECT_TRUE(gap["share"].is_null());
  const auto expect_share = [&](const Json& part) {
    ASSERT_FALSE(part["share"].is_null());
    const Rational lower(part["share"]["lower"].get<double>()), upper(part["share"]["upper"].get<double>());
    EXPECT_LE(lower * Rational(all["upper"].get<double>()),
              std::max(Rational(0), Rational(part["lower"].get<double>())));
    EXPECT_TRUE(upper == 1 || upper * Rational(all["lower"].get<double>()) >= Rational(part["upper"].get<double>()));
    EXPECT_TRUE(lower > 0 || upper < 1);
  };
  expect_share(left);
  for (const Json& zone : report["contact"][0]["zones"]) expect_share(zone);
  const std::string html = read("shares.out/report.html");
  for (const std::string& text : {ended.out, html})
    for (const std::string part : {"of the total ", "share of zone 1", "share of zone 2"})
      EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
  const Ended without =
      shell("bracket run scene.toml --no-report --set contact.0.zones=2 --set quantity.1.weight=1" + refined);
  ASSERT_EQ(without.status, 0) << without.err;
  EXPECT_EQ(without.out.find("of the total"), std::string::npos) << without.out;
  EXPECT_EQ(without.out.find("share of zone"), std::string::npos) << without.out;
}

}  // namespace
}  // namespace bracket::apps::tests
