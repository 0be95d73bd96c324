// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/certificate/problem_faults.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "bounds/certificate/elastic_form.h"
#include "bounds/certificate/geometry.h"
#include "scene/problem/gap.h"
#include "scene/problem/psi.h"

namespace bracket::bounds {

namespace {

using scene::Problem;
using scene::Support;
using scene::Vector;

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
        !all_finite(data.correction) || !all_finite(data.pressure) || !all_finite(data.normal_displacement) ||
        !all_finite(data.higher_traction) || !all_finite(data.higher_pressure))
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

/// What acts beside pressure, friction and the supports' reactions on Γ_0 and Γ_K is a perturbation's, and nothing
/// else.
std::string load_fault(const Problem<2>& first) {
  for (std::size_t f = 0; f < first.facets.size(); ++f)
    if (first.facets[f].support != Support::traction && scene::is_loaded(first.facets[f]))
      return fmt::format("boundary facet {} {} and is loaded", f,
                         first.facets[f].support == Support::contact ? "is in contact" : "slides");
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
  if (std::string fault = law_fault(problem); !fault.empty()) return fault;
  if (std::string fault = load_fault(first); !fault.empty()) return fault;
  return support_fault(first);
}

}  // namespace bracket::bounds
