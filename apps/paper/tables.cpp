// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "apps/paper/paper.h"
#include "dual/block_theory.h"

namespace bracket::apps {

using dual::integrate;
using dual::interpolate;
using dual::squared_distance;
using dual::stress_by_load_constant;

namespace {

using dual::Triangle;
using scene::Vector;

constexpr double none = std::numeric_limits<double>::quiet_NaN();

double degrees(double angle) { return angle * std::numbers::pi / 180; }

// ---- Theorem 2.1 ----------------------------------------------------------------------------------------------------

/// The triangle with these angles (degrees) at the ends of its first side, which has length one.
Triangle triangle(double first, double second, double turned) {
  const double a = degrees(first), b = degrees(second), side = std::sin(b) / std::sin(a + b);
  const Eigen::Rotation2Dd turn(degrees(turned));
  return {Vector<2>(0, 0), turn * Vector<2>(1, 0), turn * Vector<2>(side * std::cos(a), side * std::sin(a))};
}

/// The largest constant over the triangle's directions, which are the same after a quarter turn.
double largest_constant(double first, double second) {
  double largest = 0;
  for (double turned = 0; turned < 90; turned += 3.75)
    largest = std::max(largest, stress_by_load_constant(triangle(first, second, turned)));
  return largest;
}

/// The largest over all shapes with this smallest angle.
double largest_constant(double smallest) {
  constexpr int shapes = 12;
  double largest = 0;
  for (int i = 0; i <= shapes; ++i)
    largest = std::max(largest, largest_constant(smallest, smallest + i * (90 - 1.5 * smallest) / shapes));
  return largest;
}

// ---- Theorem 2.2 ----------------------------------------------------------------------------------------------------

/// The unit square in n × n squares, each cut in two; inner vertices moved by up to `irregular` of a square's side.
std::vector<Triangle> unit_square(int n, double irregular) {
  std::mt19937 random(1981);
  const auto moved = [&](int i) {
    const double by = irregular * (2.0 * random() / std::mt19937::max() - 1);
    return (i + (i > 0 && i < n ? by : 0)) / n;
  };
  std::vector<Vector<2>> vertices;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) {
      const double x = moved(i), y = moved(j);
      vertices.emplace_back(x, y);
    }
  std::vector<Triangle> cells;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const auto at = [&](int di, int dj) { return vertices[(j + dj) * (n + 1) + i + di]; };
      cells.push_back({at(0, 0), at(1, 0), at(1, 1)});
      cells.push_back({at(0, 0), at(1, 1), at(0, 1)});
    }
  return cells;
}

double smallest_angle(const Triangle& t) {
  double smallest = 180;
  for (int k = 0; k < 3; ++k) {
    const Vector<2> u = t[(k + 1) % 3] - t[k], v = t[(k + 2) % 3] - t[k];
    smallest = std::min(smallest, std::atan2(u[0] * v[1] - u[1] * v[0], u.dot(v)) / degrees(1));
  }
  return smallest;
}

double diameter(const Triangle& t) {
  return std::max({(t[1] - t[0]).norm(), (t[2] - t[1]).norm(), (t[0] - t[2]).norm()});
}

/// log of the errors by log of h, from one mesh of an example to the next; none on its first.
double order(double error, double h, double error_before, double h_before) {
  return std::log(error / error_before) / std::log(h / h_before);
}

/// A row for each mesh: n, then what `values` gives of it and of the mesh before (null on an example's first).
void add_rows(Table& table, const std::vector<Measured>& measured,
              const std::function<std::vector<double>(const Measured&, const Measured*)>& values) {
  const Measured* before = nullptr;
  for (const Measured& mesh : measured) {
    if (before && before->example != mesh.example) before = nullptr;
    std::vector<double> row = {static_cast<double>(mesh.n)};
    const std::vector<double> rest = values(mesh, before);
    row.insert(row.end(), rest.begin(), rest.end());
    table.rows.push_back({mesh.example, row});
    before = &mesh;
  }
}

/// Of one of the measured errors.
double order(double Measured::*error, const Measured& mesh, const Measured* before) {
  return before ? order(mesh.*error, mesh.h, before->*error, before->h) : none;
}

/// −S(σ) and L(u) of the smooth solution: ½ ∫ σ : C⁻¹σ by the cells, ℓ(u) by the sides.
std::array<double, 2> exact_energies() {
  constexpr int n = 8;
  const SmoothSolution exact = smooth_solution();
  const scene::Scene<2> scene = examples()[0].scene(n);
  const scene::Mesh<2> mesh = scene::build_mesh(scene);
  const auto of = [&](int cell) -> const ExactField& {
    return mesh.bodies[mesh.cell_body[cell]] == "slider" ? exact.slider : exact.stop;
  };
  double strain = 0, work = 0;
  dual::Corners zero;
  zero.fill(scene::Voigt<2>::Zero());
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    const auto& v = mesh.cells[c];
    strain += squared_distance({mesh.vertices[v[0]], mesh.vertices[v[1]], mesh.vertices[v[2]]},
                               of(static_cast<int>(c)).stress, zero,
                               scene.bodies.at(mesh.bodies[mesh.cell_body[c]]).material.compliance()) /
              2;
  }
  for (const auto& facet : mesh.boundary) {
    const auto condition = scene.boundary.find(mesh.parts[facet.part]);
    if (condition == scene.boundary.end() || condition->second.kind != scene::ConditionKind::traction) continue;
    const Vector<2>&a = mesh.vertices[facet.vertices[0]], &b = mesh.vertices[facet.vertices[1]];
    work += (b - a).norm() * integrate([&](double s) {
              const Vector<2> x = a + s * (b - a);
              const Vector<2> load(condition->second.value[0](x), condition->second.value[1](x));
              return load.dot(of(facet.cell).displacement(x));
            });
  }
  return {-strain, strain - work};
}

}  // namespace

