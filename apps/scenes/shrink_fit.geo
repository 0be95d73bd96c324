// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// A quarter of two rings. The circle on which they touch is there twice, once for each ring, with equal divisions: the
// bodies must not share nodes. Mesh: gmsh -2 -format msh41 shrink_fit.geo
n = 32;  // edges along the contact
Point(1) = {0, 0, 0};
Point(11) = {20, 0, 0};  // the bush
Point(12) = {30, 0, 0};
Point(13) = {0, 30, 0};
Point(14) = {0, 20, 0};
Line(11) = {11, 12};
Circle(12) = {12, 1, 13};
Line(13) = {13, 14};
Circle(14) = {14, 1, 11};
Point(21) = {30, 0, 0};  // the hub
Point(22) = {50, 0, 0};
Point(23) = {0, 50, 0};
Point(24) = {0, 30, 0};
Line(21) = {21, 22};
Circle(22) = {22, 1, 23};
Line(23) = {23, 24};
Circle(24) = {21, 1, 24};  // in the direction of curve 12
Curve Loop(1) = {11, 12, 13, 14};
Curve Loop(2) = {21, 22, 23, -24};
Plane Surface(1) = {1};
Plane Surface(2) = {2};
Transfinite Curve {12, 14, 22, 24} = n + 1;
Transfinite Curve {11, 13} = 8 + 1;
Transfinite Curve {21, 23} = 12 + 1;
Transfinite Surface {1, 2} Alternate;
Physical Surface("bush") = {1};
Physical Surface("hub") = {2};
Physical Curve("bush.x") = {11};
Physical Curve("bush.y") = {13};
Physical Curve("bush.outer") = {12};
Physical Curve("hub.x") = {21};
Physical Curve("hub.y") = {23};
Physical Curve("hub.inner") = {24};
