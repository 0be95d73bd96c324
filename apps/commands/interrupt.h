// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <signal.h>

namespace bracket::apps {

/// While it lives, the first Ctrl-C (SIGINT) is noted and answered by a line on standard error; a second one ends the
/// program at once. Where SIGINT is ignored already (as in a shell's background jobs) it stays ignored.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  bool requested() const;

 private:
  struct sigaction before_;
};

}  // namespace bracket::apps
