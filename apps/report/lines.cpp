// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/report/lines.h"

#include <algorithm>

namespace bracket::apps {
namespace {

/// Where a line is to be broken: the last blank before which all fits; where there is none, the first one behind it;
/// npos: nowhere. \param from what must not be broken
std::size_t break_of(const std::string& line, std::size_t from) {
  std::size_t found = std::string::npos;
  for (std::size_t at = line.find(' ', from); at != std::string::npos; at = line.find(' ', at + 1)) {
    if (line.substr(0, at).ends_with("±")) continue;
    if (columns_of(line.substr(0, at)) > terminal_columns) return found == std::string::npos ? at : found;
    found = at;
  }
  return found;
}

}  // namespace

std::size_t columns_of(const std::string& text) {
  return std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; });
}

std::string padded(const std::string& text, std::size_t columns) {
  return text + std::string(columns - std::min(columns, columns_of(text)), ' ');
}

std::string within_columns(const std::string& text) {
  std::string result;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    std::string line = text.substr(begin, end - begin);
    begin = end + 1;
    const std::string margin(std::min(line.find_first_not_of(' '), line.size()) + 2, ' ');
    for (std::size_t from = margin.size() - 2; columns_of(line) > terminal_columns; from = margin.size()) {
      const std::size_t at = break_of(line, from);
      if (at == std::string::npos) break;
      const std::size_t next = line.find_first_not_of(' ', at), last = line.find_last_not_of(' ', at);
      if (next == std::string::npos) break;
      result += line.substr(0, last + 1) + "\n";
      line = margin + line.substr(next);
    }
    result += line + "\n";
  }
  return result;
}

}  // namespace bracket::apps
