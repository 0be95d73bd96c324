// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/toml/toml.h"

#include <algorithm>
#include <memory>
#include <string_view>

namespace bracket::scene {

namespace {

constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";

bool is_ascii(char c) { return static_cast<unsigned char>(c) < 0x80; }
bool begins_character(char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }

/// The place of the first character beyond ASCII that stands outside of strings and comments; npos: there is none.
std::size_t foreign_character(std::string_view text) {
  constexpr std::string_view before_string = " \t\r\n=.,[{";
  const std::size_t begin = text.starts_with(byte_order_mark) ? byte_order_mark.size() : 0;
  std::string_view end;  // of the string or comment at the place; empty: there is none
  for (std::size_t i = begin; i < text.size(); ++i) {
    const std::string_view rest = text.substr(i);
    if (end.empty()) {
      if (!is_ascii(rest[0])) return i;
      const bool may_open = i == begin || before_string.find(text[i - 1]) != std::string_view::npos;
      for (const std::string_view quote : {"\"\"\"", "'''", "\"", "'"})
        if (may_open && end.empty() && rest.starts_with(quote)) end = quote;
      if (rest[0] == '#') end = "\n";
      i += std::max<std::size_t>(end.size(), 1) - 1;
    } else if (rest[0] == '\\' && end[0] == '"') {
      ++i;
    } else if (rest.starts_with(end)) {
      i += end.size() - 1;
      end = {};
    } else if (rest[0] == '\n' && end.size() == 1) {
      end = {};  // a string that is not closed, as the parser will say
    }
  }
  return std::string_view::npos;
}

toml::source_position position(std::string_view text, std::size_t place) {
  toml::source_position result{1, 1};
  for (const char c : text.substr(0, place)) {
    if (c == '\n')
      result = {result.line + 1, 1};
    else if (begins_character(c))
      ++result.column;
  }
  return result;
}

}  // namespace

toml::table parse_toml(const std::string& text, const std::string& name) {
  // The parser of toml++ 3.3 is undefined for letters of other alphabets where it looks for blanks.
  if (const std::size_t place = foreign_character(text); place != std::string_view::npos)
    throw toml::parse_error("only strings and comments may have characters beyond ASCII", position(text, place),
                            std::make_shared<const std::string>(name));
  return toml::parse(text, name);
}

}  // namespace bracket::scene
