// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/parallel.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace bracket::scene {
namespace {

TEST(Parallel, ChunksCoverEachIndexOnceInOrder) {
  for (const int n : {0, 1, 511, 512, 513, 100000}) {
    std::vector<int> next = {0};
    for (const auto& [begin, end] : of_chunks<std::array<int, 2>>(n, [](int begin, int end) {
           return std::array<int, 2>{begin, end};
         })) {
      EXPECT_EQ(begin, next.back());
      EXPECT_LT(begin, end);
      next.push_back(end);
    }
    EXPECT_EQ(next.back(), n);
    std::vector<int> visits(n, 0);
    for_each_index(n, [&](int i) { ++visits[i]; });
    EXPECT_EQ(visits, std::vector<int>(n, 1));
  }
}

TEST(Parallel, WhatIsThrownInAChunkArrives) {
  EXPECT_THROW(for_each_index(10000,
                              [](int i) {
                                if (i == 9000) throw std::out_of_range("9000");
                              }),
               std::out_of_range);
}

}  // namespace
}  // namespace bracket::scene
