// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/certificate/supports.h"

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

VertexSupport own_part(VertexSupport support) {
  support.held.added.factor = 0;
  for (Slide& slide : support.slide) slide.added.factor = 0;
  return support;
}

VertexSupport added_part(VertexSupport support) {
  support.held.end = {Vector<2>::Zero(), Vector<2>::Zero()};
  support.held.added.factor = 1;
  for (Slide& slide : support.slide) {
    slide.end = {0, 0};
    slide.displacement = support.held.end;
    slide.added.factor = 1;
  }
  return support;
}

}  // namespace bracket::bounds
