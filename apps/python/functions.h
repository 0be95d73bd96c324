// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

#include <string>

#include "scene/function.h"

namespace bracket::python {

/// A number, an expression in x and y (scene/toml/expression.h), or a callable f(x, y) of two floats, which is sampled
/// and may be called from any thread.
/// \param name of the argument, for messages
/// \throw TypeError if it is none of them; scene::Error for an expression that is wrong
scene::Function<2> function_of(const pybind11::handle& given, const std::string& name);

}  // namespace bracket::python
