// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.h"

/// The text of an Abaqus input file: keywords with their parameters, each followed by lines of data.
namespace bracket::scene {

struct AbaqusCard {
  struct Line {
    std::string_view text;
    std::string_view file;
    int number;
  };
  std::string keyword;                            ///< in capitals, without the star: "SOLID SECTION"
  std::map<std::string, std::string> parameters;  ///< by their names in capitals; values as they are written
  Line line;                                      ///< where it begins
  std::vector<Line> data;

  /// The value of a parameter; empty: there is none.
  std::string parameter(const std::string& name) const;
};

/// With the files that it includes; views into them are valid as long as this is.
struct AbaqusFile {
  std::deque<std::string> texts;
  std::deque<std::string> files;
  std::vector<AbaqusCard> cards;
};

/// \throw Error (input: no such file; mesh: data before the first keyword, an included file that is not there, files
/// that
///        include each other)
AbaqusFile read_abaqus_file(const std::filesystem::path& file);

/// What stands between the commas of a line, without blanks around it; empty ones at the end are left out.
std::vector<std::string_view> fields(std::string_view line);

std::string capitals(std::string_view text);

/// Throws an Error (mesh) at a line.
[[noreturn]] void refuse(const AbaqusCard::Line& line, const std::string& message);

}  // namespace bracket::scene
