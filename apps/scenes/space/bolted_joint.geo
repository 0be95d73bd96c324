// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// A quarter of two plates and the bolt through them. The plates share the surface between them, and either plate shares
// one with the bolt's head or nut: a contact that names it on both sides separates the bodies there.
// Mesh: gmsh -3 -format msh41 bolted_joint.geo
SetFactory("OpenCASCADE");
Mesh.MeshSizeFromPoints = 0;
Mesh.MeshSizeFromCurvature = 10;
Mesh.MeshSizeMax = 5;
width = 12;
thick = 6;
Box(1) = {0, 0, -thick, width, width, thick};
Box(2) = {0, 0, 0, width, width, thick};
Cylinder(3) = {0, 0, -thick, 0, 0, 2 * thick, 3.4, Pi / 2};  // the hole
Cylinder(4) = {0, 0, -thick, 0, 0, 2 * thick, 3, Pi / 2};    // the shank
Cylinder(5) = {0, 0, thick, 0, 0, 3, 5.5, Pi / 2};           // the head
Cylinder(6) = {0, 0, -thick - 3, 0, 0, 3, 5.5, Pi / 2};      // the nut
BooleanDifference{ Volume{1, 2}; Delete; }{ Volume{3}; Delete; }
BooleanUnion(7) = { Volume{4}; Delete; }{ Volume{5, 6}; Delete; };
BooleanFragments{ Volume{1, 2, 7}; Delete; }{}

e = 1e-3;
Physical Volume("lower") = {1};
Physical Volume("upper") = {2};
Physical Volume("bolt") = {7};
joint() = Surface In BoundingBox{-e, -e, -e, width + e, width + e, e};
head() = Surface In BoundingBox{-e, -e, thick - e, 6, 6, thick + e};
head() -= Surface In BoundingBox{-e, -e, thick - e, 3.5, 3.5, thick + e};  // what lies over the hole
nut() = Surface In BoundingBox{-e, -e, -thick - e, 6, 6, -thick + e};
nut() -= Surface In BoundingBox{-e, -e, -thick - e, 3.5, 3.5, -thick + e};
Physical Surface("joint") = {joint()};
Physical Surface("head") = {head()};
Physical Surface("nut") = {nut()};
x_plane() = Surface In BoundingBox{-e, -e, -10, e, width + e, 10};
y_plane() = Surface In BoundingBox{-e, -e, -10, width + e, e, 10};
Physical Surface("middle") = {x_plane(), y_plane()};
low_rim() = Surface In BoundingBox{width - e, -e, -thick - e, width + e, width + e, e};
low_rim() += Surface In BoundingBox{-e, width - e, -thick - e, width + e, width + e, e};
high_rim() = Surface In BoundingBox{width - e, -e, -e, width + e, width + e, thick + e};
high_rim() += Surface In BoundingBox{-e, width - e, -e, width + e, width + e, thick + e};
Physical Surface("lower_rim") = {low_rim()};
Physical Surface("upper_rim") = {high_rim()};
