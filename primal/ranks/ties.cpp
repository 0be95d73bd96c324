// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "primal/ranks/ties.h"

#include <Eigen/LU>
#include <Eigen/QR>
#include <Eigen/SVD>
#include <algorithm>
#include <boost/pending/disjoint_sets.hpp>
#include <map>

namespace bracket::primal {

namespace {

/// Vectors that are not multiples of others differ by far more than rounding.
constexpr double negligible = 1e-9;

}  // namespace

Unknowns unknowns_of(const scene::Problem<3>& problem, const Nodes<3>& nodes, const std::vector<Row>& rows) {
  const auto& mesh = problem.mesh;
  Unknowns of{problem, nodes, rows, {}, {}, {}};
  for (const auto& offsets : nodes.body_nodes) of.of_body.emplace_back(offsets.back(), -1);
  for (std::size_t c = 0; c < mesh.cells.size(); ++c)
    for (const int i : cell_nodes(mesh, nodes, static_cast<int>(c)))
      for (int k = 0; k < nodes.node[i].free; ++k)
        of.of_body[mesh.cell_component[c]][nodes.node[i].unknown + k] = 3 * i + k;
  std::vector<int> ranks(of.size()), parents(of.size());
  boost::disjoint_sets<int*, int*> together(ranks.data(), parents.data());
  for (int q = 0; q < of.size(); ++q) together.make_set(q);
  for (const Row& row : rows) {
    of.terms.emplace_back();
    for (const auto& [body, unknown, coefficient] : row.entries) {
      of.terms.back().emplace_back(of.of_body[body][unknown], coefficient);
      together.union_set(of.terms.back().back().first, of.terms.back().front().first);
    }
  }
  std::map<int, Unknowns::Group> groups;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    Unknowns::Group& group = groups[together.find_set(of.terms[i].front().first)];
    group.rows.push_back(static_cast<int>(i));
    for (const auto& [q, coefficient] : of.terms[i]) group.unknowns.push_back(q);
  }
  for (auto& [first, group] : groups) {
    make_distinct(group.unknowns);
    of.groups.push_back(std::move(group));
  }
  return of;
}

std::vector<Tie> ties(const Unknowns& unknowns, std::vector<int>& closed) {
  std::vector<int> place(unknowns.rows.size(), -1);  // in `closed`
  for (std::size_t i = 0; i < closed.size(); ++i) place[closed[i]] = static_cast<int>(i);
  std::vector<Tie> result;
  for (const auto& group : unknowns.groups) {
    std::vector<int> rows;
    std::ranges::copy_if(group.rows, std::back_inserter(rows), [&](int i) { return place[i] >= 0; });
    std::ranges::sort(rows, {}, [&](int i) { return place[i]; });
    const auto n = static_cast<Eigen::Index>(group.unknowns.size());
    const auto at = [&](int q) { return std::ranges::lower_bound(group.unknowns, q) - group.unknowns.begin(); };
    Eigen::MatrixXd kept(0, n), basis(0, n);
    Eigen::VectorXd bounds(0);
    for (const int i : rows) {
      Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(n);
      for (const auto& [q, coefficient] : unknowns.terms[i]) row[at(q)] += coefficient;
      Eigen::RowVectorXd own = row;
      for (int pass = 0; pass < 2; ++pass) own -= (own * basis.transpose() * basis).eval();
      if (own.norm() <= negligible * row.norm()) {
        place[i] = -1;
        continue;
      }
      const Eigen::Index m = kept.rows();
      kept.conservativeResize(m + 1, Eigen::NoChange);
      basis.conservativeResize(m + 1, Eigen::NoChange);
      bounds.conservativeResize(m + 1);
      kept.row(m) = row;
      basis.row(m) = own.normalized();
      bounds[m] = unknowns.rows[i].bound;
    }
    if (kept.rows() == 0) continue;
    const Eigen::FullPivLU<Eigen::MatrixXd> lu(kept);
    const Eigen::VectorXi order = lu.permutationQ().indices().cast<int>();
    const Eigen::Index m = kept.rows();
    std::vector<int> tied(order.data(), order.data() + m), others(order.data() + m, order.data() + n);
    const Eigen::PartialPivLU<Eigen::MatrixXd> solver(kept(Eigen::all, tied));
    const Eigen::VectorXd constant = solver.solve(bounds);
    const Eigen::MatrixXd factors = solver.solve(-kept(Eigen::all, others));
    for (Eigen::Index i = 0; i < m; ++i) {
      Tie tie{group.unknowns[tied[i]], constant[i], {}};
      for (std::size_t j = 0; j < others.size(); ++j)
        if (const double factor = factors(i, static_cast<Eigen::Index>(j)); factor != 0)
          tie.others.emplace_back(group.unknowns[others[j]], factor);
      result.push_back(std::move(tie));
    }
  }
  std::erase_if(closed, [&](int i) { return place[i] < 0; });
  return result;
}

