// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "scene/mesh/gmsh_file.h"
#include "scene/mesh/readers.h"
#include "scene/text.h"

namespace bracket::scene {

namespace {

using Tag = GmshFile::Tag;

/// Places of nodes by tag.
class NodeIndex {
 public:
  NodeIndex(const std::vector<RawMesh::Node>& nodes, std::string where) : where_(std::move(where)) {
    entries_.reserve(nodes.size());
    for (const auto& node : nodes) entries_.emplace_back(node.tag, static_cast<int>(entries_.size()));
    if (!std::is_sorted(entries_.begin(), entries_.end())) std::sort(entries_.begin(), entries_.end());
    const auto twice = std::adjacent_find(entries_.begin(), entries_.end(),
                                          [](const auto& a, const auto& b) { return a.first == b.first; });
    if (twice != entries_.end()) fail(Status::mesh, where_, fmt::format("the node {} is there twice", twice->first));
  }

  int operator()(Tag tag, const char* kind, Tag element) const {
    const auto found = std::lower_bound(guess(tag), entries_.end(), std::pair(tag, 0));
    if (found != entries_.end() && found->first == tag) return found->second;
    fail(Status::mesh, where_, fmt::format("{} {} has the node {}, which is not there", kind, element, tag));
  }

 private:
  using Entries = std::vector<std::pair<Tag, int>>;

  /// Tags mostly follow each other without holes: try that place first, and search all only if it fails.
  Entries::const_iterator guess(Tag tag) const {
    if (entries_.empty() || tag < entries_.front().first) return entries_.begin();
    const auto offset = static_cast<std::uint64_t>(tag) - static_cast<std::uint64_t>(entries_.front().first);
    const bool hit = offset < entries_.size() && entries_[offset].first == tag;
    return hit ? entries_.begin() + static_cast<std::ptrdiff_t>(offset) : entries_.begin();
  }

