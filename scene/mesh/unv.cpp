// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// Planar: of the elements lines, triangles and quadrilaterals are kept.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <set>

#include "scene/mesh/readers.h"
#include "scene/range.h"
#include "scene/text.h"

namespace bracket::scene {

namespace {

using Tag = RawMesh::Tag;
using Words = std::vector<std::string_view>;

/// Lines of a text, one after the other.
class Lines {
 public:
  Lines(std::string_view text, std::string file) : rest_(text), file_(std::move(file)) {}

  [[noreturn]] void refuse(const std::string& message) const {
    fail(Status::mesh, fmt::format("{}:{}", file_, number_), message);
  }
  bool at_end() const { return rest_.empty(); }

  /// The next line, without blanks around it.
  std::string_view line() {
    if (rest_.empty()) refuse("the file ends in the middle of a data set: it is truncated");
    ++number_;
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    std::string_view found = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    found.remove_prefix(std::min(found.find_first_not_of(blanks), found.size()));
    return found.substr(0, found.find_last_not_of(blanks) + 1);
  }

  /// The words of the next line; none: it is the line −1 that ends a data set.
  Words words() {
    std::string_view text = line();
    Words result;
    if (text == "-1") return result;
    while (!text.empty()) {
      const std::size_t end = std::min(text.find_first_of(blanks), text.size());
      result.push_back(text.substr(0, end));
      text.remove_prefix(end);
      text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
    }
    if (result.empty()) refuse("a line of data is expected, this one is empty");
    return result;
  }

  Tag integer(const Words& from, std::size_t place) const {
    if (place >= from.size()) refuse(fmt::format("at least {} numbers are expected", place + 1));
    Tag value = 0;
    const std::string_view word = from[place];
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size())
      refuse(fmt::format("'{}' is not an integer", word.substr(0, 40)));
    return value;
  }

  double number(const Words& from, std::size_t place) const {
    if (place >= from.size()) refuse(fmt::format("at least {} numbers are expected", place + 1));
    const std::optional<double> value = decimal(from[place]);
    if (!value) refuse(fmt::format("'{}' is not a number", from[place].substr(0, 40)));
    if (!(std::abs(*value) <= largest_size))
      refuse(fmt::format("{} is no coordinate; expected at most {:g} in size", from[place], largest_size));
    return *value;
  }

