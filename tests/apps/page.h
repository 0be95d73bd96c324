// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

/// Pages of documentation, to have what they say to type tried.
namespace bracket::apps::tests {

/// A block between ```: its language and its text.
struct Block {
  std::string language, text;
};

/// Those of a page.
inline std::vector<Block> blocks(const std::filesystem::path& page) {
  std::ifstream stream(page);
  std::vector<Block> result;
  bool inside = false;
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with("```")) {
      inside = !inside;
      if (inside) result.push_back({line.substr(3), ""});
    } else if (inside) {
      result.back().text += line + "\n";
    }
  }
  return result;
}

}  // namespace bracket::apps::tests
