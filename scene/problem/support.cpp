// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// Planar: two boundary facets meet at a vertex.
#include "scene/problem/support.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <optional>

#include "scene/problem/gap.h"
#include "scene/text.h"

namespace bracket::scene {

namespace {

/// The two boundary facets at each vertex: the one that ends there and the one that begins; −1 at inner vertices.
std::vector<std::array<int, 2>> facets_at_vertices(const Mesh<2>& mesh) {
  std::vector<std::array<int, 2>> facets(mesh.vertices.size(), {-1, -1});
  for (std::size_t facet = 0; facet < mesh.boundary.size(); ++facet) {
    const auto& [begin, end] = mesh.boundary[facet].vertices;
    facets[begin][1] = facets[end][0] = static_cast<int>(facet);
  }
  return facets;
}

}  // namespace

std::vector<FacetData<2>> with_agreement(const Mesh<2>& mesh, std::vector<FacetData<2>> facets,
                                         const std::vector<const Condition<2>*>& conditions, double largest) {
  const double tolerance = 1e-9 * largest;
  const auto prescribes = [&](int facet) {
    return facets[facet].support == Support::fixed || facets[facet].support == Support::sliding;
  };
  const auto facets_at = facets_at_vertices(mesh);
  for (std::size_t begins = 0; begins < facets.size(); ++begins) {
    const int vertex = mesh.boundary[begins].vertices[0];
    const int leaving = static_cast<int>(begins);
    const int ends = facets_at[vertex][0];
    if (!prescribes(leaving) || !prescribes(ends)) continue;
    FacetData<2>& out = facets[leaving];
    FacetData<2>& in = facets[ends];
    double difference = 0;
    if (in.support == Support::fixed && out.support == Support::fixed) {
      difference = (out.displacement[0] - in.displacement[1]).norm();
      out.displacement[0] = in.displacement[1];
    } else if (in.support == Support::fixed) {
      const double value = out.normal.dot(in.displacement[1]);
      difference = std::abs(out.normal_displacement[0] - value);
      out.normal_displacement[0] = value;
    } else if (out.support == Support::fixed) {
      const double value = in.normal.dot(out.displacement[0]);
      difference = std::abs(in.normal_displacement[1] - value);
      in.normal_displacement[1] = value;
    } else if (in.normal == out.normal || in.normal == -out.normal) {
      const double value = (in.normal == out.normal ? 1 : -1) * in.normal_displacement[1];
      difference = std::abs(out.normal_displacement[0] - value);
      out.normal_displacement[0] = value;
    }
    if (difference <= tolerance) continue;
    const int part_in = mesh.boundary[ends].part, part_out = mesh.boundary[leaving].part;
    fail(Status::input, conditions[part_out]->where,
         fmt::format("the displacements prescribed on '{}' and '{}' contradict each other at {}: they differ by {:.3g}",
                     mesh.parts[part_in], mesh.parts[part_out], point(mesh.vertices[vertex]), difference));
  }
  return facets;
}

namespace {

/// What is prescribed at one end of a contact facet.
struct Prescribed {
  Enclosure along;  ///< the displacement along d
  double size = 0;  ///< of the whole
};

/// \return nothing where the displacement along d is free
std::optional<Prescribed> prescribed(const FacetData<2>& data, int end, const Vector<2>& d) {
  if (data.support == Support::fixed) {
    const Vector<2>& u = data.displacement[end];
    return Prescribed{Enclosure(u[0]) * Enclosure(d[0]) + Enclosure(u[1]) * Enclosure(d[1]), u.norm()};
  }
  const double u = data.normal_displacement[end];
  if (data.support == Support::sliding && data.normal == d) return Prescribed{u, std::abs(u)};
  if (data.support == Support::sliding && data.normal == -d) return Prescribed{-u, std::abs(u)};
  return {};
}

/// The least gap that admits an approach: `gap`, or what is not more than the tolerance above it.
double with_room(double gap, const Enclosure& approach, double tolerance) {
  const double room = upper(approach);
  return room <= gap || room - gap > tolerance ? gap : room;
}

/// Makes the gap of sides that keep together that approach, if it differs by no more than the tolerance: no
/// displacement could make good what rounding did. \return by how much it was changed
double adapt(ContactFacet& facet, int end, const Enclosure& approach, double tolerance) {
  const double change =
      std::max(std::abs(facet.lower[2 * end] - upper(approach)), std::abs(facet.upper[2 * end] - lower(approach)));
  if (change > tolerance) return 0;
  facet.lower[2 * end] = lower(approach);
  facet.upper[2 * end] = upper(approach);
  return change;
}

}  // namespace

double make_room(Problem<2>& problem) {
  const Mesh<2>& mesh = problem.mesh;
  const auto facets_at = facets_at_vertices(mesh);
  const auto at_end = [&](int facet, int end, const Vector<2>& d) {  // what the neighbour there prescribes
    return prescribed(problem.facets[facets_at[mesh.boundary[facet].vertices[end]][end]], 1 - end, d);
  };
  double most = 0;
  for (std::size_t i = 0; i < problem.contact.size(); ++i) {
    ContactFacet& facet = problem.contact[i];
    const Vector<2>& d = problem.facets[facet.first].normal;
    for (int end = 0; end < 2; ++end) {
      const auto first = at_end(facet.first, end, d);
      const auto second = facet.second == -1 ? Prescribed{} : at_end(facet.second, 1 - end, d);
      if (!first || !second || has_springs(facet.law)) continue;
      GivenGap<2>& given = problem.gaps[i];
      const auto& [a, b] = positions(mesh, mesh.boundary[facet.first].vertices);
      const double gap = given.function ? lower(gap_at_end(given.function, a, b, end)) : facet.lower[2 * end];
      const double size = first->size + second->size + std::abs(gap) + problem.length_scale;
      const double tolerance = 8 * std::numeric_limits<double>::epsilon() * size;
      // Whoever computes it again comes to another middle, within the radius.
      Enclosure approach = first->along - second->along;
      approach.radius *= 4;
      if (facet.law.two_sided) {
        most = std::max(most, adapt(facet, end, approach, tolerance));
        continue;
      }
      const double room = with_room(gap, approach, tolerance);
      const double raised = upper(Interval(room) - Interval(gap));
      given.at_least[end] = std::min(gap, upper(approach));
      given.raised[end] = raised;
      if (raised == 0) continue;
      if (!given.function) {
        facet.lower[2 * end] = room;
        facet.upper[2 * end] = std::max(room, facet.upper[2 * end]);
      }
      most = std::max(most, raised);
      problem.mesh.notes.push_back(
          fmt::format("the gap at {} was raised by {:.2g}: the displacements prescribed there close it by rounding",
                      point(mesh.vertices[mesh.boundary[facet.first].vertices[end]]), raised));
    }
  }
  return most;
}

}  // namespace bracket::scene
