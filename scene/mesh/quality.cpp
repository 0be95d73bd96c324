// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "scene/mesh/angles.h"
#include "scene/mesh/space/tetrahedron.h"
#include "scene/scene.h"

namespace bracket::scene {

template <int dim> double volume(const Mesh<dim>& mesh, int cell) {
  return volume<dim>(positions(mesh, mesh.cells[cell]));
}

template <int dim> double length(const Mesh<dim>& mesh, int facet) {
  return area_vector<dim>(positions(mesh, mesh.boundary[facet].vertices)).norm();
}

template <int dim> Vector<dim> normal(const Mesh<dim>& mesh, int facet) {
  const Vector<dim> outward = area_vector<dim>(positions(mesh, mesh.boundary[facet].vertices));
  return outward / outward.norm();
}

template <int dim> Quality quality(const Mesh<dim>& mesh) {
  Quality result;
  result.smallest_area = mesh.cells.empty() ? 0 : std::numeric_limits<double>::infinity();
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) {
    const double size = volume(mesh, static_cast<int>(cell));
    result.smallest_area = std::min(result.smallest_area, size);
    result.largest_area = std::max(result.largest_area, size);
    const auto corners = positions(mesh, mesh.cells[cell]);
    const auto include = [&](const auto& of_cell) {
      for (const double angle : of_cell) {
        result.smallest_angle = std::min(result.smallest_angle, angle);
        result.largest_angle = std::max(result.largest_angle, angle);
      }
    };
    if constexpr (dim == 2) include(angles(corners));
    if constexpr (dim == 3) {
      include(dihedral_angles(corners));
      result.smallest_shape = std::min(result.smallest_shape, shape(corners));
    }
  }
  return result;
}

template <int dim> std::vector<double> flatness(const Mesh<dim>& mesh) {
  std::vector<double> result;
  for (const auto& cell : mesh.cells) {
    const auto x = positions(mesh, cell);
    double longest = 0, largest = 0;  // edge, and facet: by its height, dim times the volume
    for (const auto& [i, j] : Simplex<dim>::edges) longest = std::max(longest, (x[j] - x[i]).norm());
    for (const auto& facet : Simplex<dim>::facets) {
      std::array<Vector<dim>, dim> corners;
      for (int k = 0; k < dim; ++k) corners[k] = x[facet[k]];
      largest = std::max(largest, area_vector<dim>(corners).norm());
    }
    result.push_back(longest * largest / (dim * volume<dim>(x) * std::sqrt(dim - 1.0)));
  }
  return result;
}

double common_flatness(std::vector<double> flatness) {
  if (flatness.empty()) return 0;
  const auto at = flatness.begin() + static_cast<std::ptrdiff_t>((flatness.size() - 1) / 100);
  std::ranges::nth_element(flatness, at, std::greater<>());
  return *at;
}

template std::vector<double> flatness(const Mesh<2>&);
template std::vector<double> flatness(const Mesh<3>&);
template double volume(const Mesh<2>&, int);
template double volume(const Mesh<3>&, int);
template double length(const Mesh<2>&, int);
template double length(const Mesh<3>&, int);
template Vector<2> normal(const Mesh<2>&, int);
template Vector<3> normal(const Mesh<3>&, int);
template Quality quality(const Mesh<2>&);
template Quality quality(const Mesh<3>&);

}  // namespace bracket::scene
