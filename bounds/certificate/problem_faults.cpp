// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/certificate/problem_faults.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/pending/disjoint_sets.hpp>
#include <limits>
#include <numeric>

#include "bounds/certificate/elastic_form.h"
#include "bounds/certificate/geometry.h"
#include "scene/problem/gap.h"
#include "scene/problem/psi.h"

namespace bracket::bounds {

namespace {

using scene::Problem;
using scene::Support;
using scene::Vector;

bool in_range(int index, std::size_t size) { return index >= 0 && static_cast<std::size_t>(index) < size; }

template <class Values> bool all_finite(const Values& values) {
  return std::all_of(values.begin(), values.end(), [](double x) { return std::isfinite(x); });
}
template <std::size_t n> bool all_finite(const std::array<Vector<2>, n>& values) {
  return std::all_of(values.begin(), values.end(), [](const Vector<2>& x) { return x.allFinite(); });
}

std::string index_fault(const Problem<2>& problem) {
  const auto& mesh = problem.mesh;
  if (mesh.cells.empty() || mesh.bodies.empty() || mesh.components.empty()) return "the problem has no cells";
  if (problem.facets.size() != mesh.boundary.size() || problem.bodies.size() != mesh.bodies.size() ||
      mesh.cell_body.size() != mesh.cells.size() || mesh.cell_component.size() != mesh.cells.size() ||
      mesh.cell_edges.size() != mesh.cells.size())
    return "data and mesh of the problem differ in number";
  const auto vertex = [&](int v) { return in_range(v, mesh.vertices.size()); };
  for (std::size_t c = 0; c < mesh.cells.size(); ++c)
    if (!std::ranges::all_of(mesh.cells[c], vertex) || !in_range(mesh.cell_body[c], mesh.bodies.size()) ||
        !in_range(mesh.cell_component[c], mesh.components.size()) ||
        !std::ranges::all_of(mesh.cell_edges[c], [&](int e) { return in_range(e, mesh.edges.size()); }))
      return fmt::format("cell {} names a vertex, edge, body or component that is not there", c);
  for (const auto& edge : mesh.edges)
    if (!std::ranges::all_of(edge, vertex)) return "an edge names a vertex that is not there";
  for (const auto& facet : mesh.boundary)
    if (!std::ranges::all_of(facet.vertices, vertex) || !in_range(facet.cell, mesh.cells.size()) ||
        !in_range(facet.edge, mesh.edges.size()) || !in_range(facet.local, 3))
      return "a boundary facet names a vertex, edge or cell that is not there";
  for (const auto& pair : problem.contact)
    if (!in_range(pair.first, problem.facets.size()) || pair.second < -1 || pair.pair < 0 ||
        (pair.second >= 0 && !in_range(pair.second, problem.facets.size())))
      return "a contact names a facet that is not there";
  for (const auto& correction : problem.corrections)
    if (!in_range(correction.facet, problem.facets.size()) || !all_finite(correction.unit))
      return "a correction of the loads names a facet that is not there, or is not finite";
  for (const auto& pair : problem.contact)
    if (!problem.corrections.empty() && !in_range(pair.pair, problem.carries.size()))
      return "the corrections of the loads do not say which contacts carry";
  return "";
}

std::string number_fault(const Problem<2>& problem) {
  for (const Vector<2>& x : problem.mesh.vertices)
    if (!x.allFinite()) return "a coordinate is not finite";
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    const auto& data = problem.facets[f];
    if (!data.normal.allFinite() || !all_finite(data.traction) || !all_finite(data.displacement) ||
        !all_finite(data.correction) || !all_finite(data.pressure) || !all_finite(data.normal_displacement))
      return fmt::format("the data of boundary facet {} are not finite", f);
  }
  for (const auto& pair : problem.contact)
    if (!all_finite(pair.lower) || !all_finite(pair.upper)) return "a gap is not finite";
  for (std::size_t b = 0; b < problem.bodies.size(); ++b) {
    const auto form = elastic_form<Enclosure>(problem.bodies[b].material);
    const bool definite = std::ranges::all_of(form.d, [](const Enclosure& d) { return d.middle > d.radius; });
    if (!definite || !problem.bodies[b].force.allFinite())
      return fmt::format("the material of '{}' is not positive definite, or its weight not finite",
                         problem.mesh.bodies[b]);
  }
  return "";
}

std::string topology_fault(const Problem<2>& problem) {
  const auto& mesh = problem.mesh;
  struct Walks {
    int up = 0, down = 0, cell = -1;
  };
  std::vector<Walks> walks(mesh.edges.size());
  std::vector<int> ranks(mesh.cells.size()), parents(mesh.cells.size());
  std::iota(parents.begin(), parents.end(), 0);
  boost::disjoint_sets<int*, int*> connected(ranks.data(), parents.data());
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    const Enclosure area = doubled_area(corners<Enclosure>(problem, static_cast<int>(c)));
    if (!(area.middle > area.radius)) return fmt::format("the area of cell {} is not positive with certainty", c);
    const int cell = static_cast<int>(c);
    for (int k = 0; k < 3; ++k) {
      const std::array<int, 2> walked = scene::facet_vertices(mesh, static_cast<int>(c), k);
      const std::array<int, 2>& edge = mesh.edges[mesh.cell_edges[c][k]];
      Walks& so_far = walks[mesh.cell_edges[c][k]];
      if (walked == edge)
        ++so_far.up;
      else if (walked[0] == edge[1] && walked[1] == edge[0])
        ++so_far.down;
      else
        return fmt::format("edge {} of cell {} does not join its corners", k, c);
      if (so_far.up > 1 || so_far.down > 1)
        return fmt::format("more than one cell lies on one side of the edge of cell {}", c);
      if (so_far.cell < 0) so_far.cell = cell;
      if (mesh.cell_component[so_far.cell] != mesh.cell_component[c]) return "two components share an edge";
      connected.union_set(so_far.cell, cell);
    }
  }
  // As many connected sets as components, and a cell in each: each component is one of the sets.
  std::vector<char> has_cells(mesh.components.size(), 0);
  for (const int component : mesh.cell_component) has_cells[component] = 1;
  std::size_t sets = 0;
  for (int cell = 0; cell < static_cast<int>(mesh.cells.size()); ++cell)
    if (connected.find_set(cell) == cell) ++sets;
  if (sets != mesh.components.size() || std::ranges::count(has_cells, 0) > 0)
    return "a component of the mesh does not hang together through edges";
  std::size_t open = 0;
  for (const Walks& edge : walks) open += edge.up + edge.down == 1;
  std::vector<char> seen(mesh.edges.size(), 0);
  for (std::size_t f = 0; f < mesh.boundary.size(); ++f) {
    const auto& [vertices, cell, local, edge, part] = mesh.boundary[f];
    const bool walked = scene::facet_vertices(mesh, cell, local) == vertices && mesh.cell_edges[cell][local] == edge;
    if (!walked || seen[edge] || walks[edge].up + walks[edge].down != 1)
      return fmt::format("boundary facet {} is not an edge with one cell, walked as its cell walks it", f);
    seen[edge] = 1;
  }
  return open == mesh.boundary.size() ? "" : "an edge with one cell is not on the boundary";
}

