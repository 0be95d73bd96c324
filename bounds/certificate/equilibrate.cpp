// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/certificate/equilibrate.h"

#include <algorithm>
#include <set>

#include "bounds/certificate/links.h"

namespace bracket::bounds {

using scene::Support;
using scene::Vector;

namespace {

/// A pressure below this part of the largest traction on either body is rounding of their stresses. It has to go: on a
/// body that nothing holds it would be a load, which the data do not have.
constexpr double noise = 1e-11;

void drop_noise(const scene::Problem<2>& problem, PlainLoads& loads) {
  const auto& mesh = problem.mesh;
  std::vector<double> largest(mesh.bodies.size(), 0);  // traction in each body
  for (std::size_t c = 0; c < mesh.cells.size(); ++c)
    for (const int edge : mesh.cell_edges[c]) {
      const double length = (mesh.vertices[mesh.edges[edge][1]] - mesh.vertices[mesh.edges[edge][0]]).norm();
      for (const Vector<2>& load : loads.edge[edge])
        largest[mesh.cell_body[c]] = std::max(largest[mesh.cell_body[c]], load.norm() / length);
    }
  for (const auto& pair : problem.contact) {
    double traction = largest[mesh.cell_body[mesh.boundary[pair.first].cell]];
    if (pair.second >= 0) traction = std::max(traction, largest[mesh.cell_body[mesh.boundary[pair.second].cell]]);
    for (double& p : loads.along_normal[pair.first])
      if (p <= noise * traction * scene::length(mesh, pair.first)) p = 0;
  }
}

/// σ n
Vector<2> on(const scene::Voigt<2>& stress, const Vector<2>& n) {
  return {stress[0] * n[0] + stress[2] * n[1], stress[2] * n[0] + stress[1] * n[1]};
}

}  // namespace

PlainLoads plain_loads(const scene::Problem<2>& problem, const scene::Stress<2>& stress) {
  const auto& mesh = problem.mesh;
  PlainLoads loads;
  loads.edge.assign(mesh.edges.size(), {Vector<2>::Zero(), Vector<2>::Zero()});
  std::vector<char> sides(mesh.edges.size(), 0);
  for (std::size_t c = 0; c < mesh.cells.size(); ++c)
    for (int k = 0; k < 3; ++k) {
      const int edge = mesh.cell_edges[c][k];
      const int from = mesh.cells[c][(k + 1) % 3], to = mesh.cells[c][(k + 2) % 3];
      const Vector<2> e = mesh.vertices[to] - mesh.vertices[from];
      const Vector<2> normal(e[1], -e[0]);  // as long as the edge
      const Vector<2> begin = on(stress.cell[c][3 * k], normal);
      const Vector<2> end = on(stress.cell[c][3 * k + 1], normal);
      const bool along = mesh.edges[edge][0] == from;
      loads.edge[edge][0] += along ? begin : Vector<2>(-end);
      loads.edge[edge][1] += along ? end : Vector<2>(-begin);
      ++sides[edge];
    }
  for (std::size_t e = 0; e < sides.size(); ++e)
    for (Vector<2>& load : loads.edge[e]) load /= sides[e];

  loads.along_normal.assign(problem.facets.size(), {0, 0});
  const auto on_facet = [&](int facet) {
    const auto& edge = loads.edge[mesh.boundary[facet].edge];
    const Vector<2>& n = problem.facets[facet].normal;
    return forward(mesh.boundary[facet]) ? std::array{edge[0].dot(n), edge[1].dot(n)}
                                         : std::array{-edge[1].dot(n), -edge[0].dot(n)};
  };
  for (std::size_t f = 0; f < problem.facets.size(); ++f)
    if (problem.facets[f].support == Support::sliding) loads.along_normal[f] = on_facet(static_cast<int>(f));
  for (const auto& pair : problem.contact) {
    auto& pressure = loads.along_normal[pair.first];
    pressure = on_facet(pair.first);
    if (pair.second >= 0) {
      const auto across = on_facet(pair.second);
      for (int i = 0; i < 2; ++i) pressure[i] = (pressure[i] + across[1 - i]) / 2;
    }
    for (double& p : pressure) p = std::max(0.0, -p);
  }
  drop_noise(problem, loads);
  for (std::size_t f = 0; f < problem.facets.size(); ++f)
    if (problem.facets[f].support != Support::fixed)
      loads.edge[mesh.boundary[f].edge] = {Vector<2>::Zero(), Vector<2>::Zero()};
  return loads;
}

std::vector<Reference> references(const scene::Mesh<2>& mesh) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::vector<Vector<2>> low(mesh.bodies.size(), Vector<2>::Constant(infinity)), high(mesh.bodies.size(), -low[0]);
  for (std::size_t c = 0; c < mesh.cells.size(); ++c)
    for (const int v : mesh.cells[c]) {
      low[mesh.cell_body[c]] = low[mesh.cell_body[c]].cwiseMin(mesh.vertices[v]);
      high[mesh.cell_body[c]] = high[mesh.cell_body[c]].cwiseMax(mesh.vertices[v]);
    }
  std::vector<Reference> result;
  for (std::size_t b = 0; b < low.size(); ++b)
    result.push_back({(low[b] + high[b]) / 2, (high[b] - low[b]).norm() / 2});
  return result;
}

