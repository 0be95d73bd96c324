// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <type_traits>

/// Vectors as wide as the machine has them, which is found out when the program runs: it is built for any of its kind.
/// What is computed does not depend on how wide they are.
namespace bracket::dual {

/// Some doubles that are worked on at once.
template <int lanes> struct Lanes {
  typedef double Type __attribute__((vector_size(8 * lanes)));
  struct [[gnu::packed, gnu::may_alias]] InMemory {  // wherever a double may be
    Type value;
  };
};
template <int lanes> [[gnu::always_inline]] inline void load(typename Lanes<lanes>::Type& to, const double* first) {
  to = reinterpret_cast<const typename Lanes<lanes>::InMemory*>(first)->value;
}
template <int lanes> [[gnu::always_inline]] inline void store(double* first, const typename Lanes<lanes>::Type& from) {
  reinterpret_cast<typename Lanes<lanes>::InMemory*>(first)->value = from;
}

#ifdef __x86_64__
/// All that `work` calls is compiled once more into this.
template <class Work> [[gnu::target("avx2"), gnu::flatten]] auto with_avx2(const Work& work) {
  return work(std::integral_constant<int, 4>());
}
#endif

/// work(lanes), a constant, how many doubles the machine's vectors hold.
template <class Work> auto in_lanes(const Work& work) {
#ifdef __x86_64__
  static const bool has_avx2 = __builtin_cpu_supports("avx2");
  if (has_avx2) return with_avx2(work);
#endif
  return work(std::integral_constant<int, 2>());
}

}  // namespace bracket::dual

// Loops of a few steps over variables that are to be kept in registers, and one that would need too many.
#ifdef __clang__
#define BRACKET_UNROLL _Pragma("unroll")
#define BRACKET_KEEP_ROLLED _Pragma("nounroll")
#else
#define BRACKET_UNROLL _Pragma("GCC unroll 16")
#define BRACKET_KEEP_ROLLED _Pragma("GCC unroll 1")
#endif