/// A point of the first mesh: its vertices around it, by number, and their weights; those without are left out.
using Point = std::array<std::pair<int, double>, 3>;
constexpr std::pair<int, double> nothing = {std::numeric_limits<int>::max(), 0};

Point sorted(Point point) {
  for (auto& [vertex, weight] : point)
    if (weight == 0) vertex = nothing.first;
  std::ranges::sort(point);
  return point;
}

Point corner_of(const scene::Mesh<2>& first, const scene::Piece<2>& piece, int i) {
  const auto& [x, y] = piece.corner[i];
  const auto& v = first.cells[piece.of];
  return sorted({{{v[0], (1 - x) - y}, {v[1], x}, {v[2], y}}});
}

std::string piece_fault(const Problem<2>& problem) {
  const Problem<2>& first = scene::first_of(problem);
  const auto& mesh = problem.mesh;
  const auto& origin = problem.origin;
  if (origin.cells.size() != mesh.cells.size() || origin.facets.size() != mesh.boundary.size())
    return "the pieces of the first mesh and the mesh differ in number";
  const auto dyadic = [](double x) { return x >= 0 && x <= 1 && (1 + x) - 1 == x; };
  std::vector<Point> points(mesh.vertices.size(), {nothing, nothing, nothing});
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    const auto& piece = origin.cells[c];
    if (!in_range(piece.of, first.mesh.cells.size()) || first.mesh.cell_body[piece.of] != mesh.cell_body[c] ||
        first.mesh.cell_component[piece.of] != mesh.cell_component[c])
      return fmt::format("cell {} is no piece of a cell of its body and component on the first mesh", c);
    for (int i = 0; i < 3; ++i) {
      const auto& [x, y] = piece.corner[i];
      if (!dyadic(x) || !dyadic(y) || x + y > 1) return fmt::format("cell {} lies outside of its first cell", c);
      Point& known = points[mesh.cells[c][i]];
      const Point own = corner_of(first.mesh, piece, i);
      if (known[0] == nothing) known = own;
      if (known != own) return fmt::format("the cells at vertex {} do not meet in one point", mesh.cells[c][i]);
    }
  }
  std::vector<double> covered(first.facets.size(), 0);
  for (std::size_t f = 0; f < mesh.boundary.size(); ++f) {
    const auto& [of, corner] = origin.facets[f];
    if (!in_range(of, first.facets.size()) || !(corner[0][0] < corner[1][0]))
      return fmt::format("boundary facet {} is no piece of a facet of the first mesh", f);
    const auto& ends = first.mesh.boundary[of].vertices;
    for (int i = 0; i < 2; ++i) {
      const double t = corner[i][0];
      if (!dyadic(t) || points[mesh.boundary[f].vertices[i]] != sorted({{{ends[0], 1 - t}, {ends[1], t}, nothing}}))
        return fmt::format("boundary facet {} does not lie on its facet of the first mesh", f);
    }
    covered[of] += corner[1][0] - corner[0][0];
    if (problem.facets[f].support != first.facets[of].support || problem.facets[f].normal != first.facets[of].normal)
      return fmt::format("boundary facet {} has another support or direction than on the first mesh", f);
  }
  for (const double width : covered)
    if (width != 1) return "a facet of the first mesh is not covered by its pieces";
  return "";
}

