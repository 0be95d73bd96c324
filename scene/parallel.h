// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

/// Loops over cells on all cores. The chunks do not depend on the number of threads, and so nothing that is computed
/// from them does.
namespace bracket::scene {

/// Cells that are worth to be handed out together: some milliseconds of work, against some microseconds.
inline constexpr int chunk_size = 512;

/// [0, n) is cut in so many chunks, all but the last of one size.
int n_chunks(int n, int size = chunk_size);

/// Does work(chunk, begin, end) for each chunk [begin, end) of [0, n), in any order, some at the same time.
/// \throw what `work` throws
void in_chunks(int n, const std::function<void(int chunk, int begin, int end)>& work, int size = chunk_size);

/// What of(begin, end) gives for each chunk, in their order.
template <class Result, class Of> std::vector<Result> of_chunks(int n, const Of& of) {
  std::vector<Result> results(n_chunks(n));
  in_chunks(n, [&](int chunk, int begin, int end) { results[chunk] = of(begin, end); });
  return results;
}

/// Does work(i) for each i of [0, n), likewise.
template <class Work> void for_each_index(int n, const Work& work, int size = chunk_size) {
  in_chunks(
      n,
      [&](int, int begin, int end) {
        for (int i = begin; i < end; ++i) work(i);
      },
      size);
}

}  // namespace bracket::scene
