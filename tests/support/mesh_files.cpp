// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/mesh_files.h"

namespace bracket::tests {

const std::string gmsh_of_partitions = R"($MeshFormat
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
)";

const std::string gmsh_of_second_order = R"($MeshFormat
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
)";

const std::string gmsh_with_parameters = R"($MeshFormat
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
)";

const std::string unv_of_salome = R"(    -1
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
)";

const std::string unv_of_second_order = R"(    -1
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
)";

}  // namespace bracket::tests
