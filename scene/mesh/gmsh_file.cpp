// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// Of the elements lines, triangles, quadrilaterals and tetrahedra are kept.
#include "scene/mesh/gmsh_file.h"

#include <cmath>

#include "scene/mesh/gmsh_scanner.h"
#include "scene/range.h"

namespace bracket::scene {

namespace {

using Tag = GmshFile::Tag;

/// \return whether the version is 4.1 (else 2.2)
bool read_format(GmshScanner& in) {
  const double version = in.number();
  const Tag binary = in.integer();
  if (binary != 0) in.refuse("the file is binary; save it as ASCII (Mesh.Binary = 0)");
  if (version != 2.2 && version != 4.1) {
    in.refuse(
        fmt::format("version {} is not read; save the mesh as version 2.2 or 4.1 (Mesh.MshFileVersion)", version));
  }
  in.integer();  // size of a number, of no use in ASCII
  return version == 4.1;
}

struct Kind {
  int corners;
  int nodes;
  bool solid = false;
};

/// What is known of Gmsh's element types.
Kind kind_of(const GmshScanner& in, Tag type) {
  switch (type) {
    case 1: return {2, 2};
    case 2: return {3, 3};
    case 3: return {4, 4};
    case 4: return {4, 4, true};
    case 8: return {2, 3};
    case 9: return {3, 6};
    case 10: return {4, 9};
    case 11: return {4, 10, true};
    case 16: return {4, 8};
    default: break;
  }
  static const std::set<Tag> solid = {5, 6, 7, 12, 13, 14, 17, 18, 19};
  if (solid.contains(type))
    in.refuse("there are hexahedra, prisms or pyramids: of a mesh that is 3D only tetrahedra are read");
  in.refuse(
      fmt::format("element type {} is not known; lines, triangles, quadrilaterals and tetrahedra of first or "
                  "second order are read (Mesh.ElementOrder)",
                  type));
}

/// The number of a set of physical groups.
int groups_number(GmshFile& file, std::map<std::set<Tag>, int>& known, const std::set<Tag>& groups) {
  if (groups.empty()) return 0;
  const auto [entry, fresh] = known.emplace(groups, static_cast<int>(file.groups.size()));
  if (fresh) file.groups.push_back(groups);
  return entry->second;
}

/// Reads the nodes of one element into the file.
void read_element(GmshScanner& in, Tag type, Tag tag, Tag entity, int groups, GmshFile& file) {
  if (type == 15) {
    in.integer();
    file.named_points.insert(file.groups[groups].begin(), file.groups[groups].end());
    return;
  }
  const Kind kind = kind_of(in, type);
  GmshFile::Element element{tag, entity, groups, kind.corners, kind.nodes > kind.corners, {}};
  for (int k = 0; k < kind.nodes; ++k) {
    const Tag node = in.integer();
    if (kind.solid || (k < 2 * kind.corners && k < 8)) element.nodes[k] = node;  // not that in the middle of the cell
  }
  (kind.solid ? file.solids : kind.corners == 2 ? file.lines : file.cells).push_back(element);
}

void read_node(GmshScanner& in, Tag tag, GmshFile& file) {
  const double x = in.number(), y = in.number(), z = in.number();
  for (const double coordinate : {x, y, z}) {
    if (!std::isfinite(coordinate)) in.refuse(fmt::format("node {} has a coordinate that is not finite", tag));
    if (std::abs(coordinate) > largest_size)
      in.refuse(
          fmt::format("node {} has the coordinate {:g}; expected at most {:g} in size", tag, coordinate, largest_size));
  }
  file.nodes.push_back({tag, {x, y, z}});
}

void read_names(GmshScanner& in, GmshFile& file) {
  for (Tag left = in.count(); left > 0; --left) {
    const Tag dimension = in.integer();
    const Tag number = in.integer();
    file.names[{dimension, number}] = in.quoted();
  }
}

// ---- version 2.2 ----------------------------------------------------------------------------------------------------

void read_nodes_2(GmshScanner& in, GmshFile& file) {
  const Tag count = in.count();
  file.nodes.reserve(in.plausible(count));
  for (Tag i = 0; i < count; ++i) read_node(in, in.integer(), file);
}

void read_elements_2(GmshScanner& in, GmshFile& file) {
  std::map<std::set<Tag>, int> known;
  const Tag count = in.count();
  file.cells.reserve(in.plausible(count) / 8);
  for (Tag i = 0; i < count; ++i) {
    const Tag tag = in.integer();
    const Tag type = in.integer();
    const Tag tags = in.count();
    const Tag physical = tags > 0 ? std::abs(in.integer()) : 0;
    const Tag entity = tags > 1 ? in.integer() : 0;
    for (Tag k = 2; k < tags; ++k) in.integer();
    const int groups = physical == 0 ? 0 : groups_number(file, known, {physical});
    read_element(in, type, tag, entity, groups, file);
  }
}

// ---- version 4.1 ----------------------------------------------------------------------------------------------------

/// A curve or surface, or a piece of one that a partition made.
struct Entity {
  Tag number = 0;  ///< of the whole
  std::set<Tag> groups;
};
using Entities = std::map<std::pair<Tag, Tag>, Entity>;  // by dimension and number

/// Its coordinates or bounding box, its groups and, of what is no point, what bounds it.
std::set<Tag> read_entity(GmshScanner& in, Tag dimension) {
  for (int k = 0; k < (dimension == 0 ? 3 : 6); ++k) in.number();
  std::set<Tag> groups;
  for (Tag left = in.count(); left > 0; --left) groups.insert(std::abs(in.integer()));
  groups.erase(0);  // no group has this number
  if (dimension == 0) return groups;
  for (Tag left = in.count(); left > 0; --left) in.integer();
  return groups;
}

void read_entities(GmshScanner& in, Entities& entities) {
  std::array<Tag, 4> counts;
  for (Tag& count : counts) count = in.count();
  for (Tag dimension = 0; dimension < 4; ++dimension) {
    for (Tag i = 0; i < counts[dimension]; ++i) {
      const Tag number = in.integer();
      entities[{dimension, number}] = {number, read_entity(in, dimension)};
    }
  }
}

void read_partitioned_entities(GmshScanner& in, Entities& entities) {
  in.count();  // partitions
  for (Tag ghosts = in.count(); ghosts > 0; --ghosts) in.integer(), in.integer();
  std::array<Tag, 4> counts;
  for (Tag& count : counts) count = in.count();
  for (Tag dimension = 0; dimension < 4; ++dimension) {
    for (Tag i = 0; i < counts[dimension]; ++i) {
      const Tag number = in.integer();
      const Tag parent_dimension = in.integer();
      const Tag parent = in.integer();
      for (Tag left = in.count(); left > 0; --left) in.integer();  // partitions
      const std::set<Tag> groups = read_entity(in, dimension);
      // Between partitions of a surface lie curves with the surface's groups: they are none of the curves' own.
      entities[{dimension, number}] = parent_dimension == dimension ? Entity{parent, groups} : Entity{};
    }
  }
}

void read_nodes_4(GmshScanner& in, GmshFile& file) {
  const Tag blocks = in.count();
  file.nodes.reserve(in.plausible(in.count()) / 4);
  in.integer(), in.integer();  // smallest and largest tag
  for (Tag block = 0; block < blocks; ++block) {
    const Tag dimension = in.integer();
    in.integer();  // entity
    const Tag parameters = in.integer() != 0 ? dimension : 0;
    std::vector<Tag> tags(in.plausible(in.count()));
    for (Tag& tag : tags) tag = in.integer();
    for (const Tag tag : tags) {
      read_node(in, tag, file);
      for (Tag k = 0; k < parameters; ++k) in.number();
    }
  }
}

void read_elements_4(GmshScanner& in, const Entities& entities, GmshFile& file) {
  std::map<std::set<Tag>, int> known;
  const Tag blocks = in.count();
  file.cells.reserve(in.plausible(in.count()) / 8);
  in.integer(), in.integer();  // smallest and largest tag
  for (Tag block = 0; block < blocks; ++block) {
    const Tag dimension = in.integer();
    const Tag number = in.integer();
    const auto entity = entities.find({dimension, number});
    const int groups = entity == entities.end() ? 0 : groups_number(file, known, entity->second.groups);
    const Tag whole = entity == entities.end() ? number : entity->second.number;
    const Tag type = in.integer();
    for (Tag left = in.count(); left > 0; --left) read_element(in, type, in.integer(), whole, groups, file);
  }
}

}  // namespace

GmshFile read_gmsh_file(const std::filesystem::path& path) {
  GmshScanner in(read_text(path), path.string());
  GmshFile file;
  Entities entities;
  bool format_known = false, version_4 = false;
  for (std::string_view heading = in.word(); !heading.empty(); heading = in.word()) {
    if (heading[0] != '$') {
      in.refuse(fmt::format("a section is expected, found '{}': not a Gmsh mesh", heading.substr(0, 40)));
    }
    const std::string section(heading.substr(1, 40));
    static const std::set<std::string> formatted = {"Entities", "PartitionedEntities", "Nodes", "Elements"};
    if (formatted.contains(section) && !format_known) in.refuse("$MeshFormat must come first");
    if (section == "MeshFormat") {
      version_4 = read_format(in);
      format_known = true;
    } else if (section == "PhysicalNames") {
      read_names(in, file);
    } else if (section == "Entities") {
      read_entities(in, entities);
    } else if (section == "PartitionedEntities") {
      read_partitioned_entities(in, entities);
    } else if (section == "Nodes") {
      version_4 ? read_nodes_4(in, file) : read_nodes_2(in, file);
    } else if (section == "Elements") {
      version_4 ? read_elements_4(in, entities, file) : read_elements_2(in, file);
    } else {
      in.skip_section(section);
      continue;
    }
    in.end_section(section);
  }
  if (!format_known) in.refuse("there is no $MeshFormat: not a Gmsh mesh, or truncated");
  return file;
}

}  // namespace bracket::scene
