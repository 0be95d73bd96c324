// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// Of the elements lines, triangles and quadrilaterals are kept, in space tetrahedra and triangles.
#include "scene/mesh/abaqus_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <set>

#include "scene/text.h"

namespace bracket::scene {

namespace {

using Tag = AbaqusScope::Tag;
using Line = AbaqusCard::Line;

// ---- nodes and elements ---------------------------------------------------------------------------------------------

void add_nodes(AbaqusModel& model, AbaqusScope& scope, const AbaqusCard& card, const AbaqusPlacement& place) {
  const std::string system = capitals(card.parameter("SYSTEM"));
  if (!system.empty() && system != "R") refuse(card.line, "*NODE in cylindrical or spherical coordinates is not read");
  const std::string set = card.parameter("NSET");
  for (const Line& line : card.data) {
    const std::vector<std::string_view> values = fields(line.text);
    if (values.size() < 2) refuse(line, "a node is a number and its coordinates");
    const Tag tag = label(values[0], line);
    Eigen::Vector3d x = Eigen::Vector3d::Zero();
    for (std::size_t i = 1; i < std::min<std::size_t>(values.size(), 4); ++i) x[i - 1] = coordinate(values[i], line);
    if (!scope.nodes.emplace(tag, model.raw.nodes.size()).second)
      refuse(line, fmt::format("the node {} is there twice", tag));
    model.as_written.push_back({tag, {x[0], x[1], x[2]}});
    x = place(x);
    if (!set.empty()) scope.node_sets[capitals(set)].nodes.push_back(static_cast<int>(model.raw.nodes.size()));
    model.raw.nodes.push_back({tag, {x[0], x[1], x[2]}});
  }
  if (!set.empty()) scope.node_sets[capitals(set)].name = set;
}

struct Type {
  int corners = 0;  // 0: not of those that are read
  bool second_order = false, shell = false, solid = false;

