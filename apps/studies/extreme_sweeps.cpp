// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>

#include "apps/studies/extreme_problems.h"
#include "apps/studies/extremes.h"

namespace bracket::apps {
namespace {

using scene::Problem;
using scene::Vector;

/// base^from, base^(from + step), … base^to
std::vector<double> powers(double base, int from, int to, int step) {
  std::vector<double> result;
  for (int exponent = from; step > 0 ? exponent <= to : exponent >= to; exponent += step)
    result.push_back(std::pow(base, exponent));
  return result;
}

// About 1e-12 … 1e12, in powers of two: multiplication is exact then, and so is the reference.
std::vector<double> exact_factors() { return powers(2, -40, 40, 10); }

std::vector<Sweep> of_units(const Problem<2>& benign) {
  return {{"unit of length", exact_factors(), [benign](double unit) { return in_units(benign, unit, 1); },
           [](double unit) { return unit * unit; }, ""},
          {"unit of force", exact_factors(), [benign](double unit) { return in_units(benign, 1, unit); },
           [](double unit) { return unit; }, ""},
          {"load", exact_factors(), [benign](double factor) { return with_loads_times(benign, factor); },
           [](double factor) { return factor * factor; }, ""}};
}

std::vector<Sweep> of_materials(const scene::Scene<2>& scene, const Problem<2>& benign) {
  Sweep ratio{"modulus ratio",
              powers(10, -12, 12, 3),
              [benign](double factor) { return with_moduli_times(benign, 0, factor); },
              {},
              ""};
  if (benign.bodies.size() == 1) ratio.left_out = "the scene has one body";
  Sweep volume{
      "1/2 - nu", powers(10, -1, -8, -1), [benign](double left) { return with_poisson(benign, 0.5 - left); }, {}, ""};
  const bool isotropic =
      std::ranges::any_of(benign.bodies, [](const auto& body) { return body.material.constants().has_value(); });
  if (scene.plane == scene::Plane::stress)
    volume.left_out = "in plane stress nothing becomes stiff as nu approaches 1/2";
  else if (!isotropic)
    volume.left_out = "no body is isotropic";
  return {ratio, volume};
}

std::vector<Sweep> of_shapes(const scene::Scene<2>& scene, const Problem<2>& benign) {
  const auto same = [](double) { return 1.0; };
  return {{"flat cells", powers(10, -1, -6, -1),
           [benign](double height) {
             return with_cells_cut(benign, {height, (1 - height) / 2, (1 - height) / 2});
           },
           same, ""},
          {"needles", powers(10, -1, -6, -1),
           [benign](double side) {
             return with_cells_cut(benign, {1 - side, side / 2, side / 2});
           },
           same, ""},
          {"thin bodies", powers(10, 0, -4, -1), [scene](double factor) { return flattened(scene, factor); }, {}, ""}};
}

Sweep of_contact_end(const Problem<2>& benign) {
  Sweep sweep{"contact end", powers(10, -1, -8, -1), {}, {}, ""};
  const auto end = contact_end(benign);
  if (benign.contact.empty())
    sweep.left_out = "the scene has no contact";
  else if (!end)
    sweep.left_out = "the contact lines close on themselves";
  else
    sweep.make = [benign, where = *end](double distance) { return with_end_freed(benign, where, distance); };
  return sweep;
}

bool solvable(const Problem<2>& problem, int degree) {
  try {
    bounds::balanced(problem, degree);
  } catch (const scene::Error& error) {
    if (error.status() != scene::Status::ill_posed) throw;
    return false;
  }
  return true;
}

/// Where solvability ends as s grows from 0 and the problem becomes changed(s); none up to about 1e6.
std::optional<double> edge_of_solvability(const std::function<Problem<2>(double)>& changed, int degree) {
  double good = 0, bad = 0.5;
  for (; solvable(changed(bad), degree); bad *= 2) {
    if (bad > 1e6) return std::nullopt;
    good = bad;
  }
  for (double middle = (good + bad) / 2; good < middle && middle < bad; middle = (good + bad) / 2)
    (solvable(changed(middle), degree) ? good : bad) = middle;
  return good;
}

/// The loads of changed((1 − distance) s), where solvability ends at s. Pressures that are linear on each edge balance
/// a resultant close to the end of a contact line only if the edge there is as short.
Sweep towards_edge(const std::string& name, const std::function<Problem<2>(double)>& changed, int degree) {
  Sweep sweep{name, powers(10, -1, -8, -1), {}, {}, ""};
  const auto edge = edge_of_solvability(changed, degree);
  if (!edge)
    sweep.left_out = "supports and contact hold however large the change of the loads is";
  else
    sweep.make = [changed, s = *edge](double distance) {
      return with_ends_refined(changed((1 - distance) * s), static_cast<int>(std::ceil(std::log2(1 / distance))));
    };
  return sweep;
}

/// Where the contact begins to open as s grows from 0, which all of it being closed is linear in s; none if part of it
/// is open or it is pressed the more.
std::optional<double> edge_of_contact(const scene::Scene<2>& settings, const std::function<Problem<2>(double)>& changed,
                                      double step) {
  std::vector<std::vector<bounds::ContactState>> states;
  for (const double s : {0.0, step}) {
    const bounds::Outcome<2> outcome = bounds::run(settings, changed(s));
    if (outcome.levels.empty() || outcome.levels[0].primal.active_rows < outcome.levels[0].primal.rows ||
        outcome.levels[0].dual.active_rows < outcome.levels[0].dual.rows)
      return std::nullopt;
    states.push_back(bounds::contact_state(outcome.problem, outcome.displacement, outcome.stress));
  }
  double edge = std::numeric_limits<double>::infinity();
  for (std::size_t j = 0; j < states[0].size(); ++j)
    for (std::size_t k = 0; k < states[0][j].pressure.size(); ++k) {
      const double before = states[0][j].pressure[k], after = states[1][j].pressure[k];
      if (after < before) edge = std::min(edge, step * before / (before - after));
    }
  return std::isfinite(edge) ? std::optional(edge) : std::nullopt;
}

std::vector<Sweep> of_loads(const scene::Scene<2>& scene, const Problem<2>& benign) {
  const std::array<std::string, 3> names = {"lift-off", "resultant to the end", "resultant to zero"};
  const auto none = [&](const std::string& why) {
    std::vector<Sweep> sweeps;
    for (const std::string& name : names) sweeps.push_back({name, {}, {}, {}, why});
    return sweeps;
  };
  const Loading loads = loading(benign);
  if (benign.contact.empty()) return none("the scene has no contact");
  if (loads.facets.empty()) return none("no boundary part is loaded");
  const auto tilted = [benign, loads](double s) {
    const Vector<2> mean = loads.moment < 0 ? Vector<2>(-loads.mean) : loads.mean;
    return with_traction(benign, loads, [&](const Vector<2>& x) -> Vector<2> {
      return s * (x - loads.centre).dot(loads.reach) / loads.reach.squaredNorm() * mean;
    });
  };
  const auto weakened = [benign, loads](double s) {
    return with_traction(benign, loads, [&](const Vector<2>&) -> Vector<2> { return -s * loads.mean; });
  };
  scene::Scene<2> settings = scene;
  settings.refine = {};
  Sweep open{names[0], powers(10, -1, -8, -1), {}, {}, ""};
  const auto edge = edge_of_contact(settings, tilted, 1e-3);
  if (!edge)
    open.left_out = "part of the contact is open, or tilting the loads does not open it";
  else
    open.make = [tilted, s = *edge](double distance) { return tilted((1 - distance) * s); };
  const int degree = scene.solve.degree;
  return {open, towards_edge(names[1], tilted, degree), towards_edge(names[2], weakened, degree)};
}

}  // namespace

std::vector<Sweep> extreme_sweeps(const scene::Scene<2>& scene, const Problem<2>& benign) {
  std::vector<Sweep> all;
  const auto add = [&](const std::vector<Sweep>& sweeps) { all.insert(all.end(), sweeps.begin(), sweeps.end()); };
  add(of_units(benign));
  add(of_materials(scene, benign));
  add(of_shapes(scene, benign));
  add({of_contact_end(benign)});
  add(of_loads(scene, benign));
  return all;
}

}  // namespace bracket::apps
