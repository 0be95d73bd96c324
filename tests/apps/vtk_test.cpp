// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <vtkCell.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkTriangle.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>

#include "tests/apps/command.h"

namespace bracket::apps::tests {
namespace {

struct Field {
  int components;
  std::vector<double> values;
};

struct Plot {
  int points;
  int cells;
  std::map<std::string, Field> fields;
};

template <typename Number> std::vector<double> numbers(const std::string& bytes) {
  EXPECT_EQ(bytes.size() % sizeof(Number), 0u);
  std::vector<Number> values(bytes.size() / sizeof(Number));
  std::memcpy(values.data(), bytes.data(), bytes.size());
  return {values.begin(), values.end()};
}

std::vector<double> numbers(const std::string& type, const std::string& bytes) {
  if (type == "Float64") return numbers<double>(bytes);
  if (type == "Float32") return numbers<float>(bytes);
  if (type == "Int32") return numbers<std::int32_t>(bytes);
  EXPECT_EQ(type, "UInt8");
  return numbers<std::uint8_t>(bytes);
}

// Reads a file as VTK does; expects its blocks to follow one another without a gap to the end of the appended data.
Plot parse(const std::string& file) {
  const std::string begin_mark = "<AppendedData encoding=\"raw\">\n_";
  const std::size_t begin = file.find(begin_mark) + begin_mark.size();
  const std::string header = file.substr(0, begin);
  EXPECT_NE(header.find("header_type=\"UInt64\""), std::string::npos);
  std::smatch piece;
  if (!std::regex_search(header, piece, std::regex(R"re(NumberOfPoints="(\d+)" NumberOfCells="(\d+)")re")))
    throw std::runtime_error("no piece");
  Plot plot{std::stoi(piece[1]), std::stoi(piece[2]), {}};
  const std::regex array(R"re(<DataArray type="(\w+)" Name="(\w+)"(?: NumberOfComponents="(\d)")?)re"
                         R"re(.* format="appended" offset="(\d+)"/>)re");
  std::size_t end = begin;
  for (std::sregex_iterator found(header.begin(), header.end(), array), none; found != none; ++found) {
    const std::smatch& match = *found;
    EXPECT_EQ(begin + std::stoul(match[4]), end);
    std::uint64_t size;
    std::memcpy(&size, file.data() + end, sizeof size);
    plot.fields[match[2]] = {match[3].matched ? std::stoi(match[3]) : 1,
                             numbers(match[1], file.substr(end + sizeof size, size))};
    end += sizeof size + size;
  }
  EXPECT_EQ(file.substr(end), "\n</AppendedData>\n</VTKFile>\n");
  return plot;
}

class Vtk : public Command {
 protected:
  Plot run(const std::string& scene, const std::string& plot) const {
    write("scene.toml", scene);
    const Ended ended = shell("bracket run scene.toml");
    EXPECT_EQ(ended.status, 0) << ended.err;
    return parse(read("scene.out/" + plot));
  }
};

double sum(const std::vector<double>& values) {
  double total = 0;
  for (const double value : values) total += value;
  return total;
}

TEST_F(Vtk, EveryArrayHasItsLength) {
  Plot plot = run(two_blocks, "solution_0.vtu");
  ASSERT_EQ(plot.cells, 3 * 64);
  ASSERT_EQ(plot.points, 6 * plot.cells);  // quadratic triangles
  for (const auto& [name, components] : std::map<std::string, int>{{"Points", 3},
                                                                   {"displacement", 3},
                                                                   {"drawn", 3},
                                                                   {"stress_displacement", 6},
                                                                   {"stress_equilibrated", 6},
                                                                   {"von_mises", 1},
                                                                   {"principal", 2}}) {
    EXPECT_EQ(plot.fields[name].components, components) << name;
    EXPECT_EQ(plot.fields[name].values.size(), static_cast<std::size_t>(components) * plot.points) << name;
  }
  for (const char* name : {"offsets", "types", "body", "indicator", "indicator_density"})
    EXPECT_EQ(plot.fields[name].values.size(), static_cast<std::size_t>(plot.cells)) << name;
  ASSERT_EQ(plot.fields["connectivity"].values.size(), static_cast<std::size_t>(plot.points));
  EXPECT_EQ(plot.fields["connectivity"].values.back(), plot.points - 1);
  EXPECT_EQ(plot.fields["offsets"].values.back(), plot.points);
}

TEST_F(Vtk, ThePartsCoverTheBodies) {
  Plot plot = run(two_blocks, "solution_0.vtu");
  const std::vector<double>& x = plot.fields["Points"].values;
  std::map<double, double> area;  // by body
  for (int cell = 0; cell < plot.cells; ++cell) {
    const double* p = &x[18 * cell];  // the corners come first
    const double twice = (p[3] - p[0]) * (p[7] - p[1]) - (p[6] - p[0]) * (p[4] - p[1]);
    EXPECT_GT(twice, 0);
    area[plot.fields["body"].values[cell]] += twice / 2;
  }
  ASSERT_EQ(area.size(), 2u);
  EXPECT_NEAR(area[0], 1, 1e-14);
  EXPECT_NEAR(area[1], 1, 1e-14);
}

TEST_F(Vtk, IndicatorsAddUpToTheWidth) {
  Plot bodies = run(two_blocks, "solution_0.vtu");
  Plot contact = parse(read("scene.out/contact_0.vtu"));
  const auto energy = nlohmann::json::parse(read("scene.out/report.json"))["energy"];
  const double width = energy["upper"].get<double>() - energy["lower"].get<double>();
  // A cell's share is told on each of its three parts.
  const double total = sum(bodies.fields["indicator"].values) / 3 + sum(contact.fields["indicator"].values);
  EXPECT_NEAR(total, width, 1e-9 * width);
  // Cells of this mesh have an area of 1/32.
  EXPECT_NEAR(sum(bodies.fields["indicator_density"].values) / 32, sum(bodies.fields["indicator"].values),
              1e-12 * width);
}

TEST_F(Vtk, StressesAndDisplacementsOfAnExactSolution) {
  Plot plot = run(bending, "solution_0.vtu");
  const double e = 3.0 / (1 - 0.25 * 0.25), nu = 0.25 / (1 - 0.25);  // plane strain
  const std::vector<double>& points = plot.fields["Points"].values;
  const std::vector<double>& u = plot.fields["displacement"].values;
  for (int i = 0; i < plot.points; ++i) {
    const double x = points[3 * i], y = points[3 * i + 1];
    for (const char* name : {"stress_displacement", "stress_equilibrated"}) {
      const double* stress = &plot.fields[name].values[6 * i];
      const std::array<double, 6> exact = {y, 0, 0.25 * y, 0, 0, 0};  // plane strain, ν = 0.25
      for (int k = 0; k < 6; ++k) EXPECT_NEAR(stress[k], exact[k], 1e-12) << name << k;
    }
    EXPECT_NEAR(plot.fields["von_mises"].values[i], std::abs(y) * std::sqrt(1 - 0.25 + 0.0625), 1e-12);
    EXPECT_NEAR(plot.fields["principal"].values[2 * i], std::max(y, 0.0), 1e-12);
    EXPECT_NEAR(plot.fields["principal"].values[2 * i + 1], std::min(y, 0.0), 1e-12);
    // The beam floats along the wall: deflections are compared with that of the first point.
    const auto deflection = [&](double a, double b) { return -(a * a + nu * b * b) / (2 * e); };
    EXPECT_NEAR(u[3 * i], x * y / e, 1e-12);
    EXPECT_NEAR(u[3 * i + 1] - u[1], deflection(x, y) - deflection(points[0], points[1]), 1e-12);
    EXPECT_EQ(u[3 * i + 2], 0);
  }
}

TEST_F(Vtk, StressesOfLinearDisplacements) {
  // Pulled evenly: σ = (1, 0, 0), u linear, so that degree 1 is exact as well.
  std::string pulled = bending;
  pulled.replace(pulled.find("[\"y\", \"0\"]"), 10, "[\"1\", \"0\"]");
  Plot plot = run(pulled + "\n[solve]\ndegree = 1\n", "solution_0.vtu");
  for (const char* name : {"stress_displacement", "stress_equilibrated"})
    for (int i = 0; i < 6 * plot.points; ++i)
      EXPECT_NEAR(plot.fields[name].values[i], i % 6 == 0 ? 1 : i % 6 == 2 ? 0.25 : 0, 1e-12) << name;
}

TEST_F(Vtk, TheStressAcrossThePlaneIsToldWhereItIsKnown) {
  std::string scene = bending;
  std::string plane_stress = scene;
  plane_stress.replace(plane_stress.find("\"strain\""), 8, "\"stress\"");
  Plot stress = run(plane_stress, "solution_0.vtu");
  for (int i = 0; i < stress.points; ++i) {
    EXPECT_EQ(stress.fields["stress_equilibrated"].values[6 * i + 2], 0);
    EXPECT_NEAR(stress.fields["von_mises"].values[i], std::abs(stress.fields["Points"].values[3 * i + 1]), 1e-12);
  }
  scene.replace(scene.find("E = 3"), scene.find("nu = 0.25") + 9 - scene.find("E = 3"),
                "stiffness = [[3, 1, 0], [1, 3, 0], [0, 0, 1]]");
  Plot unknown = run(scene, "solution_0.vtu");
  EXPECT_TRUE(std::isnan(unknown.fields["stress_equilibrated"].values[2]));
  EXPECT_TRUE(std::isnan(unknown.fields["von_mises"].values[0]));
  EXPECT_TRUE(std::isfinite(unknown.fields["principal"].values[0]));
}

TEST_F(Vtk, ContactIsPressedOrOpen) {
  Plot bodies = run(two_blocks, "solution_0.vtu");
  Plot plot = parse(read("scene.out/contact_0.vtu"));
  ASSERT_EQ(plot.cells, 4 * 8);
  ASSERT_EQ(plot.points, 2 * plot.cells);
  const std::vector<double>&pressure = plot.fields["pressure"].values, &gap = plot.fields["gap"].values;
  double force = 0;
  for (int i = 0; i < plot.points; ++i) {
    EXPECT_EQ(plot.fields["Points"].values[3 * i + 1], 1);
    EXPECT_GE(pressure[i], -1e-9);  // the limit of the program's checks, by the load of 0.1
    EXPECT_GE(gap[i], -1e-9);
    force += pressure[i] / plot.points;
  }
  EXPECT_NEAR(force, 0.005, 1e-8);  // what the top presses: (0.1 - 0.09) / 2
  EXPECT_NE(read("scene.out/solution.pvd").find("file=\"contact_0.vtu\""), std::string::npos);

  // The line moves as the upper body does.
  const std::vector<double>&x = bodies.fields["Points"].values, &u = bodies.fields["displacement"].values;
  int found = 0;
  for (int i = 0; i < plot.points; ++i)
    for (int k = 0; k < bodies.points; ++k) {
      const bool upper = bodies.fields["body"].values[k / 6] == 1;
      if (!upper || x[3 * k] != plot.fields["Points"].values[3 * i] || x[3 * k + 1] != 1) continue;
      ++found;
      for (int c = 0; c < 2; ++c) EXPECT_NEAR(u[3 * k + c], plot.fields["displacement"].values[3 * i + c], 1e-14);
    }
  EXPECT_GE(found, 4 * 3);  // the ends and the middle of each edge
  // Both pressures are near each other: exact where the other is.
  double difference = 0;
  for (int i = 0; i < plot.points; ++i)
    difference = std::max(difference, std::abs(pressure[i] - plot.fields["pressure_displacement"].values[i]));
  EXPECT_GT(difference, 0);
  EXPECT_LT(difference, 0.1);
}

template <class T> vtkSmartPointer<vtkUnstructuredGrid> read_by(T* reader, const std::filesystem::path& file) {
  reader->SetFileName(file.c_str());
  reader->Update();
  return reader->GetOutput();
}

// VTK's own reader, as ParaView has it: cells with their order, fields, names and bounds.
TEST_F(Vtk, IsReadBackByVtk) {
  for (const int degree : {1, 2, 3, 4}) {
    SCOPED_TRACE(degree);
    run(std::string(two_blocks) + "\n[solve]\ndegree = " + std::to_string(degree) + "\n", "solution_0.vtu");
    const auto json = nlohmann::json::parse(read("scene.out/report.json"));
    const vtkNew<vtkXMLUnstructuredGridReader> reader, contact_reader;
    const auto grid = read_by(reader.Get(), directory / "scene.out/solution_0.vtu");
    const auto contact = read_by(contact_reader.Get(), directory / "scene.out/contact_0.vtu");
    ASSERT_EQ(grid->GetNumberOfCells(), 3 * 64);
    EXPECT_EQ(grid->GetCell(0)->GetNumberOfPoints(), (degree + 1) * (degree + 2) / 2);
    EXPECT_EQ(contact->GetNumberOfCells() % 4, 0);
    EXPECT_EQ(grid->GetPointData()->GetArray("stress_equilibrated")->GetNumberOfComponents(), 6);
    EXPECT_EQ(grid->GetPointData()->GetArray("displacement")->GetDataType(), VTK_DOUBLE);
    for (auto* const each : {grid.Get(), contact.Get()}) {
      auto* const about = each->GetFieldData();
      const auto* const energy = about->GetArray("energy");
      ASSERT_NE(energy, nullptr);
      EXPECT_EQ(const_cast<vtkDataArray*>(energy)->GetComponent(0, 0), json["energy"]["lower"]);
      EXPECT_EQ(const_cast<vtkDataArray*>(energy)->GetComponent(0, 1), json["energy"]["upper"]);
      const auto text = [&](const char* name, int i) {
        auto* const array = vtkStringArray::SafeDownCast(about->GetAbstractArray(name));
        return array == nullptr ? "" : std::string(array->GetValue(i));
      };
      EXPECT_EQ(text("title", 0), "Two blocks");
      EXPECT_EQ(text("units", 0), "N, mm, MPa");
      EXPECT_EQ(text("body_names", 1), "upper");
      EXPECT_EQ(text("pair_names", 0), "upper.bottom on lower.top");
    }
    // Sides of cells that bulge as u_h does: the areas of the curved cells, by VTK, are those of the bodies.
    double area = 0;
    for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i) {
      vtkCell* const cell = grid->GetCell(i);
      const vtkNew<vtkIdList> ids;
      const vtkNew<vtkPoints> points;
      cell->Triangulate(0, ids, points);
      for (vtkIdType k = 0; k < points->GetNumberOfPoints(); k += 3) {
        std::array<std::array<double, 3>, 3> corner;
        for (int c = 0; c < 3; ++c) points->GetPoint(k + c, corner[c].data());
        area += vtkTriangle::TriangleArea(corner[0].data(), corner[1].data(), corner[2].data());
      }
    }
    EXPECT_NEAR(area, 2, 1e-12);
  }
}

// An interference of 0.01: where the line is drawn both bodies are drawn as well, to single precision.
TEST_F(Vtk, BodiesAreDrawnSoThatTheyTouch) {
  std::string scene = two_blocks;
  Plot bodies = run(scene.replace(scene.find("gap = 0.0"), 9, "gap = -0.01"), "solution_0.vtu");
  Plot line = parse(read("scene.out/contact_0.vtu"));
  const auto place = [](Plot& plot, int i, int c) {
    return plot.fields["Points"].values[3 * i + c] + plot.fields["drawn"].values[3 * i + c];
  };
  int closed = 0;
  for (int i = 0; i < line.points; ++i) {
    if (line.fields["gap"].values[i] > 1e-9) continue;
    for (int k = 0; k < bodies.points; ++k) {
      if (bodies.fields["Points"].values[3 * k] != line.fields["Points"].values[3 * i]) continue;
      if (bodies.fields["Points"].values[3 * k + 1] != 1) continue;
      ++closed;
      EXPECT_NEAR(place(bodies, k, 1), place(line, i, 1), 1e-6);
    }
  }
  EXPECT_GT(closed, 10);
}

TEST_F(Vtk, TheViewIsPython) {
  run(two_blocks + std::string("\n"), "solution_0.vtu");
  const Ended ended = shell("python3 -c 'compile(open(\"scene.out/view.py\").read(), \"view.py\", \"exec\")'");
  EXPECT_EQ(ended.status, 0) << ended.err;
  const std::string view = read("scene.out/view.py");
  EXPECT_NE(view.find("BODIES = [\"lower\", \"upper\"]"), std::string::npos) << view;
  EXPECT_NE(view.find("PAIRS = [\"upper.bottom on lower.top\"]"), std::string::npos) << view;
}

}  // namespace
}  // namespace bracket::apps::tests
