// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/commands/version.h"

#include <bracket/version.h>
#include <dlfcn.h>
#include <fmt/format.h>
#include <suitesparse/cholmod.h>

#include <Eigen/Core>

namespace bracket::apps {
namespace {

// Which BLAS serves is settled when the program is loaded, by the machine's alternatives; so the loaded one is asked.
std::string blas() {
  using Config = const char*();
  if (void* config = dlsym(RTLD_DEFAULT, "openblas_get_config")) return reinterpret_cast<Config*>(config)();
  return "not OpenBLAS (slow: install libopenblas0-pthread)";
}

}  // namespace

std::string version_text() {
  return fmt::format(
      "bracket {}\n"
      "deal.II {}, Eigen {}.{}.{}, CHOLMOD {}.{}.{}\n"
      "BLAS: {}\n",
      BRACKET_VERSION_STRING, DEAL_II_VERSION, EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION,
      CHOLMOD_MAIN_VERSION, CHOLMOD_SUB_VERSION, CHOLMOD_SUBSUB_VERSION, blas());
}

}  // namespace bracket::apps
