// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/toml/nodes.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "scene/range.h"
#include "scene/text.h"
#include "scene/toml/expression.h"

namespace bracket::scene {

namespace {

std::string type_of(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::table: return "a table";
    case toml::node_type::array: return "a list";
    case toml::node_type::string: return "a string";
    case toml::node_type::integer:
    case toml::node_type::floating_point: return "a number";
    case toml::node_type::boolean: return "a boolean";
    default: return "a date or time";
  }
}

/// What to write in place of keys that people expect; nullptr: nothing is known.
const char* way_out_of(const std::string& key) {
  if (key == "friction" || key == "mu")
    return "friction is a law of a [[contact]]: law = { tresca = g } with a bound of the shear, or { coulomb = mu }";
  if (key == "spring" || key == "springs")
    return "a point that a spring holds gives way without limit; springs along a part are a [[contact]] with \"rigid\" "
           "and law = { winkler = k, tension = true }";
  if (key == "point" || key == "points" || key == "node" || key == "nodes")
    return "a force or a support at a point has no finite energy; give it to a short boundary part";
  return nullptr;
}

}  // namespace

std::string where(const toml::source_region& source) {
  const std::string path = source.path ? *source.path : "";
  if (path.starts_with("--set ")) return path;
  return fmt::format("{}:{}:{}", path, source.begin.line, source.begin.column);
}

void refuse(const toml::node& node, const std::string& message) { fail(Status::input, where(node), message); }

void check_keys(const toml::table& table, const std::string& name, const std::vector<std::string>& known) {
  for (const auto& [key, node] : table) {
    const std::string found{key.str()};
    if (std::find(known.begin(), known.end(), found) != known.end()) continue;
    if (const char* way_out = way_out_of(found); way_out != nullptr)
      fail(Status::input, where(key.source()), fmt::format("unknown key '{}': {}", found, way_out));
    fail(Status::input, where(key.source()),
         fmt::format("unknown key '{}'{}: {}", found, name.empty() ? "" : " in " + name, suggestion(found, known)));
  }
}

const toml::node& required(const toml::table& table, const std::string& name, const std::string& key) {
  const toml::node* node = table.get(key);
  if (node == nullptr) refuse(table, fmt::format("'{}' is missing{}", key, name.empty() ? "" : " in " + name));
  return *node;
}

const toml::node& deepest(const toml::table& root, const std::vector<std::string>& key) {
  const toml::node* node = &root;
  for (const std::string& step : key) {
    const toml::node* next = nullptr;
    if (const toml::table* inner = node->as_table()) next = inner->get(step);
    if (const toml::array* entries = node->as_array()) next = entries->get(std::stoul(step));
    if (next == nullptr) break;
    node = next;
  }
  return *node;
}

double number(const toml::node& node, const std::string& name) {
  if (!node.is_number()) refuse(node, fmt::format("{} must be a number, not {}", name, type_of(node)));
  const double value = *node.value<double>();
  check_size(value, where(node), name);
  return value;
}

int integer(const toml::node& node, const std::string& name) {
  const auto value = node.value_exact<std::int64_t>();
  if (!value) {
    refuse(node,
           fmt::format("{} must be an integer, not {}", name, node.is_floating_point() ? "a fraction" : type_of(node)));
  }
  constexpr int largest = std::numeric_limits<int>::max();
  if (*value < -largest || *value > largest)
    refuse(node, fmt::format("{} must be an integer of at most {} in size, is {}", name, largest, *value));
  return static_cast<int>(*value);
}

bool truth(const toml::node& node, const std::string& name) {
  const auto value = node.value_exact<bool>();
  if (!value) refuse(node, fmt::format("{} must be true or false, not {}", name, type_of(node)));
  return *value;
}

std::string text(const toml::node& node, const std::string& name) {
  const auto value = node.value_exact<std::string>();
  if (!value) refuse(node, fmt::format("{} must be a string, not {}", name, type_of(node)));
  return *value;
}

std::string label(const toml::node& node, const std::string& name) {
  const std::string value = text(node, name);
  if (value.empty()) refuse(node, fmt::format("{} must not be empty", name));
  return value;
}

template <class Option> Option choice(const toml::node& node, const std::string& name) {
  const std::string value = text(node, name);
  const std::vector<std::string> known(option_names<Option>.begin(), option_names<Option>.end());
  const auto found = std::find(known.begin(), known.end(), value);
  if (found == known.end()) refuse(node, fmt::format("unknown {} \"{}\": {}", name, value, suggestion(value, known)));
  return static_cast<Option>(found - known.begin());
}

template Plane choice<Plane>(const toml::node&, const std::string&);
template Strategy choice<Strategy>(const toml::node&, const std::string&);
template Dual choice<Dual>(const toml::node&, const std::string&);
template Law choice<Law>(const toml::node&, const std::string&);
template StressComponent choice<StressComponent>(const toml::node&, const std::string&);
template ForceComponent choice<ForceComponent>(const toml::node&, const std::string&);

const toml::table& table(const toml::node& node, const std::string& name) {
  const toml::table* value = node.as_table();
  if (value == nullptr) refuse(node, fmt::format("{} must be a table, not {}", name, type_of(node)));
  return *value;
}

const toml::array& list(const toml::node& node, const std::string& name, std::size_t size) {
  const toml::array* value = node.as_array();
  if (value == nullptr || value->size() != size) {
    refuse(node, fmt::format("{} must be a list of {}, not {}", name, size,
                             value == nullptr ? type_of(node) : fmt::format("of {}", value->size())));
  }
  return *value;
}

const toml::array& tables(const toml::node& node, const std::string& name) {
  const toml::array* value = node.as_array();
  if (value == nullptr || value->empty() || !value->is_homogeneous(toml::node_type::table)) {
    refuse(node, fmt::format("{0} must be a list of tables, written [[{0}]] once for each", name));
  }
  return *value;
}

template <int dim> Function<dim> function(const toml::node& node, const std::string& name) {
  if (node.is_string()) return parse_expression<dim>(text(node, name), where(node));
  if (!node.is_number()) {
    refuse(node, fmt::format("{} must be a number or an expression in {}, not {}", name,
                             dim == 2 ? "x and y" : "x, y and z", type_of(node)));
  }
  return number(node, name);
}
template Function<2> function<2>(const toml::node&, const std::string&);
template Function<3> function<3>(const toml::node&, const std::string&);

template <int dim> Vector<dim> vector(const toml::node& node, const std::string& name) {
  const toml::array& entries = list(node, name, dim);
  Vector<dim> result;
  for (std::size_t c = 0; c < dim; ++c) result[static_cast<Eigen::Index>(c)] = number(entries[c], name);
  return result;
}
template Vector<2> vector<2>(const toml::node&, const std::string&);
template Vector<3> vector<3>(const toml::node&, const std::string&);

}  // namespace bracket::scene
