// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "apps/plots/canvas.h"
#include "apps/plots/pictures.h"
#include "apps/plots/symbols.h"
#include "apps/report/deformed.h"
#include "apps/report/samples.h"
#include "apps/report/stresses.h"
#include "scene/bernstein.h"

namespace bracket::apps {
namespace {

using scene::Vector;

/// A measure of a stress in a body.
using Measure = std::function<double(int body, const scene::Voigt<2>& stress)>;

/// The run, and where it is drawn.
struct Drawn {
  const bounds::Outcome<2>& run;
  DrawnShape shape;
  std::vector<std::array<int, 3>> facet;  ///< of each cell: its boundary facets, −1: none
};

Drawn drawn(const bounds::Outcome<2>& run) {
  return {run, drawn_shape(run.problem, magnification(run.problem, run.displacement)),
          facets_of_cells(run.problem.mesh)};
}

/// A point of a cell on the side opposite to vertex `part`, at t from the next vertex to the one after.
Vector<2> on_side(const Drawn& drawn, int cell, int part, double t) {
  const int facet = drawn.facet[cell][part];
  const auto& [from, to] = scene::Simplex<2>::facets[part];
  if (facet >= 0)
    return drawn_on_facet(drawn.run.problem, &drawn.run.displacement, drawn.shape, facet,
                          from == (part + 1) % 3 ? t : 1 - t);
  std::array<double, 3> point = {0, 0, 0};
  point[(part + 1) % 3] = 1 - t;
  point[(part + 2) % 3] = t;
  return drawn_in_cell(drawn.run.problem, drawn.run.displacement, drawn.shape, cell, point);
}

/// A cell's tiles: each of its parts cut along its side, so that curved sides look curved.
void add_tiles(std::vector<Tile>& tiles, const Drawn& drawn, const Measure& measure, int cell) {
  const bounds::Outcome<2>& run = drawn.run;
  const auto sigma = bounds::displacement_stress(run.problem, run.displacement, cell);
  constexpr std::array<double, 3> centroid = {1.0 / 3, 1.0 / 3, 1.0 / 3};
  const Vector<2> centre = drawn_in_cell(run.problem, run.displacement, drawn.shape, cell, centroid);
  const int pieces = std::max(2, run.displacement.degree);
  for (int part = 0; part < 3; ++part) {
    const int a = (part + 1) % 3, b = (part + 2) % 3;
    const auto own = scene::stress_of_part(run.stress, cell, part);
    const std::vector<scene::Voigt<2>> lambda(own.begin(), own.end());
    const auto mean = [&](double t, double inside) {  // of both stresses, on the part's side or at the centroid
      std::array<double, 3> point = {inside / 3, inside / 3, inside / 3};
      point[a] += (1 - inside) * (1 - t);
      point[b] += (1 - inside) * t;
      const auto equilibrated =
          scene::value_on_triangle(lambda, run.stress.degree, {(1 - inside) * (1 - t), (1 - inside) * t, inside});
      const auto of_displacement =
          scene::value_on_triangle(sigma, scene::stress_degree(run.displacement.degree), point);
      return static_cast<float>(measure(run.problem.mesh.cell_body[cell], (equilibrated + of_displacement) / 2));
    };
    for (int i = 0; i < pieces; ++i) {
      const double from = static_cast<double>(i) / pieces, to = static_cast<double>(i + 1) / pieces;
      tiles.push_back({{on_side(drawn, cell, part, from), on_side(drawn, cell, part, to), centre},
                       {mean(from, 0), mean(to, 0), mean(0, 1)}});
    }
  }
}

/// A curve along a facet, in as many pieces as it needs to look curved.
Line along(int degree, const std::function<Vector<2>(double)>& at) {
  const int last = std::max(4, 2 * degree);
  Line line;
  for (int i = 0; i <= last; ++i) line.push_back(at(static_cast<double>(i) / last));
  return line;
}

/// The boundary of all bodies, deformed or as they were.
std::vector<Line> outline(const Drawn& drawn, bool deformed) {
  const auto& [run, shape, facets] = drawn;
  std::vector<Line> lines;
  for (int facet = 0; facet < static_cast<int>(run.problem.mesh.boundary.size()); ++facet)
    lines.push_back(along(run.displacement.degree, [&, facet](double t) {
      return drawn_on_facet(drawn.run.problem, deformed ? &drawn.run.displacement : nullptr, drawn.shape, facet, t);
    }));
  return lines;
}

/// The contact lines: where the stresses press, where they do not, what does not move, and the pressure as a height
/// over them.
struct ContactLines {
  std::vector<Line> pressed, open, walls, pressure;
};

ContactLines contact_lines(const Report& report, const Drawn& drawn, double height) {
  const scene::Problem<2>& problem = drawn.run.problem;
  const scene::Displacement<2>& u = drawn.run.displacement;
  const int degree = std::max(u.degree, drawn.run.stress.degree);
  ContactLines lines;
  for (int pair = 0; pair < static_cast<int>(report.scene.contact.size()); ++pair) {
    const double rounding = rounding_of_pressure(problem, drawn.run.stress, report.contact, pair);
    const double top = drawn_pressure(report, pair);
    for (const Chain& chain : chains(problem, pair)) {
      Line side, heights;  // of what is pressed without a break
      const auto end = [&] {
        if (side.empty()) return;
        lines.pressed.push_back(side);
        side.insert(side.end(), heights.rbegin(), heights.rend());
        lines.pressure.push_back(std::move(side));
        side.clear(), heights.clear();
      };
      for (const int i : chain) {
        const scene::ContactFacet& contact = problem.contact[i];
        const auto at = [&](double t) { return drawn_on_facet(problem, &u, drawn.shape, contact.first, t); };
        const Line line = along(degree, at);
        if (contact.second < 0)
          lines.walls.push_back(
              along(degree, [&](double t) { return drawn_opposite(problem, &u, drawn.shape, contact, t); }));
        if (!presses(report.contact[i], rounding)) {
          end();
          lines.open.push_back(line);
          continue;
        }
        side.insert(side.end(), line.begin(), line.end());
        const Line high = along(degree, [&](double t) -> Vector<2> {
          const double p = std::min(scene::value_on_segment(report.contact[i].pressure, t) / top, 1.0);
          return at(t) - height * p * problem.facets[contact.first].normal;
        });
        heights.insert(heights.end(), high.begin(), high.end());
      }
      end();
    }
  }
  return lines;
}

void add_contact(std::vector<Layer>& layers, const ContactLines& lines) {
  layers.push_back(lines_layer(lines.walls, "lw 3 lc rgb '#555555' notitle"));
  if (!lines.pressed.empty()) {
    layers.push_back(
        {"'-' with filledcurves closed fc rgb '#ffffff' fs transparent solid 0.6 border lc rgb '#ffffff' notitle",
         line_data(lines.pressure)});
    layers.push_back(lines_layer(lines.pressed, "lw 4.5 lc rgb '#ff2f5f' title 'pressed'"));
  }
  if (!lines.open.empty()) layers.push_back(lines_layer(lines.open, "lw 1.6 lc rgb '#ff2f5f' title 'open'"));
}

/// \param whole with supports, loads, names and contact
Picture coloured(const Report& report, const char* name, const std::string& caption, const char* label,
                 const Measure& measure, bool whole) {
  const Drawn shape = drawn(report.outcome);
  std::vector<Tile> tiles;
  for (int cell = 0; cell < static_cast<int>(report.outcome.problem.mesh.cells.size()); ++cell)
    add_tiles(tiles, shape, measure, cell);
  const Raster raster = rasterise(tiles, longest_side);
  Eigen::AlignedBox2d box = box_of(raster);
  const double size = box.sizes().maxCoeff();
  const std::vector<Line> before = outline(shape, false);
  box = box_of(box, before);
  std::vector<Layer> layers = {image_layer(raster), lines_layer(before, "lw 0.8 lc rgb '#aaaaaa' notitle"),
                               lines_layer(outline(shape, true), "lw 1 lc rgb '#333333' notitle")};
  std::string labels;
  if (whole) {
    const ContactLines lines = contact_lines(report, shape, 0.09 * size);
    add_contact(layers, lines);
    box = box_of(box, lines.walls);
    const Symbols marks = symbols(report.outcome.problem, report.outcome.displacement, shape.shape, size);
    layers.insert(layers.end(), marks.layers.begin(), marks.layers.end());
    labels = marks.labels;
    if (!marks.box.isEmpty()) box.extend(marks.box);
  }
  Picture picture = canvas(name, fmt::format(fmt::runtime(caption), shape.shape.factor), box, report.scene.units);
  const float highest = quantile(raster, 0.995);
  if (highest > 0) picture.script += fmt::format("set cbrange [0:{}]\n", highest);
  picture.script += fmt::format("set cblabel {} noenhanced\n", with_unit(label, stress_unit(report.scene.units))) +
                    labels + plot_command(layers);
  return picture;
}

constexpr const char* measured =
    " of the mean of both stress fields, computed, not guaranteed; the highest ½ % of the area have one colour.";

double shear(int, const scene::Voigt<2>& stress) { return largest_shear(stress); }

}  // namespace

Picture bodies_picture(const Report& report) {
  const scene::Problem<2>& problem = report.outcome.problem;
  const scene::Plane plane = report.scene.plane;
  const bool across = knows_stress_across(problem, plane);
  const Measure equivalent = [&](int body, const scene::Voigt<2>& stress) {
    return von_mises(stress, *stress_across(problem.bodies[body].material, plane, stress));
  };
  std::string caption = std::string("The deformed bodies, displacements times {0:g}, coloured by the ") +
                        (across ? "equivalent stress (von Mises)" : "largest shear stress in the plane") + measured +
                        " Arrows: loads, at a name the body force; hatches: fixed; circles: sliding; grey: before.";
  const bool gaps = std::ranges::any_of(
      problem.contact, [](const scene::ContactFacet& contact) { return contact.upper != std::array<double, 3>{}; });
  if (gaps)
    caption +=
        " Gaps and interferences are drawn times {0:g} as well, so that bodies touch where contact is closed and "
        "overlap nowhere, and are apart by what is left of the gap; before, in grey, they show all of it.";
  if (!problem.contact.empty()) caption += " Thick: the stresses press, with the pressure as a height; thin: open.";
  return coloured(report, "stress", caption, across ? "von Mises" : "largest shear",
                  across ? equivalent : Measure(shear), true);
}

Picture shear_picture(const Report& report) {
  return coloured(report, "shear",
                  std::string("The same bodies, coloured by the largest shear stress in the plane, ½(σ₁ − σ₂),") +
                      measured + " Displacements and gaps times {:g}.",
                  "largest shear", shear, false);
}

}  // namespace bracket::apps
