// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/mman.h>

#include <cstddef>
#include <cstdint>

namespace bracket::contact {

/// Asks for pages of 2 MB for memory that was allocated and not yet written: large arrays are then not paid for page by
/// page of 4 KB, when they are first touched and, by what the processor has to look up, ever after. Where the system
/// has none to give nothing changes. Without effect on what is smaller.
template <class Number> void use_large_pages(Number* values, std::size_t count) {
  constexpr std::uintptr_t page = std::uintptr_t{2} << 20;
  const auto begin = reinterpret_cast<std::uintptr_t>(values), end = begin + count * sizeof(Number);
  const std::uintptr_t from = (begin + page - 1) / page * page, to = end / page * page;
  if (from < to) madvise(reinterpret_cast<void*>(from), to - from, MADV_HUGEPAGE);
}

}  // namespace bracket::contact
