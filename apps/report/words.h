// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>

#include "scene/scene.h"

/// What things are called in the plane and in space, in texts and, where it is a key, in files.
namespace bracket::apps {

template <int dim> struct Words;
template <> struct Words<2> {
  static constexpr const char *cells = "triangles", *facet = "edge", *facets = "edges";
  static constexpr const char* size = "area";       ///< of cells and bodies
  static constexpr const char* measure = "length";  ///< of facets and parts of the boundary
};
template <> struct Words<3> {
  static constexpr const char *cells = "tetrahedra", *facet = "face", *facets = "faces";
  static constexpr const char *size = "volume", *measure = "area";
};

/// The names of coordinates.
inline constexpr std::array<const char*, 3> axis_names = {"x", "y", "z"};

/// "plane strain", "plane stress" or "three dimensions".
template <int dim> std::string setting_of(const scene::Scene<dim>& scene) {
  return dim == 3 ? "three dimensions" : "plane " + name(scene.plane);
}

}  // namespace bracket::apps
