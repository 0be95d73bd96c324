// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "apps/report/drawing.h"

namespace bracket::apps {

/// What gnuplot shall draw.
struct Picture {
  std::string name;     ///< of the file, without its ending
  std::string caption;  ///< a sentence or two below it
  int width, height;    ///< pixels
  std::string script;   ///< commands for gnuplot, without a terminal
  bool wide = false;    ///< best over the whole width of a page
};

struct Drawings {
  std::vector<Drawing> drawn;
  std::vector<std::string> missing;  ///< what could not be drawn, and why, one line each
};

/// Draws pictures by gnuplot, side by side. Pictures are bounded in size, and the tests hold those of a run to 5 s: the
/// limit, after which gnuplot is killed, leaves a busy machine twelve times as long.
Drawings draw(const std::vector<Picture>& pictures, bool png, std::chrono::seconds limit = std::chrono::seconds(60));

/// A name as a string of gnuplot, in quotes; it is drawn as it is where "noenhanced" follows.
std::string quoted(const std::string& text);

}  // namespace bracket::apps
