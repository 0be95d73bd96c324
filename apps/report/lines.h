// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

/// Text as terminals show it.
namespace bracket::apps {

inline constexpr std::size_t terminal_columns = 80;

/// How many columns a text in UTF-8 takes, each character one.
std::size_t columns_of(const std::string& text);

/// The text with blanks behind it, so that it takes `columns` at least.
std::string padded(const std::string& text, std::size_t columns);

/// A text of whole lines in which those that are longer than a terminal go on below, at blanks, two columns further in
/// than they begin. A word that is longer stays whole, for paths are copied.
std::string within_columns(const std::string& text);

}  // namespace bracket::apps
