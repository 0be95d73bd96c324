// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
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
  for (const char* name : {"Points", "displacement", "stress_displacement", "stress_equilibrated"}) {
    EXPECT_EQ(plot.fields[name].components, 3) << name;
    EXPECT_EQ(plot.fields[name].values.size(), 3u * plot.points) << name;
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
  // A cell's share is told on each of its three parts; the numbers are of single precision.
  const double total = sum(bodies.fields["indicator"].values) / 3 + sum(contact.fields["indicator"].values);
  EXPECT_NEAR(total, width, 1.2e-7 * width);
  // Cells of this mesh have an area of 1/32.
  EXPECT_NEAR(sum(bodies.fields["indicator_density"].values) / 32, sum(bodies.fields["indicator"].values),
              1.2e-7 * width);
}

TEST_F(Vtk, StressesAndDisplacementsOfAnExactSolution) {
  Plot plot = run(bending, "solution_0.vtu");
  const double e = 3.0 / (1 - 0.25 * 0.25), nu = 0.25 / (1 - 0.25);  // plane strain
  const std::vector<double>& points = plot.fields["Points"].values;
  const std::vector<double>& u = plot.fields["displacement"].values;
  for (int i = 0; i < plot.points; ++i) {
    const double x = points[3 * i], y = points[3 * i + 1];
    for (const char* name : {"stress_displacement", "stress_equilibrated"}) {
      const double* stress = &plot.fields[name].values[3 * i];
      EXPECT_NEAR(stress[0], y, 1e-7) << name;
      EXPECT_NEAR(stress[1], 0, 1e-7) << name;
      EXPECT_NEAR(stress[2], 0, 1e-7) << name;
    }
    // The beam floats along the wall: deflections are compared with that of the first point.
    const auto deflection = [&](double a, double b) { return -(a * a + nu * b * b) / (2 * e); };
    EXPECT_NEAR(u[3 * i], x * y / e, 1e-6);
    EXPECT_NEAR(u[3 * i + 1] - u[1], deflection(x, y) - deflection(points[0], points[1]), 1e-6);
    EXPECT_EQ(u[3 * i + 2], 0);
  }
}

TEST_F(Vtk, StressesOfLinearDisplacements) {
  // Pulled evenly: σ = (1, 0, 0), u linear, so that degree 1 is exact as well.
  std::string pulled = bending;
  pulled.replace(pulled.find("[\"y\", \"0\"]"), 10, "[\"1\", \"0\"]");
  Plot plot = run(pulled + "\n[solve]\ndegree = 1\n", "solution_0.vtu");
  for (const char* name : {"stress_displacement", "stress_equilibrated"})
    for (int i = 0; i < 3 * plot.points; ++i) EXPECT_NEAR(plot.fields[name].values[i], i % 3 == 0, 1e-7) << name;
}

TEST_F(Vtk, ContactIsPressedOrOpen) {
  run(two_blocks, "solution_0.vtu");
  Plot plot = parse(read("scene.out/contact_0.vtu"));
  ASSERT_EQ(plot.cells, 4);
  ASSERT_EQ(plot.points, 8);
  const std::vector<double>&pressure = plot.fields["pressure"].values, &gap = plot.fields["gap"].values;
  double force = 0;
  for (int i = 0; i < plot.points; ++i) {
    EXPECT_EQ(plot.fields["Points"].values[3 * i + 1], 1);
    EXPECT_GE(pressure[i], -1e-9);  // the limit of the program's checks, by the load of 0.1
    EXPECT_GE(gap[i], -1e-9);
    force += pressure[i] / 8;
  }
  EXPECT_NEAR(force, 0.005, 1e-8);  // what the top presses: (0.1 - 0.09) / 2
  EXPECT_NE(read("scene.out/solution.pvd").find("file=\"contact_0.vtu\""), std::string::npos);
}

}  // namespace
}  // namespace bracket::apps::tests
