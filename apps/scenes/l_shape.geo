// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// An L, finer at its re-entrant corner. Mesh: gmsh -2 -format msh22 l_shape.geo
coarse = 0.15;
fine = 0.01;
Point(1) = {-1, -1, 0, coarse};
Point(2) = {0, -1, 0, coarse};
Point(3) = {0, 0, 0, fine};
Point(4) = {1, 0, 0, coarse};
Point(5) = {1, 1, 0, coarse};
Point(6) = {-1, 1, 0, coarse};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 5};
Line(5) = {5, 6};
Line(6) = {6, 1};
Curve Loop(1) = {1, 2, 3, 4, 5, 6};
Plane Surface(1) = {1};
Physical Surface("bracket") = {1};
Physical Curve("foot") = {1};
Physical Curve("arm") = {4};
