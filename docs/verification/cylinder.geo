// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// A quarter of a thick cylinder, radii 1 and 2. gmsh -2 -format msh22 cylinder.geo -o cylinder.msh
h = 0.2;
Point(1) = {0, 0, 0, h};
Point(2) = {1, 0, 0, h};
Point(3) = {2, 0, 0, h};
Point(4) = {0, 2, 0, h};
Point(5) = {0, 1, 0, h};
Line(1) = {2, 3};
Circle(2) = {3, 1, 4};
Line(3) = {4, 5};
Circle(4) = {5, 1, 2};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
Physical Surface("cylinder") = {1};
Physical Curve("cylinder.x") = {1};
Physical Curve("cylinder.outer") = {2};
Physical Curve("cylinder.y") = {3};
Physical Curve("cylinder.bore") = {4};
