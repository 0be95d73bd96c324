// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/certificate/space/supports.h"

#include "bounds/certificate/space/exact_rank.h"

namespace bracket::bounds::space {

using scene::Support;

namespace {

/// What a perturbation adds at the vertices of a facet of the first mesh, of which some are another's that is fixed.
Added added_at(const scene::Problem<3>& problem, const std::array<FacetCorner, 3>& ends) {
  const auto& [by, loads, kinematics] = problem.perturbed;
  if (!by || kinematics == 0) return {};
  Added added{{}, {0, 0, 0}, kinematics};
  for (int i = 0; i < 3; ++i) {
    added.end[i] = by->facets[ends[i].facet].displacement[ends[i].corner];
    added.normal[i] = by->facets[ends[i].facet].normal_displacement[ends[i].corner];
  }
  return added;
}

}  // namespace

std::vector<FacetCorner> fixed_vertices(const scene::Problem<3>& first) {
  std::vector<FacetCorner> fixed(first.mesh.vertices.size());
  for (std::size_t f = 0; f < first.facets.size(); ++f)
    for (int i = 0; i < 3 && first.facets[f].support == Support::fixed; ++i)
      fixed[first.mesh.boundary[f].vertices[i]] = {static_cast<int>(f), i};
  return fixed;
}

std::array<Slide, 3> slides_of(const scene::Problem<3>& problem, const std::vector<FacetCorner>& fixed, int facet) {
  const auto [of, corner] = scene::piece_of_facet(problem, facet);
  const scene::Problem<3>& first = scene::first_of(problem);
  Slide slide{first.facets[of].normal, first.facets[of].normal_displacement};
  std::array<FacetCorner, 3> ends;
  for (int i = 0; i < 3; ++i) {
    const FacetCorner& held = fixed[first.mesh.boundary[of].vertices[i]];
    slide.fixed[i] = held.facet >= 0;
    if (slide.fixed[i]) slide.displacement[i] = first.facets[held.facet].displacement[held.corner];
    ends[i] = slide.fixed[i] ? held : FacetCorner{of, i};
  }
  slide.added = added_at(problem, ends);
  std::array<Slide, 3> slides = {slide, slide, slide};
  for (int i = 0; i < 3; ++i) slides[i].at = corner[i];
  return slides;
}

std::array<Prescribed, 3> holds_of(const scene::Problem<3>& problem, int facet) {
  const auto [of, corner] = scene::piece_of_facet(problem, facet);
  std::array<Prescribed, 3> holds;
  const Added added = added_at(problem, {FacetCorner{of, 0}, FacetCorner{of, 1}, FacetCorner{of, 2}});
  for (int i = 0; i < 3; ++i) holds[i] = {scene::first_of(problem).facets[of].displacement, corner[i], added};
  return holds;
}

std::array<int, 6> nodes_of_facet(const scene::Mesh<3>& mesh, int facet) {
  const auto& vertices = mesh.boundary[facet].vertices;
  const auto edges = scene::facet_edges(mesh, mesh.boundary[facet]);
  std::array<int, 6> nodes;
  for (int k = 0; k < 3; ++k) {
    nodes[k] = vertices[k];
    nodes[3 + k] = node_of_edge(mesh, edges[k]);
  }
  return nodes;
}

int node_across(const scene::Mesh<3>& mesh, const scene::ContactFacetOf<3>& pair, int k) {
  if (pair.second < 0) return -1;
  const auto nodes = nodes_of_facet(mesh, pair.second);
  if (k < 3) return nodes[pair.meets[k]];
  const auto& [a, b] = scene::Simplex<2>::edges[k - 3];
  return nodes[3 + scene::Simplex<2>::edge_between(pair.meets[a], pair.meets[b])];
}

namespace {

/// Adds a normal to a support unless it depends on those that are there.
void add_slide(NodeSupport& node, const Slide& slide) {
  if (node.fixed || node.slides == 3) return;
  std::vector<Row> rows;
  for (int k = 0; k < node.slides; ++k) {
    if (node.slide[k].normal == slide.normal || node.slide[k].normal == -slide.normal) return;
    rows.push_back(exact_row(node.slide[k].normal));
  }
  rows.push_back(exact_row(slide.normal));
  if (rows.size() == 1 || rank(rows) == static_cast<int>(rows.size())) node.slide[node.slides++] = slide;
}

}  // namespace

NodeSupports node_supports(const scene::Problem<3>& problem, const std::vector<FacetCorner>& fixed) {
  const auto& mesh = problem.mesh;
  NodeSupports result{{}, std::vector<int>(mesh.vertices.size() + mesh.edges.size(), -1)};
  const auto at = [&](int node) -> NodeSupport& {
    if (result.of_node[node] < 0) {
      result.of_node[node] = static_cast<int>(result.support.size());
      result.support.emplace_back();
    }
    return result.support[result.of_node[node]];
  };
  for (const Support kind : {Support::fixed, Support::sliding})
    for (int f = 0; f < static_cast<int>(problem.facets.size()); ++f) {
      if (problem.facets[f].support != kind) continue;
      const auto nodes = nodes_of_facet(mesh, f);
      if (kind == Support::fixed) {
        const auto held = holds_of(problem, f);
        for (int k = 0; k < 6; ++k) {
          at(nodes[k]).fixed = true;
          at(nodes[k]).held = k < 3 ? held[k] : Prescribed{};
        }
        continue;
      }
      const auto slides = slides_of(problem, fixed, f);
      for (int k = 0; k < 6; ++k) {
        Slide linear;  // along an edge, too
        linear.normal = slides[0].normal;
        add_slide(at(nodes[k]), k < 3 ? slides[k] : linear);
      }
    }
  return result;
}

}  // namespace bracket::bounds::space
