// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// Two whole rings. The circle on which they touch is there twice, once for each ring, with equal divisions: the bodies must
// not share nodes. gmsh -2 -format msh22 press_fit.geo -o press_fit.msh
n = 12;  // edges along a quarter
Point(1) = {0, 0, 0};
Point(11) = {20, 0, 0}; Point(12) = {0, 20, 0}; Point(13) = {-20, 0, 0}; Point(14) = {0, -20, 0};  // the bush
Point(21) = {30, 0, 0}; Point(22) = {0, 30, 0}; Point(23) = {-30, 0, 0}; Point(24) = {0, -30, 0};
Point(31) = {30, 0, 0}; Point(32) = {0, 30, 0}; Point(33) = {-30, 0, 0}; Point(34) = {0, -30, 0};  // the hub
Point(41) = {50, 0, 0}; Point(42) = {0, 50, 0}; Point(43) = {-50, 0, 0}; Point(44) = {0, -50, 0};
For ring In {1:4}
  For k In {1:4}
    Circle(10 * ring + k) = {10 * ring + k, 1, 10 * ring + (k % 4) + 1};
  EndFor
EndFor
For k In {1:4}
  Line(50 + k) = {10 + k, 20 + k};
  Line(60 + k) = {30 + k, 40 + k};
EndFor
For k In {1:4}
  next = (k % 4) + 1;
  Curve Loop(k) = {50 + k, 20 + k, -(50 + next), -(10 + k)};
  Plane Surface(k) = {k};
  Curve Loop(10 + k) = {60 + k, 40 + k, -(60 + next), -(30 + k)};
  Plane Surface(10 + k) = {10 + k};
EndFor
Transfinite Curve {11:14, 21:24, 31:34, 41:44} = n + 1;
Transfinite Curve {51:54} = 4 + 1;
Transfinite Curve {61:64} = 6 + 1;
Transfinite Surface {1:4, 11:14} Alternate;
Physical Surface("bush") = {1:4};
Physical Surface("hub") = {11:14};
Physical Curve("bush.inner") = {11:14};
Physical Curve("bush.outer") = {21:24};
Physical Curve("hub.inner") = {31:34};
Physical Curve("hub.outer") = {41:44};
