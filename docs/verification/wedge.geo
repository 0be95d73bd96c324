// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// A wedge that points down. gmsh -2 -format msh22 wedge.geo -o wedge.msh
h = 0.4;
Point(1) = {0, 0, 0, h};
Point(2) = {1, 1, 0, h};
Point(3) = {-1, 1, 0, h};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 1};
Curve Loop(1) = {1, 2, 3};
Plane Surface(1) = {1};
Physical Surface("wedge") = {1};
Physical Curve("wedge.right") = {1};
Physical Curve("wedge.top") = {2};
Physical Curve("wedge.left") = {3};
