// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/range.h"

#include <fmt/format.h>

#include <cmath>

#include "scene/text.h"

namespace bracket::scene {

std::string size_message(double value, const std::string& name) {
  if (!std::isfinite(value)) return fmt::format("{} must be finite, is {}", name, value);
  const double size = std::abs(value);
  if (size == 0 || (smallest_size <= size && size <= largest_size)) return "";
  return fmt::format("{} must be 0 or of a size between {:g} and {:g}, is {:g}", name, smallest_size, largest_size,
                     value);
}

void check_size(double value, const std::string& where, const std::string& name) {
  const std::string message = size_message(value, name);
  if (!message.empty()) fail(Status::input, where, message);
}

}  // namespace bracket::scene
