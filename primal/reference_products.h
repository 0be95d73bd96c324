// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace bracket::primal {

/// ∫ ∂_a B_i ∂_b B_j over the triangle (0,0), (1,0), (0,1) or the tetrahedron that has (0,0,1), too, for the Bernstein
/// polynomials of a degree, n of them: what all cells share. Row i, column j of the matrix dim a + b, n² numbers each,
/// row by row. primal/element/main.cpp has deal.II make them.
/// \param degree 1 to 4, in space to 2
template <int dim> const double* reference_products(int degree);
template <> const double* reference_products<2>(int degree);
template <> const double* reference_products<3>(int degree);

}  // namespace bracket::primal
