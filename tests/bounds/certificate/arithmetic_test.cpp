// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/certificate/arithmetic.h"

#include <gtest/gtest.h>

#include <cfenv>
#include <thread>

#include "dual/dual.h"
#include "primal/primal.h"
#include "scene/parallel.h"
#include "tests/bounds/certificate/exact_scenes.h"

#if defined(__x86_64__)
#include <xmmintrin.h>
#endif

namespace bracket::bounds {
namespace {

TEST(Arithmetic, is_as_enclosures_need_it) { EXPECT_EQ(arithmetic_fault(), ""); }

TEST(Arithmetic, of_another_rounding_mode_is_refused) {
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    std::fesetround(mode);
    const std::string fault = arithmetic_fault();
    std::fesetround(FE_TONEAREST);
    EXPECT_NE(fault.find("nearest"), std::string::npos) << mode;
  }
}

#if defined(__x86_64__)
TEST(Arithmetic, that_flushes_denormals_is_refused) {
  const unsigned before = _mm_getcsr();
  for (const unsigned flag : {0x8000u, 0x0040u}) {  // results; operands
    _mm_setcsr(before | flag);
    const std::string fault = arithmetic_fault();
    _mm_setcsr(before);
    EXPECT_NE(fault.find("denormal"), std::string::npos) << flag;
  }
}

TEST(Arithmetic, of_shortened_extended_precision_is_refused) {
  unsigned short control = 0;
  __asm__ volatile("fnstcw %0" : "=m"(control));
  const unsigned short before = control;
  control = static_cast<unsigned short>((control & ~0x0300) | 0x0200);  // 53 bits
  __asm__ volatile("fldcw %0" : : "m"(control));
  const std::string fault = arithmetic_fault();
  __asm__ volatile("fldcw %0" : : "m"(before));
  EXPECT_NE(fault, "");
}

// New threads inherit what their maker has set.
TEST(Arithmetic, is_checked_by_the_certificate) {
  const auto [problem, energy] = tests::exact_patch(1, 0.25, 0.5, 2);
  const auto u = primal::solve(problem, 2).displacement;
  const auto stress = dual::solve(problem, 1).stress;
  ASSERT_TRUE(certify(problem, u, stress).valid);
  const unsigned before = _mm_getcsr();
  _mm_setcsr(before | 0x8040u);
  const Certificate certificate = certify(problem, u, stress);
  _mm_setcsr(before);
  EXPECT_FALSE(certificate.valid);
  EXPECT_NE(certificate.reason.find("denormal"), std::string::npos) << certificate.reason;
}

// A pool of threads keeps what whoever made it had set, although it has been set right since.
TEST(Arithmetic, of_a_pool_is_checked_by_the_certificate) {
  const auto [problem, energy] = tests::exact_patch(1, 0.25, 0.5, 24);
  const auto u = primal::solve(problem, 2).displacement;
  const auto stress = dual::solve(problem, 1).stress;
  ASSERT_GT(scene::n_chunks(static_cast<int>(problem.mesh.cells.size())), 1);
  Certificate certificate;
  std::thread([&] {
    const unsigned before = _mm_getcsr();
    _mm_setcsr(before | 0x8040u);
    scene::for_each_index(10000, [](int) {});
    _mm_setcsr(before);
    certificate = certify(problem, u, stress);
  }).join();
  EXPECT_FALSE(certificate.valid);
  EXPECT_NE(certificate.reason.find("denormal"), std::string::npos) << certificate.reason;
}
#endif

}  // namespace
}  // namespace bracket::bounds
