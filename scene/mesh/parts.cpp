// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// Planar: a boundary part is made of sides of triangles.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include "scene/mesh/raw_mesh.h"
#include "scene/mesh/topology.h"
#include "scene/text.h"

namespace bracket::scene {

namespace {

/// Where the scene has data for something, and what it is called, for scenes without places.
struct Use {
  std::string where, called;
};
using Uses = std::map<std::string, Use>;

const std::string& place(const Use& use) { return use.where.empty() ? use.called : use.where; }

Uses used_parts(const Scene<2>& scene) {
  Uses uses;
  for (const auto& [part, condition] : scene.boundary)
    uses[part] = {condition.where, fmt::format("boundary.\"{}\"", part)};
  for (const auto& [part, curve] : scene.curves) uses[part] = {curve.where, fmt::format("curves.\"{}\"", part)};
  for (const ContactPair<2>& pair : scene.contact)
    for (const Side* side : {&pair.first, &pair.second})
      for (const std::string& part : side->parts)
        if (part != "rigid") uses[part] = {pair.where, "contact of '" + part + "'"};
  for (const Bond& bond : scene.bonds)
    for (const Side* side : {&bond.first, &bond.second})
      for (const std::string& part : side->parts) uses[part] = {bond.where, "bond of '" + part + "'"};
  return uses;
}

/// Of several names for one thing the one that the scene uses, or the first. \param what describes the thing
template <class What>
int name_of(const std::vector<int>& sets, const std::vector<RawMesh::Set>& all, const Uses& uses, const What& what,
            const std::string& where) {
  int chosen = -1;
  for (const int set : sets) {
    const auto use = uses.find(all[set].name);
    if (use == uses.end()) continue;
    if (chosen != -1) {
      const std::string& other = all[chosen].name;
      fail(Status::mesh, where,
           fmt::format("{} is in both '{}' and '{}', and the scene has data for both ({}; {})", what(), other,
                       all[set].name, place(uses.at(other)), place(use->second)));
    }
    chosen = set;
  }
  return chosen == -1 ? sets.front() : chosen;
}

/// "'a' and 'b' share 3 cells": that the scene, which names neither, may name either.
std::vector<std::string> shared_names(const std::map<std::vector<int>, int>& shared,
                                      const std::vector<RawMesh::Set>& sets, const char* word) {
  std::vector<std::string> notes;
  for (const auto& [numbers, count] : shared) {
    std::vector<std::string> names;
    for (const int set : numbers) names.push_back("'" + sets[set].name + "'");
    notes.push_back(fmt::format("{} share {} {}{}; a scene has data for one of them", fmt::join(names, " and "), count,
                                word, count == 1 ? "" : "s"));
  }
  return notes;
}

/// Refuses names of the scene that the file does not have.
void check_known(const Uses& uses, const std::vector<RawMesh::Set>& sets, const Scene<2>& scene, const char* word) {
  std::vector<std::string> known;
  for (const RawMesh::Set& set : sets) known.push_back(set.name);
  for (const auto& [name, use] : uses) {
    if (std::ranges::find(known, name) != known.end()) continue;
    if (std::ranges::any_of(scene.contact,
                            [&used = name](const ContactPair<2>& pair) { return contains(pair.second, used); }))
      known.push_back("rigid");
    fail(Status::input, use.where,
         fmt::format("{}the mesh has no {} '{}': {}", use.where.empty() ? use.called + ": " : "", word, name,
                     suggestion(name, known)));
  }
}

// ---- boundary parts -------------------------------------------------------------------------------------------------

/// An edge of the mesh that has names.
struct NamedEdge {
  std::vector<int> sets;
  std::vector<std::array<int, 2>> sides;  ///< {cell, local}, the one of the lower body first
};
using NamedEdges = std::map<int, NamedEdge>;

void add_name(NamedEdges& edges, int edge, int set) {
  std::vector<int>& sets = edges[edge].sets;
  if (std::ranges::find(sets, set) == sets.end()) sets.push_back(set);
}

void add_line(NamedEdges& edges, const Mesh<2>& mesh, const RawMesh::Element& line, const std::vector<int>& vertex,
              int set, const std::string& name, const std::string& where) {
  const int a = vertex[line.corners[0]], b = vertex[line.corners[1]];
  if (a < 0 || b < 0)
    fail(Status::mesh, where, fmt::format("the line {} of '{}' has a node that no cell has", line.tag, name));
  const std::array<int, 2> ends = {std::min(a, b), std::max(a, b)};
  const auto edge = std::lower_bound(mesh.edges.begin(), mesh.edges.end(), ends);
  if (edge == mesh.edges.end() || *edge != ends) {
    const auto cell =
        std::ranges::find_if(mesh.cells, [a](const auto& c) { return std::ranges::find(c, a) != c.end(); });
    const std::string mend = coinciding_nodes(mesh, mesh.cell_body[cell - mesh.cells.begin()]);
    fail(Status::mesh, where,
         fmt::format("the line from {} to {} of '{}' is not on the boundary of a body: it is no edge of the mesh{}{}",
                     point(mesh.vertices[a]), point(mesh.vertices[b]), name, mend.empty() ? "" : "; ", mend));
  }
  add_name(edges, static_cast<int>(edge - mesh.edges.begin()), set);
}

/// Edges that part a body from what is outside or from another body.
std::vector<char> parting_edges(const Mesh<2>& mesh) {
  std::vector<int> body(mesh.edges.size(), -1);
  std::vector<char> parting(mesh.edges.size(), 0);
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) {
    for (const int edge : mesh.cell_edges[cell]) {
      parting[edge] = body[edge] != mesh.cell_body[cell];  // of two equal bodies the second takes it back
      body[edge] = mesh.cell_body[cell];
    }
  }
  return parting;
}

NamedEdges named_edges(const Mesh<2>& mesh, const RawMesh& raw, const std::vector<int>& vertex,
                       const std::vector<RawMesh::Set>& sets, const std::string& where) {
  NamedEdges edges;
  for (std::size_t set = 0; set < raw.parts.size(); ++set)
    for (const int line : raw.parts[set].members)
      add_line(edges, mesh, raw.lines[line], vertex, static_cast<int>(set), raw.parts[set].name, where);
  if (sets.size() > raw.parts.size()) {
    const std::vector<char> parting = parting_edges(mesh);
    for (std::size_t set = raw.parts.size(); set < sets.size(); ++set) {
      std::vector<char> in_set(mesh.vertices.size(), 0);
      for (const int node : sets[set].members)
        if (vertex[node] >= 0) in_set[vertex[node]] = 1;
      for (std::size_t edge = 0; edge < mesh.edges.size(); ++edge)
        if (parting[edge] && in_set[mesh.edges[edge][0]] && in_set[mesh.edges[edge][1]])
          add_name(edges, static_cast<int>(edge), static_cast<int>(set));
    }
  }
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) {
    for (int local = 0; local < 3; ++local) {
      const auto edge = edges.find(mesh.cell_edges[cell][local]);
      if (edge != edges.end()) edge->second.sides.push_back({static_cast<int>(cell), local});
    }
  }
  for (auto& [edge, named] : edges)
    std::ranges::stable_sort(named.sides, {}, [&](const auto& side) { return mesh.cell_body[side[0]]; });
  return edges;
}

