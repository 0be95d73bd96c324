// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/mesh_files.h"

namespace bracket::tests {

const std::string abaqus_of_gmsh = R"(*Heading
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
)";

const std::string abaqus_of_prepomax = R"(** Name: Model-1
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
)";

std::string abaqus_of_cae(const std::string& placement) {
  return R"(*Heading
*Preprint, echo=NO, model=NO
*Part, name="My part"
*Node
      1,           0.,           0.
      2,           2.,           0.
      3,           2.,           1.
      4,           0.,           1.
*Element, type=CPE4R
1, 1, 2, 3, 4
*Nset, nset=_PickedSet2, internal, generate
 1,  4,  1
*Elset, elset=_PickedSet2, internal
 1,
** Section: Section-1
*Solid Section, elset=_PickedSet2, material=steel
,
*End Part
*Assembly, name=Assembly
*Instance, name=Low-1, part="My part"
*End Instance
*Instance, name=High-1, part="MY PART"
)" + placement +
         R"(*End Instance
*Node
      1,     5.,    5.,   0.
*Nset, nset=Ref
 1,
*Nset, nset=base, instance=Low-1
 1, 2
*Elset, elset=_Joint_S3, internal, instance=Low-1
 1,
*Surface, type=ELEMENT, name=Joint
_Joint_S3, S3
*Surface, type=ELEMENT, name=Start
High-1.1, S1
*Nset, nset=Two
 Low-1.2, LOW-1.3
*End Assembly
)";
}

}  // namespace bracket::tests
