// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/problem/tolerance.h"

#include <algorithm>
#include <limits>

namespace bracket::scene {

template <int dim> double tolerance(const Mesh<dim>& mesh, int facet) {
  const auto x = positions(mesh, mesh.boundary[facet].vertices);
  double size = 0, length = std::numeric_limits<double>::infinity();
  for (const Vector<dim>& vertex : x) size = std::max(size, vertex.template lpNorm<Eigen::Infinity>());
  for (const auto& [i, k] : Simplex<dim - 1>::edges) length = std::min(length, (x[k] - x[i]).norm());
  const double of_doubles = 8 * std::numeric_limits<double>::epsilon() * size;
  const double of_digits = std::min(16 * mesh.coordinate_rounding * size, 1e-3 * length);
  return std::max({1e-6 * length, of_doubles, of_digits});
}

template double tolerance(const Mesh<2>&, int);
template double tolerance(const Mesh<3>&, int);

}  // namespace bracket::scene
