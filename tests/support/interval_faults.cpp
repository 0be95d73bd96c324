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
  std::string name() const { return fmt::format("degree {}, mesh {}: [{}, {}]", degree, level, lower, upper); }
};

struct Ended {
  Status status = Status::done;
  std::string reason;
  std::vector<Found> found;
  bool internal = false;
};

Ended solved(const scene::Scene<2>& scene, const scene::Mesh<2>& mesh) {
  Ended ended;
  try {
    const auto outcome = bounds::run(scene, scene::fix_data(scene, mesh));
    ended.status = outcome.status;
    ended.reason = outcome.reason;
    if (outcome.guarantee == "none") return ended;
    for (const bounds::Level& level : outcome.levels)
      ended.found.push_back(
          {scene.solve.degree, static_cast<int>(ended.found.size()), level.bracket.lower, level.bracket.upper});
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
    faults.push_back(
        fmt::format("degree {}: {}: status {}, {}", degree, what, static_cast<int>(ended.status), ended.reason));
  };
  if (ended.internal)
    say("an exception that is no scene::Error");
  else if (ended.status == Status::internal || ended.status == Status::input || ended.status == Status::mesh)
    say("a scene that should be well-formed is refused");
  if (ended.status != Status::done && std::ranges::count(ended.reason, '\n') + ended.reason.empty() > 0)
    say("not one line");
  if (ended.reason.find("fault of this program") != std::string::npos) say("a fault it found itself");
  return faults;
}

/// Intervals are of one problem to the last bit. (That upper bounds do not rise but by rounding is what a run itself
/// sees to.)
std::vector<std::string> faults_between(const Found& one, const Found& other) {
  if (one.lower <= other.upper && other.lower <= one.upper) return {};
  return {fmt::format("they exclude each other: {} and {}", one.name(), other.name())};
}

}  // namespace

Verdict judge(scene::Scene<2> scene, const scene::Mesh<2>& mesh) {
  scene.refine = {.strategy = scene::Strategy::uniform, .max_levels = 3};
  Verdict verdict;
  std::vector<Found> found;
  for (const int degree : {1, 2}) {
    scene.solve.degree = degree;
    const Ended ended = solved(scene, mesh);
    verdict.status = ended.status;
    verdict.reason = ended.reason;
    for (const std::string& fault : faults_of_ending(degree, ended)) verdict.faults.push_back(fault);
    found.insert(found.end(), ended.found.begin(), ended.found.end());
  }
  for (const Found& one : found) {
    if (!(one.lower <= one.upper) || !std::isfinite(one.lower) || !std::isfinite(one.upper))
      verdict.faults.push_back("no interval: " + one.name());
    for (const Found& other : found)
      if (&one != &other)
        for (const std::string& fault : faults_between(one, other)) verdict.faults.push_back(fault);
  }
  return verdict;
}

}  // namespace bracket::tests
