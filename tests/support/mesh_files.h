// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

/// Small mesh files as programs write them.
namespace bracket::tests {

/// Gmsh 4.1: a square, "block" with its "bottom", in two partitions. Curve 3 lies between them and has, as its group,
/// that of the surface.
extern const std::string gmsh_of_partitions;
/// Gmsh 2.2: a quadrilateral of second order and triangles, lines and a point in groups, at z = 5.
extern const std::string gmsh_of_second_order;
/// Gmsh 4.1: a surface and a curve in two groups, nodes with parameters.
extern const std::string gmsh_with_parameters;

/// Abaqus as Gmsh exports a rectangle of two squares with two physical surfaces and curves (Mesh.SaveAll = 1).
extern const std::string abaqus_of_gmsh;
/// As PrePoMax writes a part: capitals here and there, sets one to a line, generated and internal ones, surfaces by
/// side.
extern const std::string abaqus_of_prepomax;
/// As Abaqus/CAE writes an assembly: a rectangle that is there twice, the second time placed by the lines given.
std::string abaqus_of_cae(const std::string& placement);

/// A universal file as Salome writes a square: units, nodes, elements (one of them a spring), groups of elements and of
/// nodes.
extern const std::string unv_of_salome;
/// Two triangles of second order and a curved line, one of the triangles in no group.
extern const std::string unv_of_second_order;

}  // namespace bracket::tests
