// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Some texts break assertions of toml++ 3.3 that its parser does without: it refuses these texts all the same. Debian's
// library has none; where the parser is compiled here, it has none either.
#define TOML_ASSERT(condition) static_assert(true)
#include <toml++/toml.h>

#include <string>

namespace bracket::scene {

/// A text as TOML. \param name of the file, for messages
/// \throw toml::parse_error
toml::table parse_toml(const std::string& text, const std::string& name);

}  // namespace bracket::scene
