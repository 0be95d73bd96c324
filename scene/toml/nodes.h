// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/scene.h"
#include "scene/toml/toml.h"

/// Typed access to the nodes of a scene file. `name` is how messages call a node, such as "bodies.upper.E". Whatever
/// is not as expected is thrown as Error (input) with the node's place.
namespace bracket::scene {

/// "file:line:column", or the override ("--set key=value") that a node comes from.
std::string where(const toml::source_region& source);
inline std::string where(const toml::node& node) { return where(node.source()); }

/// Throws Error (input) with the node's place.
[[noreturn]] void refuse(const toml::node& node, const std::string& message);

/// Refuses keys of `table` that are not `known`.
void check_keys(const toml::table& table, const std::string& name, const std::vector<std::string>& known);

/// The node at `key`, which must be there.
const toml::node& required(const toml::table& table, const std::string& name, const std::string& key);

/// The node at a key of a nested table, list entries by number, or the last one on the way that there is.
const toml::node& deepest(const toml::table& root, const std::vector<std::string>& key);

double number(const toml::node& node, const std::string& name);  ///< of a size that check_size() allows
int integer(const toml::node& node, const std::string& name);
bool truth(const toml::node& node, const std::string& name);
std::string text(const toml::node& node, const std::string& name);
std::string label(const toml::node& node, const std::string& name);  ///< a text that is not empty
/// A value of the option whose names are `option_names<Option>`.
template <class Option> Option choice(const toml::node& node, const std::string& name);
const toml::table& table(const toml::node& node, const std::string& name);
const toml::array& list(const toml::node& node, const std::string& name, std::size_t size);  ///< of `size` entries
const toml::array& tables(const toml::node& node, const std::string& name);  ///< [[name]], at least one; all tables
/// A number or an expression in x and y, in space in z as well.
template <int dim = 2> Function<dim> function(const toml::node& node, const std::string& name);
/// As many numbers as there are axes.
template <int dim> Vector<dim> vector(const toml::node& node, const std::string& name);

}  // namespace bracket::scene
