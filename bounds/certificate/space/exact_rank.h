// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <vector>

#include "scene/types.h"

/// Linear algebra in rational numbers, where what is dependent is so exactly or not at all.
namespace bracket::bounds::space {

using Rational =
    boost::multiprecision::number<boost::multiprecision::cpp_rational_backend, boost::multiprecision::et_off>;
using Row = std::vector<Rational>;

inline Row exact_row(const scene::Vector<3>& v) { return {Rational(v[0]), Rational(v[1]), Rational(v[2])}; }

int rank(std::vector<Row> rows);

}  // namespace bracket::bounds::space
