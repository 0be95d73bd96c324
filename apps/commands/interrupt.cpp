// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/commands/interrupt.h"

#include <unistd.h>

#include <string_view>

namespace bracket::apps {
namespace {

volatile sig_atomic_t noted = 0;  // a handler of signals can reach nothing else

void note(int) {
  constexpr std::string_view line = "\nbracket: stopping after this level; Ctrl-C again ends at once\n";
  noted = 1;
  [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, line.data(), line.size());
}

}  // namespace

Interrupt::Interrupt() {
  noted = 0;
  sigaction(SIGINT, nullptr, &before_);
  if (before_.sa_handler == SIG_IGN) return;
  struct sigaction once = {};
  once.sa_handler = note;
  once.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
  sigaction(SIGINT, &once, nullptr);
}

Interrupt::~Interrupt() { sigaction(SIGINT, &before_, nullptr); }

bool Interrupt::requested() const { return noted != 0; }

}  // namespace bracket::apps
