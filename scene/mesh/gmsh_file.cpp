// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// Planar: of the elements triangles and lines are kept.
#include "scene/mesh/gmsh_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>

#include "scene/range.h"
#include "scene/text.h"

namespace bracket::scene {

namespace {

using Tag = GmshFile::Tag;

/// Words and numbers of a text, one after the other; knows the line for messages.
class Scanner {
 public:
  Scanner(std::string text, std::string file) : text_(std::move(text)), file_(std::move(file)) {}

  [[noreturn]] void refuse(const std::string& message) const {
    const auto here = text_.begin() + static_cast<std::ptrdiff_t>(position_);
    fail(Status::mesh, fmt::format("{}:{}", file_, 1 + std::count(text_.begin(), here, '\n')), message);
  }

  /// The next word; empty at the end of the file.
  std::string_view word() {
    while (position_ < text_.size() && blank(text_[position_])) ++position_;
    const std::size_t start = position_;
    while (position_ < text_.size() && !blank(text_[position_])) ++position_;
    return std::string_view(text_).substr(start, position_ - start);
  }

  /// What stands between the next pair of quotes.
  std::string quoted() {
    const std::size_t from = text_.find('"', position_);
    const std::size_t to = from == std::string::npos ? from : text_.find('"', from + 1);
    if (to == std::string::npos) refuse("a name in quotes is expected; the file may be truncated");
    position_ = to + 1;
    return text_.substr(from + 1, to - from - 1);
  }

  template <typename Number> Number number() {
    const std::string_view found = word();
    if (found.empty()) refuse("the file ends in the middle of a section: it is truncated");
    if (found[0] == '$') refuse(fmt::format("{} comes before all announced entries: the file is truncated", found));
    Number value = 0;
    const auto [end, error] = std::from_chars(found.data(), found.data() + found.size(), value);
    if (error != std::errc() || end != found.data() + found.size()) {
      refuse(
          fmt::format("'{}' is not {}", found.substr(0, 40), std::is_integral_v<Number> ? "an integer" : "a number"));
    }
    return value;
  }

  Tag integer() {
    const Tag value = number<Tag>();
    if (value > largest || value < -largest) refuse(fmt::format("{} is out of range", value));
    return value;
  }

  /// An announced number of entries.
  Tag count() {
    const Tag value = integer();
    if (value < 0) refuse(fmt::format("{} entries cannot be", value));
    return value;
  }

  /// How many of `announced` entries can still come, each being of two characters at least: what may be reserved.
  std::size_t plausible(Tag announced) const {
    return std::min(static_cast<std::size_t>(announced), (text_.size() - position_) / 2);
  }

  void end_section(const std::string& name) {
    const std::string_view found = word();
    if (found == "$End" + name) return;
    refuse(found.empty() ? fmt::format("$End{} is missing: the file is truncated", name)
                         : fmt::format("$End{} is expected, found '{}'", name, found.substr(0, 40)));
  }

  void skip_section(const std::string& name) {
    position_ = text_.find("$End" + name, position_);
    if (position_ == std::string::npos) {
      position_ = text_.size();
      refuse(fmt::format("$End{} is missing: the file is truncated", name));
    }
    end_section(name);
  }

 private:
  static bool blank(char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; }

