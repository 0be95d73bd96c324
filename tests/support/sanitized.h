// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace bracket::tests {

/// Whether the sanitizers look at addresses, under which all takes ten times as long. What is long then goes the same
/// ways in fewer, smaller or coarser scenes; Release has all.
#ifdef __SANITIZE_ADDRESS__
constexpr bool sanitized = true;
#else
constexpr bool sanitized = false;
#endif

}  // namespace bracket::tests
