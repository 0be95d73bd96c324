// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

/// What the block element of degree 2 or 3 has beside the nine linear fields (docs/theory.md §4): stresses without
/// divergence on the three parts of the triangle (0,0), (1,0), (0,1), with continuous tractions inside. By the Piola
/// map τ = B τ̂ Bᵀ / det B they are those of any cell, and loads B times these.
namespace bracket::scene {

/// Bernstein coefficients as in Stress::cell, three components each: integers, which hold them exactly.
using BlockField = std::vector<int>;

struct BlockFields {
  /// The fields of loads are to be divided by it.
  int load_divisor;
  /// [k − 2][e][c]: on side e, per unit of its parameter t from vertex e + 1 to e + 2, the traction P_k(2t − 1) along
  /// axis c, P_k Legendre's polynomial; on the other sides none. k goes from 2 to the degree.
  std::vector<std::array<std::array<BlockField, 2>, 3>> load;
  /// A basis of all without tractions: 3 or 9.
  std::vector<BlockField> bubbles;
};
/// \param degree 2 or 3   \throw std::invalid_argument if it is another
const BlockFields& block_fields(int degree);

}  // namespace bracket::scene
