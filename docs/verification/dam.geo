// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// A triangular dam of unit height, its crest at the origin. gmsh -2 -format msh22 dam.geo -o dam.msh
h = 0.25;
Point(1) = {0, 0, 0, h};
Point(2) = {0, -1, 0, h};
Point(3) = {1, -1, 0, h};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 1};
Curve Loop(1) = {1, 2, 3};
Plane Surface(1) = {1};
Physical Surface("dam") = {1};
Physical Curve("dam.water") = {1};
Physical Curve("dam.base") = {2};
Physical Curve("dam.slope") = {3};
