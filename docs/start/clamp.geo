// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// The jaw of a clamp, 40 mm long, on a block of steel that it holds down. Lengths in mm.
h = 4;

// The jaw: an L whose foot stands on the block.
Point(1) = {0, 10, 0, h};
Point(2) = {10, 10, 0, h / 2};
Point(3) = {10, 20, 0, h / 2};
Point(4) = {40, 20, 0, h};
Point(5) = {40, 30, 0, h};
Point(6) = {0, 30, 0, h};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 5};
Line(5) = {5, 6};
Line(6) = {6, 1};
Curve Loop(1) = {1, 2, 3, 4, 5, 6};
Plane Surface(1) = {1};

// The block: longer than the foot, with points of its own.
Point(7) = {-10, 0, 0, h};
Point(8) = {30, 0, 0, h};
Point(9) = {30, 10, 0, h};
Point(10) = {-10, 10, 0, h};
Line(7) = {7, 8};
Line(8) = {8, 9};
Line(9) = {9, 10};
Line(10) = {10, 7};
Curve Loop(2) = {7, 8, 9, 10};
Plane Surface(2) = {2};

Physical Surface("jaw") = {1};
Physical Surface("block") = {2};
Physical Curve("jaw.foot") = {1};
Physical Curve("jaw.end") = {4};
Physical Curve("jaw.top") = {5};
Physical Curve("block.bottom") = {7};
Physical Curve("block.top") = {9};
