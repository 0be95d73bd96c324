// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace bracket::apps {

/// The version of the program and those of the libraries that it runs on, the BLAS in use among them.
std::string version_text();

}  // namespace bracket::apps
