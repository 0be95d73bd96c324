// A pin of radius 9.95 in the hole, of radius 10, of a lug that is pulled: the right half, by symmetry about x = 0.
// The pin touches the top of the hole.
SetFactory("Built-in");
r = 9.95; R = 10; W = 20; H = 40; c = R - r;  // the pin's centre is at (0, c)
core = 3;  // held
fine = 1; coarse = 4;
Point(1) = {0, c, 0, coarse};
Point(2) = {0, c - r, 0, coarse};
Point(3) = {r, c, 0, fine};
Point(4) = {0, c + r, 0, fine};
Circle(1) = {2, 1, 3};
Circle(2) = {3, 1, 4};
Point(13) = {0, c + core, 0, coarse / 2};
Point(14) = {core, c, 0, coarse / 2};
Point(15) = {0, c - core, 0, coarse / 2};
Line(3) = {4, 13};
Circle(4) = {13, 1, 14};
Circle(12) = {14, 1, 15};
Line(13) = {15, 2};
Curve Loop(1) = {1, 2, 3, 4, 12, 13};
Plane Surface(1) = {1};
Point(5) = {0, 0, 0, coarse};
Point(6) = {0, R, 0, fine};
Point(7) = {R, 0, 0, fine};
Point(8) = {0, -R, 0, coarse};
Point(9) = {0, -H, 0, coarse};
Point(10) = {W, -H, 0, coarse};
Point(11) = {W, 0, 0, coarse};
Point(12) = {0, W, 0, coarse};
Circle(5) = {6, 5, 7};
Circle(6) = {7, 5, 8};
Line(7) = {8, 9};
Line(8) = {9, 10};
Line(9) = {10, 11};
Circle(10) = {11, 5, 12};
Line(11) = {12, 6};
Curve Loop(2) = {5, 6, 7, 8, 9, 10, 11};
Plane Surface(2) = {2};
Physical Surface("pin") = {1};
Physical Surface("lug") = {2};
Physical Curve("pin.surface") = {1, 2};
Physical Curve("pin.axis") = {3, 13};
Physical Curve("pin.core") = {4, 12};
Physical Curve("lug.hole") = {5, 6};
Physical Curve("lug.axis") = {7, 11};
Physical Curve("lug.end") = {8};
