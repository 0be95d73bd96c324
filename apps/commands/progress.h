// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>
#include <unistd.h>

#include <string>

#include "apps/commands/say.h"

namespace bracket::apps {

/// A line on standard error, where that is a terminal, that tells what is being done; it is gone when the work ends.
class Progress {
 public:
  explicit Progress(bool wanted = true) : wanted_(wanted && isatty(STDERR_FILENO)) {}
  ~Progress() { clear(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void show(const std::string& stage) const {
    if (wanted_) say(fmt::format("{}{} …", clear_line, stage));
  }

  /// Makes room for something else, which ends with its line; the next stage is shown below that.
  void clear() const {
    if (wanted_) say(clear_line);
  }

 private:
  static constexpr const char* clear_line = "\r\033[K";
  bool wanted_;
};

}  // namespace bracket::apps
