// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/report/pairs.h"

#include <algorithm>
#include <cmath>

#include "apps/report/samples.h"

namespace bracket::apps {

namespace {

/// Whether a vertex of a contact slides along the direction d of the pair: on an axis of symmetry a contact line ends,
/// but goes on beyond it.
bool on_axis(const scene::Problem<2>& problem, int vertex, const scene::Vector<2>& d) {
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    if (problem.facets[f].support != scene::Support::sliding) continue;
    const auto& ends = problem.mesh.boundary[f].vertices;
    if ((ends[0] == vertex || ends[1] == vertex) && std::abs(problem.facets[f].normal.dot(d)) < 0.1) return true;
  }
  return false;
}

/// Why the pressure grows with refinement at one end of an edge of a chain; empty: it does not.
std::string growth(const Report& report, const Chain& chain, std::size_t place, int end) {
  const scene::Problem<2>& problem = report.outcome.problem;
  const auto facet = [&](std::size_t i) { return problem.contact[chain[i]].first; };
  const auto vertex = [&](std::size_t i, int of) { return problem.mesh.boundary[facet(i)].vertices[of]; };
  const std::size_t n = chain.size(), next = (place + (end == 0 ? n - 1 : 1)) % n;
  if (n == 1 || vertex(next, 1 - end) != vertex(place, end))
    return on_axis(problem, vertex(place, end), problem.facets[facet(place)].normal) ? ""
                                                                                     : "an end of the contact line";
  const int part = problem.mesh.boundary[facet(place)].part;
  const bool turns = problem.facets[facet(place)].normal != problem.facets[facet(next)].normal;
  return turns && !report.scene.curves.contains(problem.mesh.parts[part]) ? "a vertex at which the line turns" : "";
}

}  // namespace

template <int dim> std::string pair_name(const scene::ContactPair<dim>& pair) {
  return pair.name.empty() ? name(pair.first) + " on " + name(pair.second) : pair.name;
}

template <int dim> std::string law_text(const scene::ContactPair<dim>& pair) {
  switch (pair.law) {
    case scene::Law::frictionless: return "without friction";
    case scene::Law::bonded: return "bonded";
    case scene::Law::bilateral: return "without friction or lift-off";
    case scene::Law::winkler: return pair.lifts_off ? "on springs" : "on springs that pull, too";
    case scene::Law::coulomb: return "with Coulomb's friction";
    case scene::Law::tresca:
      return pair.lifts_off ? "with friction up to a bound" : "with friction up to a bound, no lift-off";
  }
  return "";
}

template std::string pair_name(const scene::ContactPair<2>&);
template std::string pair_name(const scene::ContactPair<3>&);
template std::string law_text(const scene::ContactPair<2>&);
template std::string law_text(const scene::ContactPair<3>&);

template <> PairSummary<2> summary(const Report& report, int pair) {
  const scene::Problem<2>& problem = report.outcome.problem;
  const double rounding = rounding_of_pressure(problem, report.outcome.stress, report.contact, pair);
  PairSummary<2> result;
  for (const Chain& chain : chains(problem, pair))
    for (std::size_t i = 0; i < chain.size(); ++i) {
      const int first = problem.contact[chain[i]].first;
      const auto& pressure = report.contact[chain[i]].pressure;
      const double length = scene::length(problem.mesh, first);
      for (const double p : pressure) result.force += length * p / static_cast<double>(pressure.size());
      result.length += length;
      if (presses(report.contact[chain[i]], rounding)) result.pressed_length += length;
      for (const double p : samples(pressure)) result.largest_tension = std::max(result.largest_tension, -p);
      if (has_friction(problem.contact[chain[i]].law)) {
        const auto [shear, slip] = bounds::shear_and_slip(problem, report.outcome.displacement, report.outcome.stress,
                                                          problem.contact[chain[i]]);
        for (const double t : shear) result.shear += length * t / static_cast<double>(shear.size());
        for (const double v : samples(slip)) result.largest_slip = std::max(result.largest_slip, std::abs(v));
      }
      const auto place = [&](std::size_t k, std::size_t last) -> scene::Vector<2> {
        const auto& [a, b] = scene::positions(problem.mesh, problem.mesh.boundary[first].vertices);
        return k == last ? b : scene::Vector<2>(a + static_cast<double>(k) / static_cast<double>(last) * (b - a));
      };
      const std::vector<double> gaps = samples(report.contact[chain[i]].gap_left);
      for (std::size_t k = 0; k < gaps.size(); ++k) {
        result.largest_shortening = std::max(result.largest_shortening, -gaps[k]);
        if (gaps[k] <= result.largest_gap) continue;
        result.largest_gap = gaps[k];
        result.gap_at = place(k, gaps.size() - 1);
      }
      const std::vector<double> values = samples(pressure);
      for (std::size_t k = 0; k < values.size(); ++k) {
        if (values[k] <= std::max(result.largest_pressure, rounding)) continue;
        const bool at_end = k == 0 || k + 1 == values.size();
        result.largest_pressure = values[k];
        result.at = place(k, values.size() - 1);
        result.grows = at_end ? growth(report, chain, i, k == 0 ? 0 : 1) : "";
      }
    }
  return result;
}

}  // namespace bracket::apps
