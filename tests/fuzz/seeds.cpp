// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/seeds.h"

#include "tests/support/mesh_files.h"

namespace bracket::tests::seeds {

std::vector<std::string> gmsh() { return {gmsh_of_second_order, gmsh_with_parameters, gmsh_of_partitions}; }

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
  return {abaqus_of_gmsh, abaqus_of_prepomax, abaqus_of_cae("0., 3., 0.\n0., 0., 0., 0., 0., 1., 30.\n")};
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

std::vector<std::string> unv() { return {unv_of_salome, unv_of_second_order}; }

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
