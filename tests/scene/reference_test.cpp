// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// docs/scene-file.md and the reader know the same keys.
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "tests/scene/inputs.h"

namespace bracket::scene {
namespace {

using namespace test;

/// A section of the reference: the keys of its table, and its examples.
struct Section {
  std::set<std::string> keys;
  std::string examples;
};

std::vector<std::string> cells(const std::string& row) {
  std::vector<std::string> result;
  std::istringstream stream(row.substr(1));
  for (std::string cell; std::getline(stream, cell, '|');) {
    const std::size_t from = cell.find_first_not_of(' ');
    result.push_back(from == std::string::npos ? "" : cell.substr(from, cell.find_last_not_of(' ') + 1 - from));
  }
  return result;
}

/// The sections by their headings: "Top level", "[mesh]", …
std::map<std::string, Section> reference() {
  std::ifstream stream(BRACKET_DOCS "/scene-file.md");
  std::map<std::string, Section> sections;
  std::string section;
  bool in_example = false, in_table = false;
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with("```")) {
      in_example = line == "```toml";
    } else if (in_example) {
      sections[section].examples += line + "\n";
    } else if (line.starts_with("## ") || line.starts_with("### ")) {
      section = line.substr(line.find(' ') + 1);
      std::erase(section, '`');
    } else if (line == "| key | value | unit | default | meaning |") {
      in_table = true;
    } else if (in_table && line.starts_with("| `")) {
      const std::vector<std::string> row = cells(line);
      EXPECT_EQ(row.size(), 5u) << line;
      for (const std::string& cell : row) EXPECT_NE(cell, "") << line;
      const std::string key = row[0].substr(1, row[0].size() - 2);
      EXPECT_TRUE(sections[section].keys.insert(key).second) << key;
    } else if (!line.starts_with("|---")) {
      in_table = false;
    }
  }
  return sections;
}

/// The keys that the reader of scenes knows in a table, as its message on an unknown one lists them.
std::set<std::string> known_keys(const std::string& table) {
  const Folder folder;
  const std::string unknown = "no_such_key = 1\n";
  std::string text = two_blocks();
  if (table == "[mesh]") text = "schema = 1\n";  // the scene of blocks cannot have it
  const std::size_t header = text.find(table + "\n");
  if (table.empty() || header == std::string::npos)
    text = table.empty() ? unknown + text : text + table + "\n" + unknown;
  else
    text.insert(header + table.size() + 1, unknown);
  const auto error = error_of([&] { read_scene<2>(folder.write("scene.toml", text)); });
  EXPECT_TRUE(error.has_value()) << table;
  std::string list = error ? error->what() : "";
  EXPECT_NE(list.find("no_such_key"), std::string::npos) << list;
  list = list.substr(std::min(list.size(), list.find("Known: ") + 7));
  std::set<std::string> keys;
  const std::regex word("[A-Za-z_]+");
  for (std::sregex_iterator it(list.begin(), list.end(), word), end; it != end; ++it) keys.insert(it->str());
  return keys;
}

TEST(Reference, HasEveryKeyOfTheReaderWithAnExample) {
  const std::map<std::string, std::string> tables = {{"Top level", ""},
                                                     {"[mesh]", "[mesh]"},
                                                     {"[[mesh.block]]", "[[mesh.block]]"},
                                                     {"[bodies.NAME]", "[bodies.lower]"},
                                                     {"[boundary.\"PART\"]", "[boundary.\"lower.bottom\"]"},
                                                     {"[[contact]]", "[[contact]]"},
                                                     {"[[quantity]]", "[[quantity]]"},
                                                     {"[curves.\"PART\"]", "[curves.\"upper.top\"]"},
                                                     {"[refine]", "[refine]"},
                                                     {"[solve]", "[solve]"}};
  const auto sections = reference();
  std::set<std::string> documented;
  for (const auto& [heading, section] : sections)
    if (!section.keys.empty()) documented.insert(heading);
  for (const auto& [heading, table] : tables) {
    SCOPED_TRACE(heading);
    EXPECT_EQ(documented.erase(heading), 1u);
    const Section& section = sections.at(heading);
    EXPECT_EQ(section.keys, known_keys(table));
    for (const std::string& key : section.keys)
      EXPECT_TRUE(std::regex_search(section.examples, std::regex("(^|\\n)(" + key + " *=|\\[+" + key + "[.\\]])")) ||
                  (heading == "[mesh]" && key == "block"))  // it has a section of its own
          << key;
  }
  EXPECT_TRUE(documented.empty()) << testing::PrintToString(documented);
}

}  // namespace
}  // namespace bracket::scene
