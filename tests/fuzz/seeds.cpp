// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/seeds.h"

namespace bracket::tests::seeds {

std::vector<std::string> gmsh() {
  return {R"($MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
4
1 5 "base"
1 6 "joint"
2 1 "lower"
2 2 "upper"
$EndPhysicalNames
$Nodes
11
1 0 0 5
2 1 0 5
3 1 1 5
4 0 1 5
5 1 2 5
6 0 2 5
7 0.5 0 5
8 1 0.5 5
9 0.5 1 5
10 0 0.5 5
11 0 1 5
$EndNodes
$Elements
8
1 8 2 5 1 1 2 7
2 1 2 6 2 4 3
3 1 2 5 2 4 3
4 16 2 1 1 1 2 3 4 7 8 9 10
5 2 2 2 2 4 3 5
6 2 2 2 2 4 5 6
7 2 2 1 2 4 5 6
8 15 2 9 1 1
$EndElements
)",
          R"($MeshFormat
4.1 0 8
$EndMeshFormat
$Entities
1 1 1 0
1 0 0 0 1 9
1 0 0 0 1 0 0 2 5 6 2 1 -1
1 0 0 0 1 1 0 1 1 1 1
$EndEntities
$Nodes
2 6 1 6
0 1 0 1
1
0 0 0
2 1 1 5
2
3
4
5
6
1 0 0 0.5 0.5
1 1 0 0.5 0.5
0 1 0 0.5 0.5
2 0 0 0.5 0.5
2 1 0 0.5 0.5
$EndNodes
$Elements
3 4 1 4
1 1 1 1
1 1 2
2 1 2 2
2 1 2 3
3 1 3 4
2 1 3 1
4 2 5 6 3
$EndElements
)",
          R"($MeshFormat
4.1 0 8
$EndMeshFormat
$PhysicalNames
2
1 1 "bottom"
2 3 "block"
$EndPhysicalNames
$Entities
0 1 1 0
1 0 0 0 1 0 0 1 1 0
7 0 0 0 1 1 0 1 3 0
$EndEntities
$PartitionedEntities
2
0
0 3 2 0
1 1 1 1 1 0 0 0 0.5 0 0 1 1 0
2 1 1 1 2 0.5 0 0 1 0 0 1 1 0
3 2 7 2 1 2 0.5 0 0 0.5 1 0 1 3 0
1 2 7 1 1 0 0 0 0.5 1 0 1 3 0
2 2 7 1 2 0.5 0 0 1 1 0 1 3 0
$EndPartitionedEntities
$Nodes
1 6 1 6
2 1 0 6
1
2
3
4
5
6
0 0 0
0.5 0 0
1 0 0
0 1 0
0.5 1 0
1 1 0
$EndNodes
$Elements
5 7 1 7
1 1 1 1
1 1 2
1 2 1 1
2 2 3
1 3 1 1
3 2 5
2 1 2 2
4 1 2 5
5 1 5 4
2 2 2 2
6 2 3 6
7 2 6 5
$EndElements
)"};
}

std::vector<std::string> gmsh_words() {
  return {" -1 ",
          " 0 ",
          " 1e308 ",
          " nan ",
          " 1e-400 ",
          " 9223372036854775807 ",
          " 1000000000000 ",
          "\n$Nodes\n",
          "\n$EndNodes\n",
          "\n$Elements\n",
          "\n$EndElements\n",
          "$PartitionedEntities\n",
          "\"",
          " 3 2 ",
          " 15 "};
}

std::vector<std::string> abaqus() {
  return {R"(*Heading
 two.inp
*NODE
1, 0, 0, 0
2, 1, 0, 0
3, 1, 1, 0
4, 0, 1, 0
5, 2, 0, 0
6, 2, 1, 0
******* E L E M E N T S *************
*ELEMENT, type=T3D2, ELSET=Line1
1, 1, 2
*ELEMENT, type=T3D2, ELSET=Line2
2, 5, 6
*ELEMENT, type=CPS3, ELSET=Surface1
3, 1, 2, 3
4, 1, 3, 4
*ELEMENT, type=CPS3, ELSET=Surface2
5, 2, 5, 6
6, 2, 6, 3
*ELSET,ELSET=bottom
1,
*ELSET,ELSET=right
2,
*ELSET,ELSET=steel
3, 4,
*ELSET,ELSET=brass
5, 6,
)",
          R"(** Name: Model-1
*Heading
Hash: x1, Date: 01/01/2026, Unit system: MM_TON_S_C
*Node
1, 0.000000E+000, 0.000000E+000
2, 2.000000E+000, 0.000000E+000
3, 2.000000E+000, 1.000000E+000
4, 0.000000E+000, 1.000000E+000
5, 1.000000E+000, 0.000000E+000
6, 2.000000E+000, 5.000000E-001
7, 1.000000E+000, 1.000000E+000
8, 0.000000E+000, 5.000000E-001
*Element, Type=CPS8R, Elset=Shell_part-1
1, 1, 2, 3, 4, 5, 6, 7,
8
*Nset, Nset=Fix
1, 4, 8
*Nset, Nset=Generated, Generate
5, 8, 2
*Elset, Elset=Internal_Selection-1_Load, Internal
1
*Surface, Name=Load, Type=Element
Internal_Selection-1_Load, S2
*Surface, Name=Free, Type=Node
Fix
*Material, Name=Steel
*Elastic
210000, 0.3
*Solid section, Elset=Shell_part-1, Material=Steel
10
*Step
*Static
*Boundary, op=New
Fix, 1, 2, 0
*End step
)",
          R"(*Heading
