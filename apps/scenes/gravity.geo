// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// A block of length a and height b, its lower corner at the origin, on a wall inclined by 30 degrees.
// Mesh: gmsh -2 -format msh22 gravity.geo
a = 200;
b = 100;
size = 16;
c = Cos(Pi / 6);
s = Sin(Pi / 6);
Point(1) = {0, 0, 0, size};
Point(2) = {a * c, a * s, 0, size};
Point(3) = {a * c - b * s, a * s + b * c, 0, size};
Point(4) = {-b * s, b * c, 0, size};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
Physical Surface("block") = {1};
Physical Curve("block.wall") = {1};
Physical Curve("block.stop") = {4};
