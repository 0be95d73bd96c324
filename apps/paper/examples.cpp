// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/paper/examples.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <tuple>

#include "apps/report/samples.h"
#include "dual/block_theory.h"
#include "scene/voigt.h"

namespace bracket::apps {

using dual::squared_distance;

namespace {

using scene::ConditionKind;
using scene::Vector;
using scene::Voigt;

constexpr double poisson = 0.3, slider_young = 2, stop_young = 1;
constexpr double mean_pressure = 0.1;

scene::Function<2> constant(double value) { return value; }

scene::Scene<2> two_blocks(int n) {
  const auto block = [n](const std::string& body, double x) {
    return scene::Block<2>{body, {{{x, x + 1}, {0, 1}}}, {n, n}, ""};
  };
  scene::Scene<2> scene;
  scene.title = "Example 1";
  scene.blocks = {block("slider", 0), block("stop", 1)};
  scene.bodies = {{"slider", scene::isotropic<2>(slider_young, poisson, scene::Plane::strain)},
                  {"stop", scene::isotropic<2>(stop_young, poisson, scene::Plane::strain)}};
  scene.boundary = {{"slider.bottom", {ConditionKind::sliding, {constant(0)}, ""}},
                    {"slider.left", {ConditionKind::pressure, {constant(mean_pressure)}, ""}}};
  scene.contact = {{"slider.right", "stop.left", constant(0), ""}};
  return scene;
}

scene::Condition<2> clamped() { return {ConditionKind::fixed, {constant(0), constant(0)}, ""}; }

// ---- the smooth solution --------------------------------------------------------------------------------------------

constexpr double wave = 2;                // k
constexpr double amplitude = 0.05;        // p₁
using Coefficients = Eigen::RowVector4d;  // of cosh ks, sinh ks, ks cosh ks, ks sinh ks in f, s = x − 1

/// f, f', f'', f''' at x, by the coefficients of f.
Eigen::Matrix4d derivatives(double x) {
  const double s = wave * (x - 1), c = std::cosh(s), d = std::sinh(s);
  Eigen::Matrix4d next;  // column j: the derivative of function j, by k
  next << 0, 1, 1, 0,    //
      1, 0, 0, 1,        //
      0, 0, 0, 1,        //
      0, 0, 1, 0;
  Eigen::Matrix4d rows;
  rows.row(0) << c, d, s * c, s * d;
  for (int i = 1; i < 4; ++i) rows.row(i) = wave * rows.row(i - 1) * next;
  return rows;
}

struct Plane {
  double modulus, ratio, shear;  ///< E' = E/(1 − ν²), ν' = ν/(1 − ν), μ
};
Plane plane(double young) {
  return {young / (1 - poisson * poisson), poisson / (1 - poisson), young / (2 * (1 + poisson))};
}

/// u = (U(x) cos ky, V(x) sin ky) plus the uniform part, by the coefficients of f.
Coefficients along(const Plane& material, double x) {  // U
  const Eigen::Matrix4d f = derivatives(x);
  return f.row(3) / (wave * wave * material.modulus) + f.row(1) * (material.ratio / material.modulus) -
         f.row(1) / material.shear;
}
Coefficients across(const Plane& material, double x) {  // V
  const Eigen::Matrix4d f = derivatives(x);
  return f.row(2) / (wave * material.modulus) + f.row(0) * (wave * material.ratio / material.modulus);
}

/// \param side σ₂₂ of the uniform part, whose σ₁₁ is −p₀
/// \param origin where its u₁ vanishes
ExactField field(const Plane& material, const Eigen::Vector4d& f, double side, double origin) {
  const double strain1 = (-mean_pressure - material.ratio * side) / material.modulus;
  const double strain2 = (side + material.ratio * mean_pressure) / material.modulus;
  return {[=](const Vector<2>& x) -> Voigt<2> {
            const Eigen::Vector4d at = derivatives(x[0]) * f;
            const double c = std::cos(wave * x[1]), s = std::sin(wave * x[1]);
            return {-wave * wave * at[0] * c - mean_pressure, at[2] * c + side, wave * at[1] * s};
          },
          [=](const Vector<2>& x) -> Vector<2> {
            return {along(material, x[0]).dot(f) * std::cos(wave * x[1]) + strain1 * (x[0] - origin),
                    across(material, x[0]).dot(f) * std::sin(wave * x[1]) + strain2 * x[1]};
          }};
}

scene::Scene<2> smooth_scene(int n) {
  const SmoothSolution exact = smooth_solution();
  const auto loaded = [](const ExactField& body, const Vector<2>& normal) {
    const auto component = [=](int c) {
      return [=](const Vector<2>& x) { return scene::traction<2>(body.stress(x), normal)[c]; };
    };
    return scene::Condition<2>{ConditionKind::traction, {component(0), component(1)}, ""};
  };
  scene::Scene<2> scene = two_blocks(n);
  scene.boundary["slider.left"] = loaded(exact.slider, {-1, 0});
  scene.boundary["slider.top"] = loaded(exact.slider, {0, 1});
  scene.boundary["stop.top"] = loaded(exact.stop, {0, 1});
  scene.boundary["stop.bottom"] = loaded(exact.stop, {0, -1});
  scene.boundary["stop.right"] = clamped();
  return scene;
}

/// The slider's face meets a stop that curves away from it.
scene::Scene<2> contact_end_scene(int n) {
  scene::Scene<2> scene = two_blocks(n);
  for (const char* side : {"stop.bottom", "stop.right"})
    scene.boundary[side] = {ConditionKind::sliding, {constant(0)}, ""};
  scene.contact[0].gap = scene::enclosed<2>([](const auto& x) { return 0.2 * x[1] * x[1]; });
  return scene;
}

scene::Scene<2> clamped_scene(int n) {
  scene::Scene<2> scene = two_blocks(n);
  scene.boundary["stop.right"] = clamped();
  return scene;
}

// ---- what is measured -----------------------------------------------------------------------------------------------

dual::Triangle triangle(const scene::Mesh<2>& mesh, std::size_t cell) {
  const auto& v = mesh.cells[cell];
  return {mesh.vertices[v[0]], mesh.vertices[v[1]], mesh.vertices[v[2]]};
}

/// ‖σ − λ_h‖_{C⁻¹} and ‖σ‖_{C⁻¹}
std::tuple<double, double> distance_and_norm(const bounds::Outcome<2>& outcome, const SmoothSolution& exact) {
  const auto& problem = outcome.problem;
  dual::Corners zero;
  zero.fill(Voigt<2>::Zero());
  double distance = 0, norm = 0;
  for (std::size_t c = 0; c < problem.mesh.cells.size(); ++c) {
    const int body = problem.mesh.cell_body[c];
    const auto& stress = (problem.mesh.bodies[body] == "slider" ? exact.slider : exact.stop).stress;
    const auto& compliance = problem.bodies[body].material.compliance();
    distance += squared_distance(triangle(problem.mesh, c), stress, outcome.stress.cell[c], compliance);
    norm += squared_distance(triangle(problem.mesh, c), stress, zero, compliance);
  }
  return {std::sqrt(distance), std::sqrt(norm)};
}

/// ∫ over an edge of the square of a linear function, by the edge's length.
double mean_square(double a, double b) { return (a * a + a * b + b * b) / 3; }

void compare_contact(const bounds::Outcome<2>& outcome, Measured& measured) {
  constexpr double rounding = 1e-8;
  const auto& problem = outcome.problem;
  const auto states = bounds::contact_state(problem, outcome.displacement, outcome.stress);
  const double no_pressure = rounding_of_pressure(problem, outcome.stress, states, 0);
  double approach = 0;
  for (const auto& u : outcome.displacement.vertex) approach = std::max(approach, u.norm());
  double difference = 0, norm = 0;
  for (std::size_t j = 0; j < states.size(); ++j) {
    const int facet = problem.contact[j].first;
    const double length = scene::length(problem.mesh, facet);
    const auto& by_stresses = states[j].pressure;
    const auto by_displacements = displacement_pressure(problem, outcome.displacement, facet);
    difference += length * mean_square(by_stresses[0] - by_displacements[0], by_stresses[1] - by_displacements[1]);
    norm += length * mean_square(by_stresses[0], by_stresses[1]);
    if (presses(states[j], no_pressure)) measured.pressed += length;
    if (std::ranges::max(states[j].gap_left) < rounding * approach) measured.closed += length;
  }
  measured.pressure_difference = std::sqrt(difference / norm);
}

}  // namespace

SmoothSolution smooth_solution() {
  const Plane slider = plane(slider_young), stop = plane(stop_young);
  const Eigen::Matrix4d at_contact = derivatives(1);
  const double pressure = amplitude / (wave * wave);  // f there: σ₁₁ = −k² f cos ky − p₀

  Eigen::Matrix4d equations;
  equations << at_contact.row(0), at_contact.row(1), along(stop, 2), across(stop, 2);  // no shear; clamped
  const Eigen::Vector4d f_stop = equations.partialPivLu().solve(Eigen::Vector4d(pressure, 0, 0, 0));

  equations << at_contact.row(0), at_contact.row(1), derivatives(0).row(1), along(slider, 1);  // no shear at x = 0
  const Eigen::Vector4d f_slider =
      equations.partialPivLu().solve(Eigen::Vector4d(pressure, 0, 0, along(stop, 1).dot(f_stop)));

  // The uniform part does not widen the stop; the slider follows it.
  const ExactField of_stop = field(stop, f_stop, -stop.ratio * mean_pressure, 2);
  const double approach = mean_pressure * (1 - stop.ratio * stop.ratio) / stop.modulus;
  return {field(slider, f_slider, 0, 1 + approach * slider.modulus / mean_pressure), of_stop};
}

std::vector<Example> examples() {
  return {{"smooth", smooth_scene}, {"contact end", contact_end_scene}, {"clamped corners", clamped_scene}};
}

std::vector<Measured> measure(const Example& example, const std::vector<int>& meshes,
                              const std::function<void(const std::string&)>& stage) {
  constexpr double reference_error = 2e-4;
  const bool smooth = example.name == "smooth";
  double energy = 0, norm = 0;  // upper bound of L(u), ‖u‖_A
  if (!smooth) {
    stage(example.name + ": reference");
    scene::Scene<2> scene = example.scene(2);
    scene.refine = {.strategy = scene::Strategy::adaptive, .target = reference_error, .max_levels = 60};
    const auto reference = bounds::run(scene);
    energy = reference.upper;
    norm = std::sqrt(2 * reference.levels.back().plain.strain);
  }

  std::vector<Measured> result;
  for (const int n : meshes) {
    stage(example.name + ": n = " + std::to_string(n));
    const auto outcome = bounds::run(example.scene(n));
    const bounds::Bracket& bracket = outcome.levels[0].bracket;
    Measured measured{example.name, n, std::numbers::sqrt2 / n, bracket.lower, bracket.upper};
    if (smooth)
      std::tie(measured.stress_error, norm) = distance_and_norm(outcome, smooth_solution());
    else
      measured.stress_error = std::sqrt(2 * (energy - bracket.lower));
    measured.stress_error /= norm;
    const auto& cells = outcome.indicator.cell;
    measured.stress_difference = std::sqrt(2 * std::accumulate(cells.begin(), cells.end(), 0.0)) / norm;
    compare_contact(outcome, measured);
    result.push_back(measured);
  }
  return result;
}

}  // namespace bracket::apps
