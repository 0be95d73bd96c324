// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/parallel.h"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace bracket::scene {

namespace {

constexpr int chunk_size = 512;  // cells: some milliseconds of work, against some microseconds to hand it out

}  // namespace

int n_chunks(int n) { return (n + chunk_size - 1) / chunk_size; }

void in_chunks(int n, const std::function<void(int, int, int)>& work) {
  tbb::parallel_for(0, n_chunks(n),
                    [&](int chunk) { work(chunk, chunk * chunk_size, std::min(n, (chunk + 1) * chunk_size)); });
}

}  // namespace bracket::scene
