// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// Planar, but for the end: data on edges.
#include <algorithm>
#include <cmath>
#include <limits>

#include "bounds/estimate/on_mesh.h"
#include "scene/problem/difference.h"
#include "scene/problem/given_gap.h"
#include "scene/problem/stretch.h"
#include "scene/quadrature.h"

namespace bracket::bounds {

using scene::Support;
using scene::Vector;

namespace {

/// Simpson's rule on (0, 1): exact for cubics.
double simpson(double at0, double middle, double at1) { return (at0 + 4 * middle + at1) / 6; }

using Panels = std::vector<scene::Difference>;

/// ∫ largest · weight over the edge, by Simpson's rule on each panel.
template <class Weight> double against(const Panels& panels, double length, const Weight& weight) {
  double sum = 0;
  for (const auto& [on, largest, slope, value] : panels) {
    if (largest == 0) continue;
    const double mean = simpson(weight(on.from), weight((on.from + on.to) / 2), weight(on.to));
    if (mean > 0) sum += length * (on.to - on.from) * largest * mean;
  }
  return sum;
}

/// ∫ of a square over s.
double squares(const Panels& panels, double scene::Difference::*what) {
  double sum = 0;
  for (const auto& panel : panels)
    if (panel.largest > 0) sum += (panel.panel.to - panel.panel.from) * (panel.*what) * (panel.*what);
  return sum;
}

/// What a displacement of degree n has on an edge beside all polynomials of degree n − 1, in size: |c P_n(s)|, c by the
/// coefficients of s^n.
auto beside_lower(const std::vector<Vector<2>>& u) {
  const int n = static_cast<int>(u.size()) - 1;
  Vector<2> leading = Vector<2>::Zero();
  std::vector<double> legendre;
  for (int i = 0; i <= n; ++i) {
    legendre.push_back(scene::legendre_coefficient(n, i));
    leading += legendre.back() * u[i];
  }
  const double size = leading.norm() / scene::binomial(2 * n, n);
  return [=](double s) { return size * std::abs(scene::value_on_segment(legendre, s)); };
}

/// Of a load δ left out, to which what has the degree of stresses is orthogonal: its work on u_h, and the energy with
/// which a half-plane answers to it, whose waves have lengths up to 4/3 of the edge: (1 − ν²)/E ∫ δ² / k with k ≥ 3 π /
/// (2 length).
double effect_of_load(const Panels& panels, double length, const std::vector<Vector<2>>& u, double compliance) {
  const int degree = static_cast<int>(u.size()) - 1;
  double work = 0;
  if (degree == 1) {  // only the mean is taken off, as what u_h lacks of the exact displacement is not known
    const double rest = (u[1] - u[0]).norm();
    work = against(panels, length, [&](double s) { return std::abs(s - 0.5) * rest; });
  } else if (degree == 2) {
    const double rest = (u[1] - scene::linear_coefficient<double>(u[0], u[2], 2, 1)).norm();
    work = against(panels, length, [&](double s) { return 2 * s * (1 - s) * rest; });
  } else {
    work = against(panels, length, beside_lower(u));
  }
  return work + compliance / 5 * length * length * squares(panels, &scene::Difference::largest);
}

/// Of a displacement δ left out: the work of λ_h n along `direction` on it, and the energy with which a half-plane
/// follows it, E/(1 − ν²)/4 ∫ δ² k, with waves of which ∫ δ² k ≤ (∫ δ² ∫ δ'²)^½.
double effect_of_displacement(const Panels& panels, double length, const std::vector<Vector<2>>& traction,
                              const Vector<2>& direction, double stiffness) {
  const double work =
      against(panels, length, [&](double s) { return std::abs(scene::value_on_segment(traction, s).dot(direction)); });
  const double lost = squares(panels, &scene::Difference::largest);
  return lost == 0 ? work : work + stiffness / 4 * std::sqrt(lost * squares(panels, &scene::Difference::slope));
}

bool is_rounding(const Panels& panels, const scene::EdgeCubic<double>& fixed, const Vector<2>& a, const Vector<2>& b) {
  double left = 0, largest = 0;
  for (const auto& panel : panels) {
    left = std::max(left, panel.largest);
    largest = std::max(largest, panel.value);
  }
  return left <= scene::rounding_of_values(largest, fixed, a, b);
}

double effect_on_facet(const scene::Condition<2>& given, const scene::Problem<2>& problem,
                       const scene::Displacement<2>& displacement, const scene::Stress<2>& stress, int facet) {
  const auto& mesh = problem.mesh;
  const auto& data = problem.facets[facet];
  const auto& [a, b] = scene::positions(mesh, mesh.boundary[facet].vertices);
  const double length = scene::length(mesh, facet);
  const auto& material = body_of(problem, mesh.boundary[facet].cell).material;
  const auto largest_entry = [](const auto& matrix) { return std::max(matrix(0, 0), matrix(1, 1)); };
  double effect = 0;
  for (int c = 0; c < static_cast<int>(given.value.size()); ++c) {
    scene::EdgeCubic<double> fixed{};
    auto& [ends, higher] = fixed;
    for (int i = 0; i < 2; ++i) switch (given.kind) {
        case scene::ConditionKind::fixed: ends[i] = data.displacement[i][c]; break;
        case scene::ConditionKind::sliding: ends[i] = data.normal_displacement[i]; break;
        case scene::ConditionKind::traction:
          ends[i] = data.traction[i][c];
          higher[i] = data.higher_traction[i][c];
          break;
        case scene::ConditionKind::pressure:
          ends[i] = data.pressure[i];
          higher[i] = data.higher_pressure[i];
          break;
      }
    const Panels panels = scene::difference(given.value[c], a, b, fixed);
    if (is_rounding(panels, fixed, a, b)) continue;
    const Vector<2> direction = given.value.size() == 1 ? data.normal : Vector<2>(Vector<2>::Unit(c));
    effect +=
        data.support == Support::traction
            ? effect_of_load(panels, length, on_facet(mesh, displacement, facet), largest_entry(material.compliance()))
            : effect_of_displacement(panels, length, tractions(mesh, stress, facet), direction,
                                     largest_entry(material.stiffness()));
  }
  return effect;
}

/// What the sides of a contact facet are asked for, fixed there by a quadratic: they press or rub with these forces per
/// area, by Bernstein coefficients.
double effect_of_quadratic(const scene::Function<2>& given, const scene::Problem<2>& problem,
                           const scene::ContactFacet& pair, const std::array<double, 3>& quadratic,
                           const std::vector<double>& force, double stiffness) {
  const auto& [a, b] = scene::positions(problem.mesh, problem.mesh.boundary[pair.first].vertices);
  const auto fixed = scene::cubic_of(quadratic);
  const Panels panels = scene::difference(given, a, b, fixed);
  if (is_rounding(panels, fixed, a, b)) return 0;
  std::vector<Vector<2>> traction;
  for (const double value : force) traction.emplace_back(value, 0);
  return effect_of_displacement(panels, scene::length(problem.mesh, pair.first), traction, Vector<2>::UnitX(),
                                stiffness);
}

/// Of the softer side: both follow together no more stiffly.
double stiffness_of_sides(const scene::Problem<2>& problem, const scene::ContactFacet& pair) {
  const auto of = [&](int facet) {
    const auto stiffness = body_of(problem, problem.mesh.boundary[facet].cell).material.stiffness();
    return std::max(stiffness(0, 0), stiffness(1, 1));
  };
  return pair.second == -1 ? of(pair.first) : std::min(of(pair.first), of(pair.second));
}

/// Of a gap that is sampled, or of sides that do not lift off: of these both bodies follow what is left out.
double effect_of_gap(const scene::ContactPair<2>& given, const scene::Problem<2>& problem,
                     const scene::ContactFacet& pair, const std::vector<double>& pressure) {
  const auto gap = given_gap(given, problem.facets[pair.first].normal);
  if (!gap || (gap->is_enclosed() && !pair.law.two_sided)) return 0;
  const double stiffness = pair.law.two_sided ? stiffness_of_sides(problem, pair) : 0;
  return effect_of_quadratic(*gap, problem, pair, pair.upper, pressure, stiffness);
}

/// Of what friction does not see of the slip.
double effect_of_slip(const scene::ContactPair<2>& given, const scene::Problem<2>& problem,
                      const scene::ContactFacet& pair, const std::vector<double>& shear) {
  const auto slip = given_slip(given, problem.facets[pair.first].normal);
  return effect_of_quadratic(*slip, problem, pair, pair.slip, shear, stiffness_of_sides(problem, pair));
}

}  // namespace

template <int dim>
DataEffect data_effect(const scene::Scene<dim>& scene, const scene::Problem<dim>& problem,
                       const scene::Displacement<dim>& displacement, const scene::Stress<dim>& stress) {
  static_assert(dim == 2);
  const auto& mesh = problem.mesh;
  DataEffect effect{0, std::vector<double>(problem.facets.size(), 0)};
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    const int part = mesh.boundary[f].part;
    const auto condition = part < 0 ? scene.boundary.end() : scene.boundary.find(mesh.parts[part]);
    if (condition != scene.boundary.end())
      effect.facet[f] = effect_on_facet(condition->second, problem, displacement, stress, static_cast<int>(f));
  }
  const auto states = contact_state(problem, displacement, stress);
  for (std::size_t j = 0; j < states.size(); ++j) {
    const scene::ContactFacet& pair = problem.contact[j];
    const scene::ContactPair<2>& given = scene.contact[pair.pair];
    effect.facet[pair.first] = effect_of_gap(given, problem, pair, states[j].pressure);
    if (given.jump && scene::has_friction(pair.law))
      effect.facet[pair.first] +=
          effect_of_slip(given, problem, pair, shear_and_slip(problem, displacement, stress, pair).shear);
  }
  for (const double share : effect.facet) effect.energy += share;
  return effect;
}

