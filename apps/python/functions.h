// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

#include <string>

#include "scene/function.h"

namespace bracket::python {

/// A number, an expression in x and y (scene/toml/expression.h), in space z as well, or a callable f(x, y), f(x, y, z)
/// of floats, which is sampled and may be called from any thread.
/// \param name of the argument, for messages
/// \throw TypeError if it is none of them; scene::Error for an expression that is wrong
template <int dim> scene::Function<dim> function_of(const pybind11::handle& given, const std::string& name);

}  // namespace bracket::python
