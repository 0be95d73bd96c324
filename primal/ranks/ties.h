// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "primal/ranks/system.h"

/// Closed contact as a change of unknowns: what a closed row says of one unknown by the others is put in its place.
namespace bracket::primal {

/// The unknowns q of a mesh and what contact says of them. Unknown k of Nodes::node[i] is 3 i + k.
struct Unknowns {
  const scene::Problem<3>& problem;
  const Nodes<3>& nodes;
  const std::vector<Row>& rows;
  std::vector<std::vector<int>> of_body;                   ///< of each body, its unknowns in these numbers
  std::vector<std::vector<std::pair<int, double>>> terms;  ///< of each row
  /// Rows that have unknowns in common, directly or by others; and these.
  struct Group {
    std::vector<int> rows, unknowns;
  };
  std::vector<Group> groups;

  Eigen::Index size() const { return 3 * static_cast<Eigen::Index>(nodes.node.size()); }
};
Unknowns unknowns_of(const scene::Problem<3>& problem, const Nodes<3>& nodes, const std::vector<Row>& rows);

/// q = constant + Σ factor · q of others.
struct Tie {
  int unknown;
  double constant;
  std::vector<std::pair<int, double>> others;
};

/// What closed rows tie. \param closed rows, those that are to be kept first; a row that depends on earlier ones is
///     left out of `closed`
std::vector<Tie> ties(const Unknowns& unknowns, std::vector<int>& closed);

/// The free motions that closed rows leave, as columns by the unknowns, all bodies'.
Eigen::MatrixXd free_motions(const Unknowns& unknowns, const Eigen::MatrixXd& motions, const std::vector<int>& closed);

/// As many unknowns as there are motions, none of them tied, whose values tell the motions apart.
std::vector<int> pins(const Unknowns& unknowns, const Eigen::MatrixXd& motions, const std::vector<Tie>& ties);

/// Of each unknown whether it is one still: it is free, and neither tied nor pinned.
std::vector<char> kept(const Unknowns& unknowns, const std::vector<Tie>& ties, const std::vector<int>& pinned);

/// The nodes that are not free, in the order of Nodes::node.
/// \param number of each node in the System   \param pinned unknowns that are kept at zero
std::vector<TiedNode> tied_nodes(const Unknowns& unknowns, const std::vector<int>& number, const std::vector<Tie>& ties,
                                 const std::vector<int>& pinned);

}  // namespace bracket::primal