/// In space: nothing where the data are carried exactly; else no bound is known.
template <>
DataEffect data_effect(const scene::Scene<3>& scene, const scene::Problem<3>& problem, const scene::Displacement<3>&,
                       const scene::Stress<3>&) {
  constexpr double rounding = 1e-13;
  DataEffect effect;
  effect.facet.assign(problem.facets.size(), 0);
  const auto [traction, displacement, gap] = problem.oscillation;
  if (std::max({traction, displacement, gap}) < rounding) return effect;
  effect.energy = std::numeric_limits<double>::infinity();
  const auto& mesh = problem.mesh;
  for (std::size_t f = 0; f < effect.facet.size(); ++f) {  // to name a part: of which the data differ at the middle
    const auto& [vertices, cell, local, edge, part] = mesh.boundary[f];
    const auto condition = part < 0 ? scene.boundary.end() : scene.boundary.find(mesh.parts[part]);
    if (condition == scene.boundary.end()) continue;
    const auto x = scene::positions(mesh, vertices);
    for (const auto& value : condition->second.value) {
      const double mean = (value(x[0]) + value(x[1]) + value(x[2])) / 3, middle = value((x[0] + x[1] + x[2]) / 3);
      effect.facet[f] = std::max(effect.facet[f], std::abs(mean - middle));
    }
  }
  return effect;
}

template DataEffect data_effect(const scene::Scene<2>&, const scene::Problem<2>&, const scene::Displacement<2>&,
                                const scene::Stress<2>&);

}  // namespace bracket::bounds
