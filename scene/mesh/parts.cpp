// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
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

template <int dim> Uses used_parts(const Scene<dim>& scene) {
  Uses uses;
  for (const auto& [part, condition] : scene.boundary)
    uses[part] = {condition.where, fmt::format("boundary.\"{}\"", part)};
  for (const auto& [part, curve] : scene.curves) uses[part] = {curve.where, fmt::format("curves.\"{}\"", part)};
  for (const ContactPair<dim>& pair : scene.contact)
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
template <int dim>
void check_known(const Uses& uses, const std::vector<RawMesh::Set>& sets, const Scene<dim>& scene, const char* word) {
  std::vector<std::string> known;
  for (const RawMesh::Set& set : sets) known.push_back(set.name);
  for (const auto& [name, use] : uses) {
    if (std::ranges::find(known, name) != known.end()) continue;
    if (std::ranges::any_of(scene.contact,
                            [&used = name](const ContactPair<dim>& pair) { return contains(pair.second, used); }))
      known.push_back("rigid");
    fail(Status::input, use.where,
         fmt::format("{}the mesh has no {} '{}': {}", use.where.empty() ? use.called + ": " : "", word, name,
                     suggestion(name, known)));
  }
}

// ---- boundary parts -------------------------------------------------------------------------------------------------

/// A facet of the mesh that has names.
struct NamedFacet {
  std::vector<int> sets;
  std::vector<std::array<int, 2>> sides;  ///< {cell, local}, the one of the lower body first
};
using NamedFacets = std::map<int, NamedFacet>;

void add_name(NamedFacets& facets, int facet, int set) {
  std::vector<int>& sets = facets[facet].sets;
  if (std::ranges::find(sets, set) == sets.end()) sets.push_back(set);
}

template <std::size_t n> std::array<int, n> sorted_vertices(std::array<int, n> vertices) {
  std::ranges::sort(vertices);
  return vertices;
}

/// The vertices of all facets in rising order, by their numbers, which is their order, too.
template <int dim> std::vector<std::array<int, dim>> facets_by_number(const Mesh<dim>& mesh) {
  std::vector<std::array<int, dim>> facets(n_facets(mesh));
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
    for (int k = 0; k <= dim; ++k)
      facets[cell_facets(mesh, static_cast<int>(cell))[k]] =
          sorted_vertices(facet_vertices(mesh, static_cast<int>(cell), k));
  return facets;
}

/// "line from (0, 0) to (1, 0)", "face with the corners …"
template <int dim> std::string described(const Mesh<dim>& mesh, const std::array<int, dim>& vertices) {
  std::vector<std::string> points;
  for (const int vertex : vertices) points.push_back(point(mesh.vertices[vertex]));
  return dim == 2 ? fmt::format("line from {}", fmt::join(points, " to "))
                  : fmt::format("face with the corners {}", fmt::join(points, ", "));
}

template <int dim>
void add_line(NamedFacets& facets, const Mesh<dim>& mesh, const std::vector<std::array<int, dim>>& all,
              const RawMesh::Element& line, const std::vector<int>& vertex, int set, const std::string& name,
              const std::string& where) {
  std::array<int, dim> given;
  for (int i = 0; i < dim; ++i) given[i] = vertex[line.corners[i]];
  if (std::ranges::min(given) < 0)
    fail(Status::mesh, where,
         fmt::format("the {} {} of '{}' has a node that no cell has", dim == 2 ? "line" : "face", line.tag, name));
  const auto facet = std::ranges::lower_bound(all, sorted_vertices(given));
  if (facet == all.end() || *facet != sorted_vertices(given)) {
    const auto cell =
        std::ranges::find_if(mesh.cells, [a = given[0]](const auto& c) { return std::ranges::find(c, a) != c.end(); });
    const std::string mend = coinciding_nodes(mesh, mesh.cell_body[cell - mesh.cells.begin()]);
    fail(Status::mesh, where,
         fmt::format("the {} of '{}' is not on the boundary of a body: it is no {} of the mesh{}{}",
                     described<dim>(mesh, given), name, dim == 2 ? "edge" : "facet", mend.empty() ? "" : "; ", mend));
  }
  add_name(facets, static_cast<int>(facet - all.begin()), set);
}

/// Facets that part a body from what is outside or from another body.
template <int dim> std::vector<char> parting_facets(const Mesh<dim>& mesh) {
  std::vector<int> body(n_facets(mesh), -1);
  std::vector<char> parting(n_facets(mesh), 0);
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) {
    for (const int facet : cell_facets(mesh, static_cast<int>(cell))) {
      parting[facet] = body[facet] != mesh.cell_body[cell];  // of two equal bodies the second takes it back
      body[facet] = mesh.cell_body[cell];
    }
  }
  return parting;
}

