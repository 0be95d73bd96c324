// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <new>
#include <vector>

#include "contact/large_pages.h"

namespace bracket::contact {

/// Of arrays that are much of the memory: not set to zero before they are written, and in large pages where the system
/// has them, as small ones take longer to come by than the numbers on them to compute.
template <class T> struct LargeAllocator {
  using value_type = T;

  LargeAllocator() = default;
  template <class Other> LargeAllocator(const LargeAllocator<Other>&) {}

  T* allocate(std::size_t n) {
    T* const memory = static_cast<T*>(::operator new(n * sizeof(T), alignment(n)));
    use_large_pages(memory, n);
    return memory;
  }
  void deallocate(T* memory, std::size_t n) { ::operator delete(memory, alignment(n)); }
  template <class Other> void construct(Other* at) { ::new (static_cast<void*>(at)) Other; }
  bool operator==(const LargeAllocator&) const { return true; }

 private:
  static constexpr std::align_val_t page{std::size_t{2} << 20};
  static std::align_val_t alignment(std::size_t n) {
    return n * sizeof(T) < static_cast<std::size_t>(page) ? std::align_val_t{alignof(T)} : page;
  }
};

template <class T> using LargeArray = std::vector<T, LargeAllocator<T>>;

}  // namespace bracket::contact
