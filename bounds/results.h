// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <type_traits>

#include "bounds/estimate/estimate.h"

/// What one asks of a solved problem: the `problem`, `displacement` and `stress` of an Outcome. All of it is computed
/// from the fields u_h and λ_h as they are, exactly but for rounding, and none of it is guaranteed: guaranteed are
/// Outcome::lower and upper, and that the fields are within the error bound in the energy norm. Forces are those of
/// λ_h, which is in equilibrium: on each body reactions, contact forces and loads add up to zero, on every mesh. They
/// are per thickness, in the units of the scene.
namespace bracket::bounds {

/// In the plane a number, counter-clockwise.
template <int dim> using Moment = std::conditional_t<dim == 2, double, scene::Vector<3>>;

/// A force and its moment about `about`. In the plane, where there is a force it acts along a line through
/// about + moment · (f_y, −f_x) / |f|².
template <int dim> struct Resultant {
  scene::Vector<dim> force = scene::Vector<dim>::Zero();
  Moment<dim> moment = scene::zero_value<Moment<dim>>();
  scene::Vector<dim> about = scene::Vector<dim>::Zero();
};

/// ∫ λ_h n over a boundary part: what acts there on its body. Of a part that is fixed or slides it is the reaction.
/// \throw scene::Error (input) if the mesh has no such part
template <int dim>
Resultant<dim> resultant(const scene::Problem<dim>& problem, const scene::Stress<dim>& stress, const std::string& part,
                         const scene::Vector<dim>& about = scene::Vector<dim>::Zero());

/// A contact pair by the pressure p of λ_h, which is contact_pressure(): exactly 0 where nothing presses.
template <int dim> struct ContactResult {
  Resultant<dim> resultant;  ///< ∫ −p d: what acts on the body of the first side; on the second the opposite does
  double largest_pressure = 0;
  scene::Vector<dim> at = scene::Vector<dim>::Zero();  ///< a vertex with that pressure; 0 where nothing presses
  double length = 0;                                   ///< of the first side; in space areas, this and the next
  double pressed_length = 0;                           ///< of the facets on which p > 0 somewhere
};
/// \param pair index into Scene::contact
/// \throw scene::Error (input) if the problem has no such pair
template <int dim>
ContactResult<dim> contact_result(const scene::Problem<dim>& problem, const scene::Stress<dim>& stress, int pair,
                                  const scene::Vector<dim>& about = scene::Vector<dim>::Zero());

/// The longest of the displacements u_h at the vertices and midpoints of edges.
template <int dim> struct LargestDisplacement {
  scene::Vector<dim> displacement = scene::Vector<dim>::Zero();
  scene::Vector<dim> at = scene::Vector<dim>::Zero();
};
template <int dim>
LargestDisplacement<dim> largest_displacement(const scene::Problem<dim>& problem,
                                              const scene::Displacement<dim>& displacement);

/// The fields at a point of a cell. Stresses jump from cell to cell, λ_h also between the parts of a cell.
template <int dim> struct PointValues {
  int cell;
  scene::Vector<dim> displacement;
  scene::Voigt<dim> displacement_stress;  ///< σ(u_h)
  scene::Voigt<dim> stress;               ///< λ_h
};
/// The values at x, from the first in Mesh::cells of the cells that hold it, within the rounding of coordinates: where
/// bodies touch, from the one that comes first in Mesh::bodies. Looks through all cells.
/// \return none outside all bodies
template <int dim>
std::optional<PointValues<dim>> values_at(const scene::Problem<dim>& problem,
                                          const scene::Displacement<dim>& displacement,
                                          const scene::Stress<dim>& stress, const scene::Vector<dim>& x);

}  // namespace bracket::bounds