  Entries entries_;
  std::string where_;
};

/// Version 2.2 writes what is in several groups once for each: of those that have one entity and the same nodes, one is
/// kept, in all the groups.
std::vector<GmshFile::Element> without_copies(const std::vector<GmshFile::Element>& elements,
                                              std::vector<std::set<Tag>>& groups) {
  std::map<Tag, int> groups_of_entity;
  std::set<Tag> in_several;
  for (const GmshFile::Element& element : elements) {
    const auto [known, fresh] = groups_of_entity.emplace(element.entity, element.groups);
    if (!fresh && known->second != element.groups) in_several.insert(element.entity);
  }
  if (in_several.empty()) return elements;
  std::vector<GmshFile::Element> kept;
  std::map<std::vector<Tag>, std::size_t> place;  // by entity and nodes
  std::map<std::set<Tag>, int> number;
  for (const GmshFile::Element& element : elements) {
    std::size_t here = kept.size();
    if (in_several.contains(element.entity)) {
      std::vector<Tag> key(element.nodes.begin(), element.nodes.begin() + element.corners);
      std::ranges::sort(key);
      key.push_back(element.entity);
      here = place.emplace(key, kept.size()).first->second;
    }
    if (here == kept.size() || groups[kept[here].groups] == groups[element.groups]) {
      kept.push_back(element);  // twice in one group is a fault, which is told later on
      continue;
    }
    std::set<Tag> both = groups[kept[here].groups];
    both.insert(groups[element.groups].begin(), groups[element.groups].end());
    const auto [known, fresh] = number.emplace(both, static_cast<int>(groups.size()));
    if (fresh) groups.push_back(both);
    kept[here].groups = known->second;
  }
  return kept;
}

/// The sets of elements by physical groups or, where none of them is in any, by entities. Two groups of one name would
/// be one body or part in the scene file, so they are refused.
std::vector<RawMesh::Set> sets_of(const GmshFile& file, Tag dimension, const std::vector<GmshFile::Element>& elements,
                                  const std::string& where) {
  const bool grouped =
      std::ranges::any_of(elements, [](const GmshFile::Element& element) { return element.groups != 0; });
  std::map<Tag, std::vector<int>> members;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const GmshFile::Element& element = elements[i];
    if (grouped) {
      for (const Tag group : file.groups[element.groups]) members[group].push_back(static_cast<int>(i));
    } else if (element.entity != 0) {
      members[element.entity].push_back(static_cast<int>(i));
    }
  }
  std::vector<RawMesh::Set> sets;
  for (auto& [tag, places] : members) {
    const auto named = file.names.find({dimension, tag});
    std::string name = !grouped                    ? fmt::format("{}_{}",
                                              dimension == 1   ? "curve"
                                                                 : dimension == 2 ? "surface"
                                                                                  : "volume",
                                                                 tag)
                       : named == file.names.end() ? std::to_string(tag)
                                                   : named->second;
    if (std::ranges::find(sets, name, &RawMesh::Set::name) != sets.end())
      fail(Status::mesh, where, fmt::format("two physical groups are named '{}'", name));
    sets.push_back({std::move(name), std::move(places)});
  }
  return sets;
}

std::vector<RawMesh::Element> raw_elements(const std::vector<GmshFile::Element>& elements, const NodeIndex& index) {
  std::vector<RawMesh::Element> result;
  result.reserve(elements.size());
  for (const GmshFile::Element& element : elements) {
    const char* kind = element.corners == 2 ? "the line" : element.corners == 3 ? "the triangle" : "the quadrilateral";
    RawMesh::Element raw{.tag = element.tag};
    for (int k = 0; k < element.corners; ++k) {
      raw.corners[k] = index(element.nodes[k], kind, element.tag);
      if (element.second_order && (element.corners > 2 || k == 0))
        raw.middles[k] = index(element.nodes[element.corners + k], kind, element.tag);
    }
    result.push_back(raw);
  }
  return result;
}

/// Tetrahedra and the triangles on their sides.
void add_solids(RawMesh& raw, GmshFile& file, const NodeIndex& index, const std::string& where) {
  raw.dimension = 3;
  raw.body_word = "physical volume";
  file.solids = without_copies(file.solids, file.groups);
  for (const GmshFile::Element& element : file.solids) {
    RawMesh::Element& solid = raw.cells.emplace_back(RawMesh::Element{.tag = element.tag});
    for (int k = 0; k < 4; ++k) solid.corners[k] = index(element.nodes[k], "the tetrahedron", element.tag);
    constexpr std::array<std::array<int, 2>, 6> middles = {{{0, 1}, {1, 2}, {2, 0}, {0, 3}, {2, 3}, {1, 3}}};
    for (int e = 0; e < 6 && element.second_order; ++e)
      solid.middles[Simplex<3>::edge_between(middles[e][0], middles[e][1])] =
          index(element.nodes[4 + e], "the tetrahedron", element.tag);
  }
  for (const GmshFile::Element& element : file.cells)
    if (element.corners == 4)
      fail(Status::mesh, where,
           fmt::format("the quadrilateral {} is no side of a tetrahedron; of a mesh that is 3D triangles are read",
                       element.tag));
  raw.lines = raw_elements(file.cells, index);
  raw.bodies = sets_of(file, 3, file.solids, where);
  raw.parts = sets_of(file, 2, file.cells, where);
}

}  // namespace

bool is_gmsh_text(std::string_view text) {
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  constexpr std::string_view blanks = " \t\r\n", heading = "$MeshFormat";
  const auto word = [&] {
    text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
    const std::string_view found = text.substr(0, text.find_first_of(blanks));
    text.remove_prefix(found.size());
    return found;
  };
  if (word() != heading) return false;
  const std::string_view version = word();
  return (version == "2.2" || version == "4.1") && word() == "0";
}

RawMesh read_gmsh(const std::filesystem::path& path) {
  const std::string where = path.string();
  GmshFile file = read_gmsh_file(path);
  RawMesh raw;
  raw.body_word = "physical surface";
  raw.nodes = std::move(file.nodes);
  raw.coordinate_rounding = rounding_of(raw.nodes, file.solids.empty() ? 2 : 3);
  file.cells = without_copies(file.cells, file.groups);
  file.lines = without_copies(file.lines, file.groups);
  const NodeIndex index(raw.nodes, where);
  if (!file.solids.empty()) {
    add_solids(raw, file, index, where);
  } else {
    raw.cells = raw_elements(file.cells, index);
    raw.lines = raw_elements(file.lines, index);
    raw.bodies = sets_of(file, 2, file.cells, where);
    raw.parts = sets_of(file, 1, file.lines, where);
  }
  for (const Tag group : file.named_points) {
    const auto named = file.names.find({0, group});
    raw.notes.push_back(fmt::format("the points '{}' are no boundary part and are ignored",
                                    named == file.names.end() ? std::to_string(group) : named->second));
  }
  return raw;
}

}  // namespace bracket::scene
