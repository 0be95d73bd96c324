// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/certificate/reactions.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace bracket::bounds {

using scene::Support;

namespace {

struct Candidate {
  Reaction reaction;
  double weight;
};

/// How much a pressure may fall before it is none.
double pressing(const scene::ContactFacet& pair, double p) { return pair.law.two_sided ? std::abs(p) : p; }

/// What is left of a shear's bound.
struct Slack {
  const scene::ContactFacet* pair;
  int which;
  double left;
};
std::vector<Slack> shear_slacks(const scene::Problem<2>& problem, const PlainLoads& loads,
                                const std::vector<char>& carrying) {
  std::vector<Slack> result;
  const FirstContacts contacts = first_contacts(problem);
  for (const auto& pair : problem.contact) {
    if (!scene::has_friction(pair.law) || !carrying[pair.pair]) continue;
    const auto bound = shear_bound<Enclosure>(problem, contacts, pair, loads.degree);
    for (int k = 0; k <= loads.degree; ++k)
      result.push_back({&pair, k, lower(bound[k]) - std::abs(loads.along_tangent[pair.first][k])});
  }
  return result;
}

/// Of each pair the largest shears of both directions: where all of it slips none has slack, but these can be less.
std::vector<Slack> largest_shears(const scene::Problem<2>& problem, const PlainLoads& loads,
                                  const std::vector<char>& carrying) {
  std::map<std::pair<int, bool>, Slack> found;
  for (const auto& pair : problem.contact) {
    if (!scene::has_friction(pair.law) || !carrying[pair.pair]) continue;
    for (int k = 0; k <= loads.degree; ++k) {
      const double shear = loads.along_tangent[pair.first][k];
      if (shear == 0) continue;
      Slack& largest = found.insert({{pair.pair, shear > 0}, {&pair, k, 0}}).first->second;
      if (std::abs(shear) > largest.left) largest = {&pair, k, std::abs(shear)};
    }
  }
  std::vector<Slack> result;
  for (const auto& [of, slack] : found) result.push_back(slack);
  return result;
}

std::vector<Candidate> candidates(const scene::Problem<2>& problem, const PlainLoads& loads) {
  constexpr double of_nothing = 1e-4, of_shear = 1e-6, of_full_shear = 1e-8,
                   of_data = 1e-9;  // so small that these come last: see reactions()
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
    for (const double p : loads.along_normal[pair.first])
      largest[pair.pair] = std::max(largest[pair.pair], pressing(pair, p));
  }
  const std::vector<char> carrying = carrying_pairs(problem, loads);
  for (const auto& pair : problem.contact)
    for (int k = 0; k <= loads.degree && carrying[pair.pair]; ++k) {
      const double p = pressing(pair, loads.along_normal[pair.first][k]);
      result.push_back({{Reaction::Kind::normal, pair.first, k, pair.second, loads.degree},
                        p > 0 ? std::max(p / largest[pair.pair], of_nothing) : of_nothing});
    }
  const std::vector<Slack> slacks = shear_slacks(problem, loads, carrying);
  double most = 0;
  for (const Slack& slack : slacks) most = std::max(most, slack.left);
  for (const auto& [pair, k, left] : slacks)
    if (left > 0)
      result.push_back({{Reaction::Kind::shear, pair->first, k, pair->second, loads.degree},
                        of_shear * std::max(left / most, 1e-2)});
  for (const auto& [pair, k, size] : largest_shears(problem, loads, carrying))
    result.push_back({{Reaction::Kind::shear, pair->first, k, pair->second, loads.degree}, of_full_shear});
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
      if (one.kind == Reaction::Kind::normal && one.facet == facet.first &&
          loads.along_normal[facet.first][one.which] > 0)
        pairs.insert(facet.pair);
  for (const auto& facet : problem.contact)
    if (pairs.contains(facet.pair))
      for (double& p : loads.along_normal[facet.first]) p = 0;
  drop_idle_shear(problem, loads);
  return !pairs.empty();
}

}  // namespace bracket::bounds
