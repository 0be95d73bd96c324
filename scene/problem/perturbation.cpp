// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// Planar: facets are edges.
#include "scene/problem/perturbation.h"

#include "scene/enclosure.h"
#include "scene/problem/psi.h"

namespace bracket::scene {

template <int dim> int degree_of_load(const typename Perturbation<dim>::Facet& added) {
  const auto acts = [&](int k) { return !added.higher_traction[k].isZero(0) || added.higher_pressure[k] != 0; };
  return acts(1) ? 3 : acts(0) ? 2 : 1;
}
template int degree_of_load<2>(const Perturbation<2>::Facet&);

namespace {

Vector<2> rounded(const TwofoldVector<2>& x) { return x.value + x.rest; }

Vector<2> rounded(const std::array<TwofoldVector<2>, 2>& ends, double t) {
  return between_ends(rounded(ends[0]), rounded(ends[1]), t);
}

/// The problem with the first mesh's own data kept: what is perturbed is not the first any more.
Problem<2> with_origin(Problem<2> problem) {
  if (problem.origin.first) return problem;
  problem.origin.first = std::make_shared<const Problem<2>>(problem);
  for (std::size_t c = 0; c < problem.mesh.cells.size(); ++c)
    problem.origin.cells.push_back(whole<2>(static_cast<int>(c)));
  for (std::size_t f = 0; f < problem.mesh.boundary.size(); ++f)
    problem.origin.facets.push_back(whole<1>(static_cast<int>(f)));
  return problem;
}

/// The load on a piece with a perturbing one added, that on the piece of its first facet.
template <class Value>
void add_load(const EdgeCubic<Value>& whole, const Piece<1>& piece, double factor, std::array<Value, 2>& linear,
              std::array<Value, 2>& higher) {
  const auto added = on_stretch<double>(whole, piece.corner[0][0], piece.corner[1][0]);
  for (int i = 0; i < 2; ++i) {
    linear[i] += factor * added.linear[i];
    higher[i] += factor * added.higher[i];
  }
}

FacetData<2> with_data(FacetData<2> data, const Perturbation<2>::Facet& added, const Piece<1>& piece, double loads,
                       double kinematics) {
  const bool curved = data.support == Support::traction && degree_of_load<2>(added) > 1;
  if (curved) {
    add_load<Vector<2>>({{rounded(added.traction[0]), rounded(added.traction[1])}, added.higher_traction}, piece, loads,
                        data.traction, data.higher_traction);
    add_load<double>({added.pressure, added.higher_pressure}, piece, loads, data.pressure, data.higher_pressure);
  }
  for (int i = 0; i < 2; ++i) {
    const double t = piece.corner[i][0];
    if (data.support == Support::traction && !curved) {
      data.traction[i] += loads * rounded(added.traction, t);
      data.pressure[i] += loads * between_ends(added.pressure, t);
    }
    if (data.support == Support::fixed) data.displacement[i] += kinematics * rounded(added.displacement, t);
    if (data.support == Support::sliding)
      data.normal_displacement[i] +=
          kinematics * (rounded(added.displacement, t).dot(data.normal) + between_ends(added.normal_displacement, t));
  }
  return data;
}

}  // namespace

template <> TwofoldVector<2> difference(const Vector<2>& a, const Vector<2>& b) {
  TwofoldVector<2> result{b - a, {}};
  for (int c = 0; c < 2; ++c) {  // Knuth's TwoSum of b and −a
    const double sum = result.value[c], a_in_sum = sum - b[c];
    result.rest[c] = (b[c] - (sum - a_in_sum)) + (-a[c] - a_in_sum);
  }
  return result;
}

template <> Perturbation<2> no_perturbation(const Problem<2>& problem) {
  const Problem<2>& first = first_of(problem);
  Perturbation<2> none;
  none.force.assign(first.bodies.size(), Vector<2>::Zero());
  none.facets.resize(first.facets.size());
  none.contact.resize(first.contact.size());
  none.contact_of = contacts_by_first(first);
  return none;
}

template <>
Problem<2> perturbed(const Problem<2>& problem, std::shared_ptr<const Perturbation<2>> by, double loads,
                     double kinematics) {
  Problem<2> result = with_origin(problem);
  for (std::size_t b = 0; b < result.bodies.size(); ++b) result.bodies[b].force += loads * by->force[b];
  for (std::size_t f = 0; f < result.facets.size(); ++f) {
    const Piece<1>& piece = result.origin.facets[f];
    result.facets[f] = with_data(result.facets[f], by->facets[piece.of], piece, loads, kinematics);
  }
  for (ContactFacet& pair : result.contact) {
    const Piece<1>& piece = result.origin.facets[pair.first];
    const auto& added = by->contact[by->contact_of[piece.of]];
    const Vector<2>& d = result.facets[pair.first].normal;
    const auto gap = psi<Enclosure>(added, d, piece);
    for (int i = 0; i < 3; ++i) {
      pair.lower[i] = lower(Enclosure(pair.lower[i]) + Enclosure(kinematics) * gap[i]);
      pair.upper[i] = upper(Enclosure(pair.upper[i]) + Enclosure(kinematics) * gap[i]);
    }
    const double width = pair.second < 0 ? 1 : length(result.mesh, pair.first) / length(result.mesh, pair.second);
    for (int i = 0; i < 2; ++i) {
      const Vector<2> load = loads * between_ends(added.opening, piece.corner[i][0]) * d;
      result.facets[pair.first].traction[i] += load;
      if (pair.second >= 0) result.facets[pair.second].traction[1 - i] -= width * load;
    }
  }
  result.perturbed = {std::move(by), loads, kinematics};
  return result;
}

}  // namespace bracket::scene
