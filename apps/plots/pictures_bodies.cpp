// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "apps/plots/pictures.h"
#include "apps/plots/raster.h"
#include "apps/report/samples.h"
#include "scene/offsets.h"

namespace bracket::apps {
namespace {

constexpr int longest = 1000;        // pixels of the bitmap; about two to one of the picture
constexpr double shortest_edge = 9;  // of these pixels: shorter edges would hide the colours
constexpr const char* viridis =
    "set palette defined (0 '#440154', 1 '#472d7b', 2 '#3b528b', 3 '#2c728e', 4 '#21918c', 5 '#28ae80', 6 '#5ec962', "
    "7 '#addc30', 8 '#fde725')\n";

using Line = std::vector<scene::Vector<2>>;

std::string line_data(const std::vector<Line>& lines) {
  std::string text;
  for (const Line& line : lines) {
    for (const scene::Vector<2>& point : line)
      fmt::format_to(std::back_inserter(text), "{:.9g} {:.9g}\n", point.x(), point.y());
    text += "\n";
  }
  return text + "e\n";
}

/// A canvas of the raster's shape: axes of equal scale, and the colours at the right.
Picture canvas(const char* name, std::string caption, const Raster& raster, const std::string& units) {
  const double scale = std::min(600.0 / raster.width, 560.0 / raster.height);
  const int width = std::max(220, static_cast<int>(scale * raster.width));
  const int height = std::max(200, static_cast<int>(scale * raster.height));
  const double x = raster.pixel * raster.width, y = raster.pixel * raster.height, margin = 0.02 * std::max(x, y);
  const auto range = [margin](double from, double size) {
    return fmt::format("[{}:{}]", from - margin, from + size + margin);
  };
  std::string script =
      plot_style() + "unset grid\nset size ratio -1\n" + viridis + units_label(units) +
      fmt::format("set xrange {}\nset yrange {}\n", range(raster.low.x(), x), range(raster.low.y(), y)) +
      "set lmargin at screen " + fmt::format("{}", 60.0 / (width + 200)) + "\nset rmargin at screen " +
      fmt::format("{}", (60.0 + width) / (width + 200)) + "\nset xlabel 'x'\nset ylabel 'y' rotate by 0\n";
  return {name, std::move(caption), width + 200, height + 80, std::move(script)};
}

std::vector<Line> contact_lines(const scene::Problem<2>& problem) {
  std::vector<Line> lines;
  for (const scene::ContactFacet& facet : problem.contact) {
    const auto& [a, b] = problem.mesh.boundary[facet.first].vertices;
    lines.push_back({problem.mesh.vertices[a], problem.mesh.vertices[b]});
  }
  return lines;
}

/// The boundary of all bodies.
std::vector<Line> outline(const scene::Mesh<2>& mesh) {
  std::vector<Line> lines;
  for (const auto& facet : mesh.boundary)
    lines.push_back({mesh.vertices[facet.vertices[0]], mesh.vertices[facet.vertices[1]]});
  return lines;
}

/// The same, moved by `factor` times u_h.
std::vector<Line> outline(const bounds::Outcome<2>& run, double factor) {
  const scene::Mesh<2>& mesh = run.problem.mesh;
  std::vector<Line> lines;
  for (const auto& facet : mesh.boundary) {
    const auto& [a, b] = facet.vertices;
    Line& line = lines.emplace_back();
    const int last = run.displacement.degree;
    for (int i = 0; i <= last; ++i) {
      const double t = static_cast<double>(i) / last;
      std::array<double, 3> point = {0, 0, 0};
      point[scene::Simplex<2>::facets[facet.local][0]] = 1 - t;
      point[scene::Simplex<2>::facets[facet.local][1]] = t;
      line.push_back((1 - t) * mesh.vertices[a] + t * mesh.vertices[b] +
                     factor * scene::displacement_at(mesh, run.displacement, facet.cell, point));
    }
  }
  return lines;
}

// Half the difference of the principal stresses in the plane: it needs no stress across the plane, which an anisotropic
// stiffness of the plane does not tell.
float shear(const scene::Voigt<2>& s) { return static_cast<float>(std::hypot((s[0] - s[1]) / 2, s[2])); }

/// How much larger displacements are drawn: the largest is about 6 % of the bodies' size. Two digits.
double magnification(const bounds::Outcome<2>& run) {
  double largest = 0;
  for (const scene::Vector<2>& u : run.displacement.vertex) largest = std::max(largest, u.norm());
  if (largest == 0) return 1;
  const double factor = 0.06 * run.problem.length_scale / largest;
  const double unit = std::pow(10, std::floor(std::log10(factor)) - 1);
  return std::floor(factor / unit) * unit;
}

/// A cell's six tiles: each of its parts cut in two at the midpoint of its edge, so that curved edges look curved.
std::array<Tile, 6> stress_tiles(const bounds::Outcome<2>& run, int cell, double factor) {
  const scene::Mesh<2>& mesh = run.problem.mesh;
  const auto& vertices = mesh.cells[cell];
  const auto sigma = bounds::displacement_stress(run.problem, run.displacement, cell);
  const int degree = run.stress.degree;
  const auto of_displacement = [&](const std::array<double, 3>& point) {
    return scene::value_on_triangle(sigma, scene::stress_degree(run.displacement.degree), point);
  };
  constexpr std::array<double, 3> centroid = {1.0 / 3, 1.0 / 3, 1.0 / 3};
  const scene::Vector<2> centre =
      (mesh.vertices[vertices[0]] + mesh.vertices[vertices[1]] + mesh.vertices[vertices[2]]) / 3 +
      factor * scene::displacement_at(mesh, run.displacement, cell, centroid);
  std::array<Tile, 6> tiles;
  for (int part = 0; part < 3; ++part) {
    const int a = (part + 1) % 3, b = (part + 2) % 3;
    const auto own = scene::stress_of_part(run.stress, cell, part);
    const std::vector<scene::Voigt<2>> lambda(own.begin(), own.end());
    const auto mean = [&](double t, double inside) {  // of both stresses, on the part's edge or at the centroid
      std::array<double, 3> point = {inside / 3, inside / 3, inside / 3};
      point[a] += (1 - inside) * (1 - t);
      point[b] += (1 - inside) * t;
      const auto equilibrated =
          scene::value_on_triangle(lambda, degree, {(1 - inside) * (1 - t), (1 - inside) * t, inside});
      return shear((equilibrated + of_displacement(point)) / 2);
    };
    const auto moved = [&](int k) -> scene::Vector<2> {
      return mesh.vertices[vertices[k]] + factor * run.displacement.vertex[vertices[k]];
    };
    std::array<double, 3> half = {0, 0, 0};
    half[a] = half[b] = 0.5;
    const scene::Vector<2> middle = (mesh.vertices[vertices[a]] + mesh.vertices[vertices[b]]) / 2 +
                                    factor * scene::displacement_at(mesh, run.displacement, cell, half);
    const float in_middle = mean(0.5, 0), in_centre = mean(0, 1);
    tiles[2 * part] = {{moved(a), middle, centre}, {mean(0, 0), in_middle, in_centre}};
    tiles[2 * part + 1] = {{middle, moved(b), centre}, {in_middle, mean(1, 0), in_centre}};
  }
  return tiles;
}

/// A mesh coloured by the density of what its cells have.
Picture density_picture(const char* name, std::string caption, const char* label, const scene::Problem<2>& problem,
                        const std::vector<double>& of_cell, const std::string& units) {
  const scene::Mesh<2>& mesh = problem.mesh;
  std::vector<Tile> tiles;
  for (int cell = 0; cell < static_cast<int>(mesh.cells.size()); ++cell) {
    const auto& [a, b, c] = mesh.cells[cell];
    const auto density = static_cast<float>(of_cell[cell] / scene::volume(mesh, cell));
    tiles.push_back({{mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]}, {density, density, density}});
  }
  Raster raster = rasterise(tiles, longest);
  // Equal colours for the hundredth of the area with least, and for what is too small to matter.
  const float highest = quantile(raster, 1), lowest = std::max(quantile(raster, 0.01), 1e-10f * highest);
  for (float& value : raster.value) value = value < lowest ? lowest : value;  // NaN stays

