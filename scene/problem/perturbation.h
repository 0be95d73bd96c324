// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "scene/types.h"

/// Data beside those of a problem: what a quantity of interest is the derivative by (docs/theory.md §10).
namespace bracket::scene {

/// As many copies of a value as a facet has vertices.
template <int dim, class Value> std::array<Value, dim> at_vertices(const Value& value) {
  std::array<Value, dim> result;
  result.fill(value);
  return result;
}

/// The Bernstein coefficients of a quadratic on a facet: in the plane from its vertex 0 to its vertex 1; in space those
/// of the three vertices, then those of the edges, as Simplex<2>::edges has them.
template <int dim> using FacetQuadratic = std::array<double, (dim * (dim + 1)) / 2>;

/// A vector each of whose components is the exact sum of two doubles: a difference of two points is one.
template <int dim> struct TwofoldVector {
  Vector<dim> value = Vector<dim>::Zero();
  Vector<dim> rest = Vector<dim>::Zero();
  bool is_zero() const { return value.isZero(0) && rest.isZero(0); }
  bool operator==(const TwofoldVector&) const = default;
};
/// b − a   \pre no overflow
template <int dim> TwofoldVector<dim> difference(const Vector<dim>& a, const Vector<dim>& b);

/// Loads (F_q, P_q) and kinematics (U, U_n, ψ, ψ_t) on a first mesh, as exact as its own data and linear or quadratic
/// on its facets as those are. They make up the functional
///     J = ∫ F_q·u + ∫ P_q·u + ∫_Γu σn·U + ∫_Γ0 (σn)_n U_n − ∫_ΓK (p ψ + τ ψ_t).
/// P_q may act on Γ_τ, beside the supports' reactions on Γ_0 and beside the other side's p and τ on each side of Γ_K;
/// there in pairs, too, by which J is of r and v_t (scene/problem/law.h).
template <int dim> struct Perturbation {
  struct Facet {
    /// At the vertices, but on Γ_u: force per area, and in addition a pressure that acts against the facet's own
    /// normal.
    std::array<TwofoldVector<dim>, dim> traction = at_vertices<dim>(TwofoldVector<dim>{});
    std::array<double, dim> pressure = at_vertices<dim>(0.0);
    /// What is not linear of both, as FacetData has it.
    std::array<Vector<dim>, 2> higher_traction = {Vector<dim>(Vector<dim>::Zero()), Vector<dim>(Vector<dim>::Zero())};
    std::array<double, 2> higher_pressure = {0, 0};
    /// U at the vertices: on Γ_u as it is, on Γ_0 by its component U_n along FacetData::normal.
    std::array<TwofoldVector<dim>, dim> displacement = at_vertices<dim>(TwofoldVector<dim>{});
    std::array<double, dim> normal_displacement = at_vertices<dim>(0.0);  ///< on Γ_0 in addition
    bool operator==(const Facet&) const = default;
  };
  /// On a contact facet, seen from the first one.
  struct Contact {
    FacetQuadratic<dim> gap = {};  ///< of ψ, …
    FacetQuadratic<dim> slip =
        {};  ///< … and, planar, of ψ_t, of which friction sees what is left of v_t; in addition …
    std::array<TwofoldVector<dim>, dim> first =
        at_vertices<dim>(TwofoldVector<dim>{});  ///< … U·d, U·t of the first side
    std::array<TwofoldVector<dim>, dim> second = at_vertices<dim>(TwofoldVector<dim>{});  ///< less those of the second
    /// Forces per area along d on the first side, the opposite on the second: they do the work of r; …
    std::array<double, dim> opening = at_vertices<dim>(0.0);
    std::array<double, dim> shear = at_vertices<dim>(0.0);  ///< … planar, along t, of v_t; where there is friction only
    bool operator==(const Contact&) const = default;
  };
  std::vector<Vector<dim>> force;  ///< per volume, as Mesh::bodies
  std::vector<Facet> facets;       ///< as Mesh::boundary
  std::vector<Contact> contact;    ///< as Problem::contact
  std::vector<int> contact_of;     ///< of each facet, the contact of which it is the first side; −1: none
};

/// What has been added to the data of a problem: these times the loads and times the kinematics of a perturbation.
template <int dim> struct Perturbed {
  std::shared_ptr<const Perturbation<dim>> by;  ///< null: nothing
  double loads = 0;
  double kinematics = 0;
};

template <int dim> struct Problem;

/// The degree of what a perturbation loads a facet with.
template <int dim> int degree_of_load(const typename Perturbation<dim>::Facet& added);

/// No data, of the sizes of the problem's first mesh.
template <int dim> Perturbation<dim> no_perturbation(const Problem<dim>& problem);

/// The problem with these added to its data, rounded for the formulations, the gaps outward; what is meant are the
/// exact sums on the first mesh, by Problem::perturbed.
/// \pre the problem is not perturbed; the perturbation is of its first mesh
template <int dim>
Problem<dim> perturbed(const Problem<dim>& problem, std::shared_ptr<const Perturbation<dim>> by, double loads,
                       double kinematics);

}  // namespace bracket::scene
