// A plate with a hole, held at its left side: gmsh -2 plate.geo
SetFactory("OpenCASCADE");
Rectangle(1) = {0, 0, 0, 2, 1};
Disk(2) = {0.7, 0.5, 0, 0.2};
BooleanDifference(3) = { Surface{1}; Delete; }{ Surface{2}; Delete; };
Physical Surface("plate") = {3};
left() = Curve In BoundingBox {-1e-6, -1e-6, -1e-6, 1e-6, 1 + 1e-6, 1e-6};
right() = Curve In BoundingBox {2 - 1e-6, -1e-6, -1e-6, 2 + 1e-6, 1 + 1e-6, 1e-6};
Physical Curve("left") = {left()};
Physical Curve("right") = {right()};
Mesh.MeshSizeMax = 0.3;
