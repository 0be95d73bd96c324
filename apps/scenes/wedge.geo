// The right half, by symmetry about x = 0, of a wedge between two cheeks: its flank and theirs are one line from (2, 0) to
// (6, 8). gmsh -2 -format msh22 wedge.geo -o wedge.msh
SetFactory("Built-in");
fine = 0.8; coarse = 2;
Point(1) = {0, 0, 0, fine};
Point(2) = {2, 0, 0, fine};
Point(3) = {6, 8, 0, fine};
Point(4) = {0, 8, 0, coarse};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
// The cheek's flank is longer at both ends: where the contact ends is the wedge's doing.
Point(5) = {1, -2, 0, fine};
Point(6) = {16, -2, 0, coarse};
Point(7) = {16, 10, 0, coarse};
Point(8) = {7, 10, 0, fine};
Line(5) = {5, 6};
Line(6) = {6, 7};
Line(7) = {7, 8};
Line(8) = {8, 5};
Curve Loop(2) = {5, 6, 7, 8};
Plane Surface(2) = {2};
Physical Surface("wedge") = {1};
Physical Surface("cheek") = {2};
Physical Curve("wedge.tip") = {1};
Physical Curve("wedge.flank") = {2};
Physical Curve("wedge.top") = {3};
Physical Curve("wedge.axis") = {4};
Physical Curve("cheek.bottom") = {5};
Physical Curve("cheek.back") = {6};
Physical Curve("cheek.flank") = {8};