/// The sets of the pair that both of its sides name `edge` by; −1: there is no such pair.
std::array<int, 2> separating_sets(const NamedEdge& edge, const std::vector<RawMesh::Set>& all, const Scene<2>& scene) {
  const auto set_of = [&](const Side& side) {
    const auto found = std::ranges::find_if(edge.sets, [&](int set) { return contains(side, all[set].name); });
    return found == edge.sets.end() ? -1 : *found;
  };
  for (const ContactPair<2>& pair : scene.contact) {
    const int first = set_of(pair.first), second = set_of(pair.second);
    if (first != -1 && second != -1) return {first, second};
  }
  return {-1, -1};
}

}  // namespace

Mesh<2> with_bodies(Mesh<2> mesh, const RawMesh& raw, const std::vector<int>& origin, const Scene<2>& scene,
                    const std::string& where) {
  if (raw.bodies.empty()) {
    mesh.bodies = {"body"};
    mesh.cell_body.assign(mesh.cells.size(), 0);
    return mesh;
  }
  Uses uses;
  for (const auto& [name, body] : scene.bodies) uses[name] = {body.where, "bodies." + name};
  check_known(uses, raw.bodies, scene, "body");
  std::vector<std::vector<int>> sets(raw.cells.size());
  for (std::size_t set = 0; set < raw.bodies.size(); ++set)
    for (const int cell : raw.bodies[set].members)
      if (sets[cell].empty() || sets[cell].back() != static_cast<int>(set)) sets[cell].push_back(static_cast<int>(set));

  std::vector<int> chosen(raw.cells.size());
  std::vector<int> number(raw.bodies.size(), -1);
  std::map<std::vector<int>, int> shared;
  for (std::size_t cell = 0; cell < raw.cells.size(); ++cell) {
    const auto what = [&] { return fmt::format("the cell {}", raw.cells[cell].tag); };
    if (sets[cell].empty())
      fail(Status::mesh, where, fmt::format("{0} is in no {1}; {1}s name the bodies", what(), raw.body_word));
    if (sets[cell].size() > 1 && uses.empty()) ++shared[sets[cell]];
    chosen[cell] = name_of(sets[cell], raw.bodies, uses, what, where);
    number[chosen[cell]] = 0;
  }
  for (std::size_t set = 0; set < raw.bodies.size(); ++set) {
    if (number[set] == -1) continue;
    number[set] = static_cast<int>(mesh.bodies.size());
    mesh.bodies.push_back(raw.bodies[set].name);
  }
  for (const int cell : origin) mesh.cell_body.push_back(number[chosen[cell]]);
  for (std::string& note : shared_names(shared, raw.bodies, "cell")) mesh.notes.push_back(std::move(note));
  return mesh;
}

