// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/report/samples.h"

#include <algorithm>
#include <map>
#include <set>

#include "scene/voigt.h"

namespace bracket::apps {

std::vector<double> displacement_pressure(const scene::Problem<2>& problem, const scene::Displacement<2>& displacement,
                                          int facet) {
  const auto& on = problem.mesh.boundary[facet];
  const auto stress = bounds::displacement_stress(problem, displacement, on.cell);
  const scene::Vector<2> d = problem.facets[facet].normal;
  const int degree = scene::stress_degree(displacement.degree);
  const auto& [from, to] = scene::Simplex<2>::facets[on.local];
  std::vector<double> pressure;
  for (int k = 0; k <= degree; ++k) {
    std::array<int, 3> index = {0, 0, 0};
    index[from] = degree - k;
    index[to] = k;
    pressure.push_back(-scene::traction<2>(stress[scene::bernstein_place(index)], d).dot(d));
  }
  return pressure;
}

std::vector<double> samples(const std::vector<double>& coefficients) {
  const int degree = static_cast<int>(coefficients.size()) - 1, last = degree == 1 ? 1 : 4 * degree;
  std::vector<double> values;
  for (int i = 0; i <= last; ++i)
    values.push_back(scene::value_on_segment(coefficients, static_cast<double>(i) / last));
  return values;
}

template <> scene::FacetQuadratic<2> quadratic_at_nodes<2>(const scene::FacetQuadratic<2>& coefficients) {
  return {coefficients[0], scene::at_middle(coefficients), coefficients[2]};
}
template <> scene::FacetQuadratic<3> quadratic_at_nodes<3>(const scene::FacetQuadratic<3>& coefficients) {
  scene::FacetQuadratic<3> values = coefficients;
  for (int e = 0; e < 3; ++e) {
    const auto& [a, b] = scene::Simplex<2>::edges[e];
    values[3 + e] = 0.5 * (coefficients[3 + e] + 0.5 * (coefficients[a] + coefficients[b]));
  }
  return values;
}

template <int dim> std::vector<std::array<int, std::size_t{dim} + 1>> facets_of_cells(const scene::Mesh<dim>& mesh) {
  std::array<int, dim + 1> none;
  none.fill(-1);
  std::vector<std::array<int, dim + 1>> result(mesh.cells.size(), none);
  for (int i = 0; i < static_cast<int>(mesh.boundary.size()); ++i)
    result[mesh.boundary[i].cell][mesh.boundary[i].local] = i;
  return result;
}
template std::vector<std::array<int, 3>> facets_of_cells(const scene::Mesh<2>&);
template std::vector<std::array<int, 4>> facets_of_cells(const scene::Mesh<3>&);

std::vector<Chain> chained(const scene::Mesh<2>& mesh, const std::vector<int>& facets) {
  const auto ends = [&](int i) { return mesh.boundary[facets[i]].vertices; };
  std::map<int, int> beginning_at;  // vertex: the facet that begins there
  std::set<int> followed;           // vertices at which a facet ends
  for (int i = 0; i < static_cast<int>(facets.size()); ++i) {
    beginning_at.emplace(ends(i)[0], i);
    followed.insert(ends(i)[1]);
  }
  std::vector<Chain> result;
  while (!beginning_at.empty()) {
    auto start = std::ranges::find_if(beginning_at, [&](const auto& entry) { return !followed.contains(entry.first); });
    if (start == beginning_at.end()) start = beginning_at.begin();  // what is left is closed
    Chain chain;
    for (auto next = start; next != beginning_at.end();) {
      const int i = next->second;
      chain.push_back(i);
      beginning_at.erase(next);
      next = beginning_at.find(ends(i)[1]);
    }
    result.push_back(chain);
  }
  return result;
}

std::vector<Chain> chains(const scene::Problem<2>& problem, int pair) {
  std::vector<int> contacts, facets;
  for (int i = 0; i < static_cast<int>(problem.contact.size()); ++i) {
    if (problem.contact[i].pair != pair) continue;
    contacts.push_back(i);
    facets.push_back(problem.contact[i].first);
  }
  std::vector<Chain> result = chained(problem.mesh, facets);
  for (Chain& chain : result)
    for (int& i : chain) i = contacts[i];
  return result;
}

namespace {

template <int dim>
double largest_pressure(const scene::Problem<dim>& problem, const std::vector<bounds::ContactState>& contact,
                        int pair) {
  double largest = 0;
  for (std::size_t i = 0; i < problem.contact.size(); ++i)
    if (problem.contact[i].pair == pair) largest = std::max(largest, std::ranges::max(contact[i].pressure));
  return largest;
}

}  // namespace

template <int dim>
double rounding_of_pressure(const scene::Problem<dim>& problem, const scene::Stress<dim>& stress,
                            const std::vector<bounds::ContactState>& contact, int pair) {
  constexpr double of_stress = 1e-11;  // the certificate drops what is less
  const scene::Mesh<dim>& mesh = problem.mesh;
  std::vector<char> touches(mesh.bodies.size(), 0);
  for (const scene::ContactFacetOf<dim>& facet : problem.contact)
    for (const int side : {facet.first, facet.second})
      if (facet.pair == pair && side >= 0) touches[mesh.cell_body[mesh.boundary[side].cell]] = 1;
  double largest = 0;
  for (std::size_t c = 0; c < stress.cell.size(); ++c) {
    if (!touches[mesh.cell_body[c]]) continue;
    for (const scene::Voigt<dim>& s : stress.cell[c]) largest = std::max(largest, s.norm());
  }
  return std::max(of_stress * largest, bounds::Checks::tolerance * largest_pressure(problem, contact, pair));
}

template double rounding_of_pressure(const scene::Problem<2>&, const scene::Stress<2>&,
                                     const std::vector<bounds::ContactState>&, int);
template double rounding_of_pressure(const scene::Problem<3>&, const scene::Stress<3>&,
                                     const std::vector<bounds::ContactState>&, int);

bool presses(const bounds::ContactState& state, double rounding) { return std::ranges::max(state.pressure) > rounding; }

}  // namespace bracket::apps