template <int dim>
NamedFacets named_facets(const Mesh<dim>& mesh, const RawMesh& raw, const std::vector<int>& vertex,
                         const std::vector<RawMesh::Set>& sets, const std::string& where) {
  NamedFacets facets;
  const std::vector<std::array<int, dim>> all = facets_by_number(mesh);
  for (std::size_t set = 0; set < raw.parts.size(); ++set)
    for (const int line : raw.parts[set].members)
      add_line<dim>(facets, mesh, all, raw.lines[line], vertex, static_cast<int>(set), raw.parts[set].name, where);
  if (sets.size() > raw.parts.size()) {
    const std::vector<char> parting = parting_facets(mesh);
    for (std::size_t set = raw.parts.size(); set < sets.size(); ++set) {
      std::vector<char> in_set(mesh.vertices.size(), 0);
      for (const int node : sets[set].members)
        if (vertex[node] >= 0) in_set[vertex[node]] = 1;
      for (std::size_t facet = 0; facet < all.size(); ++facet)
        if (parting[facet] && std::ranges::all_of(all[facet], [&](int v) { return in_set[v] != 0; }))
          add_name(facets, static_cast<int>(facet), static_cast<int>(set));
    }
  }
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) {
    for (int local = 0; local <= dim; ++local) {
      const auto facet = facets.find(cell_facets(mesh, static_cast<int>(cell))[local]);
      if (facet != facets.end()) facet->second.sides.push_back({static_cast<int>(cell), local});
    }
  }
  for (auto& [facet, named] : facets)
    std::ranges::stable_sort(named.sides, {}, [&](const auto& side) { return mesh.cell_body[side[0]]; });
  return facets;
}

/// The sets of the pair that both of its sides name a facet by; −1: there is no such pair.
template <int dim>
std::array<int, 2> separating_sets(const NamedFacet& facet, const std::vector<RawMesh::Set>& all,
                                   const Scene<dim>& scene) {
  const auto set_of = [&](const Side& side) {
    const auto found = std::ranges::find_if(facet.sets, [&](int set) { return contains(side, all[set].name); });
    return found == facet.sets.end() ? -1 : *found;
  };
  for (const ContactPair<dim>& pair : scene.contact) {
    const int first = set_of(pair.first), second = set_of(pair.second);
    if (first != -1 && second != -1) return {first, second};
  }
  return {-1, -1};
}

}  // namespace

template <int dim>
Mesh<dim> with_bodies(Mesh<dim> mesh, const RawMesh& raw, const std::vector<int>& origin, const Scene<dim>& scene,
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

template <int dim>
PartSides part_sides(const Mesh<dim>& mesh, const RawMesh& raw, const std::vector<int>& vertex, const Scene<dim>& scene,
                     const std::string& where) {
  const std::string line = dim == 2 ? "line" : "face";
  const auto all = facets_by_number(mesh);
  std::vector<RawMesh::Set> sets = raw.parts;
  for (const RawMesh::Set& set : raw.node_sets)
    if (std::ranges::find(raw.parts, set.name, &RawMesh::Set::name) == raw.parts.end()) sets.push_back(set);
  const Uses uses = used_parts(scene);
  check_known(uses, sets, scene, "boundary part");

  PartSides result;
  std::vector<PartSide> sides;  // parts by their sets
  std::vector<int> inside(sets.size(), 0), kept(sets.size(), 0);
  std::map<std::vector<int>, int> shared;
  for (const auto& [facet, named] : named_facets(mesh, raw, vertex, sets, where)) {
    const auto add = [&](const std::array<int, 2>& side, int set) {
      sides.push_back({side[0], side[1], set});
      ++kept[set];
    };
    if (named.sides.size() == 1) {
      std::vector<int> by_line = named.sets;  // node sets share the nodes at their ends anyway
      std::erase_if(by_line, [&](int set) { return set >= static_cast<int>(raw.parts.size()); });
      if (by_line.size() > 1 && uses.empty()) ++shared[by_line];
      const auto what = [&, number = facet] { return "the " + described<dim>(mesh, all[number]); };
      add(named.sides[0], name_of(named.sets, sets, uses, what, where));
    } else if (const auto [first, second] = separating_sets(named, sets, scene); first != -1) {
      result.cut.push_back(facet);
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
               ? fmt::format("the {2}s of '{0}' lie inside of a body or between two that share their nodes, and the "
                             "scene has data for it ({1}); to separate bodies along it, write a contact with first = "
                             "\"{0}\" and second = \"{0}\"",
                             name, place(use->second), line)
               : fmt::format("'{}' has no {} on the boundary, and the scene has data for it ({})", name, line,
                             place(use->second)));
    }
    if (inside[set] > 0 && set < raw.parts.size())
      result.notes.push_back(fmt::format("{} {}{} of '{}' inside of bodies ignored", inside[set], line,
                                         inside[set] == 1 ? "" : "s", name));
  }
  for (std::string& note : shared_names(shared, sets, line.c_str())) result.notes.push_back(std::move(note));
  for (const PartSide& side : sides) result.sides.push_back({side.cell, side.local, number[side.part]});
  return result;
}

template Mesh<2> with_bodies(Mesh<2>, const RawMesh&, const std::vector<int>&, const Scene<2>&, const std::string&);
template Mesh<3> with_bodies(Mesh<3>, const RawMesh&, const std::vector<int>&, const Scene<3>&, const std::string&);
template PartSides part_sides(const Mesh<2>&, const RawMesh&, const std::vector<int>&, const Scene<2>&,
                              const std::string&);
template PartSides part_sides(const Mesh<3>&, const RawMesh&, const std::vector<int>&, const Scene<3>&,
                              const std::string&);

}  // namespace bracket::scene