namespace {

struct Candidate {
  Reaction reaction;
  double weight;
};

std::vector<Candidate> candidates(const scene::Problem<2>& problem, const PlainLoads& loads) {
  constexpr double of_nothing = 1e-4, of_data = 1e-8;  // so small that these come last: see reactions()
  std::vector<Candidate> result;
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    const int facet = static_cast<int>(f);
    const auto& [a, b] = problem.mesh.boundary[f].vertices;
    const double length = (problem.mesh.vertices[b] - problem.mesh.vertices[a]).norm();
    const Support support = problem.facets[f].support;
    for (int which = 0; which < 3 && support == Support::fixed; ++which)
      result.push_back({{Reaction::Kind::any, facet, which}, 1 / (which == 2 ? length : 1)});
    for (int end = 0; end < 2 && support == Support::sliding; ++end)
      result.push_back({{Reaction::Kind::normal, facet, end}, 1});
  }
  std::vector<double> largest;  // pressure of each pair
  for (const auto& pair : problem.contact) {
    largest.resize(std::max<std::size_t>(largest.size(), pair.pair + 1), 0);
    for (const double p : loads.along_normal[pair.first]) largest[pair.pair] = std::max(largest[pair.pair], p);
  }
  for (const auto& pair : problem.contact)
    for (int end = 0; end < 2 && largest[pair.pair] > 0; ++end)
      result.push_back({{Reaction::Kind::normal, pair.first, end, pair.second},
                        std::max(loads.along_normal[pair.first][end] / largest[pair.pair], of_nothing)});
  for (std::size_t i = 0; i < scene::first_of(problem).corrections.size(); ++i)
    result.push_back({{Reaction::Kind::correction, -1, static_cast<int>(i)}, of_data});
  return result;
}

}  // namespace

std::vector<char> carrying_pairs(const scene::Problem<2>& problem, const PlainLoads& loads) {
  std::vector<char> carrying;
  for (const auto& pair : problem.contact) {
    carrying.resize(std::max<std::size_t>(carrying.size(), pair.pair + 1), 0);
    for (const double p : loads.along_normal[pair.first]) carrying[pair.pair] |= p > 0;
  }
  return carrying;
}

PlainLoads no_loads(const scene::Problem<2>& problem) {
  PlainLoads none;
  none.edge.assign(problem.mesh.edges.size(), {Vector<2>::Zero(), Vector<2>::Zero()});
  none.along_normal.assign(problem.facets.size(), {0, 0});
  return none;
}

PlainLoads assumed_loads(const scene::Problem<2>& first) {
  PlainLoads assumed = no_loads(first);
  for (const auto& pair : first.contact)
    if (first.carries[pair.pair]) assumed.along_normal[pair.first] = {1, 1};
  return assumed;
}

std::vector<Reaction> reactions(const scene::Problem<2>& problem, const std::vector<Reference>& references,
                                const PlainLoads& loads, const std::vector<Reaction>& barred) {
  std::vector<Candidate> all = candidates(problem, loads);
  std::erase_if(all, [&](const Candidate& candidate) {
    return std::find(barred.begin(), barred.end(), candidate.reaction) != barred.end();
  });
  const auto n = static_cast<Eigen::Index>(3 * problem.mesh.bodies.size());
  Eigen::MatrixXd effects(n, static_cast<Eigen::Index>(all.size()));
  for (std::size_t j = 0; j < all.size(); ++j) {
    const auto column = effect<double>(problem, references, all[j].reaction);
    effects.col(static_cast<Eigen::Index>(j)) = all[j].weight * Eigen::Map<const Eigen::VectorXd>(column.data(), n);
  }
  if (effects.cols() < n) return {};
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(effects);
  std::vector<Reaction> chosen;
  for (Eigen::Index k = 0; k < n && std::abs(qr.matrixQR()(k, k)) > 1e-11; ++k)
    chosen.push_back(all[qr.colsPermutation().indices()[k]].reaction);
  return chosen;
}

