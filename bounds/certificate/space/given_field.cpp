// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/certificate/given_field.h"

#include <algorithm>
#include <cmath>

#include "bounds/certificate/space/corrections.h"
#include "bounds/certificate/space/problem_faults.h"
#include "bounds/certificate/space/sides.h"
#include "bounds/certificate/space/stress_energy.h"

namespace bracket::bounds {

namespace space {
namespace {

using Strains = std::array<std::array<Enclosure, 6>, 4>;  // at the corners of a cell, linear between

Strains difference(Strains a, const Strains& b, const Enclosure& factor) {
  for (int k = 0; k < 4; ++k)
    for (int i = 0; i < 6; ++i) a[k][i] -= factor * b[k][i];
  return a;
}

/// What the middle of an edge has beside the mean of its ends, twice: its Bernstein coefficient.
Vector3<Enclosure> offset_of(const scene::Mesh<3>& mesh, const scene::Displacement<3>& u, int edge) {
  const auto& [a, b] = mesh.edges[edge];
  return between<Enclosure>(u.vertex[a], u.edge[edge]) + between<Enclosure>(u.vertex[b], u.edge[edge]);
}

/// As it is given: nothing is added, and offsets are not rounded.
Strains given_strain(const scene::Problem<3>& first, const scene::Displacement<3>& given, int cell) {
  const auto& v = first.mesh.cells[cell];
  DisplacedCell<Enclosure> at{cell_geometry(corners<Enclosure>(first, cell)), {}};
  for (int j = 1; j < 4; ++j) at.from_first[j] = between<Enclosure>(given.vertex[v[0]], given.vertex[v[j]]);
  for (int e = 0; e < 6 && given.degree > 1; ++e)
    at.offset[e] = offset_of(first.mesh, given, first.mesh.cell_edges[cell][e]);
  return cell_strain(at, given.degree);
}

/// The strains of a cell of the first mesh at the corners of a piece of it.
Strains on_piece(const Strains& whole, const scene::Piece<3>& piece) {
  Strains result;
  for (int corner = 0; corner < 4; ++corner) {
    const auto& at = piece.corner[corner];
    const std::array<double, 4> l = {((1 - at[0]) - at[1]) - at[2], at[0], at[1], at[2]};
    for (int i = 0; i < 6; ++i) {
      result[corner][i] = Enclosure(0);
      for (int k = 0; k < 4; ++k)
        if (l[k] != 0) result[corner][i] += Enclosure(l[k]) * whole[k][i];
    }
  }
  return result;
}

/// ‖σ(u) − f λ‖² on a cell, from ε(u), λ and f.
Enclosure squared_distance(const ElasticForm<Enclosure>& form, const Strains& strain,
                           const scene::BalancedStress<3, Enclosure>& stress, const Enclosure& factor,
                           const Enclosure& volume6) {
  std::array<Enclosure, 6> centre;
  for (int i = 0; i < 6; ++i)
    centre[i] = ((strain[0][i] + strain[1][i]) + (strain[2][i] + strain[3][i])) / Enclosure(4);
  const auto energy = [&](const std::array<Enclosure, 12>& of) {
    return form.difference_energy({of[0], of[1], of[2], of[3], of[4], of[5]},
                                  {of[6], of[7], of[8], of[9], of[10], of[11]});
  };
  Enclosure sum(0);  // of the means of energies on the four parts
  for (int part = 0; part < 4; ++part) {
    std::array<std::array<Enclosure, 12>, 4> both;
    for (int k = 0; k < 4; ++k)
      for (int i = 0; i < 6; ++i) {
        both[k][i] = k < 3 ? strain[scene::Simplex<3>::facets[part][k]][i] : centre[i];
        both[k][6 + i] = factor * stress[part][k][i];
      }
    sum += mean_of_squares<Enclosure>(energy, both);
  }
  return volume6 / Enclosure(12) * sum;  // twice the energy, each part a quarter of the cell
}

/// ‖u_s − u_x‖²
Enclosure squared_move(const scene::Problem<3>& first, const PlainField& field,
                       const std::vector<Vector3<Enclosure>>& added, const scene::Displacement<3>& given) {
  const auto forms = elastic_forms<Enclosure>(first);
  LongSum sum;
  for (int cell = 0; cell < static_cast<int>(first.mesh.cells.size()); ++cell) {
    const auto at = displaced_cell(first, field, added, cell);
    const auto& form = forms[first.mesh.cell_body[cell]];
    const Strains moved = difference(cell_strain(at, field.degree), given_strain(first, given, cell), Enclosure(1));
    sum.add(
        at.geometry.scaled_volume / Enclosure(3) *
        mean_of_squares<Enclosure>([&](const std::array<Enclosure, 6>& e) { return form.strain_energy(e); }, moved));
  }
  return sum.value();
}

double largest_move(const scene::Problem<3>& first, const PlainField& field,
                    const std::vector<Vector3<Enclosure>>& added, const scene::Displacement<3>& given) {
  const auto move = [&](int v) { return between<Enclosure>(given.vertex[v], field.node[v]) + added[v]; };
  const auto length = [](const Vector3<Enclosure>& x) {
    return std::hypot(static_cast<double>(x[0].middle), static_cast<double>(x[1].middle),
                      static_cast<double>(x[2].middle));
  };
  double most = 0;
  for (std::size_t v = 0; v < given.vertex.size(); ++v) most = std::max(most, length(move(static_cast<int>(v))));
  const Enclosure half = Enclosure(1) / Enclosure(2);
  for (int e = 0; e < static_cast<int>(given.edge.size()); ++e) {
    const auto& [a, b] = first.mesh.edges[e];
    const Vector3<Enclosure> offset =
        at_node(field, added, node_of_edge(first.mesh, e)) - offset_of(first.mesh, given, e);
    most = std::max(most, length(half * ((move(a) + move(b)) + offset)));
  }
  return most;
}

std::string fault_of_given(const scene::Problem<3>& first, const scene::Displacement<3>& given) {
  if (std::string fault = arithmetic_fault(); !fault.empty()) return fault;
  if (std::string fault = problem_fault(first); !fault.empty()) return fault;
  return displacement_fault(first.mesh, given);
}

/// Quadratics around g − r(u_s) on each contact facet; zero where sides keep together.
void enclose_gaps(const scene::Problem<3>& first, const Supports& supports, const PlainField& field,
                  GivenEnergyOf<3>& result) {
  for (const auto& pair : first.contact) {
    scene::FacetQuadratic<3> below{}, above{};
    if (!pair.law.two_sided) {
      const auto r = approach_on<Enclosure>(first, supports, field, pair);
      for (int k = 0; k < 6; ++k) {
        below[k] = lower(Enclosure(pair.lower[k]) - r[k]);
        above[k] = upper(Enclosure(pair.upper[k]) - r[k]);
        result.valid = result.valid && std::isfinite(below[k]) && std::isfinite(above[k]);
      }
    }
    result.below.push_back(below);
    result.above.push_back(above);
  }
}

}  // namespace
}  // namespace space

template <> GivenEnergyOf<3> certify_given(const scene::Problem<3>& first, const scene::Displacement<3>& given) try {
  using scene::Enclosure, scene::LongSum;
  if (std::string fault = space::fault_of_given(first, given); !fault.empty()) return {.reason = fault};
  const auto [corrections, unbalanced] = space::corrected<Enclosure, LongSum>(first);
  if (!unbalanced.empty()) return {.reason = unbalanced};
  const space::Supports supports = space::supports_of(first, given.degree);
  if (!supports.fault.empty()) return {.reason = supports.fault};
  const space::PlainField field = space::plain_field(first, given, supports);
  const auto added = space::shifts<Enclosure>(supports, field);
  const auto energy = space::field_energy<Enclosure, LongSum>(first, supports, field, corrections);
  GivenEnergyOf<3> result;
  result.lower = lower(energy.total);
  result.upper = upper(energy.total);
  result.moved = root_above(space::squared_move(first, field, added, given));
  result.misfit = space::largest_move(first, field, added, given);
  result.valid = std::isfinite(result.lower) && std::isfinite(result.upper) && std::isfinite(result.moved);
  space::enclose_gaps(first, supports, field, result);
  if (!result.valid) result.reason = "the displacement is too large for its energy to be enclosed";
  return result;
} catch (const ArithmeticFault& fault) {
  return {.reason = fault.what()};
}

template <>
GivenDistance certify_distance(const scene::Problem<3>& problem, const scene::Displacement<3>& displacement,
                               const scene::Stress<3>& stress, const scene::Displacement<3>& given) {
  using scene::Enclosure, scene::LongSum;
  const scene::Problem<3>& first = scene::first_of(problem);
  if (std::string fault = space::fault_of(problem, displacement, stress); !fault.empty()) return {.reason = fault};
  if (std::string fault = space::displacement_fault(first.mesh, given); !fault.empty()) return {.reason = fault};
  const auto [corrections, unbalanced] = space::corrected<Enclosure, LongSum>(first);
  if (!unbalanced.empty()) return {.reason = unbalanced};
  const space::Sides sides = space::both_sides(problem, corrections, displacement, stress);
  if (!sides.reason.empty()) return {.reason = sides.reason};

  const auto own = space::shifts<Enclosure>(sides.supports, sides.field);
  const auto forms = space::elastic_forms<Enclosure>(problem);
  const std::vector<space::Face> faces = space::faces_of(problem.mesh);
  std::vector<space::Strains> whole;
  for (int cell = 0; cell < static_cast<int>(first.mesh.cells.size()); ++cell)
    whole.push_back(space::given_strain(first, given, cell));
  std::vector<LongSum> shares(first.mesh.cells.size());
  const Enclosure one(1), two(2), half = one / two;
  LongSum sum, misfit;  // ‖σ(u_x) − m‖², ‖σ(u_h) − λ_h‖²
  for (int cell = 0; cell < static_cast<int>(problem.mesh.cells.size()); ++cell) {
    const int body = problem.mesh.cell_body[cell];
    const scene::Piece<3> piece = scene::piece_of_cell(problem, cell);
    const auto at = space::displaced_cell(problem, sides.field, own, cell);
    const space::Strains of_own = space::cell_strain(at, sides.field.degree);
    const space::Strains strain = space::difference(space::on_piece(whole[piece.of], piece), of_own, half);
    const auto lambda = space::block_stress(problem, space::loaded_cell(problem, faces, sides.loads, cell), body);
    const Enclosure& volume6 = at.geometry.scaled_volume;
    const Enclosure share = space::squared_distance(forms[body], strain, lambda, half, volume6);
    sum.add(share);
    shares[piece.of].add(share);
    misfit.add(space::squared_distance(forms[body], of_own, lambda, one, volume6));
  }
  const Enclosure contact =
      space::contact_work<Enclosure, LongSum>(problem, sides.supports, sides.field, sides.loads.along_normal);
  GivenDistance result;
  result.lower = root_below(sum.value());
  result.upper = root_above(sum.value());
  // ½ (w + κ) by the gap identity: a sum of squares, which does not lose w in the rounding of two energies.
  result.stress_error = root_above(misfit.value() / Enclosure(4) + contact);
  result.norm_lower = root_below(two * sides.above.strain);
  result.norm_upper = root_above(two * sides.above.strain);
  for (const LongSum& share : shares) result.cell.push_back(std::max(0.0, upper(share.value())));
  result.valid = std::isfinite(result.upper) && std::isfinite(result.stress_error) && std::isfinite(result.norm_upper);
  if (!result.valid) result.reason = "the distance could not be enclosed: numbers too large or too small";
  return result;
}

}  // namespace bracket::bounds
