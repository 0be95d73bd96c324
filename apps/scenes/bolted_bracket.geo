// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// Base, bracket, washer and pin. Curves on which two bodies touch are there twice, once for each body, with equal
// divisions: the bodies must not share nodes. Mesh: gmsh -2 -format msh41 bolted_bracket.geo
coarse = 8;
medium = 3.5;
fine = 1;

// The base, with a shoulder on the left and a fillet in the corner of shoulder and seat.
Point(1) = {-20, -20, 0, coarse};
Point(2) = {100, -20, 0, coarse};
Point(3) = {100, 0, 0, coarse};
Point(4) = {80, 0, 0, medium};
Point(5) = {3, 0, 0, fine};
Point(6) = {2, 0, 0, fine};
Point(7) = {0, 2, 0, fine};
Point(8) = {0, 3, 0, fine};
Point(9) = {0, 10, 0, fine};
Point(10) = {-20, 10, 0, coarse};
Point(11) = {2, 2, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {5, 4};  // the seat
Line(5) = {5, 6};
Circle(6) = {6, 11, 7};
Line(7) = {7, 8};
Line(8) = {8, 9};  // the shoulder's face
Line(9) = {9, 10};
Line(10) = {10, 1};

// The bracket: a foot, a fillet, an upright with a round end, a hole for the pin and one to make it lighter.
Point(21) = {3, 0, 0, fine};
Point(22) = {80, 0, 0, medium};
Point(23) = {80, 12, 0, medium};
Point(24) = {70, 12, 0, medium};
Point(25) = {50, 12, 0, medium};
Point(26) = {38, 12, 0, fine};
Point(27) = {38, 20, 0};
Point(28) = {30, 20, 0, fine};
Point(29) = {30, 85, 0, medium};
Point(30) = {15, 85, 0};
Point(31) = {15, 100, 0, medium};
Point(32) = {0, 85, 0, medium};
Point(33) = {0, 10, 0, fine};
Point(34) = {0, 3, 0, fine};
Line(21) = {21, 22};  // the foot
Line(22) = {22, 23};
Line(23) = {23, 24};
Line(24) = {25, 24};  // the pad under the washer
Line(25) = {25, 26};
Circle(26) = {26, 27, 28};
Line(27) = {28, 29};
Circle(28) = {29, 30, 31};
Circle(29) = {31, 30, 32};
Line(30) = {32, 33};
Line(31) = {34, 33};  // the heel
Line(32) = {34, 21};
Point(41) = {22, 85, 0};
Point(42) = {15, 92, 0};
Point(43) = {8, 85, 0};
Point(44) = {15, 78, 0};
Circle(41) = {41, 30, 42};
Circle(42) = {42, 30, 43};
Circle(43) = {43, 30, 44};
Circle(44) = {44, 30, 41};
Point(50) = {15, 45, 0};
Point(51) = {21, 45, 0, medium};
Point(52) = {15, 51, 0, medium};
Point(53) = {9, 45, 0, medium};
Point(54) = {15, 39, 0, medium};
Circle(51) = {51, 50, 52};
Circle(52) = {52, 50, 53};
Circle(53) = {53, 50, 54};
Circle(54) = {54, 50, 51};

// The washer.
Point(61) = {50, 12, 0};
Point(62) = {70, 12, 0};
Point(63) = {70, 16, 0};
Point(64) = {50, 16, 0};
Line(61) = {61, 62};
Line(62) = {62, 63};
Line(63) = {63, 64};
Line(64) = {64, 61};

// The pin, hollow.
Point(71) = {22, 85, 0};
Point(72) = {15, 92, 0};
Point(73) = {8, 85, 0};
Point(74) = {15, 78, 0};
Circle(71) = {71, 30, 72};
Circle(72) = {72, 30, 73};
Circle(73) = {73, 30, 74};
Circle(74) = {74, 30, 71};
Point(81) = {18, 85, 0};
Point(82) = {15, 88, 0};
Point(83) = {12, 85, 0};
Point(84) = {15, 82, 0};
Circle(81) = {81, 30, 82};
Circle(82) = {82, 30, 83};
Circle(83) = {83, 30, 84};
Circle(84) = {84, 30, 81};

Transfinite Curve {4, 21} = 40 + 1 Using Progression 1.04;
Transfinite Curve {8, 31} = 7 + 1;
Transfinite Curve {24, 61, 63} = 12 + 1;
Transfinite Curve {62, 64} = 3 + 1;
Transfinite Curve {41, 42, 43, 44, 71, 72, 73, 74} = 10 + 1;
Transfinite Curve {81, 82, 83, 84} = 5 + 1;

Curve Loop(1) = {1, 2, 3, -4, 5, 6, 7, 8, 9, 10};
Curve Loop(2) = {21, 22, 23, -24, 25, 26, 27, 28, 29, 30, -31, 32};
Curve Loop(3) = {41, 42, 43, 44};
Curve Loop(4) = {51, 52, 53, 54};
Curve Loop(5) = {61, 62, 63, 64};
Curve Loop(6) = {71, 72, 73, 74};
Curve Loop(7) = {81, 82, 83, 84};
Plane Surface(1) = {1};
Plane Surface(2) = {2, 3, 4};
Plane Surface(3) = {5};
Plane Surface(4) = {6, 7};

Physical Surface("base") = {1};
Physical Surface("bracket") = {2};
Physical Surface("washer") = {3};
Physical Surface("pin") = {4};
Physical Curve("base.bottom") = {1};
Physical Curve("base.seat") = {4};
Physical Curve("base.shoulder") = {8};
Physical Curve("bracket.foot") = {21};
Physical Curve("bracket.heel") = {31};
Physical Curve("bracket.pad") = {24};
Physical Curve("bracket.hole") = {41, 42, 43, 44};
Physical Curve("washer.face") = {61};
Physical Curve("washer.top") = {63};
Physical Curve("pin.surface") = {71, 72, 73, 74};
Physical Curve("pin.bore") = {81, 82, 83, 84};