  std::vector<Line> edges;
  for (const auto& [a, b] : mesh.edges)
    if ((mesh.vertices[a] - mesh.vertices[b]).norm() > shortest_edge * raster.pixel)
      edges.push_back({mesh.vertices[a], mesh.vertices[b]});
  Picture picture = canvas(name, std::move(caption), raster, units);
  if (lowest > 0 && highest > lowest)
    picture.script += fmt::format("set logscale cb\nset cbrange [{}:{}]\nset format cb '10^{{%L}}'\n", lowest, highest);
  picture.script += fmt::format("set cblabel '{}'\nplot ", label) + image_item(raster) +
                    ", '-' with lines lw 0.4 lc rgb '#70ffffff' notitle, '-' with lines lw 1 lc rgb '#333333' notitle";
  if (!problem.contact.empty()) picture.script += ", '-' with lines lw 2.5 lc rgb '#ff2f5f' title 'contact'";
  picture.script += '\n';
  picture.script += image_bytes(raster) + "\n" + line_data(edges) + line_data(outline(mesh));
  if (!problem.contact.empty()) picture.script += line_data(contact_lines(problem));
  return picture;
}

}  // namespace

Picture mesh_picture(const Report& report) {
  return density_picture("mesh",
                         "The mesh coloured by the density of the error indicator: what each cell adds to the width, "
                         "by its area. Contact lines are red; edges too short to be seen are left out.",
                         "indicator by area", report.outcome.problem, report.outcome.indicator.cell,
                         report.scene.units);
}

Picture error_cells_picture(const scene::Scene<2>& scene, const bounds::Assessment& assessment) {
  return density_picture("error",
                         "Where the displacement is wrong: its mesh coloured by what each cell has of the squared "
                         "error, by its area. Contact lines are red; edges too short to be seen are left out.",
                         "squared error by area", assessment.field.problem, assessment.cell, scene.units);
}

Picture stress_picture(const Report& report) {
  const bounds::Outcome<2>& run = report.outcome;
  const double factor = magnification(run);
  std::vector<Tile> tiles;
  for (int cell = 0; cell < static_cast<int>(run.problem.mesh.cells.size()); ++cell)
    for (const Tile& tile : stress_tiles(run, cell, factor)) tiles.push_back(tile);
  const Raster raster = rasterise(tiles, longest);
  Picture picture =
      canvas("stress",
             fmt::format("The deformed bodies, displacements times {:g}, coloured by the largest shear stress "
                         "in the plane, ½(σ₁ − σ₂), of the mean of both stress fields. The highest ½ % of "
                         "the area have one colour. Grey: the bodies before.",
                         factor),
             raster, report.scene.units);
  const float highest = quantile(raster, 0.995);
  if (highest > 0) picture.script += fmt::format("set cbrange [0:{}]\n", highest);
  picture.script += "set cblabel 'largest shear stress'\nplot '-' with lines lw 0.8 lc rgb '#aaaaaa' notitle, " +
                    image_item(raster) + ", '-' with lines lw 1 lc rgb '#333333' notitle\n" +
                    line_data(outline(run.problem.mesh)) + image_bytes(raster) + "\n" + line_data(outline(run, factor));
  return picture;
}

}  // namespace bracket::apps
