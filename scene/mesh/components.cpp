// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <boost/pending/disjoint_sets.hpp>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <unordered_map>

#include "scene/mesh/topology.h"
#include "scene/text.h"

namespace bracket::scene {

template <int dim> Vector<dim> centre(const Mesh<dim>& mesh, int cell) {
  Vector<dim> sum = Vector<dim>::Zero();
  for (const Vector<dim>& x : positions(mesh, mesh.cells[cell])) sum += x;
  return sum / (dim + 1);
}

template <int dim> Mesh<dim> with_components(Mesh<dim> mesh) {
  const int cells = static_cast<int>(mesh.cells.size());
  std::vector<int> ranks(cells), parents(cells);
  std::iota(parents.begin(), parents.end(), 0);
  boost::disjoint_sets<int*, int*> connected(ranks.data(), parents.data());
  std::vector<int> first(n_facets(mesh), -1);
  for (int cell = 0; cell < cells; ++cell) {
    for (const int facet : cell_facets(mesh, cell)) {
      if (first[facet] == -1) first[facet] = cell;
      connected.union_set(first[facet], cell);
    }
  }
  std::map<int, std::set<int>> bodies;  // of each set, by its representative
  for (int cell = 0; cell < cells; ++cell) bodies[connected.find_set(cell)].insert(mesh.cell_body[cell]);
  std::vector<std::pair<std::set<int>, int>> sets;
  for (const auto& [representative, of] : bodies) sets.emplace_back(of, representative);
  std::ranges::sort(sets);
  std::vector<int> number(cells, -1);
  for (const auto& [of, representative] : sets) {
    number[representative] = static_cast<int>(mesh.components.size());
    std::vector<std::string> names;
    for (const int body : of) names.push_back(mesh.bodies[body]);
    mesh.components.push_back(fmt::format("{}", fmt::join(names, " + ")));
  }
  for (int cell = 0; cell < cells; ++cell) mesh.cell_component.push_back(number[connected.find_set(cell)]);
  return mesh;
}

template <int dim> void check_whole(const Mesh<dim>& mesh, const std::string& where) {
  std::vector<int> first(mesh.bodies.size(), -1);
  for (int cell = 0; cell < static_cast<int>(mesh.cells.size()); ++cell) {
    int& known = first[mesh.cell_body[cell]];
    if (known == -1) known = cell;
    if (mesh.cell_component[known] == mesh.cell_component[cell]) continue;
    const std::string mend = coinciding_nodes(mesh, mesh.cell_body[cell]);
    fail(Status::mesh, where,
         fmt::format("the body '{}' falls into pieces: no chain of cells leads from {} to {}; {}",
                     mesh.bodies[mesh.cell_body[cell]], point(centre(mesh, known)), point(centre(mesh, cell)),
                     mend.empty() ? "make each a body" : mend));
  }
}

template <int dim> double coincidence(const Mesh<dim>& mesh) {
  double shortest = std::numeric_limits<double>::infinity();
  for (const auto& [a, b] : mesh.edges) shortest = std::min(shortest, (mesh.vertices[b] - mesh.vertices[a]).norm());
  return std::pow(10, std::floor(std::log10(1e-6 * shortest)));
}

template <int dim> std::string coinciding_nodes(const Mesh<dim>& mesh, int body) {
  std::set<int> of_body;
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
    if (mesh.cell_body[cell] == body) of_body.insert(mesh.cells[cell].begin(), mesh.cells[cell].end());
  const std::vector<int> vertices(of_body.begin(), of_body.end());
  std::vector<Vector<dim>> points;
  for (const int vertex : vertices) points.push_back(mesh.vertices[vertex]);
  const double distance = coincidence(mesh);
  const std::vector<int> first = merged(points, distance);
  int count = 0;
  Vector<dim> at = Vector<dim>::Zero();
  for (std::size_t i = 0; i < first.size(); ++i) {
    if (first[i] == static_cast<int>(i)) continue;
    if (count++ == 0) at = points[i];
  }
  if (count == 0) return "";
  return fmt::format("{} node{} with others, at {} for one; to make them one, write --set mesh.merge={:.0e}", count,
                     count == 1 ? " coincides" : "s coincide", point(at), distance);
}

namespace {

/// Across the first axis, boxes as wide as a distance; numbered by doubles, which have no end.
template <int dim> using Stripe = std::array<double, dim - 1>;

template <int dim> struct StripeHash {
  std::size_t operator()(const Stripe<dim>& stripe) const {
    std::size_t hash = 0;
    for (const double number : stripe) hash = 31 * hash + std::hash<double>()(number);
    return hash;
  }
};

/// The stripe itself and those around it.
template <int dim> std::vector<Stripe<dim>> around(const Stripe<dim>& stripe) {
  std::vector<Stripe<dim>> result = {stripe};
  for (int axis = 0; axis < dim - 1; ++axis) {
    std::vector<Stripe<dim>> wider;
    for (const double by : {-1.0, 0.0, 1.0})
      for (Stripe<dim> one : result) {
        one[axis] += by;
        wider.push_back(one);
      }
    result = std::move(wider);
  }
  return result;
}

}  // namespace

// From left to right in stripes of the distance: those in reach are in the same or a neighbour.
template <int dim> std::vector<int> merged(const std::vector<Vector<dim>>& points, double distance) {
  const int count = static_cast<int>(points.size());
  std::vector<int> order(count), ranks(count), parents(count);
  std::iota(order.begin(), order.end(), 0);
  std::iota(parents.begin(), parents.end(), 0);
  boost::disjoint_sets<int*, int*> sets(ranks.data(), parents.data());
  Vector<dim> lowest = points.empty() ? Vector<dim>(Vector<dim>::Zero()) : points.front();
  for (const Vector<dim>& x : points) lowest = lowest.cwiseMin(x);
  std::unordered_map<Stripe<dim>, std::vector<int>, StripeHash<dim>> stripes;
  const auto stripe = [&](int i) {
    Stripe<dim> result;
    for (int c = 1; c < dim; ++c) result[c - 1] = std::floor((points[i][c] - lowest[c]) / distance);
    return result;
  };
  std::ranges::sort(order, {}, [&](int i) { return std::pair(points[i][0], i); });
  for (const int i : order) {
    for (const Stripe<dim>& beside : around<dim>(stripe(i))) {
      const auto near = stripes.find(beside);
      if (near == stripes.end()) continue;
      for (auto j = near->second.rbegin(); j != near->second.rend() && points[i][0] - points[*j][0] <= distance; ++j)
        if ((points[i] - points[*j]).norm() <= distance) sets.union_set(i, *j);
    }
    stripes[stripe(i)].push_back(i);
  }
  std::vector<int> first(count, -1), result(count);
  for (int i = 0; i < count; ++i) {
    int& of = first[sets.find_set(i)];
    if (of == -1) of = i;
    result[i] = of;
  }
  return result;
}

template Vector<2> centre(const Mesh<2>&, int);
template Vector<3> centre(const Mesh<3>&, int);
template Mesh<2> with_components(Mesh<2>);
template Mesh<3> with_components(Mesh<3>);
template void check_whole(const Mesh<2>&, const std::string&);
template void check_whole(const Mesh<3>&, const std::string&);
template double coincidence(const Mesh<2>&);
template double coincidence(const Mesh<3>&);
template std::string coinciding_nodes(const Mesh<2>&, int);
template std::string coinciding_nodes(const Mesh<3>&, int);
template std::vector<int> merged(const std::vector<Vector<2>>&, double);
template std::vector<int> merged(const std::vector<Vector<3>>&, double);

}  // namespace bracket::scene
