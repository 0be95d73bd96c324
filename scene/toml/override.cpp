// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/toml/override.h"

#include <fmt/format.h>

#include <charconv>
#include <utility>

#include "scene/text.h"

namespace bracket::scene {

namespace {

struct Assignment {
  std::vector<std::string> path;
  std::string value;
};

Assignment split(const std::string& assignment, const std::string& where) {
  Assignment result;
  std::string part;
  char quote = 0;
  bool quoted = false;
  std::size_t blanks = 0;  // they count between other characters only
  for (std::size_t i = 0; i < assignment.size(); ++i) {
    const char c = assignment[i];
    if (quote != 0 && c != quote) {
      part += c;
    } else if (quote != 0) {
      quote = 0;
    } else if (c == '"' || c == '\'') {
      quote = c;
      quoted = true;
    } else if (c == '.' || c == '=') {
      if (part.empty() && !quoted) fail(Status::input, where, "a part of the key is empty; write key=value");
      result.path.push_back(part);
      part.clear();
      quoted = false;
      blanks = 0;
      if (c == '=') {
        result.value = assignment.substr(i + 1);
        return result;
      }
    } else if (c == ' ') {
      blanks += part.empty() ? 0 : 1;
    } else {
      part.append(std::exchange(blanks, 0), ' ') += c;
    }
  }
  fail(Status::input, where, "there is no '='; write key=value");
}

/// The parts [from, to) as one name.
std::string joined(const std::vector<std::string>& path, std::size_t from, std::size_t to) {
  const auto begin = path.begin();
  return fmt::format("{}", fmt::join(begin + static_cast<long>(from), begin + static_cast<long>(to), "."));
}

std::string toml_string(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) {
      result += fmt::format("\\u{:04x}", static_cast<int>(c));
    } else {
      if (c == '"' || c == '\\') result += '\\';
      result += c;
    }
  }
  return fmt::format("\"{}\"", result);
}

/// A table with one entry: `names` (a chain of tables) with `value` at the end, all placed at `where`.
toml::table entry(const std::vector<std::string>& names, const std::string& value, const std::string& where) {
  std::string key;
  for (const std::string& name : names) key += fmt::format("{}{}", key.empty() ? "" : ".", toml_string(name));
  try {
    toml::table parsed = parse_toml(key + " = " + value, where);
    if (parsed.size() == 1) return parsed;
  } catch (const toml::parse_error&) {  // not TOML: a string, so that formulas need no quotes
  }
  try {
    return parse_toml(key + " = " + toml_string(value), where);
  } catch (const toml::parse_error& error) {
    fail(Status::input, where, std::string(error.description()));
  }
}

/// How many parts of the path, from `from` on, name an existing key of `table`; the longest such name. 0: none does.
std::size_t known_parts(const toml::table& table, const std::vector<std::string>& path, std::size_t from) {
  for (std::size_t to = path.size(); to > from; --to) {
    if (table.contains(joined(path, from, to))) return to - from;
  }
  return 0;
}

/// The names of tables to add for the rest of the path. A new boundary part takes all up to the condition.
std::vector<std::string> new_names(const std::vector<std::string>& path, std::size_t from) {
  std::vector<std::string> names(path.begin() + static_cast<long>(from), path.end());
  if (path[0] == "boundary" && from <= 1 && path.size() > 3) {
    names.assign(path.begin() + static_cast<long>(from), path.begin() + 1);
    names.push_back(joined(path, 1, path.size() - 1));
    names.push_back(path.back());
  }
  return names;
}

std::size_t index_in(const toml::array& array, const std::string& list, const std::string& part,
                     const std::string& where) {
  std::size_t index = array.size();
  const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), index);
  if (error != std::errc() || end != part.data() + part.size() || index >= array.size()) {
    fail(
        Status::input, where,
        fmt::format("'{}' is a list with {} entries, numbered from 0; '{}' is none of them", list, array.size(), part));
  }
  return index;
}

}  // namespace

toml::table with_override(toml::table scene, const std::string& assignment) {
  const std::string where = "--set " + assignment;
  const auto [path, value] = split(assignment, where);
  toml::node* node = &scene;
  for (std::size_t done = 0;;) {
    if (toml::array* array = node->as_array()) {
      const std::size_t index = index_in(*array, joined(path, 0, done), path[done], where);
      if (++done < path.size()) {
        node = array->get(index);
        continue;
      }
      entry({"value"}, value, where).get("value")->visit([&](auto& fresh) {
        array->replace(array->cbegin() + static_cast<long>(index), std::move(fresh));
      });
      return scene;
    }
    toml::table* table = node->as_table();
    if (table == nullptr) {
      fail(Status::input, where, fmt::format("'{}' is a value, it has no '{}'", joined(path, 0, done), path[done]));
    }
    const std::size_t parts = known_parts(*table, path, done);
    if (parts > 0 && done + parts < path.size()) {
      node = table->get(joined(path, done, done + parts));
      done += parts;
      continue;
    }
    const std::vector<std::string> names =
        parts > 0 ? std::vector{joined(path, done, path.size())} : new_names(path, done);
    toml::table fresh = entry(names, value, where);
    table->erase(names[0]);
    for (auto&& [key, added] : fresh) {
      added.visit([&, &name = key](auto& moved) { table->insert(name, std::move(moved)); });
    }
    return scene;
  }
}

}  // namespace bracket::scene
