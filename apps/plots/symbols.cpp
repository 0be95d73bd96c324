// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/plots/symbols.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

#include "apps/report/samples.h"

namespace bracket::apps {
namespace {

using scene::Vector;

/// A place on a boundary part.
struct Place {
  Vector<2> at, outward;
  int facet;
  double t;
};

/// The bodies as they are drawn, and how large.
struct DrawnBodies {
  const scene::Problem<2>& problem;
  const scene::Displacement<2>& displacement;
  const DrawnShape& shape;
  double size;

  Place place(int facet, double t) const {
    return {drawn_on_facet(problem, &displacement, shape, facet, t), scene::normal(problem.mesh, facet), facet, t};
  }
};

/// Facets that follow one another, divided into pieces of about equal length: their middles.
std::vector<Place> middles(const DrawnBodies& drawn, const std::vector<int>& facets, double piece) {
  const scene::Mesh<2>& mesh = drawn.problem.mesh;
  double all = 0;
  for (const int facet : facets) all += scene::length(mesh, facet);
  const int n = std::max(1, static_cast<int>(std::lround(all / piece)));
  std::vector<Place> result;
  double from = 0;
  for (const int facet : facets) {
    const double length = scene::length(mesh, facet);
    for (double s; result.size() < static_cast<std::size_t>(n) &&
                   (s = (static_cast<double>(result.size()) + 0.5) * all / n) <= from + length;)
      result.push_back(drawn.place(facet, std::min(1.0, (s - from) / length)));
    from += length;
  }
  return result;
}

/// The load at a place, force by area.
Vector<2> load_at(const scene::Problem<2>& problem, const Place& place) {
  const scene::FacetData<2>& data = problem.facets[place.facet];
  if (data.support != scene::Support::traction) return Vector<2>::Zero();
  return scene::traction_at(data, place.t) - scene::pressure_at(data, place.t) * place.outward;
}

/// Parts with a condition, and of each the pieces that hang together.
std::map<int, std::vector<std::vector<int>>> parts(const scene::Problem<2>& problem) {
  std::map<int, std::vector<int>> facets;
  for (int i = 0; i < static_cast<int>(problem.facets.size()); ++i) {
    const bool load = problem.facets[i].support == scene::Support::traction && scene::is_loaded(problem.facets[i]);
    const bool held =
        problem.facets[i].support == scene::Support::fixed || problem.facets[i].support == scene::Support::sliding;
    if (load || held) facets[problem.mesh.boundary[i].part].push_back(i);
  }
  std::map<int, std::vector<std::vector<int>>> result;
  for (const auto& [part, all] : facets)
    for (const Chain& chain : chained(problem.mesh, all)) {
      std::vector<int>& piece = result[part].emplace_back();
      for (const int i : chain) piece.push_back(all[i]);
    }
  return result;
}

/// What is drawn of all parts.
struct Marks {
  std::vector<Line> hatches, rollers, arrows, names;
  std::string labels;
};

std::string label(const std::string& text, const Vector<2>& at, const char* more) {
  return fmt::format("set label {} at {:.9g},{:.9g} center noenhanced front {}\n", quoted(text), at.x(), at.y(), more);
}

void add_support(Marks& marks, const DrawnBodies& drawn, const std::vector<int>& piece, bool fixed) {
  const double step = (fixed ? 0.025 : 0.06) * drawn.size, length = 0.025 * drawn.size;
  for (const Place& place : middles(drawn, piece, step)) {
    const Vector<2>& n = place.outward;
    if (fixed)
      marks.hatches.push_back({place.at, place.at + length * (n + Vector<2>(-n.y(), n.x())) / std::sqrt(2.0)});
    else
      marks.rollers.push_back({place.at + 0.4 * length * n});
  }
}

/// An arrow's tip is on the part where the load presses, its tail where it pulls.
void add_loads(Marks& marks, const DrawnBodies& drawn, const std::vector<int>& piece, double largest) {
  for (const Place& place : middles(drawn, piece, 0.05 * drawn.size)) {
    const Vector<2> arrow = 0.1 * drawn.size / largest * load_at(drawn.problem, place);
    if (arrow.norm() < 0.004 * drawn.size) continue;
    const Vector<2> tail = arrow.dot(place.outward) < 0 ? Vector<2>(place.at - arrow) : place.at;
    marks.arrows.push_back({tail, tail + arrow});
  }
}

/// The largest load at a place that has an arrow.
double largest_load(const DrawnBodies& drawn, const std::map<int, std::vector<std::vector<int>>>& all) {
  double largest = 0;
  for (const auto& [part, pieces] : all)
    for (const auto& piece : pieces)
      for (const Place& place : middles(drawn, piece, 0.05 * drawn.size))
        largest = std::max(largest, load_at(drawn.problem, place).norm());
  return largest;
}

/// Beside the middle of the longest piece, and along it where that stands upright.
void add_name(Marks& marks, const DrawnBodies& drawn, int part, const std::vector<std::vector<int>>& pieces,
              double beyond) {
  if (part < 0) return;
  const scene::Mesh<2>& mesh = drawn.problem.mesh;
  const auto length = [&](const std::vector<int>& piece) {
    double sum = 0;
    for (const int facet : piece) sum += scene::length(mesh, facet);
    return sum;
  };
  const auto& longest_piece = *std::ranges::max_element(pieces, {}, length);
  const Place place = middles(drawn, longest_piece, length(longest_piece)).at(0);
  const bool upright = std::abs(place.outward.x()) > 0.75;
  const Vector<2> at = place.at + beyond * drawn.size * place.outward;
  marks.names.push_back({at});
  marks.labels += label(mesh.parts[part], at, upright ? "rotate by 90 font ',14'" : "font ',14'");
}

/// Whether a point is in a cell as it is drawn.
bool is_in(const DrawnBodies& drawn, const Vector<2>& point, int cell) {
  std::array<Vector<2>, 3> to;
  for (int k = 0; k < 3; ++k) {
    std::array<double, 3> corner = {0, 0, 0};
    corner[k] = 1;
    to[k] = drawn_in_cell(drawn.problem, drawn.displacement, drawn.shape, cell, corner) - point;
  }
  const auto left = [&](int k) { return to[k].x() * to[(k + 1) % 3].y() - to[k].y() * to[(k + 1) % 3].x() >= 0; };
  return left(0) && left(1) && left(2);
}

/// Names, at each body's centre of area if that is in it, else in its largest cell; from there the body force.
void add_bodies(Marks& marks, const DrawnBodies& drawn) {
  const scene::Mesh<2>& mesh = drawn.problem.mesh;
  const std::size_t n = mesh.bodies.size();
  std::vector<double> area(n, 0), largest(n, 0);
  std::vector<Vector<2>> centre(n, Vector<2>::Zero()), place(n, Vector<2>::Zero());
  constexpr std::array<double, 3> third = {1.0 / 3, 1.0 / 3, 1.0 / 3};
  for (int cell = 0; cell < static_cast<int>(mesh.cells.size()); ++cell) {
    const int body = mesh.cell_body[cell];
    const double size = scene::volume(mesh, cell);
    const Vector<2> at = drawn_in_cell(drawn.problem, drawn.displacement, drawn.shape, cell, third);
    area[body] += size;
    centre[body] += size * at;
    if (size > largest[body]) largest[body] = size, place[body] = at;
  }
  for (std::size_t body = 0; body < n; ++body) centre[body] /= area[body];
  for (int cell = 0; cell < static_cast<int>(mesh.cells.size()); ++cell)
    if (const int body = mesh.cell_body[cell]; is_in(drawn, centre[body], cell)) place[body] = centre[body];
  for (std::size_t body = 0; body < n; ++body) {
    marks.labels += label(mesh.bodies[body], place[body], "boxed");
    const Vector<2>& force = drawn.problem.bodies[body].force;
    if (force.norm() == 0) continue;
    const Vector<2> along = drawn.size * force.normalized();
    marks.arrows.push_back({place[body] + 0.04 * along, place[body] + 0.12 * along});
  }
}

Layer pairs_layer(const std::vector<Line>& arrows) {
  std::string data;
  for (const Line& line : arrows)
    fmt::format_to(std::back_inserter(data), "{:.9g} {:.9g} {:.9g} {:.9g}\n", line[0].x(), line[0].y(),
                   line[1].x() - line[0].x(), line[1].y() - line[0].y());
  return {"'-' with vectors head filled size screen 0.016,18 lw 1.3 lc rgb '#b3261e' notitle", data + "e\n"};
}

}  // namespace

Symbols symbols(const scene::Problem<2>& problem, const scene::Displacement<2>& displacement, const DrawnShape& shape,
                double size) {
  const DrawnBodies drawn{problem, displacement, shape, size};
  const auto all = parts(problem);
  const double largest = largest_load(drawn, all);
  Marks marks;
  for (const auto& [part, pieces] : all) {
    bool presses = false;
    for (const auto& piece : pieces) {
      const scene::Support support = problem.facets[piece[0]].support;
      const std::size_t before = marks.arrows.size();
      if (support == scene::Support::traction)
        add_loads(marks, drawn, piece, largest);
      else
        add_support(marks, drawn, piece, support == scene::Support::fixed);
      presses = presses || marks.arrows.size() > before;
    }
    add_name(marks, drawn, part, pieces, presses ? 0.13 : 0.055);
  }
  add_bodies(marks, drawn);
  Symbols result;
  result.labels = "set style textbox opaque noborder fillcolor rgb '#50ffffff' margins 0.6,0.4\n" + marks.labels;
  result.layers.push_back(lines_layer(marks.hatches, "lw 1.2 lc rgb '#333333' notitle"));
  result.layers.push_back(
      {fmt::format("'-' using 1:2:({:.9g}) with circles lw 1.2 lc rgb '#333333' notitle", 0.01 * size),
       line_data(marks.rollers)});
  if (!marks.arrows.empty()) result.layers.push_back(pairs_layer(marks.arrows));
  for (const auto* lines : {&marks.hatches, &marks.rollers, &marks.arrows, &marks.names})
    result.box = box_of(result.box, *lines);
  return result;
}

}  // namespace bracket::apps
