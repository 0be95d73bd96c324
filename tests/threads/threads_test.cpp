// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <future>
#include <thread>

#include "bounds/bounds.h"
#include "tests/support/scenes.h"

/// All threads of a run, for the thread sanitizer to watch: those of the certificate, those of the driver and its
/// observers, several runs at once.
namespace bracket::bounds {
namespace {

scene::Scene<2> refined_patch(int degree) {
  auto scene = tests::patch(3, 0.3, 0.01, 6);
  scene.solve.degree = degree;
  scene.refine = {.strategy = scene::Strategy::uniform, .max_levels = 3};
  return scene;
}

void expect_exact(const Outcome<2>& outcome) {
  EXPECT_EQ(outcome.guarantee, "rounding-safe") << outcome.reason;
  const double exact = 0.5 * 3 / (1 - 0.3 * 0.3) * 0.01 * 0.01;  // ½ E' e² by the area 1
  EXPECT_LE(outcome.lower, exact * (1 + 1e-15));
  EXPECT_GE(outcome.upper, exact * (1 - 1e-15));
  EXPECT_LE(outcome.upper - outcome.lower, 1e-10 * exact);
}

TEST(Threads, OfOneRun) {
  for (const int degree : {1, 2}) {
    const auto outcome = run(refined_patch(degree));
    expect_exact(outcome);
    EXPECT_EQ(outcome.levels.size(), 3u);
  }
}

TEST(Threads, OfRunsSideBySide) {
  std::vector<std::future<Outcome<2>>> runs;
  for (const int degree : {1, 2, 2})
    runs.push_back(std::async(std::launch::async, [degree] { return run(refined_patch(degree)); }));
  for (auto& one : runs) expect_exact(one.get());
}

TEST(Threads, OfCertificatesSideBySide) {
  const auto outcome = run(refined_patch(2));
  const auto certificate = [&] { return certify(outcome.problem, outcome.displacement, outcome.stress); };
  auto other = std::async(std::launch::async, certificate);
  const Certificate one = certificate(), two = other.get();
  EXPECT_TRUE(one.valid);
  EXPECT_EQ(one.lower, two.lower);
  EXPECT_EQ(one.upper, two.upper);
}

TEST(Threads, WhoStopsARunMayBeAnother) {
  std::stop_source stop;
  std::promise<void> first_level;
  Observer<2> observer;
  int levels = 0;
  observer.level = [&](const Outcome<2>&) {
    if (++levels == 1) first_level.set_value();
  };
  observer.stop = stop.get_token();
  std::jthread other([&] {
    first_level.get_future().wait();
    stop.request_stop();
  });
  const auto outcome = run(refined_patch(2), observer);
  expect_exact(outcome);
  EXPECT_GE(outcome.levels.size(), 1u);
  EXPECT_EQ(outcome.levels.size(), static_cast<std::size_t>(levels));
}

}  // namespace
}  // namespace bracket::bounds
