// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "scene/material.h"
#include "scene/mesh/mesh.h"

/// The problem: data that both formulations carry exactly.
namespace bracket::scene {

enum class Support {
  traction,  ///< Γ_τ: traction prescribed (zero: free)
  fixed,     ///< Γ_u: displacement prescribed
  sliding,   ///< Γ_0: normal displacement prescribed, no shear
  contact    ///< Γ_K
};

/// The data of one boundary facet, at its vertices, linear between.
template <int dim> struct FacetData {
  Support support = Support::traction;
  /// The direction of sliding, pressure and contact: the unit outward normal, one and the same to the last bit for all
  /// facets of the scene whose normals agree, up to sign, within 1e-6 rad (rounding of coordinates, not geometry; on a
  /// fine arc less, see scene/normals.h). So facets that meet continue each other where their normals are equal, and
  /// form a corner where they are not. The mesh's own normal() differs by that rounding; it belongs in Cauchy's λn.
  Vector<dim> normal = Vector<dim>::Zero();
  std::array<Vector<dim>, dim> traction = {Vector<dim>::Zero(), Vector<dim>::Zero()};
  std::array<Vector<dim>, dim> displacement = {Vector<dim>::Zero(), Vector<dim>::Zero()};
  std::array<double, dim> normal_displacement = {0, 0};  ///< along `normal`
};
/// Whether a traction is prescribed on the facet that is not zero.
template <int dim> bool is_loaded(const FacetData<dim>& data);

/// One facet of a contact pair and what it touches. The facets of a pair coincide; the second runs the other way, so
/// that vertex 0 of the first lies on vertex 1 of the second, with the same coordinates to the last bit.
struct ContactFacet {
  int pair;                   ///< index into Scene::contact
  int first;                  ///< index into Mesh::boundary; its FacetData::normal is d
  int second;                 ///< likewise, its normal is −d; −1: a rigid wall
  std::array<double, 3> gap;  ///< at the first facet's vertices 0 and 1 and at its midpoint; quadratic between
};

/// By how much fixing the data on the mesh moved the given functions: largest difference by largest value.
struct Oscillation {
  double traction = 0;
  double displacement = 0;
  double gap = 0;
};

/// A scene on a mesh. One fixed problem of which the two formulations compute bounds; refinement inherits it.
template <int dim> struct Problem {
  Mesh<dim> mesh;
  std::vector<Body<dim>> bodies;           ///< as Mesh::bodies
  std::vector<FacetData<dim>> facets;      ///< as Mesh::boundary
  std::vector<ContactFacet> contact;
  Oscillation oscillation;
  double length_scale = 1;  ///< diameter of the bounding box
};

}  // namespace bracket::scene
