// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "scene/fault.h"
#include "scene/text.h"
#include "scene/toml/contact.h"
#include "scene/toml/nodes.h"
#include "scene/toml/override.h"
#include "scene/toml/quantity.h"

namespace bracket::scene {

namespace {

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

template <int dim> Block<dim> read_block(const toml::table& entry) {
  const std::string name = "mesh.block";
  if (dim == 3)
    check_keys(entry, "[[mesh.block]]", {"body", "name", "x", "y", "z", "cells"});
  else if (const toml::node* z = entry.get("z"))
    refuse(*z, "mesh.block.z belongs to three dimensions; write dim = 3 above");
  else
    check_keys(entry, "[[mesh.block]]", {"body", "name", "x", "y", "cells"});
  Block<dim> block;
  block.where = where(entry);
  block.body = text(required(entry, "[[mesh.block]]", "body"), name + ".body");
  if (const toml::node* own = entry.get("name")) block.name = label(*own, name + ".name");
  const std::array<std::string, 3> axes = {"x", "y", "z"};
  for (std::size_t axis = 0; axis < dim; ++axis) {
    const std::string key = name + "." + axes[axis];
    const toml::array& range = list(required(entry, "[[mesh.block]]", axes[axis]), key, 2);
    block.range[axis] = {number(range[0], key), number(range[1], key)};
  }
  const toml::array& cells = list(required(entry, "[[mesh.block]]", "cells"), name + ".cells", dim);
  for (std::size_t axis = 0; axis < dim; ++axis) block.cells[axis] = integer(cells[axis], name + ".cells");
  return block;
}

/// A scene that has nothing but its mesh.
template <int dim> Scene<dim> mesh_scene(const toml::table& entry, const std::filesystem::path& folder) {
  check_keys(entry, "[mesh]", {"file", "merge", "block"});
  Scene<dim> scene;
  scene.mesh_where = where(entry);
  if (const toml::node* merge = entry.get("merge")) scene.merge = number(*merge, "mesh.merge");
  const toml::node* file = entry.get("file");
  const toml::node* blocks = entry.get("block");
  if ((file == nullptr) == (blocks == nullptr)) {
    refuse(file == nullptr ? entry : *file, "the mesh must be either a file or blocks ([[mesh.block]])");
  }
  if (file != nullptr) {
    scene.mesh_file = folder / label(*file, "mesh.file");
    scene.mesh_where = where(*file);
    return scene;
  }
  for (const toml::node& block : tables(*blocks, "mesh.block"))
    scene.blocks.push_back(read_block<dim>(*block.as_table()));
  return scene;
}

// ---- [bodies] -------------------------------------------------------------------------------------------------------

template <int dim> Material<dim> read_isotropic(const toml::table& entry, const std::string& name, Plane plane) {
  const double young = number(required(entry, "[" + name + "]", "E"), name + ".E");
  const double poisson = number(required(entry, "[" + name + "]", "nu"), name + ".nu");
  if (const auto fault = isotropic_fault<dim>(young, poisson, plane))
    refuse(deepest(entry, fault->key), name + "." + fault->message);
  return isotropic<dim>(young, poisson, plane);
}

template <int dim> Material<dim> read_anisotropic(const toml::node& node, const std::string& name) {
  constexpr std::size_t n = n_voigt<dim>;
  const toml::array& rows = list(node, name, n);
  Elasticity<dim> stiffness;
  for (std::size_t i = 0; i < n; ++i) {
    const toml::array& row = list(rows[i], name, n);
    for (std::size_t j = 0; j < n; ++j) stiffness(i, j) = number(row[j], name);
  }
  if (const auto fault = anisotropic_fault<dim>(stiffness)) refuse(node, name + " " + fault->message);
  return anisotropic<dim>(stiffness);
}

template <int dim> Body<dim> read_body(const toml::table& entry, const std::string& name, Plane plane) {
  check_keys(entry, "[" + name + "]", {"E", "nu", "stiffness", "body_force"});
  const toml::node* stiffness = entry.get("stiffness");
  if (stiffness != nullptr && (entry.contains("E") || entry.contains("nu"))) {
    refuse(*stiffness, name + " has both a stiffness and E, nu; write one of them");
  }
  if (stiffness == nullptr && !entry.contains("E") && !entry.contains("nu")) {
    refuse(entry, name + " has no material; write E and nu, or stiffness");
  }
  Body<dim> body = stiffness != nullptr ? read_anisotropic<dim>(*stiffness, name + ".stiffness")
                                        : read_isotropic<dim>(entry, name, plane);
  body.where = where(entry);
  if (const toml::node* force = entry.get("body_force")) body.force = vector<dim>(*force, name + ".body_force");
  return body;
}

// ---- [boundary], [[contact]] ----------------------------------------------------------------------------------------

template <int dim> Condition<dim> read_condition(const toml::table& entry, const std::string& part) {
  const std::string name = "boundary.\"" + part + "\"";
  const auto& known = option_names<ConditionKind>;
  const std::vector<std::string> kinds(known.begin(), known.end());
  check_keys(entry, "[" + name + "]", kinds);
  if (entry.size() != 1) {
    refuse(entry, fmt::format("{} has {}; write one of {}", name, entry.empty() ? "no condition" : "two conditions",
                              fmt::join(kinds, ", ")));
  }
  const auto only = entry.begin();
  const auto& [key, node] = *only;
  Condition<dim> condition;
  condition.where = where(node);
  const auto kind = std::find(kinds.begin(), kinds.end(), key.str());
  condition.kind = static_cast<ConditionKind>(kind - kinds.begin());
  if (condition.kind == ConditionKind::fixed || condition.kind == ConditionKind::traction) {
    for (const toml::node& component : list(node, name + "." + *kind, dim)) {
      condition.value.push_back(function<dim>(component, name + "." + *kind));
    }
  } else {
    condition.value.push_back(function<dim>(node, name + "." + *kind));
  }
  return condition;
}

/// A fault's key as the file has it, where contact pairs and bonds are one list.
std::vector<std::string> in_file(std::vector<std::string> key, const toml::table& root) {
  if (key.size() < 2 || (key[0] != "contact" && key[0] != "bond")) return key;
  int left = std::stoi(key[1]), place = 0;
  for (const toml::node& entry : *root["contact"].as_array()) {
    if (is_bond(*entry.as_table()) == (key[0] == "bond") && left-- == 0) break;
    ++place;
  }
  key[0] = "contact";
  key[1] = std::to_string(place);
  return key;
}

// ---- [refine], [solve] ----------------------------------------------------------------------------------------------

Refine read_refine(const toml::table& entry) {
  check_keys(entry, "[refine]", {"strategy", "target", "bulk", "max_levels", "max_cells", "max_seconds", "goal"});
  Refine refine;
  if (const toml::node* node = entry.get("strategy")) refine.strategy = choice<Strategy>(*node, "refine.strategy");
  if (const toml::node* node = entry.get("target")) refine.target = number(*node, "refine.target");
  if (const toml::node* node = entry.get("bulk")) refine.bulk = number(*node, "refine.bulk");
  if (const toml::node* node = entry.get("max_levels")) refine.max_levels = integer(*node, "refine.max_levels");
  if (const toml::node* node = entry.get("max_cells")) refine.max_cells = integer(*node, "refine.max_cells");
  if (const toml::node* node = entry.get("max_seconds")) refine.max_seconds = number(*node, "refine.max_seconds");
  if (const toml::node* node = entry.get("goal")) refine.goal = label(*node, "refine.goal");
  return refine;
}

/// Whether there is an error or a width to reach, which asks for refinement.
template <int dim> bool has_target(const Scene<dim>& scene) {
  return scene.refine.target > 0 || std::any_of(scene.quantities.begin(), scene.quantities.end(),
                                                [](const auto& one) { return one.target > 0 || one.absolute > 0; });
}

/// \param scene what is read so far: all that "auto" depends on
template <int dim> Solve read_solve(const toml::table& entry, const Scene<dim>& scene) {
  check_keys(entry, "[solve]", {"degree", "dual", "sweeps"});
  Solve solve = default_solve<dim>();
  if (const toml::node* node = entry.get("dual")) solve.dual = choice<Dual>(*node, "solve.dual");
  if (const toml::node* node = entry.get("sweeps")) solve.sweeps = integer(*node, "solve.sweeps");
  const toml::node* degree = entry.get("degree");
  if (!degree) return solve;
  if (!degree->is_string())
    solve.degree = integer(*degree, "solve.degree");
  else if (text(*degree, "solve.degree") != "auto")
    refuse(*degree, fmt::format("solve.degree must be an integer from 1 to {} or \"auto\"", largest_degree));
  else if (dim == 2 && solve.dual == Dual::hybrid && !has_coulomb(scene))  // the others have linear stresses
    solve.degree = degree_for(scene.refine.target, cells_of(scene));
  return solve;
}

}  // namespace

template <int dim> Scene<dim> read_scene(const std::filesystem::path& file, const std::vector<std::string>& overrides) {
  const toml::table root = parse(file, overrides);
  check_keys(root, "",
             {"schema", "dim", "title", "units", "plane", "mesh", "bodies", "boundary", "curves", "contact", "quantity",
              "refine", "solve"});
  if (!root.contains("schema"))
    fail(Status::input, file.string(),
         "'schema' is missing; write schema = 1 above all else: it says which format the file has");
  const toml::node& schema = required(root, "", "schema");
  if (integer(schema, "schema") != 1) refuse(schema, "schema must be 1, the only one that this version knows");

  if (const toml::node* own = root.get("dim"); own != nullptr && integer(*own, "dim") != dim)
    refuse(*own, dim == 2 ? "dim must be 2 here: what is asked is known for plane scenes only"
                          : "dim must be 3 here: what is asked is known in space only");
  if (const toml::node* plane = root.get("plane"); plane != nullptr && dim == 3)
    refuse(*plane, "plane belongs to two dimensions; leave it out");

  Scene<dim> scene = mesh_scene<dim>(table(required(root, "", "mesh"), "mesh"), file.parent_path());
  if (const auto fault = mesh_fault(scene)) refuse(deepest(root, fault->key), fault->message);
  scene.file = file.string();
  if (const toml::node* node = root.get("title")) scene.title = text(*node, "title");
  if (const toml::node* node = root.get("units")) scene.units = text(*node, "units");
  if (const toml::node* node = root.get("plane")) scene.plane = choice<Plane>(*node, "plane");
  for (const auto& [key, node] : table(required(root, "", "bodies"), "bodies")) {
    const std::string name = "bodies." + std::string{key.str()};
    if (const auto fault = unmade_body(scene.blocks, std::string{key.str()})) refuse(node, fault->message);
    scene.bodies.emplace(key.str(), read_body<dim>(table(node, name), name, scene.plane));
  }
  if (const toml::node* boundary = root.get("boundary")) {
    for (const auto& [key, node] : table(*boundary, "boundary")) {
      const std::string part{key.str()};
      scene.boundary.emplace(part, read_condition<dim>(table(node, "boundary.\"" + part + "\""), part));
    }
  }
  if (const toml::node* curves = root.get("curves"))
    for (const auto& [key, node] : table(*curves, "curves")) {
      const std::string part{key.str()};
      scene.curves.emplace(part, read_curve(table(node, "curves.\"" + part + "\""), part));
    }
  if (const toml::node* contact = root.get("contact")) {
    for (const toml::node& node : tables(*contact, "contact")) {
      const toml::table& entry = *node.as_table();
      if (is_bond(entry))
        scene.bonds.push_back(read_bond(entry));
      else
        scene.contact.push_back(read_contact<dim>(entry));
    }
  }
  if (const toml::node* quantities = root.get("quantity"))
    for (const toml::node& one : tables(*quantities, "quantity"))
      scene.quantities.push_back(read_quantity<dim>(*one.as_table()));
  if (const toml::node* node = root.get("refine")) scene.refine = read_refine(table(*node, "refine"));
  if (!root["refine"]["strategy"] && has_target(scene)) scene.refine.strategy = Strategy::adaptive;
  if (const toml::node* node = root.get("solve")) scene.solve = read_solve(table(*node, "solve"), scene);
  if (!root["refine"]["bulk"]) scene.refine.bulk = bulk_for(scene.solve.degree);
  if (const auto fault = fault_of(scene)) refuse(deepest(root, in_file(fault->key, root)), fault->message);
  return scene;
}

int dimension_of(const std::filesystem::path& file, const std::vector<std::string>& overrides) {
  const toml::table root = parse(file, overrides);
  if (const toml::node* dim = root.get("dim")) {
    const int value = integer(*dim, "dim");
    if (value != 2 && value != 3) refuse(*dim, fmt::format("dim must be 2 or 3, is {}", value));
    return value;
  }
  const toml::node* mesh = root["mesh"]["file"].node();
  if (mesh == nullptr || !mesh->is_string()) return 2;
  try {
    return dimension_of_mesh(file.parent_path() / *mesh->value<std::string>());
  } catch (const Error&) {  // told where the mesh is read
    return 2;
  }
}

template Scene<2> read_scene<2>(const std::filesystem::path&, const std::vector<std::string>&);
template Scene<3> read_scene<3>(const std::filesystem::path&, const std::vector<std::string>&);

}  // namespace bracket::scene
