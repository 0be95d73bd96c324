// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <sstream>
#include <vector>

#include "apps/commands/commands.h"
#include "apps/report/lines.h"
#include "embedded/scene_file_page.h"

namespace bracket::apps {
namespace {

/// Markdown as plain text: without the marks of code and of kinds of values, and of links only what is shown.
std::string plain(std::string text) {
  for (const std::string kind : {"number", "numbers", "function"})
    for (std::size_t at; (at = text.find("*" + kind + "*")) != std::string::npos;)
      text.replace(at, kind.size() + 2, kind);
  std::erase(text, '`');
  for (std::size_t end; (end = text.find("](")) != std::string::npos;) {
    const std::size_t begin = text.rfind('[', end), close = text.find(')', end);
    if (begin == std::string::npos || close == std::string::npos) break;
    text = text.substr(0, begin) + text.substr(begin + 1, end - begin - 1) + text.substr(close + 1);
  }
  return text;
}

/// The cells of a row of a table.
std::vector<std::string> cells_of(const std::string& row) {
  std::vector<std::string> cells;
  for (std::size_t begin = 2; begin < row.size();) {
    const std::size_t end = std::min(row.find(" |", begin), row.size());
    cells.push_back(plain(row.substr(begin, end - begin)));
    begin = end + 3;
  }
  return cells;
}

}  // namespace

std::string scene_keys_text() {
  std::string text = "The keys of a scene file: its value, unit and default.\n", heading;
  std::istringstream page(scene_file_page);
  for (std::string line; std::getline(page, line);) {
    if (line.starts_with("## ") || line.starts_with("### ")) heading = plain(line.substr(line.find(' ') + 1));
    if (!line.starts_with("| `")) continue;
    const std::vector<std::string> cells = cells_of(line);
    if (cells.size() != 5) continue;  // key, value, unit, default, meaning
    if (!heading.empty()) text += "\n" + heading + "\n";
    heading.clear();
    const std::string unit = cells[2] == "–" ? "" : "; " + cells[2];
    const std::string otherwise = cells[3] == "–"          ? ""
                                  : cells[3] == "required" ? "; required"
                                                           : "; default: " + cells[3];
    text += fmt::format("  {}  {}{}{}\n      {}\n", padded(cells[0], 12), cells[1], unit, otherwise, cells[4]);
  }
  return within_columns(text);
}

}  // namespace bracket::apps
