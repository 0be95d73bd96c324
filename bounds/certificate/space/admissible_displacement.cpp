// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/certificate/space/admissible_displacement.h"

#include <fmt/format.h>

namespace bracket::bounds::space {

using scene::Vector;

PlainField plain_field(const scene::Problem<3>& problem, const scene::Displacement<3>& u, const Supports& supports) {
  const auto& mesh = problem.mesh;
  PlainField field{u.degree, u.vertex};
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
    if (const NodeSupport& support = supports.node.of(static_cast<int>(v)); holds(support)) {
      const auto at = place<double>(support);
      field.node[v] = {at[0], at[1], at[2]};
    }
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
    const auto& [a, b] = mesh.edges[e];
    const bool is_linear = u.degree == 1 || holds(supports.node.of(node_of_edge(mesh, static_cast<int>(e))));
    field.node.push_back(is_linear ? Vector<3>(Vector<3>::Zero())
                                   : Vector<3>((u.edge[e] - field.node[a]) + (u.edge[e] - field.node[b])));
  }
  return field;
}

namespace {

/// How a node can move along d: not at all where the length is 0.
Vector<3> way(const NodeSupport& support, const Vector<3>& d) {
  const auto free = free_part(support, vector3<double>(d));
  const Vector<3> v(free[0], free[1], free[2]);
  return v.norm() < 1e-7 ? Vector<3>(Vector<3>::Zero()) : Vector<3>(v / v.dot(d));
}

/// By how much the facet penetrates at most; 0: with certainty not at all.
double excess(const Enclosure& penetration) { return certainly_non_negative(-penetration) ? 0 : upper(penetration); }

/// By how much to move what is now at u: a little more than what is missing, and not lost in rounding.
double step(double missing, const Vector<3>& u) {
  return std::max(1.0625 * missing, 8 * std::numeric_limits<double>::epsilon() * u.lpNorm<Eigen::Infinity>());
}

/// Moves node k of a contact facet out of contact. \return whether its supports let it
bool make_way(const scene::Problem<3>& problem, const Supports& supports, PlainField& field,
              const scene::ContactFacetOf<3>& pair, int k, double missing) {
  const auto& mesh = problem.mesh;
  if (k >= 3 && field.degree == 1) {  // by the ends that can
    const auto& [a, b] = scene::Simplex<2>::edges[k - 3];
    const bool moved = make_way(problem, supports, field, pair, a, missing);
    return make_way(problem, supports, field, pair, b, missing) || moved;
  }
  const Vector<3>& d = problem.facets[pair.first].normal;
  const int first = nodes_of_facet(mesh, pair.first)[k], second = node_across(mesh, pair, k);
  const Vector<3> back = way(supports.node.of(first), d);
  const Vector<3> away = second < 0 ? Vector<3>(Vector<3>::Zero()) : way(supports.node.of(second), d);
  if (back.isZero(0) && away.isZero(0)) return false;
  // The one that moves less for it.
  const bool moves_first = away.isZero(0) || (!back.isZero(0) && back.norm() <= away.norm());
  Vector<3>& u = field.node[moves_first ? first : second];
  u += step(missing, u) * (moves_first ? Vector<3>(-back) : away);
  return true;
}

std::string no_room(const scene::Problem<3>& problem, const scene::ContactFacetOf<3>& pair, int k, double missing) {
  const Vector<3>& at = problem.mesh.vertices[problem.mesh.boundary[pair.first].vertices[k % 3]];
  return fmt::format("the displacements prescribed at ({:.6g}, {:.6g}, {:.6g}) close the gap by up to {:.3g}", at[0],
                     at[1], at[2], missing);
}

}  // namespace

AdmissibleField admissible_field(const scene::Problem<3>& problem, const scene::Displacement<3>& displacement,
                                 const Supports& supports) {
  constexpr int most = 100;
  if (!supports.fault.empty()) return {{}, supports.fault};
  PlainField field = plain_field(problem, displacement, supports);
  for (int sweep = 0; sweep < most; ++sweep) {
    bool settled = true;
    for (const auto& pair : problem.contact) {
      if (pair.law.two_sided) continue;
      auto missing = penetration<Enclosure>(problem, supports, field, pair);
      for (int k = 0; k < 6; ++k) {  // vertices, then between
        const double by = excess(missing[k]);
        if (!std::isfinite(by)) return {{}, "the displacements are too large for their energies to be enclosed"};
        if (by == 0) continue;
        settled = false;
        if (!make_way(problem, supports, field, pair, k, by)) return {{}, no_room(problem, pair, k, by)};
        missing = penetration<Enclosure>(problem, supports, field, pair);
      }
    }
    if (settled) return {std::move(field), ""};
  }
  return {{}, "the displacements could not be moved out of contact"};
}

}  // namespace bracket::bounds::space
