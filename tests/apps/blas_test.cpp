// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/commands/blas.h"

#include <dlfcn.h>

#include <Eigen/Dense>
#include <cstdlib>

#include "contact/contact.h"
#include "tests/apps/command.h"

namespace bracket::apps::tests {
namespace {

constexpr const char* setting = "OPENBLAS_CORETYPE";

template <class Function> Function* loaded(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_DEFAULT, name));
}

/// Lets OpenBLAS choose its kernels once more. \param as those that it is to take; null: what it finds by itself
void choose(const char* as) {
  if (as) setenv(setting, as, 1);
  loaded<void()>("gotoblas_dynamic_quit")();
  loaded<void()>("gotoblas_dynamic_init")();
  unsetenv(setting);
}

/// A·B by BLAS.
Eigen::MatrixXd product(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  using Multiply = void(const char*, const char*, const int*, const int*, const int*, const double*, const double*,
                        const int*, const double*, const int*, const double*, double*, const int*);
  const int m = static_cast<int>(a.rows()), n = static_cast<int>(b.cols()), k = static_cast<int>(a.cols());
  const double one = 1, zero = 0;
  Eigen::MatrixXd result(m, n);
  loaded<Multiply>("dgemm_")("N", "N", &m, &n, &k, &one, a.data(), &m, b.data(), &k, &zero, result.data(), &m);
  return result;
}

/// OpenBLAS as on a processor that it does not know.
class Blas : public Command {
 protected:
  void SetUp() override {
    if (contact::BlasThreads::now() == 0) GTEST_SKIP() << "BLAS is not OpenBLAS";
    if (!loaded<void()>("gotoblas_dynamic_init")) GTEST_SKIP() << "it has no kernels to choose from";
    if (std::getenv(setting)) GTEST_SKIP() << "they are chosen";
#ifdef __x86_64__
    if (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma")) GTEST_SKIP() << "these are slow anyway";
    choose("Prescott");
    changed_ = true;
#else
    GTEST_SKIP() << "its kernels have other names";
#endif
  }
  void TearDown() override {
    if (changed_) choose(nullptr);
  }

 private:
  bool changed_ = false;
};

// Products of integers are exact, in whatever order they are summed.
TEST_F(Blas, IsGivenTheKernelsOfAProcessorThatItDoesNotKnow) {
  EXPECT_NE(blas_text().find("Prescott (slow"), std::string::npos) << blas_text();
  EXPECT_NE(blas_shortfall(), "");
  choose_blas_kernels();
  EXPECT_EQ(blas_shortfall(), "");
  EXPECT_EQ(blas_text().find("Prescott"), std::string::npos) << blas_text();
  EXPECT_EQ(std::getenv(setting), nullptr);
  for (const int n : {1, 7, 64, 300}) {
    const auto integer = [](Eigen::Index i, Eigen::Index j) { return static_cast<double>((7 * i + 3 * j) % 11 - 5); };
    const Eigen::MatrixXd a = Eigen::MatrixXd::NullaryExpr(n, n + 3, integer);
    const Eigen::MatrixXd b = Eigen::MatrixXd::NullaryExpr(n + 3, 2 * n, integer);
    EXPECT_EQ(product(a, b), Eigen::MatrixXd(a * b));
  }
}

TEST_F(Blas, KeepsTheKernelsThatTheEnvironmentNames) {
  const Ended named = shell("OPENBLAS_CORETYPE=Prescott bracket --version");
  EXPECT_NE(named.out.find("Prescott (slow"), std::string::npos) << named.out;
  EXPECT_EQ(named.err, "");
  const Ended not_named = shell("bracket --version");
  EXPECT_EQ(not_named.out.find("slow"), std::string::npos) << not_named.out;
}

}  // namespace
}  // namespace bracket::apps::tests
