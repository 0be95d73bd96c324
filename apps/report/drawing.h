// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace bracket::apps {

/// A picture that has been drawn.
struct Drawing {
  std::string name;     ///< of the file, without its ending
  std::string caption;  ///< a sentence or two below it
  std::string svg;
  std::string png;  ///< empty unless asked for
  bool wide;        ///< best over the whole width of a page
};

}  // namespace bracket::apps
