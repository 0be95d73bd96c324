// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// What ParaView reads of a run in space, through VTK itself.
#include <vtkCell.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkSmartPointer.h>
#include <vtkTetra.h>
#include <vtkTriangle.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <array>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "tests/apps/command.h"
#include "tests/apps/space/scenes.h"

namespace bracket::apps::tests {
namespace {

class VtkInSpace : public Command {
 protected:
  VtkInSpace() { write("boxes.toml", two_boxes); }
  vtkSmartPointer<vtkUnstructuredGrid> grid(const std::string& name) const {
    const vtkNew<vtkXMLUnstructuredGridReader> reader;
    reader->SetFileName((directory / "boxes.out" / name).c_str());
    reader->Update();
    return reader->GetOutput();
  }
};

std::array<double, 3> corner(vtkUnstructuredGrid* grid, vtkIdType cell, int i) {
  std::array<double, 3> x;
  grid->GetPoint(grid->GetCell(cell)->GetPointId(i), x.data());
  return x;
}

TEST_F(VtkInSpace, FourTetrahedraACellFillTheBodies) {
  for (const std::string degree : {"1", "2"}) {
    ASSERT_EQ(shell("bracket run boxes.toml --no-report --set solve.degree=" + degree).status, 0);
    const auto grid = this->grid("solution_0.vtu");
    ASSERT_EQ(grid->GetNumberOfCells(), 4 * 48);
    ASSERT_EQ(grid->GetNumberOfPoints(), grid->GetNumberOfCells() * (degree == "1" ? 4 : 10));
    double volume = 0;
    for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell) {
      auto a = corner(grid, cell, 0), b = corner(grid, cell, 1), c = corner(grid, cell, 2), d = corner(grid, cell, 3);
      const double own = vtkTetra::ComputeVolume(a.data(), b.data(), c.data(), d.data());
      EXPECT_GT(own, 0);  // not inside out
      volume += own;
    }
    EXPECT_NEAR(volume, 1, 1e-12);
    const std::map<std::string, int> arrays = {{"displacement", 3},        {"drawn", 3},     {"stress_displacement", 6},
                                               {"stress_equilibrated", 6}, {"von_mises", 1}, {"principal", 3}};
    for (const auto& [name, components] : arrays) {
      ASSERT_NE(grid->GetPointData()->GetArray(name.c_str()), nullptr) << name;
      EXPECT_EQ(grid->GetPointData()->GetArray(name.c_str())->GetNumberOfComponents(), components) << name;
    }
  }
}

// Quadratic cells have their further nodes at the middles of the edges that VTK expects there.
TEST_F(VtkInSpace, NodesAreAtTheMiddlesOfEdges) {
  ASSERT_EQ(shell("bracket run boxes.toml --no-report").status, 0);
  constexpr std::array<std::array<int, 2>, 6> edges = {{{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}};
  for (const std::string name : {"solution_0.vtu", "contact_0.vtu"}) {
    const auto grid = this->grid(name);
    const int corners = name == "contact_0.vtu" ? 3 : 4;
    for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
      for (int e = 0; e < (corners == 3 ? 3 : 6); ++e) {
        const auto a = corner(grid, cell, edges[e][0]), b = corner(grid, cell, edges[e][1]);
        const auto middle = corner(grid, cell, corners + e);
        for (int k = 0; k < 3; ++k) ASSERT_NEAR(middle[k], (a[k] + b[k]) / 2, 1e-14) << name;
      }
  }
}

// The terms of the gap identity, of cells (each on its four parts) and contact faces, add up to the width.
TEST_F(VtkInSpace, IndicatorsAddUpToTheWidth) {
  ASSERT_EQ(shell("bracket run boxes.toml --no-report").status, 0);
  const auto solution = grid("solution_0.vtu"), contact = grid("contact_0.vtu");
  double sum = 0;
  for (vtkIdType i = 0; i < solution->GetNumberOfCells(); ++i)
    sum += solution->GetCellData()->GetArray("indicator")->GetTuple1(i) / 4;
  for (vtkIdType i = 0; i < contact->GetNumberOfCells(); ++i)
    sum += contact->GetCellData()->GetArray("indicator")->GetTuple1(i);
  const auto plain = nlohmann::json::parse(read("boxes.out/report.json"))["plain"];
  const double lower = plain["lower"], upper = plain["upper"];
  EXPECT_NEAR(sum, upper - lower, 1e-10 * std::abs(lower));
}

// The contact force is the integral of the pressure, which is linear on each face.
TEST_F(VtkInSpace, PressuresGiveTheContactForce) {
  ASSERT_EQ(shell("bracket run boxes.toml --no-report").status, 0);
  const auto grid = this->grid("contact_0.vtu");
  ASSERT_EQ(grid->GetNumberOfCells(), 4);
  double force = 0;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell) {
    auto a = corner(grid, cell, 0), b = corner(grid, cell, 1), c = corner(grid, cell, 2);
    const double area = vtkTriangle::TriangleArea(a.data(), b.data(), c.data());
    for (int i = 0; i < 3; ++i)
      force += area / 3 * grid->GetPointData()->GetArray("pressure")->GetTuple1(grid->GetCell(cell)->GetPointId(i));
  }
  EXPECT_NEAR(force, nlohmann::json::parse(read("boxes.out/report.json"))["contact"][0]["force"], 1e-12);
}

}  // namespace
}  // namespace bracket::apps::tests