PartSides part_sides(const Mesh<2>& mesh, const RawMesh& raw, const std::vector<int>& vertex, const Scene<2>& scene,
                     const std::string& where) {
  std::vector<RawMesh::Set> sets = raw.parts;
  for (const RawMesh::Set& set : raw.node_sets)
    if (std::ranges::find(raw.parts, set.name, &RawMesh::Set::name) == raw.parts.end()) sets.push_back(set);
  const Uses uses = used_parts(scene);
  check_known(uses, sets, scene, "boundary part");

  PartSides result;
  std::vector<PartSide> sides;  // parts by their sets
  std::vector<int> inside(sets.size(), 0), kept(sets.size(), 0);
  std::map<std::vector<int>, int> shared;
  for (const auto& [edge, named] : named_edges(mesh, raw, vertex, sets, where)) {
    const auto add = [&](const std::array<int, 2>& side, int set) {
      sides.push_back({side[0], side[1], set});
      ++kept[set];
    };
    if (named.sides.size() == 1) {
      std::vector<int> by_line = named.sets;  // node sets share the nodes at their ends anyway
      std::erase_if(by_line, [&](int set) { return set >= static_cast<int>(raw.parts.size()); });
      if (by_line.size() > 1 && uses.empty()) ++shared[by_line];
      const auto what = [&, number = edge] {
        const auto& [a, b] = mesh.edges[number];
        return fmt::format("the line from {} to {}", point(mesh.vertices[a]), point(mesh.vertices[b]));
      };
      add(named.sides[0], name_of(named.sets, sets, uses, what, where));
    } else if (const auto [first, second] = separating_sets(named, sets, scene); first != -1) {
      result.cut.push_back(edge);
      add(named.sides[0], first);
      add(named.sides[1], second);
    } else {
      for (const int set : named.sets) ++inside[set];
    }
  }

  std::vector<int> number(sets.size(), -1);
  for (std::size_t set = 0; set < sets.size(); ++set) {
    const std::string& name = sets[set].name;
    if (kept[set] > 0) {
      number[set] = static_cast<int>(result.names.size());
      result.names.push_back(name);
    } else if (const auto use = uses.find(name); use != uses.end()) {
      fail(Status::mesh, where,
           inside[set] > 0
               ? fmt::format("the lines of '{0}' lie inside of a body or between two that share their nodes, and the "
                             "scene has data for it ({1}); to separate bodies along it, write a contact with first = "
                             "\"{0}\" and second = \"{0}\"",
                             name, place(use->second))
               : fmt::format("'{}' has no line on the boundary, and the scene has data for it ({})", name,
                             place(use->second)));
    }
    if (inside[set] > 0 && set < raw.parts.size())
      result.notes.push_back(
          fmt::format("{} line{} of '{}' inside of bodies ignored", inside[set], inside[set] == 1 ? "" : "s", name));
  }
  for (std::string& note : shared_names(shared, sets, "line")) result.notes.push_back(std::move(note));
  for (const PartSide& side : sides) result.sides.push_back({side.cell, side.local, number[side.part]});
  return result;
}

}  // namespace bracket::scene
