// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace bracket::apps {

/// The BLAS in use, its version and the kernels that it computes with.
std::string blas_text();

/// What the BLAS in use leaves of the processor, in one line; empty: nothing, or it is not known.
std::string blas_shortfall();

/// Where OpenBLAS does not know the processor it takes kernels that every processor can do, a third as fast: gives it
/// those that this one can do, or notes that it cannot. Not where OPENBLAS_CORETYPE says which to take.
/// \pre nothing computes with BLAS yet
void choose_blas_kernels();

}  // namespace bracket::apps
