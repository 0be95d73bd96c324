// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <vector>

#include "dual/local/small_blocks.h"

namespace bracket::dual {

/// A small symmetric positive definite matrix of dense blocks, many of them zero, and its Cholesky factor: minimum
/// degree ordering, no more than a few dozen rows of blocks.
template <class Block> class BlockCholesky {
 public:
  using Vector = Eigen::Matrix<double, Block::RowsAtCompileTime, 1>;

  explicit BlockCholesky(int size = 0)
      : size_(size), neighbours_(size), place_(static_cast<std::size_t>(size) * size, -1) {}
  int size() const { return size_; }

  /// Two rows that are to have an entry in common.
  void connect(int i, int j) {
    if (i == j || place_[at(i, j)] >= 0) return;
    neighbours_[i].push_back(j);
    neighbours_[j].push_back(i);
    place_[at(i, j)] = place_[at(j, i)] = 0;
  }
  /// Lays out the factor, after all are connected. \param last which row is eliminated last
  void order(int last) {
    std::vector<char> done(size_, 0);
    std::vector<std::vector<int>> graph = std::move(neighbours_);
    for (int step = 0; step < size_; ++step) {
      int best = -1;
      for (int i = 0; i < size_; ++i)
        if (!done[i] && (i != last || step == size_ - 1) && (best < 0 || graph[i].size() < graph[best].size()))
          best = i;
      done[best] = 1;
      sequence_.push_back(best);
      for (const int i : graph[best]) {
        std::erase(graph[i], best);
        for (const int j : graph[best])
          if (j != i && std::find(graph[i].begin(), graph[i].end(), j) == graph[i].end()) graph[i].push_back(j);
      }
      below_.push_back(std::move(graph[best]));
    }
    std::fill(place_.begin(), place_.end(), -1);
    int blocks = 0;
    for (int step = 0; step < size_; ++step) {
      place_[at(sequence_[step], sequence_[step])] = blocks++;
      for (const int j : below_[step]) place_[at(j, sequence_[step])] = blocks++;
    }
    block_.assign(blocks, Block::Zero());
  }
  int last() const { return sequence_.back(); }
  /// Adds to the entry in row i and column j, and its transpose to that in row j and column i.
  void add(int i, int j, const Block& block) {
    if (place_[at(i, j)] >= 0)
      block_[place_[at(i, j)]] += block;
    else
      block_[place_[at(j, i)]] += block.transpose();
  }
  Block& diagonal(int i) { return block_[place_[at(i, i)]]; }

  /// \return whether it is definite
  template <int lanes> bool factorise() {
    for (int step = 0; step < size_; ++step) {
      const int p = sequence_[step];
      if (!dual::factorise(diagonal(p))) return false;
      const std::vector<int>& below = below_[step];
      for (const int i : below) divide<lanes>(block_[place_[at(i, p)]], diagonal(p));
      for (std::size_t k = 0; k < below.size(); ++k) {
        const Block& left = block_[place_[at(below[k], p)]];
        subtract_square<lanes>(diagonal(below[k]), left);
        for (std::size_t l = 0; l < k; ++l) {
          const Block& right = block_[place_[at(below[l], p)]];
          const int to = place_[at(below[k], below[l])];
          const bool lower = to >= 0;
          subtract_product<lanes>(block_[lower ? to : place_[at(below[l], below[k])]], lower ? left : right,
                                  lower ? right : left);
        }
      }
    }
    return true;
  }
  /// \pre factorise() returned true
  void solve(std::vector<Vector>& b) const {
    for (int step = 0; step < size_; ++step) {
      const int p = sequence_[step];
      solve_lower(block_[place_[at(p, p)]], b[p]);
      for (const int i : below_[step]) b[i] -= times(block_[place_[at(i, p)]], b[p]);
    }
    for (int step = size_; step-- > 0;) {
      const int p = sequence_[step];
      for (const int i : below_[step]) b[p] -= transposed_times(block_[place_[at(i, p)]], b[i]);
      solve_upper(block_[place_[at(p, p)]], b[p]);
    }
  }

 private:
  std::size_t at(int i, int j) const { return static_cast<std::size_t>(i) * size_ + j; }

  int size_;
  std::vector<std::vector<int>> neighbours_, below_;  ///< of rows, until order(); of steps, what is eliminated later
  std::vector<int> sequence_;
  std::vector<int> place_;  ///< of each pair in `block_`, one of the two orders; −1: none
  std::vector<Block> block_;
};

}  // namespace bracket::dual