*Part, name="My part"
*Node
1, 0., 0.
2, 2., 0.
3, 2., 1.
4, 0., 1.
5, 1., 1.2
*Element, type=CPE4R
1, 1, 2, 3, 4
*Element, type=B32, elset=arc
2, 4, 5, 3
*Nset, nset=all, internal, generate
1, 4, 1
*Elset, elset=plate
1,
*Solid Section, elset=PLATE, material=steel
,
*End Part
*Assembly, name=Assembly
*Instance, name=Low-1, part="My part"
*End Instance
*Instance, name=High-1, part="MY PART"
0., 3., 0.
0., 0., 0., 0., 0., 1., 30.
*End Instance
*Nset, nset=base, instance=Low-1
1, 2
*Surface, type=ELEMENT, name=Joint
High-1.plate, S3
Low-1.1, S1
*Nset, nset=both
base, High-1.3, low-1.all
*End Assembly
)"};
}

std::vector<std::string> abaqus_words() {
  return {",GENERATE",
          "\n*NSET,NSET=x,GENERATE\n0,9223372036854775807,1\n",
          "\n*ELSET,ELSET=x\nx\n",
          ",,,",
          "1e308",
          "nan",
          "1D-400",
          "9223372036854775807",
          "\n*INCLUDE,INPUT=mesh\n",
          "\n*END PART\n",
          "\n*PART,NAME=y\n",
          "\n*ELEMENT,TYPE=CPS3,ELSET=z\n",
          "\n*SURFACE,NAME=s\nsteel\n",
          ",S1",
          ".",
          "\"",
          "=",
          "\n**",
          "\n*NODE\n"};
}

std::vector<std::string> unv() {
  return {R"(    -1
   164
         1  SI: Meter (newton)         2
   1.0000000000000000D+00   1.0000000000000000D+00   1.0000000000000000D+00
   2.7314999999999998D+02
    -1
    -1
  2411
         1         1         1        11
   0.0000000000000000D+00   0.0000000000000000D+00   0.0000000000000000D+00
         2         1         1        11
   1.0000000000000000D+00   0.0000000000000000D+00   0.0000000000000000D+00
         3         1         1        11
   1.0000000000000000D+00   1.0000000000000000D+00   0.0000000000000000D+00
         4         1         1        11
   0.0000000000000000D+00   1.0000000000000000D+00   0.0000000000000000D+00
    -1
    -1
  2412
         1        11         2         1         7         2
         0         1         1
         1         2
         2        41         2         1         7         3
         1         2         3
         4       136         2         1         7         2
         1         3
         3        41         2         1         7         3
         1         3         4
    -1
    -1
  2467
         1         0         0         0         0         0         0         1
bottom
         8         1         0         0
         3         0         0         0         0         0         0         3
corner nodes
         7         2         0         0         7         3         0         0
         7         1         0         0
         2         0         0         0         0         0         0         2
plate
         8         2         0         0         8         3         0         0
    -1
)",
          R"(    -1
  2411
1 1 1 11
0 0 0
2 1 1 11
2 0 0
3 1 1 11
2 2 0
4 1 1 11
0 2 0
5 1 1 11
1 -0.5 0
6 1 1 11
2 1 0
7 1 1 11
1 2 0
8 1 1 11
0 1 0
9 1 1 11
1 1 0
    -1
    -1
  2412
1 22 2 1 7 3
0 1 1
1 5 2
2 42 2 1 7 6
1 5 2 6 3 9
3 92 2 1 7 6
1 9 3 7 4 8
    -1
    -1
  2467
1 0 0 0 0 0 0 2
below
8 1 0 0 8 2 0 0
    -1
)"};
}

std::vector<std::string> unv_words() {
  return {"\n    -1\n",
          "\n    -1\n  2411\n",
          "\n    -1\n  2412\n",
          "\n    -1\n  2467\n",
          " 9223372036854775807 ",
          " 1D400 ",
          " -1 ",
          " 0 ",
          " 8 ",
          " 7 ",
          "\n",
          " 1000000000000 "};
}

}  // namespace bracket::tests::seeds
