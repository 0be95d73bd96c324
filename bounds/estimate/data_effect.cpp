// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "bounds/estimate/left_out.h"
#include "bounds/estimate/on_mesh.h"
#include "scene/problem/given_gap.h"

namespace bracket::bounds {

using scene::Support;
using scene::Vector;

namespace {

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

/// A displacement less what has the degree of stresses on a facet: of degree 1 only the mean is taken off, as what it
/// lacks of the exact one is not known.
template <int dim> std::vector<Vector<dim>> beside_stresses(std::vector<Vector<dim>> u) {
  const int degree = scene::degree_on_facet<dim>(u.size());
  Corners<dim> linear;
  if constexpr (dim == 2) linear = {u.front(), u.back()};
  if constexpr (dim == 3) linear = {u[0], u[1], u[2]};
  if (degree == 1) {
    Vector<dim> mean = Vector<dim>::Zero();
    for (const auto& value : u) mean += value / dim;
    for (auto& value : u) value -= mean;
    return u;
  }
  const auto interpolated = scene::linear_on_facet<double>(linear, degree);
  for (std::size_t k = 0; k < u.size(); ++k) u[k] -= interpolated[k];
  return u;
}

double longest_side(const Corners<2>& x) { return (x[1] - x[0]).norm(); }
double longest_side(const Corners<3>& x) {
  return std::max({(x[1] - x[0]).norm(), (x[2] - x[1]).norm(), (x[0] - x[2]).norm()});
}

/// Of a load δ left out, to which what has the degree of stresses is orthogonal: its work on u_h, and the energy with
/// which a half-plane, or half-space, answers to it, whose waves have lengths up to 4/3 of the facet's: in the plane
/// (1 − ν²)/E ∫ δ² / k with k ≥ 3 π / (2 length).
template <int dim>
double effect_of_load(const Panels<dim>& panels, const Corners<dim>& x, double size, const std::vector<Vector<dim>>& u,
                      double compliance) {
  double work = 0;
  const auto work_on = [&](const auto& rest) { return size * against<dim>(panels, rest); };
  if (dim == 2 && u.size() > 3) {
    if constexpr (dim == 2) work = work_on(beside_lower(u));
  } else {
    const auto rest = beside_stresses<dim>(u);
    work = work_on([&](const Place<dim>& at) { return value_on_facet(rest, at).norm(); });
  }
  return work + compliance / 5 * longest_side(x) * size * squares<dim>(panels, &Panel<dim>::largest);
}

/// Of a displacement δ left out: the work of λ_h n along `direction` on it, and the energy with which a half-plane, or
/// half-space, follows it, at most E/(1 − ν²)/4 ∫ δ² k, with waves of which ∫ δ² k ≤ (∫ δ² ∫ |∇δ|²)^½.
template <int dim>
double effect_of_displacement(const Panels<dim>& panels, double size, const std::vector<Vector<dim>>& traction,
                              const Vector<dim>& direction, double stiffness) {
  const double work = size * against<dim>(panels, [&](const Place<dim>& at) {
                        return std::abs(value_on_facet(traction, at).dot(direction));
                      });
  const double lost = squares<dim>(panels, &Panel<dim>::largest);
  return lost == 0 ? work : work + stiffness / 4 * size * std::sqrt(lost * squares<dim>(panels, &Panel<dim>::slope));
}

/// Component c of the data on a facet, as they were fixed.
template <int dim> Fixed<dim> fixed_on_facet(const scene::FacetData<dim>& data, scene::ConditionKind kind, int c) {
  std::array<double, dim> at_vertices{};
  for (int i = 0; i < dim; ++i) switch (kind) {
      case scene::ConditionKind::fixed: at_vertices[i] = data.displacement[i][c]; break;
      case scene::ConditionKind::sliding: at_vertices[i] = data.normal_displacement[i]; break;
      case scene::ConditionKind::traction: at_vertices[i] = data.traction[i][c]; break;
      case scene::ConditionKind::pressure: at_vertices[i] = data.pressure[i]; break;
    }
  if constexpr (dim == 3) {
    Fixed<3> fixed;
    std::ranges::copy(scene::linear_on_facet<double>(at_vertices, 2), fixed.begin());
    return fixed;
  } else {
    Fixed<2> fixed{at_vertices, {0, 0}};
    for (int i = 0; i < 2; ++i) {
      if (kind == scene::ConditionKind::traction) fixed.higher[i] = data.higher_traction[i][c];
      if (kind == scene::ConditionKind::pressure) fixed.higher[i] = data.higher_pressure[i];
    }
    return fixed;
  }
}

/// That of a pressure, in the plane, or across a wave in space: (1 + ν)/E there.
template <int dim> double largest_compliance(const scene::Material<dim>& material) {
  const auto diagonal = material.compliance().diagonal();
  const double direct = diagonal.template head<dim>().maxCoeff();
  return dim == 2 ? direct : std::max(direct, diagonal.template tail<scene::n_voigt<dim> - dim>().maxCoeff() / 2);
}

template <int dim> double stiffness_at(const scene::Problem<dim>& problem, int facet) {
  const auto& material = body_of(problem, problem.mesh.boundary[facet].cell).material;
  return material.stiffness().diagonal().template head<dim>().maxCoeff();
}

template <int dim>
double effect_on_facet(const scene::Condition<dim>& given, const scene::Problem<dim>& problem,
                       const scene::Displacement<dim>& displacement, const scene::Stress<dim>& stress, int facet) {
  const auto& mesh = problem.mesh;
  const auto& data = problem.facets[facet];
  const Corners<dim> x = scene::positions(mesh, mesh.boundary[facet].vertices);
  const double size = scene::length(mesh, facet);
  const auto& material = body_of(problem, mesh.boundary[facet].cell).material;
  double effect = 0;
  for (int c = 0; c < static_cast<int>(given.value.size()); ++c) {
    const Fixed<dim> fixed = fixed_on_facet<dim>(data, given.kind, c);
    const Panels<dim> panels = left_out(given.value[c], x, fixed);
    if (is_rounding<dim>(panels, fixed, x)) continue;
    const Vector<dim> direction = given.value.size() == 1 ? data.normal : Vector<dim>(Vector<dim>::Unit(c));
    effect += data.support == Support::traction
                  ? effect_of_load<dim>(panels, x, size, on_facet(mesh, displacement, facet),
                                        largest_compliance<dim>(material))
                  : effect_of_displacement<dim>(panels, size, tractions(mesh, stress, facet), direction,
                                                stiffness_at<dim>(problem, facet));
  }
  return effect;
}

Fixed<2> as_fixed(const scene::FacetQuadratic<2>& quadratic) { return scene::cubic_of(quadratic); }
Fixed<3> as_fixed(const scene::FacetQuadratic<3>& quadratic) { return quadratic; }

/// What the sides of a contact facet are asked for, fixed there by a quadratic: they press or rub with these forces per
/// area, by Bernstein coefficients.
template <int dim>
double effect_of_quadratic(const scene::Function<dim>& given, const scene::Problem<dim>& problem,
                           const scene::ContactFacetOf<dim>& pair, const scene::FacetQuadratic<dim>& quadratic,
                           const std::vector<double>& force, double stiffness) {
  const Corners<dim> x = scene::positions(problem.mesh, problem.mesh.boundary[pair.first].vertices);
  const Fixed<dim> fixed = as_fixed(quadratic);
  const Panels<dim> panels = left_out(given, x, fixed);
  if (is_rounding<dim>(panels, fixed, x)) return 0;
  std::vector<Vector<dim>> traction;
  for (const double value : force) traction.push_back(value * Vector<dim>::UnitX());
  return effect_of_displacement<dim>(panels, scene::length(problem.mesh, pair.first), traction, Vector<dim>::UnitX(),
                                     stiffness);
}

/// Of the softer side: both follow together no more stiffly.
template <int dim>
double stiffness_of_sides(const scene::Problem<dim>& problem, const scene::ContactFacetOf<dim>& pair) {
  const double first = stiffness_at(problem, pair.first);
  return pair.second == -1 ? first : std::min(first, stiffness_at(problem, pair.second));
}

/// Of a gap that is sampled, or of sides that do not lift off: of these both bodies follow what is left out.
template <int dim>
double effect_of_gap(const scene::ContactPair<dim>& given, const scene::Problem<dim>& problem,
                     const scene::ContactFacetOf<dim>& pair, const std::vector<double>& pressure) {
  const auto gap = given_gap(given, problem.facets[pair.first].normal);
  if (!gap || (gap->is_enclosed() && !pair.law.two_sided)) return 0;
  const double stiffness = pair.law.two_sided ? stiffness_of_sides<dim>(problem, pair) : 0;
  return effect_of_quadratic<dim>(*gap, problem, pair, pair.upper, pressure, stiffness);
}

/// Planar: of what friction does not see of the slip.
double effect_of_slip(const scene::ContactPair<2>& given, const scene::Problem<2>& problem,
                      const scene::ContactFacet& pair, const std::vector<double>& shear) {
  const auto slip = given_slip(given, problem.facets[pair.first].normal);
  return effect_of_quadratic<2>(*slip, problem, pair, pair.slip, shear, stiffness_of_sides<2>(problem, pair));
}

}  // namespace

template <int dim>
DataEffect data_effect(const scene::Scene<dim>& scene, const scene::Problem<dim>& problem,
                       const scene::Displacement<dim>& displacement, const scene::Stress<dim>& stress) {
  const auto& mesh = problem.mesh;
  DataEffect effect{0, std::vector<double>(problem.facets.size(), 0)};
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    const int part = mesh.boundary[f].part;
    const auto condition = part < 0 ? scene.boundary.end() : scene.boundary.find(mesh.parts[part]);
    if (condition != scene.boundary.end())
      effect.facet[f] = effect_on_facet<dim>(condition->second, problem, displacement, stress, static_cast<int>(f));
  }
  const auto states = contact_state(problem, displacement, stress);
  for (std::size_t j = 0; j < states.size(); ++j) {
    const scene::ContactFacetOf<dim>& pair = problem.contact[j];
    const scene::ContactPair<dim>& given = scene.contact[pair.pair];
    effect.facet[pair.first] = effect_of_gap<dim>(given, problem, pair, states[j].pressure);
    if constexpr (dim == 2)
      if (given.jump && scene::has_friction(pair.law))
        effect.facet[pair.first] +=
            effect_of_slip(given, problem, pair, shear_and_slip(problem, displacement, stress, pair).shear);
  }
  for (const double share : effect.facet) effect.energy += share;
  return effect;
}

template DataEffect data_effect(const scene::Scene<2>&, const scene::Problem<2>&, const scene::Displacement<2>&,
                                const scene::Stress<2>&);
template DataEffect data_effect(const scene::Scene<3>&, const scene::Problem<3>&, const scene::Displacement<3>&,
                                const scene::Stress<3>&);

}  // namespace bracket::bounds
