// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/problem/perturbation.h"

#include "scene/enclosure.h"
#include "scene/problem/psi.h"

namespace bracket::scene {

template <int dim> int degree_of_load(const typename Perturbation<dim>::Facet& added) {
  const auto acts = [&](int k) { return !added.higher_traction[k].isZero(0) || added.higher_pressure[k] != 0; };
  return acts(1) ? 3 : acts(0) ? 2 : 1;
}
template int degree_of_load<2>(const Perturbation<2>::Facet&);
template int degree_of_load<3>(const Perturbation<3>::Facet&);

namespace {

template <int dim> Vector<dim> rounded(const TwofoldVector<dim>& x) { return x.value + x.rest; }

/// Of what is linear on a facet of the first mesh.
template <class Value> Value at_point(const std::array<Value, 2>& ends, const std::array<double, 1>& at) {
  return between_ends(ends, at[0]);
}
template <class Value> Value at_point(const std::array<Value, 3>& corners, const OnFace& at) {
  return linear_at(corners, at);
}

template <int dim, std::size_t n>
Vector<dim> rounded(const std::array<TwofoldVector<dim>, n>& vertices, const std::array<double, n - 1>& at) {
  std::array<Vector<dim>, n> x;
  for (std::size_t i = 0; i < n; ++i) x[i] = rounded(vertices[i]);
  return at_point(x, at);
}

/// The problem with the first mesh's own data kept: what is perturbed is not the first any more.
template <int dim> Problem<dim> with_origin(Problem<dim> problem) {
  if (problem.origin.first) return problem;
  problem.origin.first = std::make_shared<const Problem<dim>>(problem);
  for (std::size_t c = 0; c < problem.mesh.cells.size(); ++c)
    problem.origin.cells.push_back(whole<dim>(static_cast<int>(c)));
  for (std::size_t f = 0; f < problem.mesh.boundary.size(); ++f)
    problem.origin.facets.push_back(whole<dim - 1>(static_cast<int>(f)));
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
/// Planar: where a perturbing load is not linear. \return whether it is added
bool add_curved(FacetData<2>& data, const Perturbation<2>::Facet& added, const Piece<1>& piece, double loads) {
  if (data.support == Support::fixed || degree_of_load<2>(added) == 1) return false;
  add_load<Vector<2>>({{rounded(added.traction[0]), rounded(added.traction[1])}, added.higher_traction}, piece, loads,
                      data.traction, data.higher_traction);
  add_load<double>({added.pressure, added.higher_pressure}, piece, loads, data.pressure, data.higher_pressure);
  return true;
}
bool add_curved(FacetData<3>&, const Perturbation<3>::Facet&, const Piece<2>&, double) { return false; }

template <int dim>
FacetData<dim> with_data(FacetData<dim> data, const typename Perturbation<dim>::Facet& added,
                         const Piece<dim - 1>& piece, double loads, double kinematics) {
  const bool curved = add_curved(data, added, piece, loads);
  for (int i = 0; i < dim; ++i) {
    const auto& at = piece.corner[i];
    if (data.support != Support::fixed && !curved) {
      data.traction[i] += loads * rounded(added.traction, at);
      data.pressure[i] += loads * at_point(added.pressure, at);
    }
    if (data.support == Support::fixed) data.displacement[i] += kinematics * rounded(added.displacement, at);
    if (data.support == Support::sliding)
      data.normal_displacement[i] +=
          kinematics * (rounded(added.displacement, at).dot(data.normal) + at_point(added.normal_displacement, at));
  }
  return data;
}

}  // namespace

template <int dim> TwofoldVector<dim> difference(const Vector<dim>& a, const Vector<dim>& b) {
  TwofoldVector<dim> result{b - a, {}};
  for (int c = 0; c < dim; ++c) {  // Knuth's TwoSum of b and −a
    const double sum = result.value[c], a_in_sum = sum - b[c];
    result.rest[c] = (b[c] - (sum - a_in_sum)) + (-a[c] - a_in_sum);
  }
  return result;
}

template <int dim> Perturbation<dim> no_perturbation(const Problem<dim>& problem) {
  const Problem<dim>& first = first_of(problem);
  Perturbation<dim> none;
  none.force.assign(first.bodies.size(), Vector<dim>::Zero());
  none.facets.resize(first.facets.size());
  none.contact.resize(first.contact.size());
  none.contact_of = contacts_by_first(first);
  return none;
}

template <int dim>
Problem<dim> perturbed(const Problem<dim>& problem, std::shared_ptr<const Perturbation<dim>> by, double loads,
                       double kinematics) {
  Problem<dim> result = with_origin(problem);
  for (std::size_t b = 0; b < result.bodies.size(); ++b) result.bodies[b].force += loads * by->force[b];
  for (std::size_t f = 0; f < result.facets.size(); ++f) {
    const Piece<dim - 1>& piece = result.origin.facets[f];
    result.facets[f] = with_data<dim>(result.facets[f], by->facets[piece.of], piece, loads, kinematics);
  }
  for (ContactFacetOf<dim>& pair : result.contact) {
    const Piece<dim - 1>& piece = result.origin.facets[pair.first];
    const auto& added = by->contact[by->contact_of[piece.of]];
    const Vector<dim>& d = result.facets[pair.first].normal;
    const auto gap = psi<Enclosure>(added, d, piece);
    for (std::size_t i = 0; i < gap.size(); ++i) {
      pair.lower[i] = lower(Enclosure(pair.lower[i]) + Enclosure(kinematics) * gap[i]);
      pair.upper[i] = upper(Enclosure(pair.upper[i]) + Enclosure(kinematics) * gap[i]);
    }
    if constexpr (dim == 2) {
      const auto slip = psi_of_slip<double>(added, d, piece);
      for (int i = 0; i < 3 && has_friction(pair.law); ++i) pair.slip[i] += kinematics * slip[i];
    }
    const double width = pair.second < 0 ? 1 : length(result.mesh, pair.first) / length(result.mesh, pair.second);
    for (int i = 0; i < dim; ++i) {
      Vector<dim> load = loads * at_point(added.opening, piece.corner[i]) * d;
      if constexpr (dim == 2) load += loads * between_ends(added.shear, piece.corner[i][0]) * tangent(d);
      result.facets[pair.first].traction[i] += load;
      if (pair.second >= 0) result.facets[pair.second].traction[pair.meets[i]] -= width * load;
    }
  }
  result.perturbed = {std::move(by), loads, kinematics};
  return result;
}

template TwofoldVector<2> difference(const Vector<2>&, const Vector<2>&);
template TwofoldVector<3> difference(const Vector<3>&, const Vector<3>&);
template Perturbation<2> no_perturbation(const Problem<2>&);
template Perturbation<3> no_perturbation(const Problem<3>&);
template Problem<2> perturbed(const Problem<2>&, std::shared_ptr<const Perturbation<2>>, double, double);
template Problem<3> perturbed(const Problem<3>&, std::shared_ptr<const Perturbation<3>>, double, double);

}  // namespace bracket::scene
