// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// The results of CalculiX: fixed columns, described in the manual of cgx ("Result Format").
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "scene/field/frd_solid.h"
#include "scene/field/raw_field.h"
#include "scene/mesh/readers.h"
#include "scene/text.h"

namespace bracket::scene {

namespace {

std::string_view trimmed(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(" \r"), text.size()));
  return text.substr(0, text.find_last_not_of(" \r") + 1);
}

/// The lines of a file one after the other.
class Lines {
 public:
  Lines(std::string text, std::string file) : text_(std::move(text)), file_(std::move(file)) {}

  /// The next line; nothing at the end of the file.
  std::optional<std::string_view> next() {
    if (position_ >= text_.size()) return {};
    const std::size_t start = position_, end = std::min(text_.find('\n', start), text_.size());
    position_ = end + 1;
    ++number_;
    line_ = std::string_view(text_).substr(start, end - start);
    if (line_.ends_with('\r')) line_.remove_suffix(1);
    return line_;
  }
  /// The next line of a block. \throw Error (input) where there is none
  std::string_view of_block() {
    if (!next()) refuse("the file ends in the middle of a block: it is truncated");
    return line_;
  }
  [[noreturn]] void refuse(const std::string& message) const {
    fail(Status::input, fmt::format("{}:{}", file_, number_), message);
  }

  /// What stands in some columns of the line, from 0.
  std::string_view columns(std::size_t from, std::size_t count) const {
    return trimmed(line_.substr(std::min(from, line_.size()), count));
  }
  double number(std::size_t from) const {
    const std::string_view found = columns(from, 12);
    const std::optional<double> value = decimal(found);
    if (!value)
      refuse(found.empty() ? "a number is missing: the file may be truncated"
                           : fmt::format("'{}' is not a number", found));
    return *value;
  }
  RawMesh::Tag tag(std::size_t from, std::size_t count) const {
    const std::string_view found = columns(from, count);
    const std::optional<double> value = decimal(found);
    if (!value || *value < 0 || *value > 2e9 || *value != std::floor(*value))
      refuse(fmt::format("'{}' is not a number of a node or element", found));
    return static_cast<RawMesh::Tag>(*value);
  }
  /// The width of a node's number in the block that this line begins.
  std::size_t width() const {
    const std::string_view heading = trimmed(line_);
    switch (heading.back()) {
      case '0': return 5;
      case '1': return 10;
      default: refuse("the block is binary; have CalculiX write ASCII (*NODE FILE)");
    }
  }

 private:
  std::string text_, file_;
  std::string_view line_;
  std::size_t position_ = 0;
  int number_ = 0;
};

struct Element {
  int type;
  std::vector<RawMesh::Tag> nodes;
};

struct Step {
  std::string time;
  std::map<RawMesh::Tag, std::array<double, 3>> displacement;
};

/// The number of nodes of each of cgx's types of elements, from 1: hexahedra, wedges, tetrahedra, triangles,
/// quadrilaterals, lines.
constexpr std::array n_nodes = {8, 6, 4, 20, 15, 10, 3, 6, 4, 8, 2, 3};

void read_nodes(Lines& in, std::vector<RawMesh::Node>& nodes) {
  const std::size_t width = in.width();
  std::set<RawMesh::Tag> known;
  while (!in.of_block().starts_with(" -3")) {
    const RawMesh::Tag tag = in.tag(3, width);
    if (!known.insert(tag).second) in.refuse(fmt::format("the node {} is there twice", tag));
    nodes.push_back({tag, {in.number(3 + width), in.number(15 + width), in.number(27 + width)}});
  }
}

void read_elements(Lines& in, std::vector<Element>& elements) {
  const std::size_t width = in.width();
  const std::size_t per_line = width == 5 ? 15 : 10;
  while (!in.of_block().starts_with(" -3")) {
    Element element{static_cast<int>(in.tag(3 + width, 5)), {}};
    if (element.type < 1 || element.type > static_cast<int>(n_nodes.size()))
      in.refuse(fmt::format("elements of type {} are not known", element.type));
    const std::size_t n = n_nodes[element.type - 1];
    for (std::size_t i = 0; i < n; ++i) {
      if (i % per_line == 0 && !in.of_block().starts_with(" -2"))
        in.refuse(fmt::format("an element has {} of {} nodes: the file may be truncated", i, n));
      element.nodes.push_back(in.tag(3 + i % per_line * width, width));
    }
    elements.push_back(std::move(element));
  }
}

/// A block of results, of which only displacements are kept.
void read_results(Lines& in, std::vector<Step>& steps) {
  const std::size_t width = in.width();
  const std::string time(in.columns(12, 12));
  in.of_block();
  const bool displacements = in.columns(5, 8) == "DISP";
  if (displacements) steps.push_back({time, {}});
  for (std::string_view line = in.of_block(); !line.starts_with(" -3"); line = in.of_block())
    if (displacements && line.starts_with(" -1"))
      steps.back().displacement[in.tag(3, width)] = {in.number(3 + width), in.number(15 + width),
                                                     in.number(27 + width)};
}

}  // namespace

template <int dim> RawField<dim> read_frd_field(const std::filesystem::path& path) {
  RawField<dim> field{.file = path.string(), .word = "node"};
  Lines in(read_text(path), field.file);
  std::vector<Element> elements;
  std::vector<Step> steps;
  bool ended = false;
  while (const auto line = in.next()) {
    const std::string_view heading = trimmed(*line);
    if (heading.starts_with("2C")) read_nodes(in, field.nodes);
    if (heading.starts_with("3C")) read_elements(in, elements);
    if (heading.starts_with("100C")) read_results(in, steps);
    if (heading == "9999") ended = true;
  }
  if (field.nodes.empty()) fail(Status::input, field.file, "has no nodes; expected results of CalculiX (.frd)");
  if (!ended) in.refuse("the last line, 9999, is missing: the file is truncated");
  if (steps.empty())
    fail(Status::input, field.file, "has no displacements; have CalculiX write them: *NODE FILE with a line U");
  if (steps.size() > 1)
    field.notes.push_back(
        fmt::format("the last of {} displacements is taken, at the time {}", steps.size(), steps.back().time));
  field.coordinate_rounding = field.value_rounding = 5e-6;  // all numbers have six digits

  std::map<RawMesh::Tag, int> place;
  std::vector<double> out_of_plane;
  for (std::size_t i = 0; i < field.nodes.size(); ++i) {
    const RawMesh::Tag tag = field.nodes[i].tag;
    const auto found = steps.back().displacement.find(tag);
    if (found == steps.back().displacement.end())
      fail(Status::input, field.file, fmt::format("the node {} has no displacement", tag));
    place[tag] = static_cast<int>(i);
    field.values.emplace_back(Eigen::Map<const Vector<dim>>(found->second.data()));
    if (dim == 2) out_of_plane.push_back(found->second[2]);
  }
  std::vector<FrdElement> placed;
  for (const Element& element : elements) {
    FrdElement of{element.type, {}};
    for (const RawMesh::Tag tag : element.nodes) {
      if (!place.contains(tag))
        fail(Status::input, field.file, fmt::format("an element has the node {}, which is not there", tag));
      of.nodes.push_back(place.at(tag));
    }
    placed.push_back(std::move(of));
  }
  if constexpr (dim == 2) return plane_field(std::move(field), std::move(out_of_plane), placed);
  if constexpr (dim == 3) return field_of_tetrahedra(std::move(field), placed);
}

template RawField<2> read_frd_field(const std::filesystem::path&);
template RawField<3> read_frd_field(const std::filesystem::path&);

}  // namespace bracket::scene