Eigen::MatrixXd free_motions(const Unknowns& unknowns, const Eigen::MatrixXd& motions, const std::vector<int>& closed) {
  if (motions.cols() == 0 || closed.empty()) return motions;
  Eigen::MatrixXd moved = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(closed.size()), motions.cols());
  for (std::size_t i = 0; i < closed.size(); ++i)
    for (const auto& [q, coefficient] : unknowns.terms[closed[i]])
      moved.row(static_cast<Eigen::Index>(i)) += coefficient * motions.row(q);
  Eigen::MatrixXd square = Eigen::MatrixXd::Zero(motions.cols(), motions.cols());  // of the same kernel
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(moved);
  const Eigen::Index size = std::min(moved.rows(), moved.cols());
  square.topRows(size) = qr.matrixQR().topRows(size).triangularView<Eigen::Upper>();
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(square, Eigen::ComputeFullV);
  Eigen::Index rank = 0;
  for (const double value : svd.singularValues()) rank += value > negligible * svd.singularValues()[0] ? 1 : 0;
  return motions * svd.matrixV().rightCols(motions.cols() - rank);
}

std::vector<int> pins(const Unknowns& unknowns, const Eigen::MatrixXd& motions, const std::vector<Tie>& ties) {
  if (motions.cols() == 0) return {};
  Eigen::MatrixXd candidates = motions.transpose();
  const std::vector<char> can = kept(unknowns, ties, {});
  for (Eigen::Index q = 0; q < unknowns.size(); ++q)
    if (!can[q]) candidates.col(q).setZero();
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(candidates);
  const Eigen::VectorXi order = qr.colsPermutation().indices().cast<int>();
  return {order.data(), order.data() + motions.cols()};
}

std::vector<char> kept(const Unknowns& unknowns, const std::vector<Tie>& ties, const std::vector<int>& pinned) {
  const auto& nodes = unknowns.nodes.node;
  std::vector<char> result(unknowns.size(), 1);
  for (std::size_t i = 0; i < nodes.size(); ++i)
    for (int k = nodes[i].free; k < 3; ++k) result[3 * i + k] = 0;
  for (const Tie& tie : ties) result[tie.unknown] = 0;
  for (const int q : pinned) result[q] = 0;
  return result;
}

std::vector<TiedNode> tied_nodes(const Unknowns& unknowns, const std::vector<int>& number, const std::vector<Tie>& ties,
                                 const std::vector<int>& pinned) {
  const auto& nodes = unknowns.nodes.node;
  const std::vector<char> is_kept = kept(unknowns, ties, pinned);
  std::map<int, TiedNode> tied;  // by index of Nodes::node
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (nodes[i].free < 3 || !nodes[i].directions.isIdentity(0)) tied[static_cast<int>(i)];
  for (const auto& group : unknowns.groups)
    for (const int q : group.unknowns) tied[q / 3].asked = true;
  for (const int q : pinned) tied[q / 3];
  for (auto& [i, node] : tied) {
    node.node = number[i];
    node.offset = nodes[i].prescribed;
    Eigen::Matrix3d own = nodes[i].directions;
    for (int k = 0; k < 3; ++k)
      if (!is_kept[3 * i + k]) own.col(k).setZero();
    node.of = {{number[i], own}};
  }
  for (const Tie& tie : ties) {
    const auto [i, k] = std::div(tie.unknown, 3);
    TiedNode& node = tied[i];
    const scene::Vector<3> direction = nodes[i].directions.col(k);
    node.offset += tie.constant * direction;
    for (const auto& [q, factor] : tie.others) {
      if (!is_kept[q]) continue;
      auto at = std::ranges::find(node.of, number[q / 3], [](const auto& entry) { return entry.first; });
      if (at == node.of.end()) at = node.of.insert(at, {number[q / 3], Eigen::Matrix3d::Zero()});
      at->second.col(q % 3) += factor * direction;
    }
  }
  std::vector<TiedNode> result;
  for (auto& [i, node] : tied) result.push_back(std::move(node));
  return result;
}

}  // namespace bracket::primal
