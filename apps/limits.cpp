// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <climits>
#include <cstdlib>
#include <string_view>

// Where the address space is limited (ulimit -v, -d) the libraries must not start threads: OpenBLAS does so when it is
// loaded, and each of its threads tries for ever to get 128 MB; OpenMP ends the program where it gets no thread. Both
// can be told by the environment alone, before they are initialised.

namespace {

constexpr std::array<std::string_view, 2> settings = {"OPENBLAS_NUM_THREADS=1", "OMP_THREAD_LIMIT=1"};

bool is_limited(decltype(RLIMIT_AS) resource) {
  rlimit limit;
  return getrlimit(resource, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY;
}

bool is_setting(std::string_view entry) { return std::ranges::find(settings, entry) != settings.end(); }

/// Whether it gives one of the settings another value.
bool is_other_value(std::string_view entry) {
  return std::ranges::any_of(settings, [&](std::string_view setting) {
    return entry != setting && entry.starts_with(setting.substr(0, setting.find('=') + 1));
  });
}

/// Starts the program anew, in its place, with `settings` in its own environment. Runs before any library is
/// initialised, that of C++ included.
void start_without_threads(int, char** arguments, char** environment) {
  if (!is_limited(RLIMIT_AS) && !is_limited(RLIMIT_DATA)) return;
  std::size_t given = 0, set = 0;
  for (; environment[given] != nullptr; ++given)
    if (is_setting(environment[given])) ++set;
  if (set >= settings.size()) return;  // done
  char program[PATH_MAX];
  const ssize_t length = readlink("/proc/self/exe", program, sizeof program - 1);
  auto** const changed = static_cast<char**>(std::calloc(given + settings.size() + 1, sizeof(char*)));
  if (length < 0 || changed == nullptr) return;
  program[length] = '\0';
  std::size_t n = 0;
  for (const std::string_view setting : settings) changed[n++] = const_cast<char*>(setting.data());
  for (std::size_t i = 0; i < given; ++i)
    if (!is_setting(environment[i]) && !is_other_value(environment[i])) changed[n++] = environment[i];
  execve(program, arguments, changed);
  std::free(changed);  // it could not be started: go on
}

[[gnu::section(".preinit_array"), gnu::used]] void (*const before_libraries)(int, char**,
                                                                             char**) = start_without_threads;

}  // namespace
