// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "scene/scene.h"

/// Where the deformed bodies are drawn. Displacements are magnified, and a picture that magnified nothing else would
/// show bodies that touch as overlapping or apart, wherever a gap was given or drawn. So gaps are magnified as well:
/// with the factor m, a gap g and sides that lie at a distance c (along d) on the mesh, the first side of a pair is
/// drawn shifted by (c − m g) d. What is drawn between the sides then is, along d, m (g − r): nothing where contact is
/// closed, never less, and what is left of the gap in the measure of the displacements elsewhere. A wall is drawn at m
/// g in front of the side as it was. The shift of the sides goes on smoothly into their bodies (docs/report.md).
namespace bracket::apps {

template <int dim> struct DrawnShapeOf {
  double factor = 1;  ///< m
  /// Of Mesh::vertices: the shift, continuous, linear on cells: harmonic but for contact, fixed and sliding facets.
  std::vector<scene::Vector<dim>> shift;
  /// Of Mesh::boundary: what is still to be added along FacetData::normal on a facet of a contact, by Bernstein
  /// coefficients in the order of scene/on_facet.h, so that the shift is exact there; zero elsewhere.
  std::vector<scene::FacetQuadratic<dim>> beside;
};
using DrawnShape = DrawnShapeOf<2>;

/// A factor of two digits: displacements are drawn as at most 6 % of the length scale and gaps, unless that would make
/// it less than 1, as at most 12 %.
template <int dim>
double magnification(const scene::Problem<dim>& problem, const scene::Displacement<dim>& displacement);

template <int dim> DrawnShapeOf<dim> drawn_shape(const scene::Problem<dim>& problem, double factor);

// Planar, all that follows.

/// What DrawnShape::beside is at t of a boundary facet.
scene::Vector<2> beside(const scene::Problem<2>& problem, const DrawnShape& shape, int facet, double t);

/// A boundary facet at t, 0 at its vertex 0 and 1 at its vertex 1, as it is drawn.
/// \param displacement nothing: before any deformation, gaps magnified all the same
scene::Vector<2> drawn_on_facet(const scene::Problem<2>& problem, const scene::Displacement<2>* displacement,
                                const DrawnShape& shape, int facet, double t);

/// What the first side of a contact touches, opposite to t on that side: its second side, or the wall.
scene::Vector<2> drawn_opposite(const scene::Problem<2>& problem, const scene::Displacement<2>* displacement,
                                const DrawnShape& shape, const scene::ContactFacet& contact, double t);

/// A point of a cell away from the facets of contacts.
scene::Vector<2> drawn_in_cell(const scene::Problem<2>& problem, const scene::Displacement<2>& displacement,
                               const DrawnShape& shape, int cell, const std::array<double, 3>& point);

}  // namespace bracket::apps
