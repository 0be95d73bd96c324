// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/certificate/admissible_displacement.h"

#include <fmt/format.h>

namespace bracket::bounds {

using scene::Support;
using scene::Vector;

namespace {

/// What a perturbation adds at the ends of a facet of the first mesh, of which one end is another's that is fixed.
Added added_at(const scene::Problem<2>& problem, const std::array<FacetEnd, 2>& ends) {
  const auto& [by, loads, kinematics] = problem.perturbed;
  if (!by || kinematics == 0) return {};
  Added added{{}, {0, 0}, kinematics};
  for (int i = 0; i < 2; ++i) {
    added.end[i] = by->facets[ends[i].facet].displacement[ends[i].end];
    added.normal[i] = by->facets[ends[i].facet].normal_displacement[ends[i].end];
  }
  return added;
}

}  // namespace

std::vector<FacetEnd> fixed_vertices(const scene::Problem<2>& first) {
  std::vector<FacetEnd> fixed(first.mesh.vertices.size());
  for (std::size_t f = 0; f < first.facets.size(); ++f)
    for (int i = 0; i < 2 && first.facets[f].support == Support::fixed; ++i)
      fixed[first.mesh.boundary[f].vertices[i]] = {static_cast<int>(f), i};
  return fixed;
}

std::array<Slide, 2> slides_of(const scene::Problem<2>& problem, const std::vector<FacetEnd>& fixed, int facet) {
  const auto [of, corner] = scene::piece_of_facet(problem, facet);
  const scene::Problem<2>& first = scene::first_of(problem);
  Slide slide{first.facets[of].normal, first.facets[of].normal_displacement};
  std::array<FacetEnd, 2> ends;
  for (int i = 0; i < 2; ++i) {
    const FacetEnd& held = fixed[first.mesh.boundary[of].vertices[i]];
    slide.fixed[i] = held.facet >= 0;
    if (slide.fixed[i]) slide.displacement[i] = first.facets[held.facet].displacement[held.end];
    ends[i] = slide.fixed[i] ? held : FacetEnd{of, i};
  }
  slide.added = added_at(problem, ends);
  std::array<Slide, 2> slides = {slide, slide};
  for (int i = 0; i < 2; ++i) slides[i].t = corner[i][0];
  return slides;
}

std::array<Held, 2> holds_of(const scene::Problem<2>& problem, int facet) {
  const auto [of, corner] = scene::piece_of_facet(problem, facet);
  std::array<Held, 2> holds;
  for (int i = 0; i < 2; ++i)
    holds[i] = {scene::first_of(problem).facets[of].displacement, corner[i][0],
                added_at(problem, {FacetEnd{of, 0}, FacetEnd{of, 1}})};
  return holds;
}

std::vector<VertexSupport> vertex_supports(const scene::Problem<2>& problem) {
  std::vector<VertexSupport> supports(problem.mesh.vertices.size());
  const auto fixed = fixed_vertices(scene::first_of(problem));
  for (const Support kind : {Support::fixed, Support::sliding})
    for (std::size_t f = 0; f < problem.facets.size(); ++f) {
      if (problem.facets[f].support != kind) continue;
      const int facet = static_cast<int>(f);
      const auto slides = slides_of(problem, fixed, facet);
      const auto holds = holds_of(problem, facet);
      for (int i = 0; i < 2; ++i) {
        VertexSupport& vertex = supports[problem.mesh.boundary[f].vertices[i]];
        const Vector<2>& n = slides[i].normal;
        if (kind == Support::fixed) {
          vertex.fixed = true;
          vertex.held = holds[i];
        } else if (!vertex.fixed && vertex.slides < 2 &&
                   (vertex.slides == 0 || (vertex.slide[0].normal != n && vertex.slide[0].normal != -n))) {
          vertex.slide[vertex.slides++] = slides[i];
        }
      }
    }
  return supports;
}

PlainField plain_field(const scene::Problem<2>& problem, const scene::Displacement<2>& displacement,
                       const std::vector<VertexSupport>& supports) {
  PlainField field{displacement.degree, displacement.vertex, {}};
  for (std::size_t v = 0; v < supports.size(); ++v) {
    const auto& [end, t, added] = supports[v].held;
    if (!supports[v].fixed) continue;
    for (int c = 0; c < 2; ++c) {
      field.vertex[v][c] = between_ends(end[0][c], end[1][c], t);
      if (added.factor != 0)
        field.vertex[v][c] += added.factor * between_ends(added.end[0].value[c], added.end[1].value[c], t);
    }
  }
  const auto& mesh = problem.mesh;
  field.offset = scene::offsets<double, Vector<2>>(mesh, displacement, field.vertex, scene::plain_difference);
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
bool make_way(const scene::Problem<2>& problem, const std::vector<VertexSupport>& supports, PlainField& field,
              const scene::ContactFacet& pair, int end, double missing) {
  const auto& mesh = problem.mesh;
  const Vector<2>& d = problem.facets[pair.first].normal;
  const int first = mesh.boundary[pair.first].vertices[end];
  const int second = pair.second < 0 ? -1 : mesh.boundary[pair.second].vertices[1 - end];
  const Vector<2> back = way(supports[first], d);
  const Vector<2> away = second < 0 ? Vector<2>(Vector<2>::Zero()) : way(supports[second], d);
  if (back.isZero(0) && away.isZero(0)) return false;
  // The one that moves less for it.
  const bool moves_first = away.isZero(0) || (!back.isZero(0) && back.norm() <= away.norm());
  Vector<2>& u = field.vertex[moves_first ? first : second];
  u += step(missing, u) * (moves_first ? Vector<2>(-back) : away);
  return true;
}

/// The same between: by the offset k, or, in degree 1, by the ends that can.
bool make_way_between(const scene::Problem<2>& problem, const std::vector<VertexSupport>& supports, PlainField& field,
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

AdmissibleField admissible_field(const scene::Problem<2>& problem, const scene::Displacement<2>& displacement,
                                 const std::vector<VertexSupport>& supports) {
  constexpr int most = 100;
  PlainField field = plain_field(problem, displacement, supports);
  const int last = std::max(2, field.degree);
  std::vector<int> order = {0, last};  // both ends, then between
  for (int k = 1; k < last; ++k) order.push_back(k);
  for (int sweep = 0; sweep < most; ++sweep) {
    bool settled = true;
    for (const auto& pair : problem.contact)
      for (const int k : order) {
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
