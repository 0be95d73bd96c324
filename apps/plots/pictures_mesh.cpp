// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "apps/plots/canvas.h"
#include "apps/plots/pictures.h"

namespace bracket::apps {
namespace {

constexpr double shortest_edge = 9;  // of the bitmap's pixels: shorter edges would hide the colours

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
  Raster raster = rasterise(tiles, longest_side);
  // Equal colours for the hundredth of the area with least, and for what is too small to matter.
  const float highest = quantile(raster, 1), lowest = std::max(quantile(raster, 0.01), 1e-10f * highest);
  for (float& value : raster.value) value = value < lowest ? lowest : value;  // NaN stays

  std::vector<Line> edges;
  for (const auto& [a, b] : mesh.edges)
    if ((mesh.vertices[a] - mesh.vertices[b]).norm() > shortest_edge * raster.pixel)
      edges.push_back({mesh.vertices[a], mesh.vertices[b]});
  Picture picture = canvas(name, std::move(caption), box_of(raster), units);
  if (lowest > 0 && highest > lowest)
    picture.script += fmt::format("set logscale cb\nset cbrange [{}:{}]\nset format cb '10^{{%L}}'\n", lowest, highest);
  std::vector<Layer> layers = {image_layer(raster), lines_layer(edges, "lw 0.4 lc rgb '#70ffffff' notitle"),
                               lines_layer(outline(mesh), "lw 1 lc rgb '#333333' notitle")};
  if (!problem.contact.empty())
    layers.push_back(lines_layer(contact_lines(problem), "lw 2.5 lc rgb '#ff2f5f' title 'contact'"));
  picture.script += fmt::format("set cblabel '{}'\n", label) + plot_command(layers);
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

}  // namespace bracket::apps
