// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/interval_faults.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "bounds/bounds.h"

namespace bracket::tests {
namespace {

using scene::Status;

/// An interval, and where it comes from.
struct Found {
  int degree, level;
  double lower, upper;
  double added;  // to the upper bound by its certificate
  std::string name() const { return fmt::format("degree {}, mesh {}: [{}, {}]", degree, level, lower, upper); }
};

struct Ended {
  Status status = Status::done;
  std::string reason;
  std::vector<Found> found;
  double rounding = 0;  // see rounding()
  bool internal = false;
};

/// The work of the loads, with every component of every load counted as positive.
double absolute_work(const scene::Problem<2>& problem, const scene::Displacement<2>& displacement) {
  const auto& mesh = problem.mesh;
  double work = 0;
  const auto at = [&](int vertex) { return displacement.vertex[vertex].cwiseAbs(); };
  for (std::size_t c = 0; c < mesh.cells.size(); ++c)
    for (const int vertex : mesh.cells[c])
      work += scene::volume(mesh, static_cast<int>(c)) *
              problem.bodies[mesh.cell_body[c]].force.cwiseAbs().dot(at(vertex));
  for (std::size_t f = 0; f < problem.facets.size(); ++f)
    for (int end = 0; end < 2; ++end)
      work += scene::length(mesh, static_cast<int>(f)) *
              problem.facets[f].traction[end].cwiseAbs().dot(at(mesh.boundary[f].vertices[end]));
  return work;
}

/// What rounding may do to the energy between meshes of one scene, whose midpoints are not exactly on their edges: it
/// turns loads and areas by a share of them, however much of their work cancels, and strains what the displacements
/// move rigidly.
double rounding(const bounds::Outcome<2>& outcome) {
  const scene::Mesh<2>& mesh = outcome.problem.mesh;
  constexpr double epsilon = 64 * std::numeric_limits<double>::epsilon();
  double farthest = 0, shortest = std::numeric_limits<double>::infinity(), largest = 0, stiffness = 0;
  for (const auto& x : mesh.vertices) farthest = std::max(farthest, x.cwiseAbs().maxCoeff());
  for (const auto& [a, b] : mesh.edges) shortest = std::min(shortest, (mesh.vertices[b] - mesh.vertices[a]).norm());
  for (const auto& u : outcome.displacement.vertex) largest = std::max(largest, u.norm());
  for (std::size_t c = 0; c < mesh.cells.size(); ++c)
    stiffness += scene::volume(mesh, static_cast<int>(c)) * outcome.problem.bodies[mesh.cell_body[c]].stiffness.norm();
  const double strain = epsilon * largest / shortest * std::max(1.0, farthest / outcome.problem.length_scale);
  const double size = std::max(std::abs(outcome.lower), std::abs(outcome.upper));
  return epsilon * farthest / shortest * (size + absolute_work(outcome.problem, outcome.displacement)) +
         stiffness * strain * strain;
}

Ended solved(const scene::Scene<2>& scene, const scene::Mesh<2>& mesh) {
  Ended ended;
  try {
    const auto outcome = bounds::run(scene, scene::fix_data(scene, mesh));
    ended.status = outcome.status;
    ended.reason = outcome.reason;
    if (outcome.guarantee == "none") return ended;
    ended.rounding = rounding(outcome);
    for (const bounds::Level& level : outcome.levels)
      ended.found.push_back({scene.solve.degree, static_cast<int>(ended.found.size()), level.bracket.lower,
                             level.bracket.upper, std::abs(level.bracket.upper - level.plain.upper)});
  } catch (const scene::Error& error) {
    ended.status = error.status();
    ended.reason = error.what();
  } catch (const std::exception& error) {
    ended.internal = true;
    ended.reason = error.what();
  }
  return ended;
}

std::vector<std::string> faults_of_ending(int degree, const Ended& ended) {
  std::vector<std::string> faults;
  const auto say = [&](const std::string& what) {
    faults.push_back(fmt::format("degree {}: {}: status {}, {}", degree, what, static_cast<int>(ended.status),
                                 ended.reason));
  };
  if (ended.internal) say("an exception that is no scene::Error");
  else if (ended.status == Status::internal || ended.status == Status::input || ended.status == Status::mesh)
    say("a scene that should be well-formed is refused");
  if (ended.status != Status::done && std::ranges::count(ended.reason, '\n') + ended.reason.empty() > 0)
    say("not one line");
  if (ended.reason.find("fault of this program") != std::string::npos) say("a fault it found itself");
  return faults;
}

std::vector<std::string> faults_between(const Found& one, const Found& other, double slack) {
  std::vector<std::string> faults;
  if (one.lower > other.upper + slack || other.lower > one.upper + slack)
    faults.push_back(fmt::format("they exclude each other: {} and {}", one.name(), other.name()));
  const bool nested = one.degree <= other.degree && one.level <= other.level;
  if (nested && other.upper > one.upper + other.added + one.added + slack)
    faults.push_back(fmt::format("the upper bound rises: {} to {}", one.name(), other.name()));
  return faults;
}

}  // namespace

Verdict judge(scene::Scene<2> scene, const scene::Mesh<2>& mesh) {
  scene.refine = {.strategy = "uniform", .max_levels = 3};
  Verdict verdict;
  std::vector<Found> found;
  double slack = 0;
  for (const int degree : {1, 2}) {
    scene.solve.degree = degree;
    const Ended ended = solved(scene, mesh);
    verdict.status = ended.status;
    verdict.reason = ended.reason;
    for (const std::string& fault : faults_of_ending(degree, ended)) verdict.faults.push_back(fault);
    slack = std::max(slack, ended.rounding);
    found.insert(found.end(), ended.found.begin(), ended.found.end());
  }
  for (const Found& one : found) {
    if (!(one.lower <= one.upper) || !std::isfinite(one.lower) || !std::isfinite(one.upper))
      verdict.faults.push_back("no interval: " + one.name());
    for (const Found& other : found)
      if (&one != &other)
        for (const std::string& fault : faults_between(one, other, slack)) verdict.faults.push_back(fault);
  }
  return verdict;
}

}  // namespace bracket::tests