  std::size_t nodes() const {
    if (!second_order) return corners;
    return corners == 2 ? 3 : solid ? 10 : 2 * corners;
  }
};

Type type_of(std::string type, const Line& line) {
  for (const char* solid : {"C3D", "SC6", "SC8"}) {
    if (!type.starts_with(solid)) continue;
    while (type.size() > 4 && type.back() >= 'A' && type.back() <= 'Z') type.pop_back();  // H, I, M, T
    if (type == "C3D4") return {4, false, false, true};
    if (type == "C3D10") return {4, true, false, true};
    refuse(line, fmt::format("{}: of a mesh that is 3D only tetrahedra are read, C3D4 and C3D10", type));
  }
  for (const char* axisymmetric : {"CAX", "SAX", "MAX", "CGAX"})
    if (type.starts_with(axisymmetric))
      refuse(line, fmt::format("{}: only plane elements are read, not axisymmetric ones", type));
  while (type.size() > 2 && type.back() >= 'A' && type.back() <= 'Z') type.pop_back();  // R, I, H, T, M
  static const std::map<std::string, Type> known = [] {
    std::map<std::string, Type> types;
    for (const char* family : {"CPS", "CPE", "CPEG", "M3D", "S"})
      for (const int nodes : {3, 4, 6, 8})
        types[family + std::to_string(nodes)] = {nodes > 4 ? nodes / 2 : nodes, nodes > 4, family[0] == 'S'};
    types["STRI3"] = {3, false, true};
    types["STRI65"] = {3, true, true};
    types["S4R5"] = {4, false, true};
    types["S8R5"] = {4, true, true};
    for (const char* line_type : {"T2D2", "T3D2", "B21", "B31"}) types[line_type] = {2, false, false};
    for (const char* line_type : {"T2D3", "T3D3", "B22", "B32"}) types[line_type] = {2, true, false};
    return types;
  }();
  const auto found = known.find(type);
  return found == known.end() ? Type{} : found->second;
}

int node_of(const AbaqusScope& scope, Tag tag, Tag element, const Line& line) {
  const auto node = scope.nodes.find(tag);
  if (node == scope.nodes.end())
    refuse(line, fmt::format("the element {} has the node {}, which is not there", element, tag));
  return node->second;
}

/// The middle of a line of second order stands second or last: it is the node nearest to the others.
RawMesh::Element curved_line(const RawMesh& raw, RawMesh::Element line, int third) {
  const auto distance = [&](int a, int b) {
    return (Eigen::Vector3d(raw.nodes[a].x.data()) - Eigen::Vector3d(raw.nodes[b].x.data())).norm();
  };
  auto& [a, b, c, d] = line.corners;
  line.middles[0] = third;
  if (distance(a, third) > std::max(distance(a, b), distance(b, third))) std::swap(b, line.middles[0]);
  return line;
}

void add_elements(AbaqusModel& model, AbaqusScope& scope, const AbaqusCard& card) {
  const std::string type_name = capitals(card.parameter("TYPE")), set = card.parameter("ELSET");
  Type type = type_of(type_name, card.line);
  const bool space = model.raw.dimension == 3;
  if (space && !type.solid && type.corners != 3) type.corners = 0;  // beside tetrahedra only triangles are sides
  AbaqusSet unnamed;
  AbaqusSet& named = set.empty() ? unnamed : scope.element_sets[capitals(set)];
  named.name = set;
  named.rank = 1;
  std::vector<Tag> numbers;  // of one element: it may go on in the next line
  for (const Line& line : card.data) {
    for (const std::string_view field : fields(line.text)) numbers.push_back(label(field, line));
    if (numbers.empty()) continue;
    const Tag tag = numbers[0];
    if (type.corners == 0) {
      scope.others[tag] = type_name;
      numbers.clear();
      continue;
    }
    const std::size_t needed = type.nodes();
    if (numbers.size() < needed + 1) {
      if (&line == &card.data.back())
        refuse(line, fmt::format("the element {} has {} nodes; {} has {}", tag, numbers.size() - 1, type_name, needed));
      continue;
    }
    if (numbers.size() > needed + 1)
      refuse(line, fmt::format("the element {} has {} nodes; {} has {}", tag, numbers.size() - 1, type_name, needed));
    if (scope.cells.contains(tag) || scope.lines.contains(tag))
      refuse(line, fmt::format("the element {} is there twice", tag));
    RawMesh::Element element{.tag = tag};
    for (int k = 0; k < type.corners; ++k) element.corners[k] = node_of(scope, numbers[1 + k], tag, line);
    if (type.corners == 2 || (space && !type.solid)) {
      if (type.corners == 2 && type.second_order)
        element = curved_line(model.raw, element, node_of(scope, numbers[3], tag, line));
      scope.lines[tag] = static_cast<int>(model.raw.lines.size());
      named.lines.push_back(scope.lines[tag]);
      model.raw.lines.push_back(element);
    } else {
      constexpr std::array<std::array<int, 2>, 6> edges = {{{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}};
      const int middles = static_cast<int>(needed) - type.corners;
      for (int k = 0; k < middles; ++k)
        element.middles[type.solid ? Simplex<3>::edge_between(edges[k][0], edges[k][1]) : k] =
            node_of(scope, numbers[1 + type.corners + k], tag, line);
      scope.cells[tag] = static_cast<int>(model.raw.cells.size());
      scope.shell[scope.cells[tag]] = type.shell;
      named.cells.push_back(scope.cells[tag]);
      model.raw.cells.push_back(element);
    }
    numbers.clear();
  }
}

}  // namespace

Tag label(std::string_view field, const Line& line) {
  Tag value = 0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  if (error != std::errc() || end != field.data() + field.size() || value < 0)
    refuse(line, fmt::format("'{}' is not a number of a node or element", field.substr(0, 40)));
  return value;
}

AbaqusScope& AbaqusModel::scope(const std::string& instance, const Line& line) {
  std::vector<std::string> known;
  for (AbaqusScope& scope : scopes) {
    if (!scope.name.empty() && capitals(scope.name) == capitals(instance)) return scope;
    if (!scope.name.empty()) known.push_back(scope.name);
  }
  refuse(line, fmt::format("there is no instance '{}': {}", instance, suggestion(instance, known)));
}

void add_geometry(AbaqusModel& model, std::size_t scope, const AbaqusCard& card, const AbaqusPlacement& place) {
  static const std::set<std::string> generators = {"NGEN", "NFILL", "NCOPY", "NMAP", "ELGEN", "ELCOPY", "SYSTEM"};
  if (generators.contains(card.keyword))
    refuse(card.line, fmt::format("*{} is not read; write the nodes and elements that it makes", card.keyword));
  if (card.keyword == "NODE") add_nodes(model, model.scopes[scope], card, place);
  if (card.keyword == "ELEMENT") add_elements(model, model.scopes[scope], card);
}

}  // namespace bracket::scene
