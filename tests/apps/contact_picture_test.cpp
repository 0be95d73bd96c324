// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <sstream>

#include "apps/plots/pictures.h"
#include "bounds/bounds.h"

namespace bracket::apps::tests {
namespace {

/// The inline data of a script, block by block, as they follow the plot commands.
std::vector<std::vector<std::array<double, 6>>> blocks(const std::string& script) {
  std::vector<std::vector<std::array<double, 6>>> result(1);
  std::istringstream lines(script.substr(script.find("\nplot ") + 1));
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line)) {
    if (line == "e") {
      result.emplace_back();
      continue;
    }
    std::istringstream words(line);
    std::array<double, 6> row{};
    std::size_t n = 0;
    while (n < row.size() && words >> row[n]) ++n;
    if (n > 1) result.back().push_back(row);
  }
  return result;
}

// The arc length of the picture is that of the quantities' stretches: the mean pressure of a zone, by the curve, is
// within what is guaranteed of it.
TEST(ContactPicture, ZonesLieWhereTheyAre) {
  const auto scene = scene::read_scene<2>(
      BRACKET_SCENES "/two_blocks.toml",
      {"mesh.block.0.cells=[8, 8]", "mesh.block.1.cells=[8, 8]", "contact.0.zones=2", "refine.max_levels=3"});
  const auto outcome = bounds::run(scene);
  const auto data = blocks(contact_picture(report(scene, outcome), 0).script);
  ASSERT_GE(data.size(), 3u);
  const auto &zones = data[0], &pressure = data[2];
  ASSERT_EQ(zones.size(), 2u);
  for (const auto& zone : zones) {
    double force = 0;
    for (std::size_t i = 0; i + 1 < pressure.size(); ++i)
      if (pressure[i][0] >= zone[2] - 1e-9 && pressure[i + 1][0] <= zone[3] + 1e-9)
        force += (pressure[i + 1][0] - pressure[i][0]) * (pressure[i][1] + pressure[i + 1][1]) / 2;
    const double mean = force / (zone[3] - zone[2]);
    EXPECT_GE(mean, zone[4] - 1e-4);
    EXPECT_LE(mean, zone[5] + 1e-4);
  }
  EXPECT_GT(zones[1][4], zones[0][5]);  // the left half of the block presses: its right one, seen from inside
}

}  // namespace
}  // namespace bracket::apps::tests
