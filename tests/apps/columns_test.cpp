// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/report/columns.h"

#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "tests/apps/command.h"

namespace bracket::apps::tests {
namespace {

using Json = nlohmann::json;

class Columns : public Command {
 protected:
  Columns() { write("scene.toml", two_blocks); }

  /// The lines of a table, each by the names of its columns.
  std::vector<std::map<std::string, std::string>> table(const std::string& file) const {
    const auto split = [](const std::string& line) {
      std::vector<std::string> words;
      std::istringstream in(line);
      for (std::string word; std::getline(in, word, ',');) words.push_back(word);
      return words;
    };
    std::istringstream in(read(file));
    std::string line;
    std::getline(in, line);
    const std::vector<std::string> names = split(line);
    EXPECT_EQ(std::set(names.begin(), names.end()).size(), names.size());
    std::vector<std::map<std::string, std::string>> rows;
    while (std::getline(in, line)) {
      const std::vector<std::string> values = split(line);
      EXPECT_EQ(values.size(), names.size());
      auto& row = rows.emplace_back();
      for (std::size_t i = 0; i < names.size(); ++i) row[names[i]] = values.at(i);
    }
    return rows;
  }
};

// The same doubles in both files, and no number that only one of them has.
void expect_same(const std::map<std::string, std::string>& row, const Json& level, std::size_t names_beside) {
  EXPECT_EQ(row.size(), columns().size() + names_beside);
  EXPECT_EQ(level.flatten().size(), columns().size());
  for (const Column& column : columns()) {
    ASSERT_TRUE(row.contains(column.name)) << column.name;
    const Json& value = level.at(Json::json_pointer(column.path));
    EXPECT_EQ(value.get<double>(), std::stod(row.at(column.name))) << column.name;
  }
}

TEST_F(Columns, HistoryAndReportTellTheSameOfEveryLevel) {
  ASSERT_EQ(shell("bracket run scene.toml --no-report --set refine.strategy=uniform --set refine.max_levels=2").status,
            0);
  const Json levels = Json::parse(read("scene.out/report.json"))["levels"];
  const auto rows = table("scene.out/history.csv");
  ASSERT_EQ(levels.size(), 2u);
  ASSERT_EQ(rows.size(), 2u);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(rows[i].at("level"), std::to_string(i));
    expect_same(rows[i], levels[i], 1);
  }
}

TEST_F(Columns, BothTablesOfAStudyTellTheSame) {
  ASSERT_EQ(shell("bracket study scene.toml --set refine.max_levels=2").status, 0);
  const Json series = Json::parse(read("scene.study/study.json"))["series"];
  auto row = table("scene.study/study.csv");
  std::size_t next = 0;
  for (const Json& each : series)
    for (const Json& level : each["levels"]) {
      ASSERT_LT(next, row.size());
      EXPECT_EQ(row[next].at("strategy"), each["strategy"]);
      EXPECT_EQ(row[next].at("degree"), std::to_string(each["degree"].get<int>()));
      EXPECT_GT(std::stod(row[next].at("seconds_certify")), 0);
      expect_same(row[next++], level, 3);
    }
  EXPECT_EQ(next, row.size());
}

TEST(Column, NumbersThatOthersReadKeepTheirNames) {
  std::set<std::string> names;
  for (const Column& column : columns()) names.insert(column.name);
  for (const char* name :
       {"cells", "primal_dofs", "dual_dofs", "lower", "upper", "relative_width", "relative_error_bound", "contact_rows",
        "contact_active", "contact_iterations", "seconds_mesh", "seconds_primal", "seconds_dual", "seconds_estimate",
        "seconds_certify", "seconds_total", "seconds_write", "seconds_elapsed"})
    EXPECT_TRUE(names.contains(name)) << name;
  for (const std::string formulation : {"primal_", "dual_"})
    for (const char* phase : {"assemble", "order", "factorise", "contact", "recover"})
      EXPECT_TRUE(names.contains(formulation + phase)) << formulation << phase;
}

TEST(Column, FormulationsDoNotMix) {
  bounds::Level level;
  level.primal = {1, 2, 3, 4, 5, {6, 7, 8, 9, 10}};
  level.dual = {11, 12, 13, 14, 15, {16, 17, 18, 19, 20}};
  const auto number = [&](const std::string& name) { return value(name, level, {}); };
  EXPECT_EQ(number("primal_dofs"), 1);
  EXPECT_EQ(number("dual_dofs"), 11);
  double expected = 2;
  for (const char* name : {"rows", "active", "iterations"}) {
    EXPECT_EQ(number(std::string("contact_") + name), expected) << name;
    EXPECT_EQ(number(std::string("contact_dual_") + name), expected + 10) << name;
    ++expected;
  }
  EXPECT_EQ(number("imbalance_primal"), 5);
  EXPECT_EQ(number("imbalance_dual"), 15);
  expected = 6;
  for (const std::string phase : phase_names) {
    EXPECT_EQ(number("primal_" + phase), expected) << phase;
    EXPECT_EQ(number("dual_" + phase), expected + 10) << phase;
    ++expected;
  }
}

}  // namespace
}  // namespace bracket::apps::tests
