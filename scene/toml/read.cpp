// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "scene/text.h"
#include "scene/toml/nodes.h"
#include "scene/toml/override.h"

namespace bracket::scene {

namespace {

[[noreturn]] void refuse(const toml::node& node, const std::string& message) {
  fail(Status::input, where(node), message);
}

/// A line of a text, the first being 1, without the blanks around it.
std::string_view line_of(std::string_view text, std::size_t number) {
  for (; number > 1; --number) text.remove_prefix(text.find('\n') + 1);
  text = text.substr(0, text.find('\n'));
  constexpr const char* blanks = " \t\r";
  text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
  return text.substr(0, text.find_last_not_of(blanks) + 1);
}

toml::table parse(const std::filesystem::path& file, const std::vector<std::string>& overrides) {
  toml::table table;
  const std::string text = read_text(file);
  try {
    table = parse_toml(text, file.string());
  } catch (const toml::parse_error& error) {
    const std::string_view description = error.description();
    // toml++ garbles the name of what is written twice: show the line instead.
    fail(Status::input, where(error.source()),
         description.find("cannot redefine") == std::string_view::npos
             ? fmt::format("not valid TOML: {}", description)
             : fmt::format("'{}' defines again what is defined above", line_of(text, error.source().begin.line)));
  }
  if (table.empty()) fail(Status::input, file.string(), "the scene is empty");
  for (const std::string& override : overrides) table = with_override(std::move(table), override);
  return table;
}

// ---- [mesh] ---------------------------------------------------------------------------------------------------------

Block<2> read_block(const toml::table& entry) {
  const std::string name = "mesh.block";
  check_keys(entry, "[[mesh.block]]", {"body", "x", "y", "cells"});
  Block<2> block;
  block.where = where(entry);
  block.body = label(required(entry, "[[mesh.block]]", "body"), name + ".body");
  const std::array<std::string, 2> axes = {"x", "y"};
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const std::string key = name + "." + axes[axis];
    const toml::array& range = list(required(entry, "[[mesh.block]]", axes[axis]), key, 2);
    block.range[axis] = {number(range[0], key), number(range[1], key)};
    if (block.range[axis][0] >= block.range[axis][1]) {
      refuse(range, fmt::format("{} = [{}, {}] is empty; write [from, to] with from < to", key, block.range[axis][0],
                                block.range[axis][1]));
    }
  }
  const toml::array& cells = list(required(entry, "[[mesh.block]]", "cells"), name + ".cells", 2);
  block.cells = {integer(cells[0], name + ".cells", 1), integer(cells[1], name + ".cells", 1)};
  return block;
}

/// A scene that has nothing but its mesh.
Scene<2> read_mesh(const toml::table& entry, const std::filesystem::path& folder) {
  check_keys(entry, "[mesh]", {"file", "block"});
  Scene<2> scene;
  scene.mesh_where = where(entry);
  const toml::node* file = entry.get("file");
  const toml::node* blocks = entry.get("block");
  if ((file == nullptr) == (blocks == nullptr)) {
    refuse(file == nullptr ? entry : *file, "[mesh] must have either a file or blocks ([[mesh.block]])");
  }
  if (file != nullptr) {
    scene.mesh_file = folder / label(*file, "mesh.file");
    scene.mesh_where = where(*file);
    return scene;
  }
  for (const toml::node& block : tables(*blocks, "mesh.block")) scene.blocks.push_back(read_block(*block.as_table()));
  return scene;
}

// ---- [bodies] -------------------------------------------------------------------------------------------------------

Body<2> read_isotropic(const toml::table& entry, const std::string& name, bool plane_stress) {
  const toml::node& young_node = required(entry, "[" + name + "]", "E");
  const toml::node& poisson_node = required(entry, "[" + name + "]", "nu");
  const double young = number(young_node, name + ".E");
  const double poisson = number(poisson_node, name + ".nu");
  if (young <= 0) refuse(young_node, fmt::format("{}.E must be > 0, is {}", name, young));
  if (poisson <= -1 || poisson > 0.5 || (poisson == 0.5 && !plane_stress)) {
    refuse(poisson_node, fmt::format("{}.nu must lie in (-1, 0.5{} in plane {}, is {}", name, plane_stress ? "]" : ")",
                                     plane_stress ? "stress" : "strain", poisson));
  }
  return isotropic<2>(young, poisson, plane_stress);
}

Body<2> read_anisotropic(const toml::node& node, const std::string& name) {
  const toml::array& rows = list(node, name, 3);
  Elasticity<2> stiffness;
  for (std::size_t i = 0; i < 3; ++i) {
    const toml::array& row = list(rows[i], name, 3);
    for (std::size_t j = 0; j < 3; ++j) stiffness(i, j) = number(row[j], name);
  }
  const double rounding = 64 * std::numeric_limits<double>::epsilon();
  if ((stiffness - stiffness.transpose()).cwiseAbs().maxCoeff() > rounding * stiffness.cwiseAbs().maxCoeff()) {
    refuse(node, name + " is not symmetric");
  }
  stiffness = Elasticity<2>(stiffness.selfadjointView<Eigen::Upper>());
  bool definite = (stiffness.diagonal().array() > 0).all();
  if (definite) {
    const Voigt<2> scale = stiffness.diagonal().cwiseSqrt().cwiseInverse();
    const Elasticity<2> unit = scale.asDiagonal() * stiffness * scale.asDiagonal();
    definite = Eigen::SelfAdjointEigenSolver<Elasticity<2>>(unit).eigenvalues()[0] > rounding;
  }
  if (!definite) refuse(node, name + " is not positive definite");
  return anisotropic<2>(stiffness);
}

Body<2> read_body(const toml::table& entry, const std::string& name, bool plane_stress) {
  check_keys(entry, "[" + name + "]", {"E", "nu", "stiffness", "body_force"});
  const toml::node* stiffness = entry.get("stiffness");
  if (stiffness != nullptr && (entry.contains("E") || entry.contains("nu"))) {
    refuse(*stiffness, name + " has both a stiffness and E, nu; write one of them");
  }
  if (stiffness == nullptr && !entry.contains("E") && !entry.contains("nu")) {
    refuse(entry, name + " has no material; write E and nu, or stiffness");
  }
  Body<2> body = stiffness != nullptr ? read_anisotropic(*stiffness, name + ".stiffness")
                                      : read_isotropic(entry, name, plane_stress);
  body.where = where(entry);
  if (const toml::node* force = entry.get("body_force")) {
    const toml::array& components = list(*force, name + ".body_force", 2);
    body.force = {number(components[0], name + ".body_force"), number(components[1], name + ".body_force")};
  }
  return body;
}

// ---- [boundary], [[contact]] ----------------------------------------------------------------------------------------

Condition<2> read_condition(const toml::table& entry, const std::string& part) {
  const std::string name = "boundary.\"" + part + "\"";
  const std::vector<std::string> kinds = {"fixed", "sliding", "traction", "pressure"};  // as in ConditionKind
  check_keys(entry, "[" + name + "]", kinds);
  if (entry.size() != 1) {
    refuse(entry, fmt::format("{} has {}; write one of {}", name, entry.empty() ? "no condition" : "two conditions",
                              fmt::join(kinds, ", ")));
  }
  const auto only = entry.begin();
  const auto& [key, node] = *only;
  Condition<2> condition;
  condition.where = where(node);
  const auto kind = std::find(kinds.begin(), kinds.end(), key.str());
  condition.kind = static_cast<ConditionKind>(kind - kinds.begin());
  if (condition.kind == ConditionKind::fixed || condition.kind == ConditionKind::traction) {
    for (const toml::node& component : list(node, name + "." + *kind, 2)) {
      condition.value.push_back(function(component, name + "." + *kind));
    }
  } else {
    condition.value.push_back(function(node, name + "." + *kind));
  }
  return condition;
}

ContactPair<2> read_contact(const toml::table& entry) {
  check_keys(entry, "[[contact]]", {"first", "second", "gap"});
  ContactPair<2> pair;
  pair.where = where(entry);
  const toml::node& first = required(entry, "[[contact]]", "first");
  pair.first = label(first, "contact.first");
  if (pair.first == "rigid") refuse(first, "contact.first must be a boundary part; a rigid wall is the second side");
  pair.second = label(required(entry, "[[contact]]", "second"), "contact.second");
  const toml::node* gap = entry.get("gap");
  pair.gap = gap != nullptr ? function(*gap, "contact.gap") : [](const Vector<2>&) { return 0.0; };
  return pair;
}

// ---- [refine], [solve] ----------------------------------------------------------------------------------------------

std::string read_choice(const toml::node& node, const std::string& name, const std::vector<std::string>& names) {
  const std::string value = text(node, name);
  if (std::find(names.begin(), names.end(), value) == names.end()) {
    refuse(node, fmt::format("unknown {} \"{}\": {}", name, value, suggestion(value, names)));
  }
  return value;
}

Refine read_refine(const toml::table& entry) {
  check_keys(entry, "[refine]", {"strategy", "target", "bulk", "max_levels", "max_cells", "max_seconds"});
  Refine refine;
  if (const toml::node* node = entry.get("strategy")) {
    refine.strategy = read_choice(*node, "refine.strategy", {"none", "adaptive", "uniform"});
  }
  if (const toml::node* node = entry.get("target")) {
    refine.target = number(*node, "refine.target");
    if (refine.target < 0) refuse(*node, fmt::format("refine.target must not be negative, is {}", refine.target));
  }
  if (const toml::node* node = entry.get("bulk")) {
    refine.bulk = number(*node, "refine.bulk");
    if (refine.bulk <= 0 || refine.bulk > 1) {
      refuse(*node, fmt::format("refine.bulk must lie in (0, 1], is {}", refine.bulk));
    }
  }
  if (const toml::node* node = entry.get("max_levels")) refine.max_levels = integer(*node, "refine.max_levels", 1);
  if (const toml::node* node = entry.get("max_cells")) refine.max_cells = integer(*node, "refine.max_cells", 1);
  if (const toml::node* node = entry.get("max_seconds")) {
    refine.max_seconds = number(*node, "refine.max_seconds");
    if (refine.max_seconds < 1) {
      refuse(*node, fmt::format("refine.max_seconds must be at least 1, is {}", refine.max_seconds));
    }
  }
  return refine;
}

Solve read_solve(const toml::table& entry) {
  check_keys(entry, "[solve]", {"degree", "dual"});
  Solve solve;
  if (const toml::node* node = entry.get("degree")) {
    solve.degree = integer(*node, "solve.degree", 1);
    if (solve.degree > 2) refuse(*node, fmt::format("solve.degree must be 1 or 2, is {}", solve.degree));
  }
  if (const toml::node* node = entry.get("dual")) solve.dual = read_choice(*node, "solve.dual", {"hybrid", "uzawa"});
  return solve;
}

}  // namespace

