// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Sparse>
#include <vector>

namespace bracket::contact {

/// A fill-reducing ordering by nested dissection of the graph of the nodes, the unknowns `last` behind all others.
/// \param stiffness lower triangle   \param nodes as in Body
/// \return the unknown that comes k-th
std::vector<int> order(const Eigen::SparseMatrix<double>& stiffness, const std::vector<int>& nodes,
                       const std::vector<int>& last);

}  // namespace bracket::contact
