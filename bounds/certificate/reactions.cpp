// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/certificate/reactions.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace bracket::bounds {

using scene::Support;

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
    for (int k = 0; k <= loads.degree && support == Support::sliding; ++k)
      result.push_back({{Reaction::Kind::normal, facet, k, -1, loads.degree}, 1});
  }
  std::vector<double> largest;  // pressure of each pair
  for (const auto& pair : problem.contact) {
    largest.resize(std::max<std::size_t>(largest.size(), pair.pair + 1), 0);
    for (const double p : loads.along_normal[pair.first]) largest[pair.pair] = std::max(largest[pair.pair], p);
  }
  for (const auto& pair : problem.contact)
    for (int k = 0; k <= loads.degree && largest[pair.pair] > 0; ++k)
      result.push_back({{Reaction::Kind::normal, pair.first, k, pair.second, loads.degree},
                        std::max(loads.along_normal[pair.first][k] / largest[pair.pair], of_nothing)});
  for (std::size_t i = 0; i < scene::first_of(problem).corrections.size(); ++i)
    result.push_back({{Reaction::Kind::correction, -1, static_cast<int>(i)}, of_data});
  return result;
}

}  // namespace

std::vector<Reaction> reactions(const scene::Problem<2>& problem, const std::vector<Reference>& references,
                                const PlainLoads& loads, const std::vector<Reaction>& barred) {
  std::vector<Candidate> all = candidates(problem, loads);
  std::erase_if(all, [&](const Candidate& candidate) {
    return std::find(barred.begin(), barred.end(), candidate.reaction) != barred.end();
  });
  const auto n = static_cast<Eigen::Index>(3 * problem.mesh.components.size());
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

bool drop_barred_pairs(const scene::Problem<2>& problem, const std::vector<Reaction>& barred, PlainLoads& loads) {
  std::set<int> pairs;
  for (const auto& facet : problem.contact)
    for (const Reaction& one : barred)
      if (one.facet == facet.first && loads.along_normal[facet.first][one.which] > 0) pairs.insert(facet.pair);
  for (const auto& facet : problem.contact)
    if (pairs.contains(facet.pair))
      for (double& p : loads.along_normal[facet.first]) p = 0;
  return !pairs.empty();
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
