// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "apps/report/report.h"

/// Results as files that ParaView opens: VTK XML, unstructured grids, appended raw data.
namespace bracket::apps {

/// The fields on the three parts of each cell, each part a triangle with points of its own, because stresses jump: a
/// linear, quadratic or Lagrange's triangle of the displacements' degree. All numbers are double.
/// Point data: displacement (x, y, 0); drawn, the way from each point to where pictures have it (deformed.h; single
/// precision); stress_displacement σ(u_h) and stress_equilibrated λ_h as symmetric tensors (xx, yy, zz, xy, yz, xz), zz
/// not a number where a stiffness of the plane does not tell it; of their mean von_mises (likewise) and
/// principal, the two principal stresses in the plane, the larger first. Cell data: body (index), indicator (the cell's
/// term of the gap identity, the same on its three parts) and indicator_density (that term by the area of the cell).
/// Field data: title, units, guarantee, energy (lower, upper), relative_error_bound, drawn_factor (by which drawn has
/// displacements and gaps magnified), body_names, pair_names,
/// quantity_names, quantities (lower, upper of each).
/// In space a cell has four parts, each a linear or quadratic tetrahedron, displacements three components, and all
/// three principal stresses are told.
template <int dim> std::string solution_vtu(const ReportOf<dim>& report);
template <> std::string solution_vtu(const Report& report);
template <> std::string solution_vtu(const ReportOf<3>& report);

/// Each contact facet, at its place on the first side, as lines so short that fields look as they are. Point data:
/// displacement of the first side, drawn, pressure (of λ_h), pressure_displacement (of σ(u_h) on the first side) and
/// gap (what u_h leaves of it, g − r). Cell data: pair (index) and indicator (the facet's, shared out). Field data: as
/// above. In space each is a quadratic triangle.
template <int dim> std::string contact_vtu(const ReportOf<dim>& report);
template <> std::string contact_vtu(const Report& report);
template <> std::string contact_vtu(const ReportOf<3>& report);

/// A script for ParaView that opens the collection beside it: bodies and contact lines where pictures have them,
/// coloured by von Mises stress and pressure.
template <int dim> std::string paraview_view(const ReportOf<dim>& report);

/// A ParaView collection of solution_k.vtu and, with a contact, contact_k.vtu of the levels k from `first` on, which
/// stand for time.
std::string collection_pvd(int first, int levels, bool contact);

}  // namespace bracket::apps
