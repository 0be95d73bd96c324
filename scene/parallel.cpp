// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/parallel.h"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace bracket::scene {

int n_chunks(int n, int size) { return (n + size - 1) / size; }

void in_chunks(int n, const std::function<void(int, int, int)>& work, int size) {
  tbb::parallel_for(0, n_chunks(n, size),
                    [&](int chunk) { work(chunk, chunk * size, std::min(n, (chunk + 1) * size)); });
}

}  // namespace bracket::scene
