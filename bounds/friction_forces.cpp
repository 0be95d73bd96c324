// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/friction_forces.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "bounds/certificate/geometry.h"
#include "bounds/quantities/line.h"
#include "bounds/quantities/weights.h"
#include "scene/bernstein.h"
#include "scene/problem/stretch.h"

namespace bracket::bounds {

namespace {

using scene::Enclosure;
using scene::Problem;
using Weights = std::vector<std::array<double, 3>>;

struct Tent {
  scene::Vector<2> at;  ///< where it is one
  Weights weights;      ///< of each contact facet of the first mesh, Bernstein coefficients
};

/// Tents over equally long parts of a line, linear on its edges.
std::vector<Tent> tents(const Problem<2>& first, const ContactLine& line) {
  constexpr int most = 4;
  const auto held = held_corners(first);
  const double length = line.arc.back();
  const int parts = std::min(most, static_cast<int>(line.contact.size()));
  std::vector<Tent> result;
  for (int k = 0; k < parts + !line.closed; ++k) {
    const double middle = std::min(length, length * k / parts);  // which rounds
    const auto height = [&](double arc) {
      double off = std::abs(arc - middle);
      if (line.closed) off = std::min(off, length - off);
      return std::max(0.0, 1 - off * parts / length);
    };
    Tent tent{scene::Vector<2>::Zero(), Weights(first.contact.size(), {0, 0, 0})};
    for (std::size_t i = 0; i < line.contact.size(); ++i) {  // vertex 1 of facet i is at arc[i]
      const int j = line.contact[i];
      const double a = held[j][0] ? 0 : height(line.arc[i + 1]), b = held[j][1] ? 0 : height(line.arc[i]);
      tent.weights[j] = {a, (a + b) / 2, b};
      if (middle < line.arc[i] || middle > line.arc[i + 1]) continue;
      const auto ends = scene::positions(first.mesh, first.mesh.boundary[first.contact[j].first].vertices);
      tent.at = scene::between_ends(ends, 1 - (middle - line.arc[i]) / (line.arc[i + 1] - line.arc[i]));
    }
    const auto is_something = [](const auto& w) { return w[0] > 0 || w[2] > 0; };
    if (std::ranges::any_of(tent.weights, is_something)) result.push_back(std::move(tent));
  }
  return result;
}

/// ∫ g_T ψ/μ over the contact.
Enclosure assumed(const Problem<2>& problem, const Weights& weights) {
  const std::vector<int> contact_of = scene::contacts_by_first(scene::first_of(problem));
  LongSum sum;
  for (const auto& pair : problem.contact) {
    const auto [of, corner] = scene::piece_of_facet(problem, pair.first);
    const auto& [a, middle, b] = weights[contact_of[of]];
    if ((a == 0 && b == 0) || !(pair.law.coulomb > 0)) continue;
    const auto psi =
        scene::on_stretch<Enclosure>({Enclosure(a), Enclosure(middle), Enclosure(b)}, corner[0][0], corner[1][0]);
    const auto e = along<Enclosure>(problem, pair.first);
    sum.add(root(dot(e, e)) / Enclosure(pair.law.coulomb) *
            scene::bernstein_product(
                std::vector<Enclosure>{Enclosure(pair.law.friction[0]), Enclosure(pair.law.friction[1])},
                std::vector<Enclosure>(psi.begin(), psi.end())));
  }
  return sum.value();
}

}  // namespace

template <int dim> std::vector<FrictionForce> friction_forces(const SolvedLevel<dim>& level) {
  const Problem<dim>& first = scene::first_of(level.problem);
  std::set<int> rubbing;
  for (const auto& pair : first.contact)
    if (pair.law.coulomb > 0) rubbing.insert(pair.pair);
  std::vector<FrictionForce> result;
  Learned learned;
  for (const int pair : rubbing)
    for (const ContactLine& line : contact_lines(first, pair))
      for (const auto& [at, weights] : tents(first, line)) {
        Weights negative = weights;
        for (auto& facet : negative)
          for (double& w : facet) w = 0.0 - w;
        Functionals<dim> force = contact_work_functionals(first, negative, negative);
        force.non_negative = true;
        auto found = evaluate(force, level, {}, learned);
        learned = std::move(found.learned);  // the factors of one tent are those of the next
        const Enclosure from_bound = assumed(level.problem, weights);
        result.push_back({pair, at, found.level.lower, found.level.upper, lower(from_bound), upper(from_bound)});
      }
  return result;
}

template std::vector<FrictionForce> friction_forces(const SolvedLevel<2>&);

}  // namespace bracket::bounds