bool corrections_vanish(const scene::Problem<2>& problem, const std::vector<Reaction>& chosen,
                        const std::vector<char>& carrying) {
  const scene::Problem<2>& first = scene::first_of(problem);
  const auto corrections = std::count_if(chosen.begin(), chosen.end(), [](const Reaction& reaction) {
    return reaction.kind == Reaction::Kind::correction;
  });
  if (corrections == 0) return true;
  const int unheld = unheld_motions(first, carrying);
  std::vector<char> either = carrying;
  for (std::size_t pair = 0; pair < either.size(); ++pair) either[pair] |= first.carries[pair];
  return corrections == unheld && unheld == unheld_motions(first, either);
}

bool drop_barred_pairs(const scene::Problem<2>& problem, const std::vector<Reaction>& barred, PlainLoads& loads) {
  std::set<int> pairs;
  for (const auto& facet : problem.contact)
    for (const Reaction& one : barred)
      if (one.facet == facet.first && loads.along_normal[facet.first][one.which] > 0) pairs.insert(facet.pair);
  for (const auto& facet : problem.contact)
    if (pairs.contains(facet.pair)) loads.along_normal[facet.first] = {0, 0};
  return !pairs.empty();
}

std::vector<Branch> trees(const scene::Mesh<2>& mesh, const std::vector<Reference>& references) {
  std::vector<std::array<int, 2>> cells_at(mesh.edges.size(), {-1, -1});
  std::vector<int> root(mesh.bodies.size(), -1);
  std::vector<double> nearest(mesh.bodies.size(), std::numeric_limits<double>::infinity());
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    for (const int edge : mesh.cell_edges[c]) cells_at[edge][cells_at[edge][0] >= 0] = static_cast<int>(c);
    const int body = mesh.cell_body[c];
    const double distance = (mesh.vertices[mesh.cells[c][0]] - references[body].point).norm();
    if (distance >= nearest[body]) continue;
    nearest[body] = distance;
    root[body] = static_cast<int>(c);
  }
  std::vector<Branch> order;
  std::vector<char> reached(mesh.cells.size(), 0);
  for (const int cell : root) {
    order.push_back({cell, -1, -1});
    reached[cell] = 1;
  }
  for (std::size_t k = 0; k < order.size(); ++k) {
    const int cell = order[k].cell;
    for (const int edge : mesh.cell_edges[cell])
      for (const int other : cells_at[edge]) {
        if (other < 0 || reached[other]) continue;
        reached[other] = 1;
        const auto& edges = mesh.cell_edges[other];  // edge m lies between the corners m + 1 and m + 2
        const int m = static_cast<int>(std::find(edges.begin(), edges.end(), edge) - edges.begin());
        order.push_back({other, cell, (m + 1) % 3});
      }
  }
  return order;
}

// Gaussian elimination: zeros stay zeros, so that what does not act on a body stays zero exactly.
std::optional<std::vector<Enclosure>> solution(std::vector<std::vector<Enclosure>> a, std::vector<Enclosure> b) {
  const std::size_t n = b.size();
  const auto certain = [](const Enclosure& x) { return std::abs(x.middle) - x.radius; };  // size, whatever the rounding
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < n; ++i)
      if (certain(a[i][k]) > certain(a[pivot][k])) pivot = i;
    if (!(certain(a[pivot][k]) > 0)) return {};
    std::swap(a[k], a[pivot]);
    std::swap(b[k], b[pivot]);
    for (std::size_t i = k + 1; i < n; ++i) {
      if (a[i][k].is_zero()) continue;
      const Enclosure factor = a[i][k] / a[k][k];
      for (std::size_t j = k + 1; j < n; ++j) a[i][j] -= factor * a[k][j];
      b[i] -= factor * b[k];
    }
  }
  std::vector<Enclosure> x(n);
  for (std::size_t k = n; k-- > 0;) {
    Enclosure rest = b[k];
    for (std::size_t j = k + 1; j < n; ++j) rest -= a[k][j] * x[j];
    x[k] = rest / a[k][k];
    if (!std::isfinite(magnitude(x[k]))) return {};
  }
  return x;
}

}  // namespace bracket::bounds
