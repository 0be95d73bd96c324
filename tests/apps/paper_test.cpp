// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>

#include "tests/apps/command.h"

/// The tables of `bracket paper` against what the theorems say.
namespace bracket::apps::tests {
namespace {

using Json = nlohmann::json;

class Paper : public Command {};

/// A table by labels and columns; of columns with one name the first.
struct Rows {
  explicit Rows(const Json& table) : json(table) {}
  double at(const Json& row, const std::string& column) const {
    const auto name = std::find(json["columns"].begin(), json["columns"].end(), column);
    EXPECT_NE(name, json["columns"].end()) << column;
    return row["values"][name - json["columns"].begin()].get<double>();
  }
  std::vector<double> of(const std::string& label, const std::string& column) const {
    std::vector<double> values;
    for (const Json& row : json["rows"])
      if (row["label"] == label) values.push_back(at(row, column));
    EXPECT_FALSE(values.empty()) << label;
    return values;
  }
  Json json;
};

/// The order between two meshes.
double order(const std::vector<double>& h, const std::vector<double>& error, std::size_t from, std::size_t to) {
  return std::log(error[from] / error[to]) / std::log(h[from] / h[to]);
}

/// The least root of sin²(λω) = ((κ + 1)² − 4λ² sin²ω) / (4κ), ω = π/2, κ = 3 − 4ν: at a right angle between a clamped
/// and a free side displacements go like r^λ, stresses like r^(λ−1).
double clamped_corner(double poisson) {
  const double kappa = 3 - 4 * poisson;
  const auto f = [&](double exponent) {
    const double sine = std::sin(exponent * std::numbers::pi / 2);
    return sine * sine - ((kappa + 1) * (kappa + 1) - 4 * exponent * exponent) / (4 * kappa);
  };
  double low = 0, high = 1;  // f(0) < 0 < f(1)
  for (int i = 0; i < 60; ++i) (f((low + high) / 2) < 0 ? low : high) = (low + high) / 2;
  return low;
}

void expect_theorem_2_1(const Rows& table) {
  double before = 0;
  for (const Json& row : table.json["rows"]) {
    const double c = table.at(row, "c(alpha)");
    EXPECT_GE(c, table.at(row, "needle"));
    EXPECT_GE(c, table.at(row, "flat"));
    EXPECT_GT(c, before);  // the angles fall
    before = c;
  }
}

void expect_theorem_2_2(const Rows& table) {
  for (const char* mesh : {"regular", "irregular"}) {
    const auto h = table.of(mesh, "h"), error = table.of(mesh, "error");
    EXPECT_NEAR(order(h, error, 1, 4), 2, 0.15) << mesh;
    for (const double angle : table.of(mesh, "smallest angle")) EXPECT_GT(angle, 15) << "else not a regular family";
  }
}

void expect_theorem_2_3(const Rows& table, const Rows& formulations) {
  std::map<std::string, double> expected = {
      {"smooth", 2}, {"contact end", 1.5}, {"clamped corners", clamped_corner(0.3)}};
  for (const auto& [example, power] : expected) {
    const auto h = table.of(example, "h"), error = table.of(example, "error");
    // The end of the contact lies differently in the edges of each mesh.
    EXPECT_NEAR(order(h, error, 1, 4), power, 0.1) << example;
  }
  const auto smooth = table.of("smooth", "error");
  for (std::size_t i = 1; i < smooth.size(); ++i) EXPECT_LT(smooth[i], std::pow(2, -1.5) * smooth[i - 1]);
  // On a closed contact σ(u_h) − σ and σ − λ_h are orthogonal.
  for (const char* closed : {"smooth", "clamped corners"}) {
    const auto error = table.of(closed, "error"), difference = formulations.of(closed, "stresses");
    for (std::size_t i = 0; i < error.size(); ++i) EXPECT_LT(error[i], difference[i]);
  }
}

void expect_lemma_1_6(const Rows& table) {
  constexpr double rounding = 1e-12, broken = 1e-3;
  const std::map<std::string, std::vector<std::string>> breaks = {
      {"(1.18) inside of a cell", {"balance"}},
      {"(1.18) between cells", {"jumps"}},
      {"(1.19) load", {"boundary"}},
      {"(1.20) shear on the base", {"boundary"}},
      {"(1.21) shear on the contact", {"boundary", "jumps"}},  // one side alone is sheared
      {"(1.22) two pressures", {"jumps"}},
      {"(1.22) tension", {"tension"}}};
  std::size_t seen = 0;
  for (const Json& row : table.json["rows"]) {
    const std::string label = row["label"];
    const auto entry = breaks.find(label);
    if (entry != breaks.end())
      ++seen;
    else
      EXPECT_TRUE(label.starts_with("solved: ")) << label;
    for (const char* condition : {"balance", "jumps", "boundary", "tension"}) {
      const bool meant = entry != breaks.end() && std::ranges::count(entry->second, condition) > 0;
      if (meant)
        EXPECT_GT(table.at(row, condition), broken) << label << ": " << condition;
      else
        EXPECT_LT(table.at(row, condition), rounding) << label << ": " << condition;
    }
    if (entry != breaks.end())
      EXPECT_GT(table.at(row, "excess"), broken) << label;
    else
      EXPECT_LT(table.at(row, "excess"), rounding) << label;
  }
  EXPECT_EQ(seen, breaks.size());
}

void expect_equality_1_15(const Rows& table) {
  EXPECT_NEAR(table.of("smooth, exact", "-S")[0], table.of("smooth, exact", "L")[0],
              1e-14 * std::abs(table.of("smooth, exact", "L")[0]));
  for (const char* example : {"contact end", "clamped corners"}) {  // one problem on all meshes
    const auto lower = table.of(example, "-S"), upper = table.of(example, "L");
    EXPECT_LE(std::ranges::max(lower), std::ranges::min(upper)) << example;
  }
  for (const char* example : {"smooth", "contact end", "clamped corners"}) {
    const auto difference = table.of(example, "difference");
    EXPECT_GT(difference.back(), 0);
    EXPECT_TRUE(std::ranges::is_sorted(difference, std::greater())) << example;
  }
}

void expect_two_formulations(const Rows& table) {
  for (const char* example : {"smooth", "contact end", "clamped corners"}) {
    SCOPED_TRACE(example);
    const auto n = table.of(example, "n"), pressed = table.of(example, "pressed"), closed = table.of(example, "closed");
    for (const char* error : {"stresses", "pressures"})
      EXPECT_TRUE(std::ranges::is_sorted(table.of(example, error), std::greater())) << error;
    for (std::size_t i = 0; i < n.size(); ++i) EXPECT_LE(std::abs(pressed[i] - closed[i]), 1.01 / n[i]) << "one edge";
  }
  EXPECT_LT(table.of("contact end", "pressed").back(), 1);
  EXPECT_EQ(table.of("smooth", "pressed").back(), 1);
}

TEST_F(Paper, HoldsWhatItStates) {
  const Ended ended = shell("bracket paper");
  ASSERT_EQ(ended.status, 0) << ended.err;
  EXPECT_LE(widest(ended.out), 80u);
  EXPECT_EQ(ended.err, "");
  const Json tables = Json::parse(read("bracket.paper/paper.json"))["tables"];
  for (const auto& [key, table] : tables.items())
    EXPECT_NE(ended.out.find(table["claim"].get<std::string>()), std::string::npos) << key;
  EXPECT_EQ(read("bracket.paper/paper.svg").substr(0, 5), "<?xml");

  expect_theorem_2_1(Rows(tables["theorem_2_1"]));
  expect_theorem_2_2(Rows(tables["theorem_2_2"]));
  expect_theorem_2_3(Rows(tables["theorem_2_3"]), Rows(tables["two_formulations"]));
  expect_lemma_1_6(Rows(tables["lemma_1_6"]));
  expect_equality_1_15(Rows(tables["equality_1_15"]));
  expect_two_formulations(Rows(tables["two_formulations"]));
}

}  // namespace
}  // namespace bracket::apps::tests
