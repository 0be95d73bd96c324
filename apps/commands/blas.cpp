// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/commands/blas.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string_view>
#include <vector>

#include "apps/commands/say.h"

namespace bracket::apps {
namespace {

// Which BLAS serves is settled when the program is loaded, by the machine's alternatives; so the loaded one is asked.
template <class Function> Function* loaded(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_DEFAULT, name));
}

/// The kernels in use, as OPENBLAS_CORETYPE names them; empty: not OpenBLAS.
std::string kernels() {
  const auto name = loaded<char*()>("openblas_get_corename");
  return name ? name() : "";
}

/// Those of OpenBLAS that the processor can do, the fastest first, as far as they have AVX2 at least.
std::vector<const char*> possible_kernels() {
  std::vector<const char*> result;
#ifdef __x86_64__
  const bool avx512 = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512cd") &&
                      __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512dq") &&
                      __builtin_cpu_supports("avx512vl");
  if (avx512) result.push_back("SkylakeX");
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) result.push_back("Haswell");
#endif
  return result;
}

bool are_slow(std::string_view kernels) {
  constexpr std::array<std::string_view, 6> with_avx2 = {"Excavator", "Haswell",    "Zen",
                                                         "SkylakeX",  "Cooperlake", "SapphireRapids"};
  return !kernels.empty() && !possible_kernels().empty() && std::ranges::find(with_avx2, kernels) == with_avx2.end();
}

constexpr const char* setting = "OPENBLAS_CORETYPE";

}  // namespace

std::string blas_text() {
  const auto config = loaded<const char*()>("openblas_get_config");
  if (!config) return "not OpenBLAS (slow: install libopenblas0-pthread)";
  const std::string shortfall = blas_shortfall();
  return fmt::format("{}, kernels for {}{}", config(), kernels(), shortfall.empty() ? "" : " (" + shortfall + ")");
}

std::string blas_shortfall() {
  if (!are_slow(kernels())) return "";
  return fmt::format("slow: the processor can do those for {0}; set {1}={0}", possible_kernels().front(), setting);
}

void choose_blas_kernels() {
  // OpenBLAS's own way of choosing, once more.
  const auto forget = loaded<void()>("gotoblas_dynamic_quit"), choose = loaded<void()>("gotoblas_dynamic_init");
  if (std::getenv(setting) || !are_slow(kernels())) return;
  for (const char* name : possible_kernels()) {
    if (!forget || !choose) break;
    setenv(setting, name, 1);
    forget();
    choose();
    unsetenv(setting);
    if (kernels() == name) return;  // else this OpenBLAS is built without them
  }
  say_note("BLAS is " + blas_shortfall());
}

}  // namespace bracket::apps
