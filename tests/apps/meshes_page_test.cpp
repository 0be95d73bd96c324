// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// docs/meshes.md: what it says to type works, and prints what it says.
#include <fstream>
#include <sstream>

#include "tests/apps/command.h"

namespace bracket::apps::tests {
namespace {

/// A block between ```: its language and its text.
struct Block {
  std::string language, text;
};

std::vector<Block> blocks() {
  std::ifstream stream(BRACKET_DOCS "/meshes.md");
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

class MeshesPage : public Command {
 protected:
  MeshesPage() { shell("cp '" BRACKET_DOCS "'/meshes/* ."); }
};

TEST_F(MeshesPage, ItsCommandsRunAndPrintWhatItSays) {
  const std::vector<Block> all = blocks();
  std::vector<std::pair<double, double>> energies;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].language != "sh") continue;
    const Ended ended = shell(all[i].text);
    EXPECT_EQ(ended.status, 0) << all[i].text << ended.err;
    if (i + 1 < all.size() && all[i + 1].language == "text") {
      EXPECT_EQ(ended.out, all[i + 1].text);
    }
    if (ended.out.starts_with("energy in [")) {
      const std::string numbers = ended.out.substr(11);
      energies.emplace_back(std::stod(numbers), std::stod(numbers.substr(numbers.find(',') + 1)));
    }
  }
  // One plate, whatever it is written in: .inp has 14 digits.
  ASSERT_EQ(energies.size(), 5u);
  for (const auto& [lower, upper] : energies) {
    EXPECT_NEAR(lower, energies[0].first, 1e-12 * std::abs(lower));
    EXPECT_NEAR(upper, energies[0].second, 1e-12 * std::abs(upper));
  }
}

}  // namespace
}  // namespace bracket::apps::tests
