// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <mpi.h>

#include <vector>

#include "primal/ranks/system.h"

/// What passes between the root and the others.
namespace bracket::primal {

enum class Order { end, mesh, solve };

/// The root's order to all. Collective, as all here; who waits for it sleeps.
Order ordered(MPI_Comm processes, Order order = Order::end);

/// Each process its piece. \param pieces the root's; empty elsewhere
Piece scattered(MPI_Comm processes, const std::vector<Piece>& pieces);
/// The root's, to all.
std::vector<scene::Elasticity<3>> broadcast(MPI_Comm processes, std::vector<scene::Elasticity<3>> materials);
Way broadcast(MPI_Comm processes, Way way);
/// Each process its nodes. \param tied the root's; empty elsewhere
std::vector<TiedNode> scattered(MPI_Comm processes, const std::vector<std::vector<TiedNode>>& tied);

}  // namespace bracket::primal
