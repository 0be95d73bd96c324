// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/report/sha256.h"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cstdint>

namespace bracket::apps {
namespace {

using Word = std::uint32_t;

constexpr std::size_t block_bytes = 64;

/// The first 32 bits of the fractional part of the root of n, of degree 2 or 3: floor(2³² root) mod 2³², found bit by
/// bit in whole numbers. \pre n < 512
constexpr Word fraction_of_root(unsigned n, int degree) {
  std::uint64_t root = 0;  // root^degree ≤ n 2^(32 degree)
  for (int bit = 36; bit >= 0; --bit) {
    const std::uint64_t tried = root | std::uint64_t{1} << bit;
    using Wide = unsigned __int128;
    const Wide square = Wide{tried} * tried;
    // For the third degree both sides are divided by 2^64, of which the right one is a multiple: tried³ ≤ n 2^96.
    const bool fits = degree == 2 ? square <= Wide{n} << 64 : tried < (Wide{n} << 96) / square + 1;
    if (fits) root = tried;
  }
  return static_cast<Word>(root);
}

constexpr std::array<unsigned, 64> primes() {
  std::array<unsigned, 64> found{};
  std::size_t n = 0;
  for (unsigned candidate = 2; n < found.size(); ++candidate) {
    bool prime = true;
    for (std::size_t i = 0; i < n; ++i) prime = prime && candidate % found[i] != 0;
    if (prime) found[n++] = candidate;
  }
  return found;
}

constexpr std::array<Word, 64> round_constants = [] {
  std::array<Word, 64> constants{};
  for (std::size_t i = 0; i < constants.size(); ++i) constants[i] = fraction_of_root(primes()[i], 3);
  return constants;
}();

using State = std::array<Word, 8>;

constexpr State first_state = [] {
  State state{};
  for (std::size_t i = 0; i < state.size(); ++i) state[i] = fraction_of_root(primes()[i], 2);
  return state;
}();

State after_block(const State& state, std::string_view block) {
  std::array<Word, 64> w{};
  for (std::size_t i = 0; i < block_bytes; ++i) w[i / 4] = w[i / 4] << 8 | static_cast<unsigned char>(block[i]);
  for (std::size_t t = 16; t < w.size(); ++t) {
    const Word a = w[t - 15], b = w[t - 2];
    w[t] = w[t - 16] + (std::rotr(a, 7) ^ std::rotr(a, 18) ^ a >> 3) + w[t - 7] +
           (std::rotr(b, 17) ^ std::rotr(b, 19) ^ b >> 10);
  }
  auto [a, b, c, d, e, f, g, h] = state;
  for (std::size_t t = 0; t < w.size(); ++t) {
    const Word one =
        h + (std::rotr(e, 6) ^ std::rotr(e, 11) ^ std::rotr(e, 25)) + ((e & f) ^ (~e & g)) + round_constants[t] + w[t];
    const Word two = (std::rotr(a, 2) ^ std::rotr(a, 13) ^ std::rotr(a, 22)) + ((a & b) ^ (a & c) ^ (b & c));
    h = g, g = f, f = e, e = d + one, d = c, c = b, b = a, a = one + two;
  }
  return {state[0] + a, state[1] + b, state[2] + c, state[3] + d,
          state[4] + e, state[5] + f, state[6] + g, state[7] + h};
}

}  // namespace

std::string sha256(std::string_view bytes) {
  State state = first_state;
  const std::uint64_t bits = 8 * static_cast<std::uint64_t>(bytes.size());
  for (; bytes.size() >= block_bytes; bytes.remove_prefix(block_bytes))
    state = after_block(state, bytes.substr(0, block_bytes));
  // What is left, a bit 1, zeros, and the number of bits in the last eight bytes.
  std::string end(bytes);
  end += '\x80';
  end.append((2 * block_bytes - end.size() - 8) % block_bytes, '\0');
  for (int shift = 56; shift >= 0; shift -= 8) end += static_cast<char>(bits >> shift & 0xff);
  for (std::size_t at = 0; at < end.size(); at += block_bytes)
    state = after_block(state, std::string_view(end).substr(at, block_bytes));
  std::string digits;
  for (const Word word : state) digits += fmt::format("{:08x}", word);
  return digits;
}

}  // namespace bracket::apps
