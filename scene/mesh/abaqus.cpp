// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scene/mesh/abaqus_model.h"
#include "scene/mesh/readers.h"
#include "scene/range.h"
#include "scene/text.h"

namespace bracket::scene {

namespace {

/// A part: its cards, and those of each instance.
struct Instance {
  AbaqusCard card;
  std::vector<const AbaqusCard*> cards;
};

/// The cards of a file by where they belong.
struct Structure {
  std::map<std::string, std::vector<const AbaqusCard*>> parts;  // by names in capitals
  std::vector<Instance> instances;
  std::vector<const AbaqusCard*> model;
};

Structure structure_of(const AbaqusFile& file) {
  Structure structure;
  std::vector<const AbaqusCard*>* open = nullptr;  // a part or an instance
  const AbaqusCard* opened = nullptr;
  for (const AbaqusCard& card : file.cards) {
    const bool part = card.keyword == "PART", instance = card.keyword == "INSTANCE";
    const bool end = card.keyword == "END PART" || card.keyword == "END INSTANCE";
    if ((part || instance) && open != nullptr)
      refuse(card.line, fmt::format("*{} within *{} of line {}", card.keyword, opened->keyword, opened->line.number));
    if ((part || instance) && card.parameter("NAME").empty())
      refuse(card.line, fmt::format("*{} has no NAME", card.keyword));
    if (part) {
      const auto [entry, fresh] = structure.parts.try_emplace(capitals(card.parameter("NAME")));
      if (!fresh) refuse(card.line, fmt::format("there is another part '{}'", card.parameter("NAME")));
      open = &entry->second;
    } else if (instance) {
      open = &structure.instances.emplace_back(Instance{card, {}}).cards;
    } else if (end) {
      open = nullptr;
    } else {
      (open != nullptr ? *open : structure.model).push_back(&card);
    }
    if (part || instance) opened = &card;
  }
  if (open != nullptr) refuse(opened->line, fmt::format("*END {} is missing: the file is truncated", opened->keyword));
  return structure;
}

/// Fills the model: first all nodes and elements, so that sets may come before what they hold.
AbaqusModel model_of(const Structure& structure, int dimension) {
  AbaqusModel model;
  model.raw.dimension = dimension;
  std::vector<std::vector<const AbaqusCard*>> cards = {structure.model};
  std::vector<AbaqusPlacement> places(1);
  for (const Instance& instance : structure.instances) {
    const std::string name = instance.card.parameter("NAME"), of = instance.card.parameter("PART");
    for (const AbaqusScope& scope : model.scopes)
      if (capitals(scope.name) == capitals(name))
        refuse(instance.card.line, fmt::format("there is another instance '{}'", name));
    const auto part = structure.parts.find(capitals(of));
    if (part == structure.parts.end()) {
      std::vector<std::string> known;
      for (const auto& [part_name, part_cards] : structure.parts) known.push_back(part_name);
      refuse(instance.card.line, fmt::format("there is no part '{}': {}", of, suggestion(capitals(of), known)));
    }
    cards.push_back(part->second);
    cards.back().insert(cards.back().end(), instance.cards.begin(), instance.cards.end());
    places.push_back(placement_of(instance.card));
    model.scopes.push_back({.name = name,
                            .nodes = {},
                            .cells = {},
                            .lines = {},
                            .others = {},
                            .shell = {},
                            .node_sets = {},
                            .element_sets = {},
                            .surfaces = {}});
  }
  for (std::size_t scope = 0; scope < cards.size(); ++scope)
    for (const AbaqusCard* card : cards[scope]) add_geometry(model, scope, *card, places[scope]);
  for (std::size_t scope = cards.size(); scope-- > 0;)  // the model's sets are of those of instances
    for (const AbaqusCard* card : cards[scope]) add_set(model, scope, *card);
  return model;
}

/// How a set is called in the scene file: by its name where only one instance has it, else with the instance's.
std::string set_name(const AbaqusModel& model, AbaqusSets AbaqusScope::*kind, const AbaqusScope& scope,
                     const std::string& key) {
  const AbaqusSet& set = (scope.*kind).at(key);
  const auto count =
      std::ranges::count_if(model.scopes, [&](const AbaqusScope& other) { return (other.*kind).contains(key); });
  return scope.name.empty() || count == 1 ? set.name : scope.name + "." + set.name;
}

void add(std::vector<RawMesh::Set>& sets, std::string name, std::vector<int> members) {
  if (members.empty()) return;
  std::ranges::sort(members);
  members.erase(std::unique(members.begin(), members.end()), members.end());
  const auto known = std::ranges::find(sets, name, &RawMesh::Set::name);
  if (known == sets.end())
    sets.push_back({std::move(name), std::move(members)});
  else
    known->members.insert(known->members.end(), members.begin(), members.end());
}

/// Bodies: element sets with sections, those named with their elements, others, and instances; boundary parts:
/// surfaces, sets of lines, node sets.
void add_names(AbaqusModel& model) {
  RawMesh& raw = model.raw;
  for (const int rank : {0, 1, 2}) {
    for (const AbaqusScope& scope : model.scopes)
      for (const auto& [key, set] : scope.element_sets)
        if (set.rank == rank && (rank == 0 || !set.internal))
          add(raw.bodies, set_name(model, &AbaqusScope::element_sets, scope, key), set.cells);
  }
  for (const AbaqusScope& scope : model.scopes) {
    std::vector<int> cells;
    for (const auto& [tag, cell] : scope.cells) cells.push_back(cell);
    if (!scope.name.empty()) add(raw.bodies, scope.name, std::move(cells));
    for (const auto& [key, set] : scope.surfaces) {
      if (set.internal) continue;
      const std::string name = set_name(model, &AbaqusScope::surfaces, scope, key);
      add(raw.parts, name, set.lines);
      add(raw.node_sets, name, set.nodes);
    }
    for (const auto& [key, set] : scope.element_sets)
      if (!set.internal) add(raw.parts, set_name(model, &AbaqusScope::element_sets, scope, key), set.lines);
    for (const auto& [key, set] : scope.node_sets)
      if (!set.internal) add(raw.node_sets, set_name(model, &AbaqusScope::node_sets, scope, key), set.nodes);
  }
  std::vector<char> in_set(raw.cells.size(), 0);
  for (const RawMesh::Set& set : raw.bodies)
    for (const int cell : set.members) in_set[cell] = 1;
  if (raw.bodies.empty() || std::ranges::find(in_set, 0) == in_set.end()) return;
  std::vector<int> rest;
  for (std::size_t cell = 0; cell < in_set.size(); ++cell)
    if (in_set[cell] == 0) rest.push_back(static_cast<int>(cell));
  add(raw.bodies, "body", std::move(rest));
}

}  // namespace

double coordinate(std::string_view field, const AbaqusCard::Line& line) {
  const std::optional<double> value = field.empty() ? 0 : decimal(field);
  if (!value) refuse(line, fmt::format("'{}' is not a number", field.substr(0, 40)));
  if (!(std::abs(*value) <= largest_size))
    refuse(line, fmt::format("{} is no coordinate; expected at most {:g} in size", field, largest_size));
  return *value;
}

AbaqusPlacement placement_of(const AbaqusCard& instance) {
  AbaqusPlacement place;
  if (instance.data.size() > 2) refuse(instance.data[2], "*INSTANCE has two lines at most: a translation, a rotation");
  std::array<double, 7> value = {};
  for (const AbaqusCard::Line& line : instance.data) {
    const std::vector<std::string_view> numbers = fields(line.text);
    const bool translation = &line == &instance.data[0];
    if (numbers.size() > (translation ? 3u : 7u) || (!translation && numbers.size() < 7))
      refuse(line,
             translation ? "a translation has three numbers" : "a rotation has seven numbers: two points, degrees");
    value = {};
    for (std::size_t i = 0; i < numbers.size(); ++i) value[i] = coordinate(numbers[i], line);
    if (translation) {
      place.translation = {value[0], value[1], value[2]};
      continue;
    }
    place.centre = {value[0], value[1], value[2]};
    const Eigen::Vector3d axis = Eigen::Vector3d(value[3], value[4], value[5]) - place.centre;
    if (!(axis.norm() > 0)) refuse(line, "the two points of the rotation's axis coincide");
    const double quarters = std::remainder(value[6], 360.0) / 90, angle = quarters * std::numbers::pi / 2;
    const bool exact = quarters == std::round(quarters);  // quarters of a turn leave coordinates as they are
    const double sine = exact ? std::round(std::sin(angle)) : std::sin(angle);
    const double cosine = exact ? std::round(std::cos(angle)) : std::cos(angle);
    const Eigen::Vector3d n = axis.normalized();
    Eigen::Matrix3d cross;
    cross << 0, -n[2], n[1], n[2], 0, -n[0], -n[1], n[0], 0;
    place.rotation = cosine * Eigen::Matrix3d::Identity() + sine * cross + (1 - cosine) * n * n.transpose();
  }
  return place;
}

RawMesh read_abaqus(const std::filesystem::path& path) {
  const AbaqusFile file = read_abaqus_file(path);
  const bool solid = std::ranges::any_of(file.cards, [](const AbaqusCard& card) {
    return card.keyword == "ELEMENT" && capitals(card.parameter("TYPE")).starts_with("C3D");
  });
  AbaqusModel model = model_of(structure_of(file), solid ? 3 : 2);
  model.raw.body_word = "element set";
  model.raw.coordinate_rounding = rounding_of(model.as_written, model.raw.dimension);
  add_names(model);
  std::map<std::string, int> others;
  for (const AbaqusScope& scope : model.scopes)
    for (const auto& [tag, type] : scope.others) ++others[type];
  for (const auto& [type, count] : others)
    model.raw.notes.push_back(fmt::format("{} element{} of type {} ignored", count, count == 1 ? "" : "s", type));
  return std::move(model.raw);
}

}  // namespace bracket::scene
