// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdio>
#include <string>

namespace bracket::apps {

/// Says something on standard error; where that is closed or full nobody hears it, and nothing else happens.
inline void say(const std::string& text) { std::fputs(text.c_str(), stderr); }

/// A line that does not change how the command ends.
inline void say_note(const std::string& line) { say("note: " + line + "\n"); }

}  // namespace bracket::apps
