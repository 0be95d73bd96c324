// The right half, by symmetry about x = 0, of a roller of radius 10 on a plate.
// gmsh -2 -format msh22 roller.geo -o roller.msh
SetFactory("Built-in");
R = 10; W = 20; H = 15;
fine = 0.3; coarse = 3;  // the contact is about 3 wide
Point(1) = {0, R, 0, coarse};
Point(2) = {0, 0, 0, fine};
Point(3) = {R, R, 0, coarse};
Point(4) = {R * Sin(Pi / 9), R - R * Cos(Pi / 9), 0, 1};
Circle(1) = {2, 1, 4};  // what may touch
Circle(2) = {4, 1, 3};
Line(3) = {3, 1};       // the load comes from above
Line(4) = {1, 2};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
Point(5) = {0, 0, 0, fine};
Point(6) = {R * Sin(Pi / 9), 0, 0, 1};
Point(7) = {W, 0, 0, coarse};
Point(8) = {W, -H, 0, coarse};
Point(9) = {0, -H, 0, coarse};
Line(5) = {5, 9};
Line(6) = {9, 8};
Line(7) = {8, 7};
Line(8) = {7, 6};
Line(9) = {6, 5};
Curve Loop(2) = {5, 6, 7, 8, 9};
Plane Surface(2) = {2};
Physical Surface("roller") = {1};
Physical Surface("plate") = {2};
Physical Curve("roller.surface") = {1};
Physical Curve("roller.middle") = {3};
Physical Curve("roller.axis") = {4};
Physical Curve("plate.top") = {9};
Physical Curve("plate.axis") = {5};
Physical Curve("plate.bottom") = {6};
