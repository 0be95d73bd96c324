// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <pybind11/pybind11.h>

#include <algorithm>
#include <string>

#include "scene/options.h"

namespace bracket::python {

/// The option of that name.
/// \param what it is, for messages
/// \throw ValueError with the names that there are
template <class Option> Option option_of(const std::string& text, const char* what) {
  const auto& names = scene::option_names<Option>;
  const auto found = std::ranges::find(names, text);
  if (found == names.end())
    throw pybind11::value_error(fmt::format("{} must be one of {}, not '{}'", what, fmt::join(names, ", "), text));
  return static_cast<Option>(found - names.begin());
}

}  // namespace bracket::python
