// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/certificate/admissible_displacement.h"

#include <fmt/format.h>

namespace bracket::bounds {

using scene::Support;
using scene::Vector;

PlainField plain_field(const scene::Problem<2>& problem, const scene::Displacement<2>& displacement,
                       const Supports& supports) {
  PlainField field{displacement.degree, displacement.vertex, {}};
  for (std::size_t v = 0; v < supports.vertex.size(); ++v) {
    const auto& [end, t, added] = supports.vertex[v].held;
    if (!supports.vertex[v].fixed) continue;
    for (int c = 0; c < 2; ++c) {
      field.vertex[v][c] = between_ends(end[0][c], end[1][c], t);
      if (added.factor != 0)
        field.vertex[v][c] += added.factor * between_ends(added.end[0].value[c], added.end[1].value[c], t);
    }
  }
  const auto& mesh = problem.mesh;
  field.offset = scene::offsets<double, Vector<2>>(mesh, displacement, field.vertex, scene::plain_difference<2>);
  const int n = scene::n_inside_edge(field.degree);
  for (std::size_t f = 0; f < problem.facets.size(); ++f)
    for (int k = 0; k < n && problem.facets[f].support == Support::fixed; ++k)
      field.offset.edge[n * mesh.boundary[f].edge + k].setZero();
  return field;
}

namespace {

/// How a vertex can move along d: not at all where the length is 0.
Vector<2> way(const VertexSupport& support, const Vector<2>& d) {
  if (support.fixed || support.slides == 2) return Vector<2>::Zero();
  if (support.slides == 0) return d / d.squaredNorm();
  const Vector<2> tangent(-support.slide[0].normal[1], support.slide[0].normal[0]);
  const double along = tangent.dot(d);
  return std::abs(along) < 1e-7 ? Vector<2>::Zero() : Vector<2>(tangent / along);
}

/// By how much the facet penetrates at most; 0: with certainty not at all.
double excess(const Enclosure& penetration) { return certainly_non_negative(-penetration) ? 0 : upper(penetration); }

/// By how much to move what is now at u: a little more than what is missing, and not lost in rounding.
double step(double missing, const Vector<2>& u) {
  return std::max(1.0625 * missing, 8 * std::numeric_limits<double>::epsilon() * u.lpNorm<Eigen::Infinity>());
}

/// Moves one end of a contact facet out of contact. \return whether its supports let it
bool make_way(const scene::Problem<2>& problem, const Supports& supports, PlainField& field,
              const scene::ContactFacet& pair, int end, double missing) {
  const auto& mesh = problem.mesh;
  const Vector<2>& d = problem.facets[pair.first].normal;
  const int first = mesh.boundary[pair.first].vertices[end];
  const int second = pair.second < 0 ? -1 : mesh.boundary[pair.second].vertices[1 - end];
  const Vector<2> back = way(supports.vertex[first], d);
  const Vector<2> away = second < 0 ? Vector<2>(Vector<2>::Zero()) : way(supports.vertex[second], d);
  if (back.isZero(0) && away.isZero(0)) return false;
  // The one that moves less for it.
  const bool moves_first = away.isZero(0) || (!back.isZero(0) && back.norm() <= away.norm());
  Vector<2>& u = field.vertex[moves_first ? first : second];
  u += step(missing, u) * (moves_first ? Vector<2>(-back) : away);
  return true;
}

/// The same between: by the offset k, or, in degree 1, by the ends that can.
bool make_way_between(const scene::Problem<2>& problem, const Supports& supports, PlainField& field,
                      const scene::ContactFacet& pair, int k, double missing) {
  if (field.degree == 1) {
    const bool at_first = make_way(problem, supports, field, pair, 0, missing);
    return make_way(problem, supports, field, pair, 1, missing) || at_first;
  }
  const Vector<2>& d = problem.facets[pair.first].normal;
  const auto& at = problem.mesh.boundary[pair.first];
  Vector<2>& offset =
      field.offset.edge[scene::place_inside_edge(problem.mesh, field.degree, at.edge, at.vertices[0], k)];
  offset -= step(missing, offset) * d / d.squaredNorm();
  return true;
}

}  // namespace

std::string kept_fault(const scene::Problem<2>& problem, int degree, const Supports& supports) {
  if (!supports.fault.empty()) return supports.fault;
  for (const auto& pair : problem.contact) {
    if (degree > 1 || !keeps_together(pair.law)) continue;
    const KeptGap& gap =
        supports.contacts.kept[supports.contacts.of_facet[scene::piece_of_facet(problem, pair.first).of]];
    if (!gap.is_linear || (gap.factor != 0 && !gap.is_psi_linear))
      return "the gap of sides that keep together is not linear, as displacements of degree 1 are";
  }
  return "";
}

AdmissibleField admissible_field(const scene::Problem<2>& problem, const scene::Displacement<2>& displacement,
                                 const Supports& supports) {
  constexpr int most = 100;
  if (std::string fault = kept_fault(problem, displacement.degree, supports); !fault.empty()) return {{}, fault};
  PlainField field = plain_field(problem, displacement, supports);
  const int last = std::max(2, field.degree);
  std::vector<int> order = {0, last};  // both ends, then between
  for (int k = 1; k < last; ++k) order.push_back(k);
  for (int sweep = 0; sweep < most; ++sweep) {
    bool settled = true;
    for (const auto& pair : problem.contact)
      for (const int k : order) {
        if (pair.law.two_sided || scene::has_springs(pair.law)) break;
        const double missing = excess(penetration<Enclosure>(problem, supports, field, pair)[k]);
        if (!std::isfinite(missing)) return {{}, "the displacements are too large for their energies to be enclosed"};
        if (missing == 0) continue;
        settled = false;
        const bool at_end = k == 0 || k == last;
        if (at_end ? make_way(problem, supports, field, pair, k / last, missing)
                   : make_way_between(problem, supports, field, pair, k, missing))
          continue;
        const Vector<2>& at = problem.mesh.vertices[problem.mesh.boundary[pair.first].vertices[k / last]];
        return {{},
                fmt::format("the displacements prescribed at ({:.6g}, {:.6g}) close the gap by up to {:.3g}", at[0],
                            at[1], missing)};
      }
    if (settled) return {std::move(field), ""};
  }
  return {{}, "the displacements could not be moved out of contact"};
}

}  // namespace bracket::bounds