Table stress_by_loads() {
  Table table{"theorem_2_1",
              "Theorem 2.1. Linear side loads T in equilibrium determine the stress of a block,\n"
              "and max|tau| <= c max|T|, c depending on the smallest angle alone. The least\n"
              "such c: of the triangle with that angle once (needle), of that with it twice\n"
              "(flat), of all triangles with it; in all directions.",
              {{"needle", ".4g"}, {"flat", ".4g"}, {"c(alpha)", ".4g"}, {"c sin^2(alpha)", ".3g"}}};
  for (const double angle : {60., 45., 30., 20., 15., 10., 5., 2., 1.}) {
    const double needle = largest_constant(angle, 90 - angle / 2), flat = largest_constant(angle, angle);
    const double all = std::max({needle, flat, largest_constant(angle)}), sine = std::sin(degrees(angle));
    table.rows.push_back({fmt::format("{:g} degrees", angle), {needle, flat, all, all * sine * sine}});
  }
  return table;
}

Table interpolation() {
  Table table{"theorem_2_2",
              "Theorem 2.2. |tau - r_h tau| <= C h^2 in L2, r_h being the blocks' stress whose\n"
              "side tractions are the projections of those of tau. By the norm of tau, the\n"
              "stress of the slider in the smooth solution.",
              {{"n", ".0f"}, {"h", ".3g"}, {"smallest angle", ".1f"}, {"error", ".3e"}, {"order", ".2f"}}};
  const dual::StressField stress = smooth_solution().slider.stress;
  scene::Elasticity<2> form = scene::Elasticity<2>::Identity();
  form(2, 2) = 2;
  dual::Corners zero;
  zero.fill(scene::Voigt<2>::Zero());
  for (const double irregular : {0.0, 0.15}) {
    double error_before = none, h_before = none;
    for (const int n : {2, 4, 8, 16, 32}) {
      double error = 0, norm = 0, h = 0, angle = 180;
      for (const Triangle& cell : unit_square(n, irregular)) {
        error += squared_distance(cell, stress, interpolate(cell, stress), form);
        norm += squared_distance(cell, stress, zero, form);
        h = std::max(h, diameter(cell));
        angle = std::min(angle, smallest_angle(cell));
      }
      error = std::sqrt(error / norm);
      table.rows.push_back({irregular > 0 ? "irregular" : "regular",
                            {static_cast<double>(n), h, angle, error, order(error, h, error_before, h_before)}});
      error_before = error, h_before = h;
    }
  }
  return table;
}

Table stress_error(const std::vector<Measured>& measured) {
  Table table{"theorem_2_3",
              "Theorem 2.3. |lambda - lambda_h| = O(h^(3/2)) in L2 where lambda and its\n"
              "pressure are in H2. Example 1, on blocks of n x n squares, in the energy norm,\n"
              "by that of lambda. Smooth: by its closed form. Contact end (stress like r^0.5)\n"
              "and clamped corners (like r^-0.29), where the theorem does not apply: at most\n"
              "this, by an upper bound of the energy on a refined mesh.",
              {{"n", ".0f"}, {"h", ".3g"}, {"error", ".3e"}, {"order", ".2f"}}};
  add_rows(table, measured, [](const Measured& mesh, const Measured* before) {
    return std::vector<double>{mesh.h, mesh.stress_error, order(&Measured::stress_error, mesh, before)};
  });
  return table;
}

Table equal_energies(const std::vector<Measured>& measured) {
  Table table{"equality_1_15",
              "(1.15). -S(sigma) = L(u). The smooth solution in closed form (S by the bodies, L\n"
              "with the work of the loads by their sides), and the certified bounds of each\n"
              "mesh.",
              {{"n", ".0f"}, {"-S", ".14g"}, {"L", ".14g"}, {"difference", ".1e"}, {"order", ".2f"}}};
  const auto [lower, upper] = exact_energies();
  table.rows.push_back({"smooth, exact", {none, lower, upper, (upper - lower) / std::abs(upper), none}});
  add_rows(table, measured, [](const Measured& mesh, const Measured* before) {
    const double difference = (mesh.upper - mesh.lower) / std::abs(mesh.upper);
    const double rate =
        before ? order(mesh.upper - mesh.lower, mesh.h, before->upper - before->lower, before->h) : none;
    return std::vector<double>{mesh.lower, mesh.upper, difference, rate};
  });
  return table;
}

Table two_formulations(const std::vector<Measured>& measured) {
  Table table{"two_formulations",
              "The two formulations. Differences of stresses, sigma(u_h) - lambda_h, in the\n"
              "energy norm, by that of the solution, and of pressures in L2 on the contact, by\n"
              "that of lambda_h; the length of the contact on which the stresses press, and the\n"
              "length that the displacements close.",
              {{"n", ".0f"},
               {"stresses", ".3e"},
               {"order", ".2f"},
               {"pressures", ".3e"},
               {"order", ".2f"},
               {"pressed", ".4g"},
               {"closed", ".4g"}}};
  add_rows(table, measured, [](const Measured& mesh, const Measured* before) {
    return std::vector<double>{mesh.stress_difference,
                               order(&Measured::stress_difference, mesh, before),
                               mesh.pressure_difference,
                               order(&Measured::pressure_difference, mesh, before),
                               mesh.pressed,
                               mesh.closed};
  });
  return table;
}

}  // namespace bracket::apps
