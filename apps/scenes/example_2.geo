// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// Two quadrilaterals that touch along the line from (1.25, 0) to (0.75, 1).
// Mesh: gmsh -2 -format msh22 example_2.geo
size = 0.3;
Point(1) = {0, 0, 0, size};
Point(2) = {1.25, 0, 0, size};
Point(3) = {0.75, 1, 0, size};
Point(4) = {0, 1, 0, size};
Point(5) = {1.25, 0, 0, size};
Point(6) = {2, 0, 0, size};
Point(7) = {2, 1, 0, size};
Point(8) = {0.75, 1, 0, size};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Line(5) = {5, 6};
Line(6) = {6, 7};
Line(7) = {7, 8};
Line(8) = {8, 5};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
Curve Loop(2) = {5, 6, 7, 8};
Plane Surface(2) = {2};
Physical Surface("slider") = {1};
Physical Surface("stop") = {2};
Physical Curve("slider.base") = {1};
Physical Curve("slider.slope") = {2};
Physical Curve("slider.left") = {4};
Physical Curve("stop.right") = {6};
Physical Curve("stop.slope") = {8};