bool is_same(const scene::Material<2>& a, const scene::Material<2>& b) {
  const auto &one = a.constants(), &other = b.constants();
  if (one.has_value() != other.has_value() || a.stiffness() != b.stiffness()) return false;
  return !one || (one->young == other->young && one->poisson == other->poisson && one->plane == other->plane);
}

/// \pre perturbation_fault() and piece_fault() find none
std::string body_fault(const Problem<2>& problem) {
  const Problem<2>& first = scene::first_of(problem);
  const auto& by = problem.perturbed.by;
  if (problem.bodies.size() != first.bodies.size()) return "there are other bodies than on the first mesh";
  for (std::size_t b = 0; b < problem.bodies.size(); ++b) {
    const auto &body = problem.bodies[b], &known = first.bodies[b];
    const bool is_perturbed = by && !by->force[b].isZero(0);  // then the sum is formed from what the first mesh has
    if (!is_same(body.material, known.material) || (!is_perturbed && body.force != known.force))
      return fmt::format("'{}' has another material or weight than on the first mesh", problem.mesh.bodies[b]);
  }
  return "";
}

std::string direction_fault(const Problem<2>& problem) {
  const double cosine = std::cos(25 * 3.14159265358979323846 / 180);
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    const auto& [support, normal] = std::pair(problem.facets[f].support, problem.facets[f].normal);
    if (support != Support::sliding && support != Support::contact) continue;
    const auto e = along<double>(problem, static_cast<int>(f));
    const Vector<2> outward(e.y, -e.x);
    if (std::abs(normal.squaredNorm() - 1) > 16 * std::numeric_limits<double>::epsilon())
      return fmt::format("the direction of boundary facet {} is not a unit vector", f);
    if (!(outward.dot(normal) >= cosine * outward.norm()))
      return fmt::format("the direction of boundary facet {} is more than 25 degrees off its outward normal", f);
  }
  return "";
}

/// Whether the two facets of a contact are the same pieces of two facets that face each other on the first mesh: end
/// lies opposite to end along the direction of the first, but for rounding and, as neighbours on arcs have other
/// directions, for a part of the distance.
bool face_each_other(const Problem<2>& problem, const scene::ContactFacet& pair) {
  const scene::Mesh<2>& first = scene::first_of(problem).mesh;
  const auto one = scene::piece_of_facet(problem, pair.first), other = scene::piece_of_facet(problem, pair.second);
  const auto& a = first.boundary[one.of].vertices;
  const auto& b = first.boundary[other.of].vertices;
  const Vector<2>& d = problem.facets[pair.first].normal;
  for (int i = 0; i < 2; ++i) {
    const Vector<2>&x = first.vertices[a[i]], &y = first.vertices[b[1 - i]];
    const double across = std::abs((y - x).dot(Vector<2>(-d[1], d[0]))), along = std::abs((y - x).dot(d));
    const double length = (first.vertices[a[1]] - first.vertices[a[0]]).norm();
    if (!(across <= 0.01 * length + 0.5 * along)) return false;
  }
  return one.corner[0][0] == 1 - other.corner[1][0] && one.corner[1][0] == 1 - other.corner[0][0];
}

