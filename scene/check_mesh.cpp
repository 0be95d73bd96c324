// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "scene/fault.h"
#include "scene/range.h"
#include "scene/text.h"

namespace bracket::scene {

namespace {

using Key = std::vector<std::string>;

Key under(Key key, const std::string& last) {
  key.push_back(last);
  return key;
}

template <int dim> std::optional<Fault> block_fault(const Block<dim>& block, const Key& key) {
  static constexpr std::array<const char*, 3> axes = {"x", "y", "z"};
  const std::string& where = block.where;
  const std::string which = where.empty() ? fmt::format("the block of '{}': ", block.body) : "";
  if (block.body.empty()) return Fault{under(key, "body"), "mesh.block.body must not be empty", block.where};
  for (std::size_t axis = 0; axis < dim; ++axis) {
    const std::string name = axes[axis];
    const auto& [from, to] = block.range[axis];
    for (const double end : {from, to})
      if (const std::string message = size_message(end, which + "mesh.block." + name); !message.empty())
        return Fault{under(key, name), message, where};
    if (from >= to) {
      return Fault{
          under(key, name),
          fmt::format("{}mesh.block.{} = [{}, {}] is empty; write [from, to] with from < to", which, name, from, to),
          where};
    }
    if (block.cells[axis] < 1) {
      return Fault{under(key, "cells"),
                   fmt::format("{}mesh.block.cells must be at least 1, is {}", which, block.cells[axis]), where};
    }
  }
  return {};
}

/// Whether two blocks have no point in common, a corner, or a whole side that both cut alike (in space an edge, too).
template <int dim> bool fit_together(const Block<dim>& one, const Block<dim>& other) {
  std::vector<int> along;  // the axes along which they do not but touch
  for (int axis = 0; axis < dim; ++axis) {
    const auto& [from, to] = one.range[axis];
    const auto& [other_from, other_to] = other.range[axis];
    if (to < other_from || other_to < from) return true;
    if (to != other_from && other_to != from) along.push_back(axis);
  }
  return along.size() < dim && std::all_of(along.begin(), along.end(), [&](int axis) {
           return one.range[axis] == other.range[axis] && one.cells[axis] == other.cells[axis];
         });
}

}  // namespace

template <int dim> std::optional<Fault> mesh_fault(const Scene<dim>& scene) {
  constexpr double most_cells = 2e7;  // so that all indices, some to a cell, are far from the end of int
  if (!scene.blocks.empty() + !scene.mesh_file.empty() + scene.given.has_value() != 1)
    return Fault{
        {"mesh"}, "the mesh must be either a file or blocks ([[mesh.block]]), or given in code", scene.mesh_where};
  if (const std::string message = size_message(scene.merge, "mesh.merge"); !message.empty())
    return Fault{{"mesh", "merge"}, message, scene.mesh_where};
  if (scene.merge < 0)
    return Fault{
        {"mesh", "merge"}, fmt::format("mesh.merge must not be negative, is {}", scene.merge), scene.mesh_where};
  if (scene.merge > 0 && !scene.blocks.empty())
    return Fault{
        {"mesh", "merge"}, "mesh.merge is for the nodes of a mesh file; blocks have none to merge", scene.mesh_where};
  double cells = 0;
  for (std::size_t i = 0; i < scene.blocks.size(); ++i) {
    const Block<dim>& block = scene.blocks[i];
    const Key key = {"mesh", "block", std::to_string(i)};
    if (std::optional<Fault> fault = block_fault(block, key)) return fault;
    cells += cells_of(block);
    if (cells > most_cells)
      return Fault{key, fmt::format("the blocks have more than {:.0f} cells together", most_cells), block.where};
    for (std::size_t other = 0; other < i; ++other)
      if (block.body == scene.blocks[other].body && !fit_together(block, scene.blocks[other]))
        return Fault{key,
                     fmt::format("two blocks of the body '{0}' touch or overlap, but not along a whole side of both in "
                                 "the same edges; expected that, or bodies of their own and a [[contact]]",
                                 block.body),
                     block.where};
  }
  for (const auto& [name, body] : scene.bodies) {
    std::optional<Fault> fault = unmade_body(scene.blocks, name);
    if (!fault) continue;
    fault->where = body.where;
    return fault;
  }
  return {};
}

template <int dim> std::optional<Fault> unmade_body(const std::vector<Block<dim>>& blocks, const std::string& body) {
  std::vector<std::string> made;
  for (const Block<dim>& block : blocks) made.push_back(block.body);
  if (made.empty() || std::find(made.begin(), made.end(), body) != made.end()) return {};
  return Fault{{"bodies", body}, fmt::format("no block makes the body '{}': {}", body, suggestion(body, made))};
}

template std::optional<Fault> mesh_fault(const Scene<2>&);
template std::optional<Fault> mesh_fault(const Scene<3>&);
template std::optional<Fault> unmade_body(const std::vector<Block<2>>&, const std::string&);
template std::optional<Fault> unmade_body(const std::vector<Block<3>>&, const std::string&);

}  // namespace bracket::scene
