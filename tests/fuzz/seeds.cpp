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

std::vector<std::string> csv() {
  return {
      "x,y,ux,uy,body\n0,0,0,0,lower\n1,0,0,0,lower\n0,1,.1,-.2,lower\n1,1,.2,-.1,lower\n0,1,0,0,upper\n"
      "1,1,1e-3,0,upper\n0,2,0,0,upper\n1,2,0,-1e-3,upper\n",
      "\"uy\",x,z,UX,y,uz\r\n0,0,0,0,0,0\r\n0,1,0,0,0,0\r\n0,0,0,0,1,0\r\n.1,1,0,0,1,0\r\n0,0,0,0,2,0\r\n"
      "0,1,0,0,2,0\r\n"};
}

std::vector<std::string> csv_words() {
  return {"nan",   "inf",  "-1e308", "1e-400",       ",,",  "\"",
          "upper", "body", "\n\n",   "\xef\xbb\xbf", "0.5", "0,.5,0,0,lower\n"};
}

std::vector<std::string> frd() {
  const std::string nodes =
      " -1         1 0.00000E+00 0.00000E+00-5.00000E-01\n"
      " -1         2 1.00000E+00 0.00000E+00-5.00000E-01\n"
      " -1         3 1.00000E+00 1.00000E+00-5.00000E-01\n"
      " -1         4 0.00000E+00 1.00000E+00-5.00000E-01\n"
      " -1         5 0.00000E+00 0.00000E+00 5.00000E-01\n"
      " -1         6 1.00000E+00 0.00000E+00 5.00000E-01\n"
      " -1         7 1.00000E+00 1.00000E+00 5.00000E-01\n"
      " -1         8 0.00000E+00 1.00000E+00 5.00000E-01\n"
      " -1        11 0.00000E+00 1.00000E+00-5.00000E-01\n"
      " -1        12 1.00000E+00 1.00000E+00-5.00000E-01\n"
      " -1        13 1.00000E+00 2.00000E+00-5.00000E-01\n"
      " -1        14 0.00000E+00 2.00000E+00-5.00000E-01\n -3\n";
  const std::string displacement =
      " -1         1 0.00000E+00 0.00000E+00 4.50000E-03\n"
      " -1         2 0.00000E+00 0.00000E+00 0.00000E+00\n"
      " -1         3-3.68852E-04 2.13689E-02 0.00000E+00\n"
      " -1         4 1.30000E-02 3.86311E-02 0.00000E+00\n"
      " -1         5 0.00000E+00 0.00000E+00-4.50000E-03\n"
      " -1         6 0.00000E+00 0.00000E+00 0.00000E+00\n"
      " -1         7-3.68852E-04 2.13689E-02 0.00000E+00\n"
      " -1         8 1.30000E-02 3.86311E-02 0.00000E+00\n"
      " -1        11 1.00000E+00 1.00000E+00 0.00000E+00\n"
      " -1        12 1.00000E+00 1.00000E+00 0.00000E+00\n"
      " -1        13 1.00000E+00 2.00000E+00 0.00000E+00\n"
      " -1        14 0.00000E+00 2.00000E+00 0.00000E+00\n -3\n 9999\n";
  const auto file = [&](const std::string& elements) {
    return "    1C\n    2C        12                  1\n" + nodes + "    3C         4                  1\n" +
           elements +
           " -3\n  100CL  101 1.000000000          12                    1\n -4  DISP        4    1\n"
           " -5  D1          1    2    1    0\n" +
           displacement;
  };
  const std::string upper =
      " -1         3    7    0    1\n -2        11        12        13\n"
      " -1         4    7    0    1\n -2        11        13        14\n";
  return {file(" -1         1    2    0    1\n -2         1         2         3         5         6         7\n"
               " -1         2    2    0    1\n -2         1         3         4         5         7         8\n" +
               upper),
          file(" -1         1    1    0    1\n -2         1         2         3         4         5         6         7"
               "         8\n" +
               upper)};
}

std::vector<std::string> frd_words() {
  return {"         nan",
          " 1.00000+308",
          "-1.00000E-99",
          " 9999\n",
          " -3\n",
          " -2 ",
          " -1 ",
          "    3C         1      1\n",
          "    2C         0      0\n",
          "         4",
          "    5",
          "    8",
          "  100CL  101 2.0 12 1\n",
          "2147483648",
          "\n"};
}

}  // namespace bracket::tests::seeds
