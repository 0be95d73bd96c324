// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// Cook's membrane. Mesh: gmsh -2 -format msh41 cook.geo
size = 3;
Point(1) = {0, 0, 0, size};
Point(2) = {48, 44, 0, size};
Point(3) = {48, 60, 0, size};
Point(4) = {0, 44, 0, size};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
Physical Surface("membrane") = {1};
Physical Curve("clamped") = {4};
Physical Curve("loaded") = {2};