std::string contact_fault(const Problem<2>& problem) {
  const Problem<2>& first = scene::first_of(problem);
  const std::vector<int> contact_of_facet = scene::contacts_by_first(first);
  std::vector<char> taken(problem.facets.size(), 0);
  for (const auto& pair : problem.contact) {
    const std::string name = fmt::format("the contact of boundary facet {}", pair.first);
    for (const int side : {pair.first, pair.second}) {
      if (side < 0) continue;
      if (taken[side] || problem.facets[side].support != Support::contact)
        return name + " is not its only one, or a side of it has another support";
      taken[side] = 1;
    }
    if (pair.second >= 0 && problem.facets[pair.second].normal != -problem.facets[pair.first].normal)
      return name + " has directions that are not opposite on its two sides";
    if (pair.second >= 0 && !face_each_other(problem, pair)) return name + " has sides that do not face each other";
    if (scene::cross({pair.lower, pair.upper})) return name + " has a lower gap above its upper one";
    if (!problem.origin.first) continue;
    const auto& piece = problem.origin.facets[pair.first];
    const int whole = contact_of_facet[piece.of];
    if (whole < 0 || first.contact[whole].pair != pair.pair ||
        (pair.second < 0 ? first.contact[whole].second >= 0
                         : problem.origin.facets[pair.second].of != first.contact[whole].second))
      return name + " is none of the first mesh";
    const scene::ContactFacet exact = scene::on_piece(first, whole, pair.first, pair.second, piece);
    std::array<Enclosure, 3> added;
    if (const auto& [by, loads, kinematics] = problem.perturbed; by && kinematics != 0) {
      added = scene::psi<Enclosure>(by->contact[whole], problem.facets[pair.first].normal, piece);
      for (Enclosure& one : added) one = Enclosure(kinematics) * one;
    }
    for (int i = 0; i < 3; ++i)
      if (pair.lower[i] > lower(Enclosure(exact.lower[i]) + added[i]) ||
          pair.upper[i] < upper(Enclosure(exact.upper[i]) + added[i]))
        return name + " has gaps that do not enclose those of the first mesh";
  }
  for (std::size_t f = 0; f < problem.facets.size(); ++f)
    if (problem.facets[f].support == Support::contact && !taken[f])
      return fmt::format("boundary facet {} is in contact with nothing", f);
  return "";
}

/// What acts on a contact line beside its pressure is a perturbation's opening load, and nothing else.
std::string load_fault(const Problem<2>& first) {
  for (std::size_t f = 0; f < first.facets.size(); ++f)
    if (first.facets[f].support == Support::contact && scene::is_loaded(first.facets[f]))
      return fmt::format("boundary facet {} is in contact and loaded", f);
  return "";
}

/// Facets that meet at a vertex of the first mesh must prescribe the same there.
std::string support_fault(const Problem<2>& first) {
  for (const auto& [ends, begins] : facets_that_meet(first.mesh)) {
    if (ends < 0 || begins < 0) continue;
    const auto &in = first.facets[ends], &out = first.facets[begins];
    const bool both_fixed = in.support == Support::fixed && out.support == Support::fixed;
    const bool both_slide = in.support == Support::sliding && out.support == Support::sliding;
    if ((both_fixed && in.displacement[1] != out.displacement[0]) ||
        (both_slide && in.normal == out.normal && in.normal_displacement[1] != out.normal_displacement[0]) ||
        (both_slide && in.normal == -out.normal && in.normal_displacement[1] != -out.normal_displacement[0]))
      return fmt::format("boundary facets {} and {} prescribe different displacements where they meet", ends, begins);
  }
  return "";
}

}  // namespace

std::vector<std::array<int, 2>> facets_that_meet(const scene::Mesh<2>& mesh) {
  std::vector<std::array<int, 2>> at(mesh.vertices.size(), {-1, -1});
  for (std::size_t f = 0; f < mesh.boundary.size(); ++f)
    for (int i = 0; i < 2; ++i) at[mesh.boundary[f].vertices[i]][1 - i] = static_cast<int>(f);
  return at;
}

std::string problem_fault(const Problem<2>& problem) {
  const Problem<2>& first = scene::first_of(problem);
  for (const Problem<2>* one : {&first, &problem}) {
    if (std::string fault = index_fault(*one); !fault.empty()) return fault;
    if (std::string fault = number_fault(*one); !fault.empty()) return fault;
    if (one == &problem && problem.origin.first)
      if (std::string fault = piece_fault(problem); !fault.empty()) return fault;
    if (one == &problem)
      if (std::string fault = perturbation_fault(problem); !fault.empty()) return fault;
    if (one == &problem)
      if (std::string fault = body_fault(problem); !fault.empty()) return fault;
    if (std::string fault = topology_fault(*one); !fault.empty()) return fault;
    if (std::string fault = direction_fault(*one); !fault.empty()) return fault;
    if (std::string fault = contact_fault(*one); !fault.empty()) return fault;
    if (&first == &problem) break;
  }
  if (std::string fault = load_fault(first); !fault.empty()) return fault;
  return support_fault(first);
}

}  // namespace bracket::bounds
