// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/report/lines.h"

#include <gtest/gtest.h>

#include "apps/report/units.h"
#include "tests/apps/command.h"

namespace bracket::apps::tests {
namespace {

TEST(Lines, KeepTheirWordsAndFit) {
  std::string text;
  for (int word = 0; word < 200; ++word) text += (word % 60 == 59 ? "\n" : " ") + std::string(word % 11 + 1, 'a') + "é";
  text += "\n";
  const std::string broken = within_columns(text);
  EXPECT_LE(widest(broken), terminal_columns);
  EXPECT_GT(widest(broken), terminal_columns - 13);  // no more is left than a word takes
  const auto words = [](const std::string& of) {
    std::istringstream in(of);
    return std::vector<std::string>(std::istream_iterator<std::string>(in), {});
  };
  EXPECT_EQ(words(broken), words(text));
  EXPECT_EQ(within_columns(broken), broken);
}

TEST(Lines, LeaveWhatCannotBeBroken) {
  const std::string path(100, '/');
  EXPECT_EQ(within_columns("a " + path + " b\n"), "a\n  " + path + "\n  b\n");
  EXPECT_EQ(within_columns("  " + path + "\n"), "  " + path + "\n");
  EXPECT_EQ(within_columns("\nshort\n\n"), "\nshort\n\n");
}

TEST(Units, StandBehindNumbersWhereTheyAreKnownAndFit) {
  for (const char* label : {"N, mm, MPa", "MPa, N, mm", "mm; N"}) EXPECT_EQ(units_of(label).force, " N/mm") << label;
  EXPECT_EQ(units_of("N, mm, MPa").stress, " MPa");
  EXPECT_EQ(units_of("N, m").stress, " N/m²");
  EXPECT_EQ(units_of("m, kPa").force, " kPa m");
  EXPECT_EQ(units_of("m, kPa").body_force, " kPa/m");
  EXPECT_EQ(units_of("N, mm, MPa").body_force, " N/mm³");
  EXPECT_EQ(units_of("N, mm, MPa").energy_norm, " √(N mm/mm)");
  EXPECT_EQ(units_of("ft, kip").area, " ft²");
  EXPECT_EQ(units_of("lbf, in, psi").length, " in");
  // Not fitting together, unknown, twice or too few: the label is all there is.
  for (const char* label : {"N, m, MPa", "kgf, mm", "N, mm, m", "mm", "", "SI"})
    EXPECT_EQ(units_of(label).length + units_of(label).force + units_of(label).stress, "") << label;
}

}  // namespace
}  // namespace bracket::apps::tests