template <int dim> Scene<dim> read_scene(const std::filesystem::path& file, const std::vector<std::string>& overrides) {
  static_assert(dim == 2);
  const toml::table root = parse(file, overrides);
  check_keys(root, "",
             {"schema", "title", "units", "plane", "mesh", "bodies", "boundary", "contact", "refine", "solve"});
  const toml::node& schema = required(root, "", "schema");
  if (integer(schema, "schema", 1) != 1) refuse(schema, "schema must be 1, the only one that this version knows");

  Scene<dim> scene = read_mesh(table(required(root, "", "mesh"), "mesh"), file.parent_path());
  scene.file = file.string();
  if (const toml::node* node = root.get("title")) scene.title = text(*node, "title");
  if (const toml::node* node = root.get("units")) scene.units = text(*node, "units");
  if (const toml::node* node = root.get("plane")) {
    const std::vector<std::string> planes = {"strain", "stress"};
    scene.plane = text(*node, "plane");
    if (std::find(planes.begin(), planes.end(), scene.plane) == planes.end()) {
      refuse(*node, fmt::format("unknown plane \"{}\": {}", scene.plane, suggestion(scene.plane, planes)));
    }
  }
  std::vector<std::string> known;
  for (const Block<dim>& block : scene.blocks) known.push_back(block.body);
  for (const auto& [key, node] : table(required(root, "", "bodies"), "bodies")) {
    const std::string name{key.str()};
    if (!known.empty() && std::find(known.begin(), known.end(), name) == known.end()) {
      refuse(node, fmt::format("no block makes the body '{}': {}", name, suggestion(name, known)));
    }
    scene.bodies.emplace(name, read_body(table(node, "bodies." + name), "bodies." + name, scene.plane == "stress"));
  }
  if (const toml::node* boundary = root.get("boundary")) {
    for (const auto& [key, node] : table(*boundary, "boundary")) {
      const std::string part{key.str()};
      scene.boundary.emplace(part, read_condition(table(node, "boundary.\"" + part + "\""), part));
    }
  }
  if (const toml::node* contact = root.get("contact")) {
    for (const toml::node& pair : tables(*contact, "contact")) scene.contact.push_back(read_contact(*pair.as_table()));
  }
  if (const toml::node* node = root.get("refine")) scene.refine = read_refine(table(*node, "refine"));
  if (const toml::node* node = root.get("solve")) scene.solve = read_solve(table(*node, "solve"));
  return scene;
}

template Scene<2> read_scene<2>(const std::filesystem::path&, const std::vector<std::string>&);

}  // namespace bracket::scene
