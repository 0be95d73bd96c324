// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <dlfcn.h>
#include <gtest/gtest.h>

namespace bracket::tests {

/// Whether the address sanitizer looks at the libraries under test, under which all takes ten times as long. What is
/// long then goes the same ways in fewer, smaller or coarser scenes; Release has all. Asked of the process: the same
/// programs are run on either libraries.
inline const bool sanitized = dlsym(RTLD_DEFAULT, "__asan_init") != nullptr;

/// What is long and shows no other code is left to the libraries without sanitizers.
class Long : public testing::Test {
 protected:
  void SetUp() override {
    if (sanitized) GTEST_SKIP() << "long: without sanitizers only";
  }
};

}  // namespace bracket::tests
