// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/certificate/arithmetic.h"

#include <limits>

#include "scene/enclosure.h"

namespace bracket::bounds {

namespace {

/// Volatile numbers, so that the processor computes and not the compiler.
template <class Float> bool rounds_to_nearest() {
  constexpr Float epsilon = std::numeric_limits<Float>::epsilon();
  volatile Float one = 1, above = epsilon * 5 / 8, below = epsilon * 3 / 8;
  const Float up = one + above, stays = one + below, minus_up = -one - above, minus_stays = -one - below;
  return up == 1 + epsilon && stays == 1 && minus_up == -1 - epsilon && minus_stays == -1;
}

template <class Float> bool keeps_denormals() {
  volatile Float least = std::numeric_limits<Float>::min();
  volatile Float half = least / 2;  // flushed to zero where results are
  const Float again = half * 2;     // zero where operands are
  return half != 0 && again == std::numeric_limits<Float>::min();
}

/// (1 + u)² − (1 + 2u) is u² exactly and 0 where the square is rounded first.
template <class Float> bool contracts() {
  volatile Float u = std::sqrt(std::numeric_limits<Float>::epsilon()) / 2;
  const Float a = 1 + u, c = -(1 + 2 * u);
  return a * a + c != 0;
}

}  // namespace

std::string arithmetic_fault() {
  using scene::Real;
  if (!rounds_to_nearest<double>() || !rounds_to_nearest<Real>())
    return "the processor does not round to nearest, or not to the digits of the format: this thread's floating-point "
           "control was changed";
  if (!keeps_denormals<double>() || !keeps_denormals<Real>())
    return "the processor takes denormal numbers for zero: this thread's floating-point control was changed";
  if (contracts<double>() || contracts<Real>())
    return "products and sums are contracted: the program was not compiled as bracket::certificate asks "
           "(-ffp-contract=off)";
  return "";
}

void check_arithmetic() {
  if (const std::string fault = arithmetic_fault(); !fault.empty()) throw ArithmeticFault(fault);
}

}  // namespace bracket::bounds
