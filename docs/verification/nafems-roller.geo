// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// Half of a roller of radius 50 on half of a block of 200 by 200, finer where they touch.
// gmsh -2 -format msh22 nafems-roller.geo -o nafems-roller.msh
fine = 1.5;
coarse = 14;
Point(1) = {0, 0, 0, fine};
Point(2) = {100, 0, 0, coarse};
Point(3) = {100, -200, 0, 2 * coarse};
Point(4) = {0, -200, 0, 2 * coarse};
Point(5) = {12, 0, 0, fine};
Line(1) = {1, 4};
Line(2) = {4, 3};
Line(3) = {3, 2};
Line(4) = {2, 5};
Line(5) = {5, 1};
Curve Loop(1) = {1, 2, 3, 4, 5};
Plane Surface(1) = {1};
Point(11) = {0, 0, 0, fine};
Point(12) = {0, 50, 0, coarse};
Point(13) = {0, 100, 0, coarse};
Point(14) = {50, 50, 0, coarse};
Point(15) = {50 * Sin(0.24), 50 - 50 * Cos(0.24), 0, fine};
Circle(11) = {11, 12, 15};
Circle(12) = {15, 12, 14};
Line(13) = {14, 12};
Line(14) = {12, 11};
Curve Loop(2) = {11, 12, 13, 14};
Plane Surface(2) = {2};
Physical Surface("block") = {1};
Physical Surface("roller") = {2};
Physical Curve("block.axis") = {1};
Physical Curve("block.bottom") = {2};
Physical Curve("block.contact") = {5};
Physical Curve("roller.contact") = {11};
Physical Curve("roller.top") = {13};
Physical Curve("roller.axis") = {14};
