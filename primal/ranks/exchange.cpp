// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "primal/ranks/exchange.h"

#include <unistd.h>

#include <limits>
#include <stdexcept>
#include <type_traits>

namespace bracket::primal {

namespace {

template <class T> std::vector<T> scattered_values(MPI_Comm processes, const std::vector<std::vector<T>>& of) {
  const MPI_Datatype type = std::is_same_v<T, int> ? MPI_INT : MPI_DOUBLE;
  std::vector<int> counts, begins = {0};
  std::vector<T> all;
  for (const auto& one : of) {
    all.insert(all.end(), one.begin(), one.end());
    if (all.size() > static_cast<std::size_t>(std::numeric_limits<int>::max()))
      throw std::length_error("the mesh is too large to be handed out by MPI");
    counts.push_back(static_cast<int>(one.size()));
    begins.push_back(static_cast<int>(all.size()));
  }
  int count = 0;
  MPI_Scatter(counts.data(), 1, MPI_INT, &count, 1, MPI_INT, 0, processes);
  std::vector<T> own(count);
  MPI_Scatterv(all.data(), counts.data(), begins.data(), type, own.data(), count, type, 0, processes);
  return own;
}

}  // namespace

Order ordered(MPI_Comm processes, Order order) {
  int number = static_cast<int>(order), arrived = 0;
  MPI_Request request;
  MPI_Ibcast(&number, 1, MPI_INT, 0, processes, &request);
  while (MPI_Test(&request, &arrived, MPI_STATUS_IGNORE), arrived == 0) usleep(200);
  return static_cast<Order>(number);
}

Piece scattered(MPI_Comm processes, const std::vector<Piece>& pieces) {
  std::vector<std::vector<int>> numbers;
  std::vector<std::vector<double>> corners;
  for (const Piece& piece : pieces) {
    numbers.push_back({piece.degree, piece.first, piece.end, piece.n_nodes, static_cast<int>(piece.cell_body.size())});
    numbers.back().insert(numbers.back().end(), piece.cell_body.begin(), piece.cell_body.end());
    numbers.back().insert(numbers.back().end(), piece.cell_nodes.begin(), piece.cell_nodes.end());
    corners.emplace_back();
    for (const auto& x : piece.corners) corners.back().insert(corners.back().end(), x.begin(), x.end());
  }
  const std::vector<int> own = scattered_values(processes, numbers);
  const std::vector<double> x = scattered_values(processes, corners);
  Piece piece;
  piece.degree = own[0];
  piece.first = own[1];
  piece.end = own[2];
  piece.n_nodes = own[3];
  const auto bodies = own.begin() + 5, nodes = bodies + own[4];
  piece.cell_body.assign(bodies, nodes);
  piece.cell_nodes.assign(nodes, own.end());
  for (std::size_t i = 0; i < x.size(); i += 3) piece.corners.emplace_back(x[i], x[i + 1], x[i + 2]);
  return piece;
}

std::vector<scene::Elasticity<3>> broadcast(MPI_Comm processes, std::vector<scene::Elasticity<3>> materials) {
  int count = static_cast<int>(materials.size());
  MPI_Bcast(&count, 1, MPI_INT, 0, processes);
  materials.resize(count);
  for (auto& material : materials)
    MPI_Bcast(material.data(), static_cast<int>(material.size()), MPI_DOUBLE, 0, processes);
  return materials;
}

Way broadcast(MPI_Comm processes, Way way) {
  int direct = way.direct ? 1 : 0;
  MPI_Bcast(&direct, 1, MPI_INT, 0, processes);
  MPI_Bcast(&way.tolerance, 1, MPI_DOUBLE, 0, processes);
  way.direct = direct != 0;
  return way;
}

std::vector<TiedNode> scattered(MPI_Comm processes, const std::vector<std::vector<TiedNode>>& tied) {
  std::vector<std::vector<double>> packed;
  for (const auto& list : tied) {
    packed.emplace_back();
    auto& values = packed.back();
    for (const TiedNode& node : list) {
      values.insert(values.end(), {static_cast<double>(node.node), node.asked ? 1.0 : 0.0, node.offset[0],
                                   node.offset[1], node.offset[2], static_cast<double>(node.of.size())});
      for (const auto& [other, matrix] : node.of) {
        values.push_back(other);
        values.insert(values.end(), matrix.data(), matrix.data() + 9);
      }
    }
  }
  const std::vector<double> own = scattered_values(processes, packed);
  std::vector<TiedNode> result;
  for (std::size_t at = 0; at < own.size();) {
    result.push_back({static_cast<int>(own[at]), own[at + 1] != 0, {own[at + 2], own[at + 3], own[at + 4]}});
    const auto count = static_cast<std::size_t>(own[at + 5]);
    at += 6;
    for (std::size_t i = 0; i < count; ++i, at += 10)
      result.back().of.emplace_back(static_cast<int>(own[at]), Eigen::Map<const Eigen::Matrix3d>(&own[at + 1]));
  }
  return result;
}

}  // namespace bracket::primal
