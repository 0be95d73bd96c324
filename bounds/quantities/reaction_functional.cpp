// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "bounds/quantities/parts.h"

namespace bracket::bounds {

using scene::Enclosure;
using scene::Perturbation;
using scene::Problem;
using scene::Quantity;
using scene::Support;
using scene::Vector;

namespace {

/// Whether e has no component along n: exactly.
template <int dim> bool is_across(const Vector<dim>& e, const Vector<dim>& n) {
  for (int k = 0; k < dim; ++k)
    if (e[k] * n[k] != 0) return false;
  return true;
}

/// Whether a support can be moved by e although another boundary facet begins where it ends.
template <int dim>
bool goes_on(const scene::FacetData<dim>& part, const scene::FacetData<dim>& beside, const Vector<dim>& e) {
  const Vector<dim>& n = beside.normal;
  if (beside.support == Support::traction) return true;
  if (beside.support == Support::fixed) return false;
  if (part.support == Support::fixed) return is_across<dim>(e, n);
  return n != part.normal && n != -part.normal;
}

bool are_independent(const std::vector<Vector<3>>& directions) {
  std::vector<Vector<3>> before;
  for (const Vector<3>& d : directions) {
    if (is_known_along(d, before)) return false;
    before.push_back(d);
  }
  return true;
}

/// The weight is zero where so many sliding and touching facets meet that a vertex cannot follow the part and leave the
/// others: where their normals depend on each other.
/// \param own whether a facet is the part's   \param along_normals whether U is the normal of each
void let_go_where_crowded(const Problem<3>& first, const std::vector<char>& own, bool along_normals,
                          std::vector<double>& weight) {
  std::vector<std::vector<Vector<3>>> normals(weight.size()), beside(weight.size());
  for (std::size_t f = 0; f < own.size(); ++f) {
    const auto& data = first.facets[f];
    if (data.support != Support::sliding && data.support != Support::contact) continue;
    for (const int v : first.mesh.boundary[f].vertices) add_direction<3>(data.normal, (own[f] ? normals : beside)[v]);
  }
  for (std::size_t v = 0; v < weight.size(); ++v) {
    if (normals[v].empty() || (beside[v].empty() && !along_normals)) continue;
    std::vector<Vector<3>> all = normals[v];
    all.insert(all.end(), beside[v].begin(), beside[v].end());
    if (!are_independent(all)) weight[v] = 0;
  }
}

}  // namespace

template <int dim> Functionals<dim> reaction(const Problem<dim>& first, const Quantity<dim>& quantity) {
  const auto& mesh = first.mesh;
  const std::vector<int> facets = facets_of(first, quantity);
  std::vector<char> own(mesh.boundary.size(), 0);
  for (const int f : facets) {
    own[f] = 1;
    const Support support = first.facets[f].support;
    if (support != Support::fixed && support != Support::sliding)
      refuse(quantity, fmt::format("'{}' has no reaction: it is neither fixed nor sliding", quantity.of));
    if (support == Support::fixed && !quantity.direction && scene::normal(mesh, f) != scene::normal(mesh, facets[0]) &&
        first.facets[f].normal != first.facets[facets[0]].normal)
      refuse(quantity, fmt::format("the facets of '{}' have different normals; give a direction", quantity.of));
  }
  const auto direction = [&](int f) {
    return quantity.direction.value_or(first.facets[first.facets[f].support == Support::fixed ? facets[0] : f].normal);
  };
  std::vector<std::vector<int>> of_vertex(mesh.vertices.size());  // the part's facets there
  for (const int f : facets)
    for (const int v : mesh.boundary[f].vertices) of_vertex[v].push_back(f);
  std::vector<double> weight(mesh.vertices.size(), 1);
  for (std::size_t g = 0; g < mesh.boundary.size(); ++g) {
    if (own[g]) continue;
    for (const int v : mesh.boundary[g].vertices)
      for (const int f : of_vertex[v])
        if (!goes_on<dim>(first.facets[f], first.facets[g], direction(f))) weight[v] = 0;
  }
  if constexpr (dim == 3) let_go_where_crowded(first, own, !quantity.direction, weight);
  Perturbation<dim> perturbation = scene::no_perturbation(first);
  bool any = false, weighted = false;
  for (const int f : facets)
    for (int i = 0; i < dim; ++i) {
      const double w = weight[mesh.boundary[f].vertices[i]];
      perturbation.facets[f].displacement[i] = plain<dim>(w * direction(f));
      any = any || w != 0;
      weighted = weighted || w == 0;
    }
  if (!any)
    refuse(quantity, fmt::format("'{}' is one {} between supports: no weight that falls to zero at both ends is left; "
                                 "take a finer first mesh",
                                 quantity.of, facet_name<dim>));
  const Enclosure scale = quantity.direction ? size(*quantity.direction) : Enclosure(1);
  Functionals<dim> result = linear(std::move(perturbation), scale);
  result.weighted = weighted;
  return result;
}

template Functionals<2> reaction(const Problem<2>&, const Quantity<2>&);
template Functionals<3> reaction(const Problem<3>&, const Quantity<3>&);

}  // namespace bracket::bounds
