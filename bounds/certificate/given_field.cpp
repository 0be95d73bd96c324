// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// Planar: contact lines.
#include "bounds/certificate/given_field.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "bounds/certificate/arithmetic.h"
#include "bounds/certificate/functional.h"
#include "bounds/certificate/problem_faults.h"
#include "bounds/certificate/sides.h"

namespace bracket::bounds {

namespace {

using Strains = std::vector<std::array<Enclosure, 3>>;  // on a cell, by Bernstein coefficients

int degree_of(const Strains& strains) {
  int degree = 0;
  while (scene::n_bernstein(degree) < static_cast<int>(strains.size())) ++degree;
  return degree;
}

Strains raised_to(int degree, const Strains& strains) { return raised(strains, degree_of(strains), degree); }

/// As it is given: nothing is added, and offsets are not rounded.
MovedField<Enclosure> as_given(const scene::Problem<2>& first, const scene::Displacement<2>& given) {
  MovedField<Enclosure> result;
  result.shifts.resize(given.vertex.size());
  result.offsets = scene::offsets<Enclosure, Vector2<Enclosure>>(first.mesh, given, given.vertex, between<Enclosure>);
  return result;
}

Strains difference(Strains a, const Strains& b, const Enclosure& factor) {
  for (std::size_t k = 0; k < a.size(); ++k)
    for (int i = 0; i < 3; ++i) a[k][i] -= factor * b[k][i];
  return a;
}

/// Of each cell of the first mesh.
std::vector<Strains> given_strains(const scene::Problem<2>& first, const scene::Displacement<2>& given) {
  const PlainField field{given.degree, given.vertex, {}};
  const MovedField<Enclosure> all = as_given(first, given);
  std::vector<Strains> result;
  for (std::size_t c = 0; c < first.mesh.cells.size(); ++c)
    result.push_back(cell_strain(first, field, all, static_cast<int>(c)));
  return result;
}

/// The strains of a cell of the first mesh on a piece of it.
Strains on_piece(const Strains& whole, const scene::Piece<2>& piece) {
  std::array<std::array<Enclosure, 3>, 3> corners;
  for (int corner = 0; corner < 3; ++corner) {
    const auto& [second, third] = piece.corner[corner];
    corners[corner] = {Enclosure((1 - second) - third), Enclosure(second), Enclosure(third)};
  }
  return by_component(whole, [&](const auto& c) { return scene::on_triangle(c, degree_of(whole), corners); });
}

/// ‖σ(u) − f λ‖² on a cell, from ε(u), λ and f.
Enclosure squared_distance(const ElasticForm<Enclosure>& form, const Strains& strain,
                           const BlockStress<Enclosure>& stress, const Enclosure& factor,
                           const Enclosure& doubled_area) {
  const int degree = std::max(degree_of(strain), degree_of(stress[0]));
  const Strains of_cell = raised_to(degree, strain);
  Enclosure sum;
  for (int part = 0; part < 3; ++part) {
    const int opposite = (part + 2) % 3;
    const Strains on_part =
        by_component(of_cell, [&](const auto& c) { return scene::on_centroid_part<Enclosure>(c, degree, opposite); });
    const Strains lambda = raised_to(degree, stress[part]);
    std::vector<std::array<Enclosure, 6>> both(on_part.size());
    for (std::size_t k = 0; k < both.size(); ++k)
      for (int i = 0; i < 3; ++i) {
        both[k][i] = on_part[k][i];
        both[k][3 + i] = factor * lambda[k][i];
      }
    const auto energy = [&](const std::array<Enclosure, 6>& of) {
      return form.difference_energy({of[0], of[1], of[2]}, {of[3], of[4], of[5]});
    };
    sum += integral(energy, both, doubled_area / Enclosure(3));
  }
  return Enclosure(2) * sum;
}

/// ‖u_s − u_x‖²
Enclosure squared_move(const scene::Problem<2>& first, const PlainField& field, const MovedField<Enclosure>& added,
                       const scene::Displacement<2>& given) {
  const std::vector<Strains> before = given_strains(first, given);
  const auto forms = elastic_forms<Enclosure>(first);
  LongSum sum;
  for (std::size_t c = 0; c < before.size(); ++c) {
    const int cell = static_cast<int>(c);
    const auto& form = forms[first.mesh.cell_body[c]];
    sum.add(integral([&](const std::array<Enclosure, 3>& e) { return form.strain_energy(e); },
                     difference(cell_strain(first, field, added, cell), before[c], Enclosure(1)),
                     doubled_area(corners<Enclosure>(first, cell))));
  }
  return Enclosure(2) * sum.value();
}

double largest_move(const scene::Problem<2>& first, const PlainField& field, const MovedField<Enclosure>& added,
                    const scene::Displacement<2>& given) {
  const auto move = [&](int v) { return between<Enclosure>(given.vertex[v], field.vertex[v]) + added.shifts[v]; };
  const auto length = [](const Vector2<Enclosure>& x) {
    return std::hypot(static_cast<double>(x.x.middle), static_cast<double>(x.y.middle));
  };
  double most = 0;
  for (std::size_t v = 0; v < given.vertex.size(); ++v) most = std::max(most, length(move(static_cast<int>(v))));
  const MovedField<Enclosure> before = as_given(first, given);
  const Enclosure half = Enclosure(1) / Enclosure(2);
  for (std::size_t e = 0; e < given.edge.size(); ++e) {  // midpoints of quadratics
    const auto& [a, b] = first.mesh.edges[e];
    most = std::max(most, length(half * (move(a) + move(b) + (added.offsets.edge[e] - before.offsets.edge[e]))));
  }
  return most;
}

std::string fault_of_given(const scene::Problem<2>& first, const scene::Displacement<2>& given) {
  if (std::string fault = arithmetic_fault(); !fault.empty()) return fault;
  if (std::string fault = problem_fault(first); !fault.empty()) return fault;
  if (given.degree > 2) return "displacements of a degree above 2 violate a contact by more than quadratics";
  return displacement_fault(first, given);
}

}  // namespace

double root_below(const Enclosure& x) {
  const double least = lower(x);
  return least > 0 ? lower(root(Enclosure(least))) : 0;
}
double root_above(const Enclosure& x) {
  const double most = upper(x);
  return most > 0 ? upper(root(Enclosure(most))) : most == 0 ? 0 : std::nan("");
}

template <> GivenEnergy certify_given(const scene::Problem<2>& first, const scene::Displacement<2>& given) try {
  if (std::string fault = fault_of_given(first, given); !fault.empty()) return {.reason = fault};
  const auto [corrections, unbalanced] = corrected<Enclosure, LongSum>(first);
  if (!unbalanced.empty()) return {.reason = unbalanced};
  const Supports supports = supports_of(first);
  if (std::string fault = kept_fault(first, given.degree, supports); !fault.empty()) return {.reason = fault};
  const PlainField field = plain_field(first, given, supports);
  const MovedField<Enclosure> added = moved<Enclosure>(first, supports, field);
  const auto energy = field_energy<Enclosure, LongSum>(first, supports, field, corrections);
  GivenEnergy result;
  const bool stores = std::ranges::any_of(
      first.contact, [](const auto& pair) { return scene::has_springs(pair.law) || scene::has_friction(pair.law); });
  result.lower = stores ? -std::numeric_limits<double>::infinity() : lower(energy.total);
  result.upper = upper(energy.total);
  result.moved = root_above(squared_move(first, field, added, given));
  result.misfit = largest_move(first, field, added, given);
  result.valid = (stores || std::isfinite(result.lower)) && std::isfinite(result.upper) && std::isfinite(result.moved);
  for (const auto& pair : first.contact) {
    const auto r = approach_on<Enclosure>(first, supports, field, pair);
    const auto least = gap_on<Enclosure>(pair.lower, 2), most = gap_on<Enclosure>(pair.upper, 2);
    std::array<double, 3> below{}, above{};
    const bool resists = !pair.law.two_sided && !scene::has_springs(pair.law);
    for (int i = 0; i < 3 && resists; ++i) {
      below[i] = lower(least[i] - r[i]);
      above[i] = upper(most[i] - r[i]);
      result.valid = result.valid && std::isfinite(below[i]) && std::isfinite(above[i]);
    }
    result.below.push_back(below);
    result.above.push_back(above);
  }
  if (!result.valid) result.reason = "the displacement is too large for its energy to be enclosed";
  return result;
} catch (const ArithmeticFault& fault) {
  return {.reason = fault.what()};
}

template <>
GivenDistance certify_distance(const scene::Problem<2>& problem, const scene::Displacement<2>& displacement,
                               const scene::Stress<2>& stress, const scene::Displacement<2>& given) {
  const scene::Problem<2>& first = scene::first_of(problem);
  if (std::string fault = fault_of(problem, displacement, stress); !fault.empty()) return {.reason = fault};
  if (std::string fault = displacement_fault(first, given); !fault.empty()) return {.reason = fault};
  const auto [corrections, unbalanced] = corrected<Enclosure, LongSum>(first);
  if (!unbalanced.empty()) return {.reason = unbalanced};
  const Sides sides = both_sides(problem, corrections, displacement, stress, Digits::extended);
  if (!sides.reason.empty()) return {.reason = sides.reason};

  const MovedField<Enclosure> own = moved<Enclosure>(problem, sides.above.supports, sides.above.field);
  const auto forms = elastic_forms<Enclosure>(problem);
  const std::vector<Strains> whole = given_strains(first, given);
  std::vector<LongSum> shares(first.mesh.cells.size());
  const Enclosure one(1), two(2), half = one / two;
  LongSum sum, misfit;  // ‖σ(u_x) − m‖², ‖σ(u_h) − λ_h‖²
  for (std::size_t c = 0; c < problem.mesh.cells.size(); ++c) {
    const int cell = static_cast<int>(c);
    const auto& form = forms[problem.mesh.cell_body[c]];
    const scene::Piece<2> piece = scene::piece_of_cell(problem, cell);
    const Strains of_given = on_piece(whole[piece.of], piece),
                  of_own = cell_strain(problem, sides.above.field, own, cell);
    const int degree = std::max(degree_of(of_given), degree_of(of_own));
    const Strains strain = difference(raised_to(degree, of_given), raised_to(degree, of_own), half);
    const LoadedCell<Enclosure> block = loaded_cell(problem, sides.below.loads, cell);
    const BlockStress<Enclosure> lambda = block_stress(problem, sides.below.loads, block, cell);
    const Enclosure area = doubled_area(block.x), share = squared_distance(form, strain, lambda, half, area);
    sum.add(share);
    shares[piece.of].add(share);
    misfit.add(squared_distance(form, of_own, lambda, one, area));
  }
  const Enclosure contact =
      contact_work<Enclosure, LongSum>(problem, sides.above.supports, sides.above.field, sides.below.loads);
  GivenDistance result;
  result.lower = root_below(sum.value());
  result.upper = root_above(sum.value());
  // ½ (w + κ) by the gap identity: a sum of squares, which does not lose w in the rounding of two energies.
  result.stress_error = root_above(misfit.value() / Enclosure(4) + contact);
  result.norm_lower = root_below(two * sides.above.energy.strain);
  result.norm_upper = root_above(two * sides.above.energy.strain);
  for (const LongSum& share : shares) result.cell.push_back(std::max(0.0, upper(share.value())));
  result.valid = std::isfinite(result.upper) && std::isfinite(result.stress_error) && std::isfinite(result.norm_upper);
  if (!result.valid) result.reason = "the distance could not be enclosed: numbers too large or too small";
  return result;
}

}  // namespace bracket::bounds
