// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/mesh/abaqus_cards.h"

#include <fmt/format.h>

#include <algorithm>

#include "scene/text.h"

namespace bracket::scene {

namespace {

using Line = AbaqusCard::Line;

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r";
  text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
  return text.substr(0, text.find_last_not_of(blanks) + 1);
}

std::string unquoted(std::string_view text) {
  if (text.size() > 1 && text.front() == '"' && text.back() == '"') text = text.substr(1, text.size() - 2);
  return std::string(text);
}

/// The lines of a text that are neither empty nor comments.
std::vector<Line> lines_of(std::string_view text, std::string_view file) {
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);  // a byte-order mark
  std::vector<Line> lines;
  for (int number = 1; !text.empty(); ++number) {
    const std::string_view line = trimmed(text.substr(0, text.find('\n')));
    if (!line.empty() && !line.starts_with("**")) lines.push_back({line, file, number});
    text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
  }
  return lines;
}

AbaqusCard card_of(const Line& line, std::string_view text) {
  AbaqusCard card;
  card.line = line;
  for (const std::string_view field : fields(text.substr(1))) {
    const std::size_t equals = field.find('=');
    const std::string name = capitals(trimmed(field.substr(0, equals)));
    if (card.keyword.empty()) {
      for (const char c : name)  // blanks between its words count once
        if (c != ' ' || !card.keyword.ends_with(' ')) card.keyword += c;
      if (card.keyword.empty()) refuse(line, "a keyword is expected after '*'");
    } else if (!name.empty()) {
      card.parameters[name] = equals == std::string_view::npos ? "" : unquoted(trimmed(field.substr(equals + 1)));
    }
  }
  if (card.keyword.empty()) refuse(line, "a keyword is expected after '*'");
  return card;
}

/// \param open the files that lead to this one
void read_into(AbaqusFile& all, const std::filesystem::path& path, std::vector<std::filesystem::path> open) {
  open.push_back(std::filesystem::weakly_canonical(path));
  const std::string& text = all.texts.emplace_back(read_text(path));
  const std::string& name = all.files.emplace_back(path.string());
  const std::vector<Line> lines = lines_of(text, name);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (!lines[i].text.starts_with('*')) {
      if (all.cards.empty()) refuse(lines[i], "a keyword ('*NODE' and the like) is expected: not an Abaqus input file");
      all.cards.back().data.push_back(lines[i]);
      continue;
    }
    const Line& first = lines[i];
    std::string keyword_line(first.text);  // goes on as long as it ends with a comma
    while (keyword_line.ends_with(',') && i + 1 < lines.size() && !lines[i + 1].text.starts_with('*'))
      keyword_line += lines[++i].text;
    AbaqusCard card = card_of(first, keyword_line);
    const bool include = card.keyword == "INCLUDE";
    const std::string input = card.parameter("INPUT");
    if (!include) all.cards.push_back(std::move(card));  // else what it includes goes on with the card before
    if (input.empty()) {
      if (include) refuse(first, "*INCLUDE has no INPUT=file");
      continue;
    }
    const std::filesystem::path included = path.parent_path() / input;
    if (std::ranges::find(open, std::filesystem::weakly_canonical(included)) != open.end())
      refuse(first, fmt::format("'{}' includes itself", input));
    try {
      read_into(all, included, open);
    } catch (const Error& error) {
      if (error.status() != Status::input) throw;
      refuse(first, error.what());
    }
  }
}

}  // namespace

std::string AbaqusCard::parameter(const std::string& name) const {
  const auto found = parameters.find(name);
  return found == parameters.end() ? "" : found->second;
}

std::vector<std::string_view> fields(std::string_view line) {
  std::vector<std::string_view> result;
  for (bool more = true; more;) {
    bool quoted = false;
    std::size_t end = 0;
    for (; end < line.size() && (quoted || line[end] != ','); ++end) quoted ^= line[end] == '"';
    result.push_back(trimmed(line.substr(0, end)));
    more = end < line.size();
    line.remove_prefix(std::min(end + 1, line.size()));
  }
  while (!result.empty() && result.back().empty()) result.pop_back();
  return result;
}

std::string capitals(std::string_view text) {
  std::string result(text);
  std::ranges::transform(result, result.begin(), [](char c) { return c >= 'a' && c <= 'z' ? char(c - 'a' + 'A') : c; });
  return result;
}

void refuse(const AbaqusCard::Line& line, const std::string& message) {
  fail(Status::mesh, fmt::format("{}:{}", line.file, line.number), message);
}

AbaqusFile read_abaqus_file(const std::filesystem::path& file) {
  AbaqusFile all;
  read_into(all, file, {});
  return all;
}

}  // namespace bracket::scene
