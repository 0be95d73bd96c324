// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <cstdlib>

#include "bounds/bounds.h"
#include "tests/support/scenes.h"

/// The main job, both formulations and the estimate, on the two blocks of docs/theory.md §9.2 with n × n cells each,
/// beside the same with the contact pair glued by hand into one body: what contact costs is their ratio. And the start
/// of the program, which is most of what a small scene takes.
/// bracket_benchmarks --benchmark_repetitions=3 --benchmark_enable_random_interleaving=true
namespace bracket {
namespace {

scene::Scene<2> glued(int n) {
  scene::Scene<2> s;
  s.blocks = {tests::block("both", 0, 1, 0, 2, n, 2 * n)};
  s.bodies = {{"both", scene::isotropic<2>(1, 0.3, scene::Plane::strain)}};
  s.boundary = {
      {"both.bottom", tests::fixed(0, 0)},
      {"both.top", tests::traction(tests::constant(0), [](const auto& x) { return x[0] < 0.5 ? -0.1 : 0.09; })}};
  return s;
}

void report(benchmark::State& state, const bounds::Level& level) {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  state.counters["cells"] = level.cells;
  state.counters["unknowns"] = level.primal.unknowns;
  state.counters["primal_s"] = level.seconds.primal;
  state.counters["dual_s"] = level.seconds.dual;
  state.counters["estimate_s"] = level.seconds.estimate;
  state.counters["certify_s"] = level.seconds.certify;
  state.counters["peak_GB"] = static_cast<double>(usage.ru_maxrss) / (1024 * 1024);
}

void run(benchmark::State& state, const scene::Scene<2>& scene) {
  bounds::Level level;
  for (auto _ : state) level = bounds::run(scene).levels.back();
  report(state, level);
}

void contact(benchmark::State& state) { run(state, tests::two_blocks(static_cast<int>(state.range(0)))); }
void glued_by_hand(benchmark::State& state) { run(state, glued(static_cast<int>(state.range(0)))); }

void start_up(benchmark::State& state) {
  for (auto _ : state)
    if (std::system(BRACKET_PROGRAM " --version > /dev/null") != 0) state.SkipWithError("the program failed");
}

BENCHMARK(start_up)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(contact)->Arg(45)->Arg(90)->Arg(180)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(glued_by_hand)->Arg(45)->Arg(90)->Arg(180)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace bracket
