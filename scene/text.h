// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "scene/scene.h"

/// What messages are made of, and files as text.
namespace bracket::scene {

/// Throws Error with the line "where: message" (or "message" if `where` is empty). Control characters, which names in
/// a scene may hold, become blanks: it stays one line.
[[noreturn]] void fail(Status status, const std::string& where, const std::string& message);

/// The name with the smallest edit distance (insert, delete, replace: 1 each) to `name`; "" if none is known.
std::string nearest(const std::string& name, std::span<const std::string> known);

/// "did you mean 'a'? Known: a, b, c", for messages about an unknown name; a long list is cut.
std::string suggestion(const std::string& name, std::span<const std::string> known);

/// "(0.5, 1)"
std::string point(const Vector<2>& x);
std::string point(const Vector<3>& x);

/// A whole file.
/// \throw Error (input) if it does not exist, is a directory or cannot be read
std::string read_text(const std::filesystem::path& file);

}  // namespace bracket::scene