  static constexpr Tag largest = Tag{1} << 62;  // its negative and small sums are numbers, too
  std::string text_;
  std::string file_;
  std::size_t position_ = 0;
};

/// \return whether the version is 4.1 (else 2.2)
bool read_format(Scanner& in) {
  const double version = in.number<double>();
  const Tag binary = in.integer();
  if (binary != 0) in.refuse("the file is binary; save it as ASCII (Mesh.Binary = 0)");
  if (version != 2.2 && version != 4.1) {
    in.refuse(
        fmt::format("version {} is not read; save the mesh as version 2.2 or 4.1 (Mesh.MshFileVersion)", version));
  }
  in.integer();  // size of a number, of no use in ASCII
  return version == 4.1;
}

void refuse_type(const Scanner& in, Tag type) {
  static const std::set<Tag> quadrilateral = {3, 10, 16}, solid = {4, 5, 6, 7, 11, 12, 13, 14, 17, 18, 19};
  if (quadrilateral.contains(type)) in.refuse("there are quadrilaterals; only triangles are read");
  if (solid.contains(type)) in.refuse("there are solid elements: the mesh is 3D, only plane triangles are read");
  if (type == 8 || type == 9) in.refuse("the elements are of second order; save the mesh with Mesh.ElementOrder = 1");
  in.refuse(fmt::format("element type {} is not known; only lines and triangles of first order are read", type));
}

/// Reads the nodes of one element into the file.
void read_element(Scanner& in, Tag type, Tag tag, Tag physical, GmshFile& file) {
  if (type == 15) {
    in.integer();
  } else if (type == 1) {
    file.lines.push_back({tag, physical, {in.integer(), in.integer()}});
  } else if (type == 2) {
    file.triangles.push_back({tag, physical, {in.integer(), in.integer(), in.integer()}});
  } else {
    refuse_type(in, type);
  }
}

void read_node(Scanner& in, Tag tag, GmshFile& file) {
  const GmshFile::Node node = {tag, {in.number<double>(), in.number<double>(), in.number<double>()}};
  for (const double x : node.x) {
    if (!std::isfinite(x)) in.refuse(fmt::format("node {} has a coordinate that is not finite", tag));
    if (std::abs(x) > largest_size)
      in.refuse(fmt::format("node {} has the coordinate {:g}; expected at most {:g} in size", tag, x, largest_size));
  }
  file.nodes.push_back(node);
}

void read_names(Scanner& in, GmshFile& file) {
  for (Tag left = in.count(); left > 0; --left) {
    const Tag dimension = in.integer();
    const Tag number = in.integer();
    file.names[{dimension, number}] = in.quoted();
  }
}

// ---- version 2.2 ----------------------------------------------------------------------------------------------------

void read_nodes_2(Scanner& in, GmshFile& file) {
  const Tag count = in.count();
  file.nodes.reserve(in.plausible(count));
  for (Tag i = 0; i < count; ++i) read_node(in, in.integer(), file);
}

void read_elements_2(Scanner& in, GmshFile& file) {
  const Tag count = in.count();
  file.triangles.reserve(in.plausible(count) / 4);
  for (Tag i = 0; i < count; ++i) {
    const Tag tag = in.integer();
    const Tag type = in.integer();
    const Tag tags = in.count();
    const Tag physical = tags > 0 ? std::abs(in.integer()) : 0;
    for (Tag k = 1; k < tags; ++k) in.integer();
    read_element(in, type, tag, physical, file);
  }
}

// ---- version 4.1 ----------------------------------------------------------------------------------------------------

/// The physical group of each entity that has one, by dimension and number.
using Groups = std::map<std::pair<Tag, Tag>, Tag>;

Groups read_entities(Scanner& in) {
  Groups groups;
  std::array<Tag, 4> counts;
  for (Tag& count : counts) count = in.count();
  for (Tag dimension = 0; dimension < 4; ++dimension) {
    for (Tag i = 0; i < counts[dimension]; ++i) {
      const Tag tag = in.integer();
      for (int k = 0; k < (dimension == 0 ? 3 : 6); ++k) in.number<double>();  // point or bounding box
      const Tag physicals = in.count();
      for (Tag k = 0; k < physicals; ++k) {
        const Tag physical = std::abs(in.integer());
        if ((dimension == 1 || dimension == 2) && !groups.try_emplace({dimension, tag}, physical).second) {
          in.refuse(fmt::format("the {} {} is in two physical groups, {} and {}", dimension == 1 ? "curve" : "surface",
                                tag, groups[{dimension, tag}], physical));
        }
      }
      if (dimension == 0) continue;
      for (Tag left = in.count(); left > 0; --left) in.integer();  // what bounds it
    }
  }
  return groups;
}

void read_nodes_4(Scanner& in, GmshFile& file) {
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
      for (Tag k = 0; k < parameters; ++k) in.number<double>();
    }
  }
}

void read_elements_4(Scanner& in, const Groups& groups, GmshFile& file) {
  const Tag blocks = in.count();
  file.triangles.reserve(in.plausible(in.count()) / 4);
  in.integer(), in.integer();  // smallest and largest tag
  for (Tag block = 0; block < blocks; ++block) {
    const Tag dimension = in.integer();
    const auto group = groups.find({dimension, in.integer()});
    const Tag type = in.integer();
    for (Tag left = in.count(); left > 0; --left) {
      read_element(in, type, in.integer(), group == groups.end() ? 0 : group->second, file);
    }
  }
}

}  // namespace

GmshFile read_gmsh_file(const std::filesystem::path& path) {
  Scanner in(read_text(path), path.string());
  GmshFile file;
  Groups groups;
  bool format_known = false, version_4 = false;
  for (std::string_view heading = in.word(); !heading.empty(); heading = in.word()) {
    if (heading[0] != '$') {
      in.refuse(fmt::format("a section is expected, found '{}': not a Gmsh mesh", heading.substr(0, 40)));
    }
    const std::string section(heading.substr(1, 40));
    if (section == "MeshFormat") {
      version_4 = read_format(in);
      format_known = true;
    } else if (section == "PhysicalNames") {
      read_names(in, file);
    } else if (section == "Entities" || section == "Nodes" || section == "Elements") {
      if (!format_known) in.refuse("$MeshFormat must come first");
      if (section == "Entities") {
        groups = read_entities(in);
      } else if (section == "Nodes") {
        version_4 ? read_nodes_4(in, file) : read_nodes_2(in, file);
      } else {
        version_4 ? read_elements_4(in, groups, file) : read_elements_2(in, file);
      }
    } else if (section == "NOD") {
      in.refuse("Gmsh format 1 is not read; save the mesh as version 2.2 or 4.1 ASCII (Mesh.MshFileVersion)");
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
