// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "scene/mesh/abaqus_model.h"
#include "scene/text.h"

namespace bracket::scene {

namespace {

using Tag = AbaqusScope::Tag;
using Line = AbaqusCard::Line;

bool is_number(std::string_view field) {
  return !field.empty() && std::ranges::all_of(field, [](char c) { return c >= '0' && c <= '9'; });
}

/// Where a name or number of a data line is looked for: "Part-1-1.top" names the instance itself.
struct Reference {
  AbaqusScope* scope;
  std::string_view field;
};

Reference resolved(AbaqusModel& model, AbaqusScope& scope, std::string_view field, const Line& line) {
  const std::size_t dot = field.rfind('.');
  if (dot == std::string_view::npos) return {&scope, field};
  return {&model.scope(std::string(field.substr(0, dot)), line), field.substr(dot + 1)};
}

/// The set of a name; that of an instance where the model has none and only one instance has one.
const AbaqusSet& set_of(AbaqusModel& model, AbaqusScope& scope, AbaqusSets AbaqusScope::*kind, std::string_view name,
                        const Line& line, const char* word) {
  const std::string key = capitals(name);
  if (const auto found = (scope.*kind).find(key); found != (scope.*kind).end()) return found->second;
  const AbaqusSet* only = nullptr;
  int count = 0;
  std::vector<std::string> known;
  for (const auto& [other, set] : scope.*kind) known.push_back(set.name);
  for (AbaqusScope& instance : model.scopes) {
    if (&scope != &model.scopes[0] || &instance == &scope) continue;
    for (const auto& [other, set] : instance.*kind) {
      if (other == key) only = &set, ++count;
      known.push_back(set.name);
    }
  }
  if (count == 1) return *only;
  refuse(line, fmt::format("there is no {} set '{}': {}", word, name, suggestion(std::string(name), known)));
}

void append(std::vector<int>& to, const std::vector<int>& from) { to.insert(to.end(), from.begin(), from.end()); }

void sort_out(std::vector<int>& members) {
  std::ranges::sort(members);
  members.erase(std::unique(members.begin(), members.end()), members.end());
}

/// The labels from, to and each `step` between that there are.
void add_range(std::vector<int>& to, const std::map<Tag, int>& known, const std::array<Tag, 3>& range) {
  const auto [from, last, step] = range;
  for (auto label = known.lower_bound(from); label != known.end() && label->first <= last; ++label)
    if ((label->first - from) % step == 0) to.push_back(label->second);
}

std::array<Tag, 3> range_of(const std::vector<std::string_view>& values, const Line& line) {
  if (values.size() < 2 || values.size() > 3) refuse(line, "GENERATE asks for: first, last, step");
  const std::array<Tag, 3> range = {label(values[0], line), label(values[1], line),
                                    values.size() == 3 ? label(values[2], line) : 1};
  if (range[2] == 0) refuse(line, "the step of GENERATE must not be 0");
  return range;
}

void add_node_set(AbaqusModel& model, AbaqusScope& scope, AbaqusScope& of, const AbaqusCard& card, AbaqusSet& set) {
  for (const Line& line : card.data) {
    const std::vector<std::string_view> values = fields(line.text);
    if (card.parameters.contains("GENERATE")) {
      add_range(set.nodes, of.nodes, range_of(values, line));
      continue;
    }
    for (const std::string_view value : values) {
      const auto [where, field] = resolved(model, of, value, line);
      if (!is_number(field)) {
        const AbaqusSet& other = set_of(model, *where, &AbaqusScope::node_sets, field, line, "node");
        if (&other == &set) refuse(line, fmt::format("the set '{}' holds itself", field));
        append(set.nodes, other.nodes);
        continue;
      }
      const auto node = where->nodes.find(label(field, line));
      if (node == where->nodes.end()) refuse(line, fmt::format("there is no node {}", value));
      set.nodes.push_back(node->second);
    }
  }
  if (const std::string elements = card.parameter("ELSET"); !elements.empty()) {
    for (const int cell : set_of(model, scope, &AbaqusScope::element_sets, elements, card.line, "element").cells)
      for (const int node : model.raw.cells[cell].corners)
        if (node != -1) set.nodes.push_back(node);
  }
}

void add_elements_named(AbaqusModel& model, AbaqusScope& of, std::string_view value, const Line& line, AbaqusSet& set) {
  const auto [where, field] = resolved(model, of, value, line);
  if (!is_number(field)) {
    const AbaqusSet& other = set_of(model, *where, &AbaqusScope::element_sets, field, line, "element");
    if (&other == &set) refuse(line, fmt::format("the set '{}' holds itself", field));
    append(set.cells, other.cells);
    append(set.lines, other.lines);
    return;
  }
  const Tag tag = label(field, line);
  if (const auto cell = where->cells.find(tag); cell != where->cells.end()) {
    set.cells.push_back(cell->second);
  } else if (const auto element = where->lines.find(tag); element != where->lines.end()) {
    set.lines.push_back(element->second);
  } else if (!where->others.contains(tag)) {
    refuse(line, fmt::format("there is no element {}", value));
  }
}

void add_element_set(AbaqusModel& model, AbaqusScope& of, const AbaqusCard& card, AbaqusSet& set) {
  for (const Line& line : card.data) {
    const std::vector<std::string_view> values = fields(line.text);
    if (card.parameters.contains("GENERATE")) {
      const std::array<Tag, 3> range = range_of(values, line);
      add_range(set.cells, of.cells, range);
      add_range(set.lines, of.lines, range);
    } else {
      for (const std::string_view value : values) add_elements_named(model, of, value, line, set);
    }
  }
}

/// The side of a plane element that "S2" or "E2" means; CalculiX counts both faces of a shell first. −1: none.
int side_of(const std::string& name, bool shell, int corners) {
  if (name.size() != 2 || (name[0] != 'S' && name[0] != 'E')) return -1;
  const int side = name[1] - '1' - (shell && name[0] == 'S' ? 2 : 0);
  return side >= 0 && side < corners ? side : -1;
}

void add_sides(AbaqusModel& model, const AbaqusScope& where, const std::vector<int>& cells,
               const std::string& side_name, const Line& line, AbaqusSet& surface) {
  for (const int cell : cells) {
    const RawMesh::Element& of = model.raw.cells[cell];
    const int corners = of.corners[3] == -1 ? 3 : 4;
    if (side_name.empty()) {  // what of the elements is outside
      for (int k = 0; k < corners; ++k) surface.nodes.push_back(of.corners[k]);
      continue;
    }
    if (model.raw.dimension == 3) {
      constexpr std::array<std::array<int, 3>, 4> faces = {{{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}}};
      const int face = side_of(side_name, false, 4);
      if (face == -1 || side_name[0] != 'S')
        refuse(line, fmt::format("the element {} has no side '{}'", of.tag, side_name));
      surface.lines.push_back(static_cast<int>(model.raw.lines.size()));
      const auto& [a, b, c] = faces[face];
      model.raw.lines.push_back({.tag = of.tag, .corners = {of.corners[a], of.corners[b], of.corners[c], -1}});
      continue;
    }
    const auto shell = where.shell.find(cell);
    const int side = side_of(side_name, shell != where.shell.end() && shell->second, corners);
    if (side == -1) refuse(line, fmt::format("the element {} has no side '{}'", of.tag, side_name));
    surface.lines.push_back(static_cast<int>(model.raw.lines.size()));
    model.raw.lines.push_back({.tag = of.tag, .corners = {of.corners[side], of.corners[(side + 1) % corners], -1, -1}});
  }
}

void add_surface(AbaqusModel& model, AbaqusScope& scope, const AbaqusCard& card, AbaqusSet& surface) {
  if (capitals(card.parameter("TYPE")) == "NODE") {
    add_node_set(model, scope, scope, card, surface);
    return;
  }
  for (const Line& line : card.data) {
    const std::vector<std::string_view> values = fields(line.text);
    if (values.empty()) continue;
    AbaqusSet elements;
    add_elements_named(model, scope, values[0], line, elements);
    const AbaqusScope* where = resolved(model, scope, values[0], line).scope;
    for (const AbaqusScope& other : model.scopes)  // the model's sets hold elements of instances
      if (!elements.cells.empty() && other.shell.contains(elements.cells[0])) where = &other;
    add_sides(model, *where, elements.cells, values.size() > 1 ? capitals(values[1]) : "", line, surface);
    append(surface.lines, elements.lines);
  }
}

}  // namespace

void add_set(AbaqusModel& model, std::size_t number, const AbaqusCard& card) {
  AbaqusScope& scope = model.scopes[number];
  const auto fresh = [&](AbaqusSets& sets, const char* name) -> AbaqusSet& {
    const std::string given = card.parameter(name);
    if (given.empty()) refuse(card.line, fmt::format("*{} has no {}", card.keyword, name));
    AbaqusSet& set = sets[capitals(given)];  // what is there already stays
    if (set.name.empty()) set.name = given;
    set.internal = card.parameters.contains("INTERNAL");
    return set;
  };
  const std::string instance = card.parameter("INSTANCE");
  AbaqusScope& of = instance.empty() ? scope : model.scope(instance, card.line);
  static const std::set<std::string> sections = {"SOLID SECTION", "SHELL SECTION", "MEMBRANE SECTION"};
  if (card.keyword == "NSET") {
    AbaqusSet& set = fresh(scope.node_sets, "NSET");
    add_node_set(model, scope, of, card, set);
    sort_out(set.nodes);  // a set of sets of sets may hold one member a thousand times
  } else if (card.keyword == "ELSET") {
    AbaqusSet& set = fresh(scope.element_sets, "ELSET");
    add_element_set(model, of, card, set);
    sort_out(set.cells);
    sort_out(set.lines);
  } else if (card.keyword == "SURFACE") {
    add_surface(model, scope, card, fresh(scope.surfaces, "NAME"));
  } else if (sections.contains(card.keyword)) {
    const std::string name = card.parameter("ELSET");
    set_of(model, scope, &AbaqusScope::element_sets, name, card.line, "element");
    if (const auto own = scope.element_sets.find(capitals(name)); own != scope.element_sets.end()) own->second.rank = 0;
  }
}

}  // namespace bracket::scene
