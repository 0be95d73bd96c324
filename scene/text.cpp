// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <numeric>
#include <sstream>

namespace bracket::scene {

namespace {

std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, replaced});
    }
  }
  return row.back();
}

}  // namespace

void fail(Status status, const std::string& where, const std::string& message) {
  const auto on_one_line = [](std::string text) {
    std::replace_if(
        text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, ' ');
    return text;
  };
  throw Error(status, on_one_line(where), on_one_line(message));
}

std::string nearest(const std::string& name, std::span<const std::string> known) {
  const auto best = std::min_element(known.begin(), known.end(), [&](const std::string& a, const std::string& b) {
    return edit_distance(name, a) < edit_distance(name, b);
  });
  return best == known.end() ? "" : *best;
}

std::string suggestion(const std::string& name, std::span<const std::string> known) {
  if (known.empty()) return "there are none";
  constexpr std::size_t shown = 24;
  return fmt::format("did you mean '{}'? Known: {}{}", nearest(name, known),
                     fmt::join(known.first(std::min(shown, known.size())), ", "),
                     known.size() > shown ? fmt::format(", … ({} in all)", known.size()) : "");
}

std::string point(const Vector<2>& x) { return fmt::format("({:.7g}, {:.7g})", x[0], x[1]); }

std::string point(const Vector<3>& x) { return fmt::format("({:.7g}, {:.7g}, {:.7g})", x[0], x[1], x[2]); }

std::string read_text(const std::filesystem::path& file) {
  std::error_code error;
  const auto type = std::filesystem::status(file, error).type();
  if (type == std::filesystem::file_type::not_found) fail(Status::input, file.string(), "no such file");
  if (type == std::filesystem::file_type::directory) fail(Status::input, file.string(), "is a directory, not a file");
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  if (stream.peek() != std::ifstream::traits_type::eof()) text << stream.rdbuf();
  if (!stream.is_open() || stream.bad() || text.fail()) fail(Status::input, file.string(), "cannot be read");
  return std::move(text).str();
}

}  // namespace bracket::scene
