// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/commands/version.h"

#include <bracket/version.h>
#include <fmt/format.h>
#include <suitesparse/cholmod.h>

#include <Eigen/Core>

#include "apps/commands/blas.h"
#include "apps/report/lines.h"

namespace bracket::apps {

std::string version_text() {
  return within_columns(
      fmt::format("bracket {}\n"
                  "deal.II {}, Eigen {}.{}.{}, CHOLMOD {}.{}.{}\n"
                  "BLAS: {}\n",
                  BRACKET_VERSION_STRING, DEAL_II_VERSION, EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION,
                  EIGEN_MINOR_VERSION, CHOLMOD_MAIN_VERSION, CHOLMOD_SUB_VERSION, CHOLMOD_SUBSUB_VERSION, blas_text()));
}

}  // namespace bracket::apps
