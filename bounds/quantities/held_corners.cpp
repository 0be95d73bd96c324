// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/quantities/parts.h"
#include "bounds/quantities/weights.h"

namespace bracket::bounds {

using scene::Support;
using scene::Vector;

template <int dim> std::vector<std::array<bool, std::size_t{dim}>> held_corners(const scene::Problem<dim>& problem) {
  const auto& mesh = problem.mesh;
  std::vector<char> fixed(mesh.vertices.size(), 0);
  std::vector<std::vector<Vector<dim>>> known(mesh.vertices.size());
  for (std::size_t f = 0; f < problem.facets.size(); ++f)
    for (const int v : mesh.boundary[f].vertices) {
      if (problem.facets[f].support == Support::fixed) fixed[v] = 1;
      if (problem.facets[f].support == Support::sliding) add_direction<dim>(problem.facets[f].normal, known[v]);
    }
  const auto held = [&](int vertex, const Vector<dim>& d) { return fixed[vertex] || is_known_along(d, known[vertex]); };
  std::vector<std::array<bool, dim>> result;
  for (const auto& pair : problem.contact) {
    const Vector<dim>& d = problem.facets[pair.first].normal;
    std::array<bool, dim>& both = result.emplace_back();
    for (int i = 0; i < dim; ++i)
      both[i] = held(mesh.boundary[pair.first].vertices[i], d) &&
                (pair.second < 0 || held(mesh.boundary[pair.second].vertices[pair.meets[i]], d));
  }
  return result;
}

template std::vector<std::array<bool, 2>> held_corners(const scene::Problem<2>&);
template std::vector<std::array<bool, 3>> held_corners(const scene::Problem<3>&);

}  // namespace bracket::bounds
