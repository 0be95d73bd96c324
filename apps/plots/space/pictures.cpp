// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/plots/space/pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "apps/plots/pictures.h"
#include "apps/report/pairs.h"
#include "apps/report/stresses.h"
#include "apps/report/units.h"
#include "apps/report/words.h"
#include "scene/text.h"

namespace bracket::apps {

using scene::Vector;

namespace {

/// From where bodies are seen.
Vector<3> from_front() { return {0.5, 0.4, 1}; }
Vector<3> from_behind() { return -from_front(); }

std::string bracketed(const std::string& what, const std::string& unit) {
  return unit.empty() ? what : fmt::format("{} [{}]", what, unit.substr(1));
}

bool has_gaps(const scene::Problem<3>& problem) {
  return std::ranges::any_of(problem.contact,
                             [](const auto& contact) { return contact.upper != scene::FacetQuadratic<3>{}; });
}

std::string magnified(const ReportOf<3>& report, const DrawnShapeOf<3>& shape) {
  return fmt::format("{} times {:g}", has_gaps(report.outcome.problem) ? "displacements and gaps" : "displacements",
                     shape.factor);
}

constexpr const char* of_both_fields =
    " the von Mises stress of the mean of both stress fields, computed, not guaranteed; the highest ½ % of what is "
    "seen "
    "have one colour.";
constexpr const char* shaded = " Faces that are turned from the light are up to a quarter darker than the bar.";

std::string place_of(const Eye& eye) {
  return fmt::format("({:.2f}, {:.2f}, {:.2f})", eye.to_eye.x(), eye.to_eye.y(), eye.to_eye.z());
}

/// Pieces of a surface as they are seen.
Sketch seen(std::vector<Tessera> pieces, const Eye& eye, const std::string& units, const std::string& what) {
  Sketch sketch;
  sketch.pieces = std::move(pieces);
  for (int k = 0; k < 3; ++k) sketch.axes[k] = eye.project(Vector<3>::Unit(k));
  sketch.length_unit = units_of(units, 3).length;
  sketch.legend = {fmt::format("{}seen from the direction {}, parallel rays", what, place_of(eye))};
  return sketch;
}
Sketch seen(const ReportOf<3>& report, const DrawnShapeOf<3>& shape, const Eye& eye, const SurfaceColour& colour) {
  return seen(surface(report.outcome.problem, report.outcome.displacement, shape, eye, colour), eye, report.scene.units,
              magnified(report, shape) + "; ");
}

/// Equal colours for the hundredth of what is seen with least, and for what is too small to matter.
ColourScale of_density(const std::vector<Tessera>& pieces, const char* label) {
  const double highest = quantile_by_area(pieces, 1);
  const double lowest = std::max(quantile_by_area(pieces, 0.01), 1e-10 * highest);
  return {.lowest = lowest, .highest = highest, .logarithmic = lowest > 0, .label = label};
}

ColourScale of_stress(const std::vector<Tessera>& pieces, const Units& units) {
  return {.lowest = 0, .highest = quantile_by_area(pieces, 0.995), .label = bracketed("von Mises", units.stress)};
}

Drawing stress_picture(const ReportOf<3>& report, const DrawnShapeOf<3>& shape, const Vector<3>& from,
                       const char* name) {
  const Eye eye(from);
  Sketch sketch = seen(report, shape, eye, by_von_mises(report.outcome));
  sketch.colours = of_stress(sketch.pieces, units_of(report.scene.units, 3));
  const std::string caption = "The deformed bodies, " + magnified(report, shape) + ", seen from " + place_of(eye) +
                              ", coloured by" + of_both_fields + shaded;
  return {.name = name, .caption = caption, .svg = svg(std::move(sketch)), .png = {}, .wide = false};
}

Drawing indicator_picture(const ReportOf<3>& report, const DrawnShapeOf<3>& shape, const Vector<3>& from) {
  Sketch sketch =
      seen(report, shape, Eye(from), by_density(report.outcome.problem.mesh, report.outcome.indicator.cell));
  sketch.colours = of_density(sketch.pieces, "indicator by volume");
  return {.name = "mesh",
          .caption =
              "The same bodies coloured by the density of the error indicator: what the cell at the surface adds "
              "to the width of the energy's interval, by its volume." +
              std::string(shaded),
          .svg = svg(std::move(sketch)),
          .png = {},
          .wide = false};
}

/// The pair whose pressure is the largest; −1: none presses.
int most_pressed(const ReportOf<3>& report) {
  int result = -1;
  double largest = 0;
  for (int pair = 0; pair < static_cast<int>(report.scene.contact.size()); ++pair)
    if (const double p = summary(report, pair).largest_pressure; p > largest) {
      largest = p;
      result = pair;
    }
  return result;
}

/// The direction of a pair's contact at a vertex of it.
Vector<3> direction_at(const scene::Problem<3>& problem, int pair, const Vector<3>& x) {
  for (const auto& contact : problem.contact)
    for (const int vertex : problem.mesh.boundary[contact.first].vertices)
      if (contact.pair == pair && problem.mesh.vertices[vertex] == x) return problem.facets[contact.first].normal;
  return Vector<3>::UnitY();
}

Drawing slice_picture(const ReportOf<3>& report, const DrawnShapeOf<3>& shape, int pair) {
  const PairSummary<3> of = summary(report, pair);
  const Vector<3> d = direction_at(report.outcome.problem, pair, of.at);
  int axis = 2;  // the most at right angles to the contact's direction
  for (const int other : {0, 1})
    if (std::abs(d[other]) < std::abs(d[axis]) - 1e-9) axis = other;
  constexpr std::array<std::array<int, 2>, 3> planes = {{{2, 1}, {0, 2}, {0, 1}}};
  const std::array<int, 2> plane = planes[axis];
  const Units units = units_of(report.scene.units, 3);
  Sketch sketch;
  sketch.pieces = slice(report.outcome, shape, axis, of.at[axis], plane);
  sketch.colours = of_stress(sketch.pieces, units);
  sketch.axes.fill(Vector<2>::Zero());
  sketch.axes[plane[0]] = {1, 0};
  sketch.axes[plane[1]] = {0, 1};
  sketch.length_unit = units.length;
  const std::string where = fmt::format("{} = {:.4g}{}", axis_names[axis], of.at[axis], units.length);
  sketch.legend = {fmt::format("slice {}; {}, as far as they lie in it", where, magnified(report, shape)),
                   fmt::format("largest pressure {:.4g}{} at {}{}", of.largest_pressure, units.stress,
                               scene::point(of.at), units.length)};
  for (const auto& contact : report.outcome.problem.contact)
    for (const int vertex : report.outcome.problem.mesh.boundary[contact.first].vertices)
      if (contact.pair == pair && report.outcome.problem.mesh.vertices[vertex] == of.at && sketch.rings.empty()) {
        const Vector<3> drawn = of.at + shape.factor * report.outcome.displacement.vertex[vertex] + shape.shift[vertex];
        sketch.rings.emplace_back(drawn[plane[0]], drawn[plane[1]]);
      }
  return {.name = "slice",
          .caption = fmt::format("The slice {} through the largest contact pressure, of {} (ring), coloured by{}",
                                 where, pair_name(report.scene.contact[pair]), of_both_fields),
          .svg = svg(std::move(sketch)),
          .png = {},
          .wide = false};
}

}  // namespace

SurfaceColour by_von_mises(const bounds::Outcome<3>& run) {
  return [&run](int facet) -> FaceColour {
    const auto& face = run.problem.mesh.boundary[facet];
    return [&run, &face,
            sigma = bounds::displacement_stress(run.problem, run.displacement, face.cell)](const InCell& in_part) {
      return von_mises(mean_stress(sigma, run.stress, face.cell, face.local, in_part));
    };
  };
}

SurfaceColour by_density(const scene::Mesh<3>& mesh, const std::vector<double>& of_cell) {
  return [&mesh, &of_cell](int facet) -> FaceColour {
    const int cell = mesh.boundary[facet].cell;
    return [density = of_cell[cell] / scene::volume(mesh, cell)](const InCell&) { return density; };
  };
}

std::vector<Drawing> space_pictures(const ReportOf<3>& report) {
  const scene::Problem<3>& problem = report.outcome.problem;
  const DrawnShapeOf<3> shape = drawn_shape(problem, magnification(problem, report.outcome.displacement));
  std::vector<Drawing> drawings = {stress_picture(report, shape, from_front(), "stress"),
                                   stress_picture(report, shape, from_behind(), "stress_behind")};
  if (const int pair = most_pressed(report); pair >= 0) drawings.push_back(slice_picture(report, shape, pair));
  if (!error_is_rounding(report.outcome)) drawings.push_back(indicator_picture(report, shape, from_front()));
  return drawings;
}

std::vector<Drawing> error_cells_pictures(const scene::Scene<3>& scene, const bounds::AssessmentOf<3>& assessment) {
  const scene::Problem<3>& problem = assessment.field.problem;
  const DrawnShapeOf<3> undeformed = {
      .factor = 0,
      .shift = std::vector<Vector<3>>(problem.mesh.vertices.size(), Vector<3>::Zero()),
      .beside = std::vector<scene::FacetQuadratic<3>>(problem.mesh.boundary.size(), scene::FacetQuadratic<3>{})};
  std::vector<Drawing> drawings;
  for (const auto& [name, from] : {std::pair("error", from_front()), std::pair("error_behind", from_behind())}) {
    const Eye eye(from);
    Sketch sketch = seen(surface(problem, assessment.field.given.displacement, undeformed, eye,
                                 by_density(problem.mesh, assessment.cell)),
                         eye, scene.units, "");
    sketch.colours = of_density(sketch.pieces, "squared error by volume");
    drawings.push_back({.name = name,
                        .caption = "Where the displacement is wrong: its mesh, seen from " + place_of(eye) +
                                   ", coloured by what the cell at the surface has of the squared error, by its "
                                   "volume." +
                                   shaded,
                        .svg = svg(std::move(sketch)),
                        .png = {},
                        .wide = false});
  }
  return drawings;
}

Drawings drawn(const ReportOf<3>& report, bool png) {
  Drawings drawings = draw(level_pictures(report), png);
  const std::vector<Drawing> bodies = space_pictures(report);
  drawings.drawn.insert(drawings.drawn.begin(), bodies.begin(), bodies.end());
  if (png) drawings.missing.emplace_back("pictures of the bodies as PNG: in space they are SVG alone");
  return drawings;
}

}  // namespace bracket::apps
