// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string>
#include <string_view>

#include "scene/mesh/gmsh_file.h"
#include "scene/mesh/readers.h"
#include "scene/text.h"

namespace bracket::scene {

/// Words and numbers of a text, one after the other; knows the line for messages.
class GmshScanner {
 public:
  using Tag = GmshFile::Tag;

  GmshScanner(std::string text, std::string file) : text_(std::move(text)), file_(std::move(file)) {
    if (text_.starts_with("\xef\xbb\xbf")) position_ = 3;  // a byte-order mark
  }

  [[noreturn]] void refuse(const std::string& message) const {
    const auto here = text_.begin() + static_cast<std::ptrdiff_t>(position_);
    fail(Status::mesh, fmt::format("{}:{}", file_, 1 + std::count(text_.begin(), here, '\n')), message);
  }

  /// The next word; empty at the end of the file.
  std::string_view word() {
    while (position_ < text_.size() && blank(text_[position_])) ++position_;
    const std::size_t start = position_;
    while (position_ < text_.size() && !blank(text_[position_])) ++position_;
    return std::string_view(text_).substr(start, position_ - start);
  }

  /// What stands between the next pair of quotes.
  std::string quoted() {
    const std::size_t from = text_.find('"', position_);
    const std::size_t to = from == std::string::npos ? from : text_.find('"', from + 1);
    if (to == std::string::npos) refuse("a name in quotes is expected; the file may be truncated");
    position_ = to + 1;
    return text_.substr(from + 1, to - from - 1);
  }

  double number() {
    const std::string_view found = entry();
    const std::optional<double> value = decimal(found);
    if (!value) refuse(fmt::format("'{}' is not a number", found.substr(0, 40)));
    return *value;
  }

  Tag integer() {
    std::string_view found = entry();
    const std::string_view shown = found.substr(0, 40);
    if (found.size() > 1 && found[0] == '+' && found[1] != '-') found.remove_prefix(1);
    Tag value = 0;
    const auto [end, error] = std::from_chars(found.data(), found.data() + found.size(), value);
    if (error != std::errc() || end != found.data() + found.size())
      refuse(fmt::format("'{}' is not an integer", shown));
    if (value > largest || value < -largest) refuse(fmt::format("{} is out of range", value));
    return value;
  }

  /// An announced number of entries.
  Tag count() {
    const Tag value = integer();
    if (value < 0) refuse(fmt::format("{} entries cannot be", value));
    return value;
  }

  /// How many of `announced` entries can still come, each being of two characters at least: what may be reserved.
  std::size_t plausible(Tag announced) const {
    return std::min(static_cast<std::size_t>(announced), (text_.size() - position_) / 2);
  }

  void end_section(const std::string& name) {
    const std::string_view found = word();
    if (found == "$End" + name) return;
    refuse(found.empty() ? fmt::format("$End{} is missing: the file is truncated", name)
                         : fmt::format("$End{} is expected, found '{}'", name, found.substr(0, 40)));
  }

  void skip_section(const std::string& name) {
    position_ = text_.find("$End" + name, position_);
    if (position_ == std::string::npos) {
      position_ = text_.size();
      refuse(fmt::format("$End{} is missing: the file is truncated", name));
    }
    end_section(name);
  }

 private:
  static bool blank(char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; }

  std::string_view entry() {
    const std::string_view found = word();
    if (found.empty()) refuse("the file ends in the middle of a section: it is truncated");
    if (found[0] == '$') refuse(fmt::format("{} comes before all announced entries: the file is truncated", found));
    return found;
  }

  static constexpr Tag largest = Tag{1} << 62;  // its negative and small sums are numbers, too
  std::string text_;
  std::string file_;
  std::size_t position_ = 0;
};

}  // namespace bracket::scene
