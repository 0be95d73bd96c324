// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// docs/meshes.md: what it says to type works, and prints what it says.
#include <nlohmann/json.hpp>

#include "tests/apps/command.h"
#include "tests/apps/page.h"

namespace bracket::apps::tests {
namespace {

class MeshesPage : public Command {
 protected:
  MeshesPage() { shell("cp '" BRACKET_DOCS "'/meshes/* ."); }
};

TEST_F(MeshesPage, ItsCommandsRunAndPrintWhatItSays) {
  const std::vector<Block> all = blocks(BRACKET_DOCS "/meshes.md");
  std::vector<std::pair<double, double>> energies;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].language != "sh") continue;
    const Ended ended = shell(all[i].text);
    EXPECT_EQ(ended.status, 0) << all[i].text << ended.err;
    if (i + 1 < all.size() && all[i + 1].language == "text") {
      EXPECT_EQ(ended.out, all[i + 1].text);
    }
    if (all[i].text.find("bracket run") == std::string::npos) continue;
    const auto energy = nlohmann::json::parse(shell("cat *.out/report.json && rm -r *.out").out)["energy"];
    energies.emplace_back(energy["lower"], energy["upper"]);
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