 private:
  static constexpr std::string_view blanks = " \t\r";
  std::string_view rest_;
  std::string file_;
  int number_ = 0;
};

/// Places of nodes, cells and lines by their numbers.
struct Places {
  std::map<Tag, int> nodes, cells, lines;
  std::set<Tag> others;  ///< elements that are not read
};

void read_nodes(Lines& in, RawMesh& raw, Places& places) {
  for (Words words = in.words(); !words.empty(); words = in.words()) {
    const Tag tag = in.integer(words, 0);
    words = in.words();
    const std::array<double, 3> x = {in.number(words, 0), in.number(words, 1), in.number(words, 2)};
    if (!places.nodes.emplace(tag, raw.nodes.size()).second) in.refuse(fmt::format("the node {} is there twice", tag));
    raw.nodes.push_back({tag, x});
  }
}

/// The corners that elements of a kind have: 2, 3 or 4; 0: they are not read.
int corners_of(const Lines& in, Tag kind) {
  static const std::set<Tag> line = {11, 21, 22, 23, 24}, triangle = {41, 42, 51, 52, 61, 62, 72, 74, 91, 92},
                             quadrilateral = {44, 45, 54, 55, 64, 65, 71, 75, 94, 95};
  if (kind >= 101 && kind <= 118)
    in.refuse(
        "there are solid elements: the mesh is 3D, and universal files are read in the plane only; of bodies in space "
        "write Gmsh's .msh or Abaqus' .inp");
  if (kind >= 81 && kind <= 86) in.refuse("there are axisymmetric elements; only plane ones are read");
  return line.contains(kind) ? 2 : triangle.contains(kind) ? 3 : quadrilateral.contains(kind) ? 4 : 0;
}

void read_elements(Lines& in, RawMesh& raw, Places& places) {
  for (Words words = in.words(); !words.empty(); words = in.words()) {
    const Tag tag = in.integer(words, 0), count = in.integer(words, 5);
    const int corners = corners_of(in, in.integer(words, 1));
    std::vector<Tag> nodes;
    words = in.words();
    if (corners == 2 && words.size() == 3) words = in.words();  // after a beam's orientation
    for (;; words = in.words()) {
      for (std::size_t i = 0; i < words.size(); ++i) nodes.push_back(in.integer(words, i));
      if (static_cast<Tag>(nodes.size()) >= count) break;
      if (words.empty()) in.refuse(fmt::format("the element {} has {} of {} nodes", tag, nodes.size(), count));
    }
    if (corners == 0) {
      places.others.insert(tag);
      continue;
    }
    const int order = corners == 2 ? static_cast<int>(count) - 1 : static_cast<int>(count / corners);
    if (static_cast<Tag>(nodes.size()) != count || order < 1 || order > 2 ||
        count != (corners == 2 ? order + 1 : order * corners))
      in.refuse(fmt::format("the element {} has {} nodes; {} of first or second order are expected", tag, nodes.size(),
                            corners == 2   ? "those of a line"
                            : corners == 3 ? "those of a triangle"
                                           : "those of a quadrilateral"));
    RawMesh::Element element{.tag = tag};
    for (std::size_t i = 0; i < nodes.size(); ++i) {  // corners and middles take turns
      const auto node = places.nodes.find(nodes[i]);
      if (node == places.nodes.end())
        in.refuse(fmt::format("the element {} has the node {}, which is not there", tag, nodes[i]));
      const std::size_t k = order == 2 ? i / 2 : i;
      (order == 2 && i % 2 == 1 ? element.middles[k] : element.corners[k]) = node->second;
    }
    std::vector<RawMesh::Element>& all = corners == 2 ? raw.lines : raw.cells;
    if (places.cells.contains(tag) || places.lines.contains(tag))
      in.refuse(fmt::format("the element {} is there twice", tag));
    (corners == 2 ? places.lines : places.cells).emplace(tag, all.size());
    all.push_back(element);
  }
}

struct Group {
  std::string name;
  std::vector<Tag> nodes, elements;
};

/// A group says how many entries of four numbers follow, the first two of which are what it is and its number.
std::vector<Group> read_groups(Lines& in) {
  std::vector<Group> groups;
  for (Words words = in.words(); !words.empty(); words = in.words()) {
    const Tag count = in.integer(words, 7);
    Group group{std::string(in.line()), {}, {}};
    for (Tag done = 0; done < count;) {
      words = in.words();
      if (words.empty() || words.size() % 4 != 0)
        in.refuse(fmt::format("the group '{}' has {} of {} entries", group.name, done, count));
      for (std::size_t i = 0; i < words.size(); i += 4, ++done) {
        const Tag kind = in.integer(words, i), tag = in.integer(words, i + 1);
        if (kind == 7) group.nodes.push_back(tag);
        if (kind == 8) group.elements.push_back(tag);
      }
    }
    groups.push_back(std::move(group));
  }
  return groups;
}

void add_sets(RawMesh& raw, const Places& places, const std::vector<Group>& groups, const std::string& where) {
  const auto add = [](std::vector<RawMesh::Set>& sets, const std::string& name, std::vector<int> members) {
    if (!members.empty()) sets.push_back({name, std::move(members)});
  };
  std::set<int> rest;
  for (const auto& [tag, cell] : places.cells) rest.insert(cell);
  std::set<std::string> known;
  for (const Group& group : groups) {
    if (!known.insert(group.name).second)
      fail(Status::mesh, where, fmt::format("two groups are named '{}'", group.name));
    std::vector<int> nodes, cells, lines;
    for (const Tag tag : group.nodes) {
      const auto node = places.nodes.find(tag);
      if (node == places.nodes.end())
        fail(Status::mesh, where, fmt::format("the group '{}' has the node {}, which is not there", group.name, tag));
      nodes.push_back(node->second);
    }
    for (const Tag tag : group.elements) {
      if (const auto cell = places.cells.find(tag); cell != places.cells.end()) {
        cells.push_back(cell->second);
        rest.erase(cell->second);
      } else if (const auto line = places.lines.find(tag); line != places.lines.end()) {
        lines.push_back(line->second);
      } else if (!places.others.contains(tag)) {
        fail(Status::mesh, where,
             fmt::format("the group '{}' has the element {}, which is not there", group.name, tag));
      }
    }
    add(raw.bodies, group.name, std::move(cells));
    add(raw.parts, group.name, std::move(lines));
    add(raw.node_sets, group.name, std::move(nodes));
  }
  if (!raw.bodies.empty()) add(raw.bodies, "body", {rest.begin(), rest.end()});
}

}  // namespace

RawMesh read_unv(const std::filesystem::path& path) {
  const std::string text = read_text(path), where = path.string();
  Lines in(text, where);
  RawMesh raw;
  raw.body_word = "group";
  Places places;
  std::vector<Group> groups;
  while (!in.at_end()) {
    std::string_view line = in.line();
    if (line.empty()) continue;
    if (line != "-1") in.refuse(fmt::format("-1 is expected, found '{}': not a universal file", line.substr(0, 40)));
    const std::string_view data_set = in.line();
    if (data_set == "2411" || data_set == "781") {
      read_nodes(in, raw, places);
    } else if (data_set == "2412") {
      read_elements(in, raw, places);
    } else if (data_set == "2467" || data_set == "2477" || data_set == "2452" || data_set == "2435") {
      const std::vector<Group> more = read_groups(in);
      groups.insert(groups.end(), more.begin(), more.end());
    } else {
      while (in.line() != "-1") {
      }
    }
  }
  add_sets(raw, places, groups, where);
  raw.coordinate_rounding = rounding_of(raw.nodes);
  if (!places.others.empty())
    raw.notes.push_back(fmt::format("{} elements that are neither lines, triangles nor quadrilaterals are ignored",
                                    places.others.size()));
  return raw;
}

}  // namespace bracket::scene
