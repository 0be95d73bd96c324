// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "scene/function.h"
#include "scene/material.h"
#include "scene/mesh/mesh.h"
#include "scene/problem/perturbation.h"

/// The problem: data that both formulations carry exactly.
namespace bracket::scene {

enum class Support {
  traction,  ///< Γ_τ: traction prescribed (zero: free)
  fixed,     ///< Γ_u: displacement prescribed
  sliding,   ///< Γ_0: normal displacement prescribed, no shear
  contact    ///< Γ_K
};

/// The data of one boundary facet, at its vertices, linear between; loads have more beside.
template <int dim> struct FacetData {
  Support support = Support::traction;
  /// The direction of sliding and contact: the unit outward normal, one and the same to the last bit for all
  /// facets of the scene whose normals agree, up to sign, within 1e-6 rad (rounding of coordinates, not geometry; on a
  /// fine arc less, see scene/normals.h). So facets that meet continue each other where their normals are equal, and
  /// form a corner where they are not. The mesh's own normal() differs by that rounding; it belongs in Cauchy's λn.
  Vector<dim> normal = Vector<dim>::Zero();
  std::array<Vector<dim>, dim> traction = at_vertices<dim>(Vector<dim>(Vector<dim>::Zero()));
  /// In addition to `traction`. It acts against the facet's own outward normal, whatever `normal` is: so a uniform
  /// pressure on a closed contour is in balance, however its nodes were rounded.
  std::array<double, dim> pressure = at_vertices<dim>(0.0);
  /// In the plane, in addition to both what is not linear, from vertex 0 to 1: the coefficients of Legendre's
  /// polynomials P_2 and P_3 along the facet, which are 1 at vertex 1. They have neither a resultant nor a moment.
  std::array<Vector<dim>, 2> higher_traction = {Vector<dim>(Vector<dim>::Zero()), Vector<dim>(Vector<dim>::Zero())};
  std::array<double, 2> higher_pressure = {0, 0};
  /// In addition, per unit of the facet's parameter: see Correction.
  std::array<Vector<dim>, dim> correction = at_vertices<dim>(Vector<dim>(Vector<dim>::Zero()));
  std::array<Vector<dim>, dim> displacement = at_vertices<dim>(Vector<dim>(Vector<dim>::Zero()));
  std::array<double, dim> normal_displacement = at_vertices<dim>(0.0);  ///< along `normal`
};
/// Whether the facet carries a load: it belongs to Γ_τ, or to Γ_0 or Γ_K in a perturbed problem.
template <int dim> bool is_loaded(const FacetData<dim>& data);
/// The degree of what is given as its traction and pressure: 1, 2 or 3.
template <int dim> int degree_of_load(const FacetData<dim>& data);
/// Their values at a place, 0 at vertex 0 and 1 at vertex 1.
template <int dim> Vector<dim> traction_at(const FacetData<dim>& data, double t);
template <int dim> double pressure_at(const FacetData<dim>& data, double t);

/// The last vertex of a facet first.
template <int dim> constexpr std::array<int, std::size_t{dim}> backwards() {
  std::array<int, dim> result{};
  for (int i = 0; i < dim; ++i) result[i] = dim - 1 - i;
  return result;
}

/// What the sides of a contact facet do to each other (docs/theory.md §11): by default they press and slide freely.
/// Values are those at vertices 0 and 1 of the first facet, linear between.
struct FacetLaw {
  bool two_sided = false;                  ///< they do not lift off: r = g in place of r ≤ g, p of either sign
  std::array<double, 2> modulus = {0, 0};  ///< k of springs between them, force per area and length: p = k (r − g), the
                                           ///< unilateral ones not below zero; zero at both vertices: rigid
  std::array<double, 2> friction = {0, 0};  ///< g_T, the largest shear, force per area (Tresca)
  /// Coulomb's μ, of which `friction` is one step: a bound of the shear by some pressure, frozen. Neither formulation
  /// nor the certificate asks for it.
  double coulomb = 0;
};
inline bool has_springs(const FacetLaw& law) { return law.modulus[0] > 0; }
/// Whether there may be shear; where `friction` is zero at both vertices, of a step of Coulomb's, there is none.
inline bool has_friction(const FacetLaw& law) { return law.friction[0] > 0 || law.friction[1] > 0 || law.coulomb > 0; }

/// One facet of a contact pair and what it touches. The facets of a pair coincide; the second runs the other way. Where
/// vertices of the two lie on each other they have the same coordinates to the last bit.
template <int dim> struct ContactFacetOf {
  int pair;    ///< index into Scene::contact
  int first;   ///< index into Mesh::boundary; its FacetData::normal is d
  int second;  ///< likewise, its normal is −d; −1: a rigid wall
  /// Of two quadratics between which the gap lies: displacements keep to the lower, the lower bound pays for the upper.
  /// They differ by rounding only where the gap is a quadratic on the facet of the first mesh.
  FacetQuadratic<dim> lower, upper;
  FacetLaw law = {};  ///< in space only `two_sided` counts
  /// Which vertex of the second facet lies on vertex i of the first; in the plane always 1 and 0.
  std::array<int, dim> meets = backwards<dim>();
  /// Planar: what friction does not see of v_t: it acts on v_t less this quadratic, likewise. On the first mesh it is
  /// that of a prescribed jump, exactly; on others, and in a perturbed problem, rounded.
  FacetQuadratic<dim> slip = {};
};
using ContactFacet = ContactFacetOf<2>;
/// Planar: the value of a quadratic with these Bernstein coefficients at the middle of its facet.
inline double at_middle(const std::array<double, 3>& gap) { return 0.5 * (gap[1] + 0.5 * (gap[0] + gap[2])); }

/// A gap that is no quadratic on a facet of the first mesh: each mesh encloses it anew.
template <int dim> struct GivenGap {
  Function<dim> function;  ///< on the first side; empty: the gap is the quadratic of the contact facet
  /// At the facet's ends, where the displacements of both sides are prescribed: their approach, which the lower gap has
  /// to admit, and by how much the gap was raised to it, quadratically from the other end.
  std::array<double, dim> at_least = at_vertices<dim>(-std::numeric_limits<double>::infinity());
  std::array<double, dim> raised = at_vertices<dim>(0.0);
  std::string where = {};
};

/// By how much fixing the data on the mesh moved the given functions: largest difference by largest value.
struct Oscillation {
  double traction = 0;
  double displacement = 0;
  double gap = 0;
};

/// What the loads lack of balance, taken off as a multiple of a load on a facet of the first mesh (at its vertices,
/// linear between, per unit of its parameter). The multiples are the real numbers by which the loads balance exactly;
/// FacetData::correction holds them rounded.
template <int dim> struct Correction {
  int facet;
  std::array<Vector<dim>, dim> unit;
};

/// A simplex that refinement cut from one of the first mesh: its vertices in barycentric coordinates 1 … d of that one.
/// They are multiples of a power of two, of at most 52 binary places, so that they and their differences are exact.
template <int d> struct Piece {
  int of;
  std::array<std::array<double, d>, d + 1> corner;
};

template <int dim> struct Problem;

/// Where a mesh comes from. Midpoints are rounded where they become coordinates, data where they become numbers; what
/// is meant is the first mesh's cells, facets and data, cut exactly. So all meshes of a run carry one problem.
template <int dim> struct Origin {
  std::shared_ptr<const Problem<dim>> first;  ///< the problem on the first mesh; null: this is the first
  std::vector<Piece<dim>> cells;              ///< as Mesh::cells; empty on the first mesh, so below
  std::vector<Piece<dim - 1>> facets;         ///< as Mesh::boundary
};
/// The piece that a cell or facet of the first mesh is of itself.
template <int d> Piece<d> whole(int of) {
  Piece<d> piece{of, {}};
  for (int i = 0; i < d; ++i) piece.corner[i + 1][i] = 1;
  return piece;
}

/// A scene on a mesh. One fixed problem of which the two formulations compute bounds; refinement inherits it. Whoever
/// changes a problem by hand does so on its first mesh.
template <int dim> struct Problem {
  Mesh<dim> mesh;
  std::vector<Body<dim>> bodies;       ///< as Mesh::bodies
  std::vector<FacetData<dim>> facets;  ///< as Mesh::boundary
  std::vector<ContactFacetOf<dim>> contact;
  std::vector<GivenGap<dim>> gaps;  ///< of each contact facet of the first mesh; empty: all are quadratics
  bool sampled = false;             ///< some function is known at points only: between them the data are a guess
  Oscillation oscillation;
  double length_scale = 1;                   ///< diameter of the bounding box
  std::vector<Correction<dim>> corrections;  ///< of the first mesh's loads, as long as there are motions that nothing
                                             ///< holds; see bounds::balanced()
  double imbalance = 0;                      ///< the largest of the corrections' resultants by the size of all loads
  std::vector<char> carries;  ///< of each contact pair, where there are corrections: whether the loads need
                              ///< its pressure
  Origin<dim> origin;
  Perturbed<dim> perturbed;  ///< what the data are beside those of the scene; then `origin` has the first problem
};

/// What a cell is made of.
template <int dim> const Body<dim>& body_of(const Problem<dim>& problem, int cell) {
  return problem.bodies[problem.mesh.cell_body[cell]];
}

/// The problem on the first mesh.
template <int dim> const Problem<dim>& first_of(const Problem<dim>& problem) {
  return problem.origin.first ? *problem.origin.first : problem;
}
template <int dim> Piece<dim> piece_of_cell(const Problem<dim>& problem, int cell) {
  return problem.origin.first ? problem.origin.cells[cell] : whole<dim>(cell);
}
template <int dim> Piece<dim - 1> piece_of_facet(const Problem<dim>& problem, int facet) {
  return problem.origin.first ? problem.origin.facets[facet] : whole<dim - 1>(facet);
}

/// Of each facet, the contact of which it is the first side: index into Problem::contact, −1: none.
template <int dim> std::vector<int> contacts_by_first(const Problem<dim>& problem);

/// What is linear of the loads on a facet of Γ_τ, and of Γ_K in a perturbed problem, all kinds added up, at its
/// vertices, per unit of its parameter (traction · length, in space · area). It has their resultant and moment.
template <int dim> std::array<Vector<dim>, std::size_t{dim}> load(const Problem<dim>& problem, int facet);
/// What they have beside it likewise: the coefficients of Legendre's polynomials P_2 and P_3.
template <int dim> std::array<Vector<dim>, 2> higher_load(const Problem<dim>& problem, int facet);
/// The largest degree of the loads, of those of a perturbation, too: stresses of a lower degree cannot carry them.
template <int dim> int degree_of_loads(const Problem<dim>& problem);

}  // namespace bracket::scene
