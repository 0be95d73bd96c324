// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// Planar: facets are edges, cut at points.
#include "scene/problem/cutting.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "scene/mesh/angles.h"
#include "scene/mesh/bisection.h"
#include "scene/problem/facing.h"
#include "scene/problem/matching.h"
#include "scene/problem/normals.h"
#include "scene/text.h"

namespace bracket::scene {

namespace {

/// The smallest angles that sliding and cutting may leave, in degrees, where bisection does not leave smaller ones.
struct LeastAngles {
  double usual;
  double of_thirds;  ///< where a facet is cut near a third, which halving never comes near
};

std::vector<int> facets_of(const Mesh<2>& mesh, const std::vector<int>& parts) {
  std::vector<int> facets;
  for (std::size_t f = 0; f < mesh.boundary.size(); ++f)
    if (std::find(parts.begin(), parts.end(), mesh.boundary[f].part) != parts.end())
      facets.push_back(static_cast<int>(f));
  return facets;
}

/// The vertices of the other side that are at the same place as a vertex; two bodies may meet there.
using Partners = std::map<int, std::set<int>>;

/// Which vertices of the two sides are at the same place, and where vertices are still missing.
struct Comparison {
  std::vector<Partners> partner;  ///< of each contact
  std::vector<Landing> missing;
};

/// The pairs where all facets of all contacts coincide two by two; nothing where not.
std::optional<std::vector<FacetPairs>> coinciding(const Mesh<2>& mesh, const std::vector<SideParts>& contacts) {
  std::vector<FacetPairs> all;
  std::set<int> used;
  for (const SideParts& contact : contacts) {
    if (contact.first == contact.second) return {};
    for (const auto* parts : {&contact.first, &contact.second})
      for (const int part : *parts)
        if (!used.insert(part).second) return {};
    auto pairs = match_sides(mesh, facets_of(mesh, contact.first), facets_of(mesh, contact.second));
    if (!pairs) return {};
    all.push_back(std::move(*pairs));
  }
  return all;
}

Comparison compare(const Mesh<2>& mesh, const std::vector<Vector<2>>& normals, const std::vector<SideParts>& contacts,
                   const Arcs& arcs) {
  Comparison result;
  for (const SideParts& contact : contacts) {
    const std::vector<int> first = facets_of(mesh, contact.first), second = facets_of(mesh, contact.second);
    std::vector<Landing> all = landings(mesh, normals, first, second, arcs);
    const std::vector<Landing> back = landings(mesh, normals, second, first, arcs);
    all.insert(all.end(), back.begin(), back.end());
    auto& partner = result.partner.emplace_back();
    for (const Landing& one : all)
      if (one.onto >= 0) {
        partner[one.vertex].insert(one.onto);
        partner[one.onto].insert(one.vertex);
      }
    for (const Landing& one : all)
      if (!partner.contains(one.vertex)) result.missing.push_back(one);
  }
  // In an order that does not depend on which side is called the first.
  std::ranges::stable_sort(result.missing, {}, [](const Landing& one) { return std::pair(one.vertex, one.facet); });
  return result;
}

/// Where the vertex is missing.
Vector<2> place(const Mesh<2>& mesh, const Landing& landing, const Arcs& arcs) {
  const auto& facet = mesh.boundary[landing.facet];
  const auto [a, b] = positions(mesh, facet.vertices);
  const Vector<2> x = a + landing.t * (b - a);
  return facet.part >= 0 && arcs[facet.part] ? onto(*arcs[facet.part], x) : x;
}

/// The vertices that may slide: inside of a straight line or an arc of one part, and opposite to no other vertex yet.
std::vector<char> movable(const Mesh<2>& mesh, const std::vector<Vector<2>>& normals, const Comparison& comparison,
                          const Arcs& arcs) {
  std::vector<std::vector<int>> facets(mesh.vertices.size());
  for (std::size_t f = 0; f < mesh.boundary.size(); ++f)
    for (const int vertex : mesh.boundary[f].vertices) facets[vertex].push_back(static_cast<int>(f));
  std::vector<char> result(mesh.vertices.size(), 0);
  for (std::size_t v = 0; v < facets.size(); ++v) {
    if (facets[v].size() != 2) continue;
    const int one = facets[v][0], other = facets[v][1];
    const int part = mesh.boundary[one].part;
    const bool on_arc = part >= 0 && arcs[part];
    result[v] = mesh.boundary[other].part == part && (on_arc || normals[one] == normals[other]);
  }
  for (const auto& partner : comparison.partner)
    for (const auto& [vertex, others] : partner) result[vertex] = 0;
  return result;
}

std::vector<std::vector<int>> cells_by_vertex(const Mesh<2>& mesh) {
  std::vector<std::vector<int>> cells(mesh.vertices.size());
  for (std::size_t c = 0; c < mesh.cells.size(); ++c)
    for (const int vertex : mesh.cells[c]) cells[vertex].push_back(static_cast<int>(c));
  return cells;
}

double smallest_angle_of(const Mesh<2>& mesh, const std::vector<int>& cells) {
  double smallest = 180;
  for (const int cell : cells) smallest = std::min(smallest, smallest_angle(positions(mesh, mesh.cells[cell])));
  return smallest;
}

/// Slides vertices next to which one is missing, where cells keep their shape. \return how many
int slide(Mesh<2>& mesh, const Comparison& comparison, std::vector<char> can_slide, double least, const Arcs& arcs) {
  const auto cells = cells_by_vertex(mesh);
  int count = 0;
  std::set<int> touched;  // facets with an end that slid
  for (const Landing& landing : comparison.missing) {
    const auto& ends = mesh.boundary[landing.facet].vertices;
    const int nearest = ends[landing.t < 0.5 ? 0 : 1];
    if (!can_slide[nearest] || touched.contains(landing.facet)) continue;
    const Vector<2> before = mesh.vertices[nearest];
    const double allowed = std::min(least, smallest_angle_of(mesh, cells[nearest]));
    mesh.vertices[nearest] = place(mesh, landing, arcs);
    if (smallest_angle_of(mesh, cells[nearest]) < allowed) {
      mesh.vertices[nearest] = before;
      continue;
    }
    ++count;
    can_slide[nearest] = can_slide[landing.vertex] = 0;
    for (std::size_t f = 0; f < mesh.boundary.size(); ++f) {
      const auto& [a, b] = mesh.boundary[f].vertices;
      if (a == nearest || b == nearest) touched.insert(static_cast<int>(f));
    }
  }
  return count;
}

/// The smallest angle of the two cells that bisection makes at a facet, if it is cut at t.
double angle_of_cut(const Mesh<2>& mesh, int facet, double t) {
  const auto& [vertices, cell, local, edge, part] = mesh.boundary[facet];
  const auto [p, q] = positions(mesh, vertices);
  const int cut = mesh.refinement_edge[cell];
  const auto opposite = positions(mesh, facet_vertices(mesh, cell, cut));
  const Vector<2> apex =
      cut == local ? mesh.vertices[mesh.cells[cell][local]] : Vector<2>(0.5 * (opposite[0] + opposite[1]));
  const Vector<2> x = p + t * (q - p);
  return std::min(smallest_angle({apex, p, x}), smallest_angle({apex, x, q}));
}

/// Halves the longest of the facets where vertices are missing, and puts the midpoint where one is missing if the cells
/// keep their shape.
Mesh<2> halve(const Mesh<2>& mesh, const std::vector<Landing>& missing, const LeastAngles& least, const Arcs& arcs) {
  struct Cut {
    double t, angle;
    Vector<2> place;
  };
  double longest = 0;
  for (const Landing& landing : missing) longest = std::max(longest, length(mesh, landing.facet));
  std::map<int, Cut> cuts;  // of each facet the best
  for (const Landing& landing : missing) {
    if (length(mesh, landing.facet) <= 0.5 * longest) continue;
    const Cut cut{landing.t, angle_of_cut(mesh, landing.facet, landing.t), place(mesh, landing, arcs)};
    const auto [known, is_new] = cuts.try_emplace(landing.facet, cut);
    if (!is_new && cut.angle > known->second.angle) known->second = cut;
  }
  std::vector<int> edges;
  for (const auto& [facet, cut] : cuts) edges.push_back(mesh.boundary[facet].edge);
  Bisected bisected = bisect(mesh, conforming(mesh, edges));
  for (const auto& [facet, cut] : cuts)
    if (cut.angle >= std::min(least.usual, angle_of_cut(mesh, facet, 0.5)) ||
        (std::abs(cut.t - 0.5) <= 0.2 && cut.angle >= least.of_thirds))
      bisected.mesh.vertices[bisected.midpoint[mesh.boundary[facet].edge]] = cut.place;
  return with_new_vertices_on_arcs(std::move(bisected.mesh), arcs, mesh.vertices.size());
}

FacetPairs pairs_of(const Mesh<2>& mesh, const SideParts& contact, const Partners& partner, std::vector<char>& taken) {
  std::map<std::array<int, 2>, int> second;
  for (const int facet : facets_of(mesh, contact.second)) second[mesh.boundary[facet].vertices] = facet;
  FacetPairs pairs;
  for (const int facet : facets_of(mesh, contact.first)) {
    const auto& [a, b] = mesh.boundary[facet].vertices;
    const auto from = partner.find(b), to = partner.find(a);
    if (from == partner.end() || to == partner.end()) continue;
    for (const int one : from->second)
      for (const int other : to->second) {
        const auto found = second.find({one, other});
        if (found == second.end() || taken[facet] || taken[found->second]) continue;
        taken[facet] = taken[found->second] = 1;
        pairs.push_back({facet, found->second});
      }
  }
  return pairs;
}

std::string names(const Mesh<2>& mesh, const std::vector<int>& parts) {
  std::string result;
  for (const int part : parts) result += (result.empty() ? "'" : "', '") + mesh.parts[part];
  return result + "'";
}

/// Which facets of a contact are left, if any; "" if none.
std::string free_facets(const Mesh<2>& mesh, const SideParts& contact, const FacetPairs& pairs) {
  const std::size_t first = facets_of(mesh, contact.first).size(), second = facets_of(mesh, contact.second).size();
  const std::size_t in_contact = (contact.first == contact.second ? 2 : 1) * pairs.size();
  if (in_contact == first && in_contact == second) return "";
  return fmt::format("{} of {} edges of {} and {} of {} of {} face each other; the others are free", in_contact, first,
                     names(mesh, contact.first), in_contact, second, names(mesh, contact.second));
}

[[noreturn]] void refuse_apart(const Mesh<2>& mesh, const SideParts& contact) {
  double nearest = std::numeric_limits<double>::infinity();
  Vector<2> at = Vector<2>::Zero();
  for (const int one : facets_of(mesh, contact.first))
    for (const int other : facets_of(mesh, contact.second))
      for (const auto& x : positions(mesh, mesh.boundary[one].vertices))
        for (const auto& y : positions(mesh, mesh.boundary[other].vertices))
          if (one != other && (x - y).norm() < nearest) {
            nearest = (x - y).norm();
            at = x;
          }
  fail(Status::mesh, contact.where,
       fmt::format("no edge of {} faces an edge of {} within 25 degrees: the sides come nearest, {:.3g} apart, at {}; "
                   "expected sides with normals against each other",
                   names(mesh, contact.first), names(mesh, contact.second), nearest, point(at)));
}

/// The pairs and the notes of a mesh on which no vertex is missing.
CutAlike finished(Mesh<2> mesh, const std::vector<SideParts>& contacts, const Comparison& comparison) {
  CutAlike result;
  std::vector<char> taken(mesh.boundary.size(), 0);
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    result.pairs.push_back(pairs_of(mesh, contacts[i], comparison.partner[i], taken));
    if (result.pairs.back().empty()) refuse_apart(mesh, contacts[i]);
  }
  for (std::size_t i = 0; i < contacts.size(); ++i)
    if (std::string note = free_facets(mesh, contacts[i], result.pairs[i]); !note.empty())
      mesh.notes.push_back(std::move(note));
  result.mesh = std::move(mesh);
  return result;
}

/// What cut_alike() returns, where that takes no more cells.
std::optional<CutAlike> with_at_most(std::size_t most_cells, Mesh<2> mesh, const std::vector<SideParts>& contacts,
                                     const Arcs& arcs, const LeastAngles& least) {
  constexpr int most_rounds = 200;
  const std::size_t cells = mesh.cells.size();
  int slid = 0;
  for (int round = 0; round < most_rounds && mesh.cells.size() <= most_cells; ++round) {
    const std::vector<Vector<2>> normals = shared_normals(mesh);
    const Comparison comparison = compare(mesh, normals, contacts, arcs);
    if (comparison.missing.empty()) {
      if (slid > 0 || mesh.cells.size() > cells)
        mesh.notes.push_back(fmt::format(
            "the sides of contacts were cut alike: {} vertices slid along their lines, {} cells became {}; the "
            "smallest angle is {:.3g} degrees",
            slid, cells, mesh.cells.size(), quality(mesh).smallest_angle));
      return finished(std::move(mesh), contacts, comparison);
    }
    const int now = slide(mesh, comparison, movable(mesh, normals, comparison, arcs), least.usual, arcs);
    slid += now;
    if (now == 0) mesh = halve(mesh, comparison.missing, least, arcs);
  }
  return {};
}

}  // namespace

CutAlike cut_alike(Mesh<2> mesh, const std::vector<SideParts>& contacts, const Arcs& arcs) {
  if (auto pairs = coinciding(mesh, contacts)) return {std::move(mesh), std::move(*pairs)};
  const double usual = std::min(20.0, 0.7 * quality(mesh).smallest_angle);
  const std::size_t cells = mesh.cells.size();
  // With angles that are as good as can be; where that would halve on and on, with others.
  if (auto cut = with_at_most(8 * cells + 2000, mesh, contacts, arcs, {usual, 0.85 * usual})) return std::move(*cut);
  if (auto cut = with_at_most(20 * cells + 20000, mesh, contacts, arcs, {usual, 0.6 * usual})) return std::move(*cut);
  fail(Status::mesh, contacts.front().where,
       "the sides of the contacts cannot be cut alike without a great many cells: mesh them to match, or more evenly");
}

}  // namespace bracket::scene
