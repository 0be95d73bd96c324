// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/certificate/space/hold.h"

#include <algorithm>
#include <numeric>

namespace bracket::bounds::space {

using scene::Support;

std::vector<Reference> references(const scene::Mesh<3>& mesh) {
  std::vector<Eigen::AlignedBox3d> boxes(mesh.components.size());
  for (std::size_t c = 0; c < mesh.cells.size(); ++c)
    for (const int v : mesh.cells[c]) boxes[mesh.cell_component[c]].extend(mesh.vertices[v]);
  std::vector<Reference> result;
  for (const auto& box : boxes) result.push_back({box.center(), box.diagonal().norm() / 2});
  return result;
}

Rows rows_of(const scene::Problem<3>& problem) {
  const auto& mesh = problem.mesh;
  Rows rows{std::vector<int>(mesh.components.size(), 0), 0};
  for (std::size_t f = 0; f < problem.facets.size(); ++f)
    if (problem.facets[f].support == Support::fixed) rows.of_body[mesh.cell_component[mesh.boundary[f].cell]] = -1;
  for (int& row : rows.of_body) {
    if (row < 0) continue;
    row = rows.count;
    rows.count += 6;
  }
  return rows;
}

std::vector<Spread> spreads(const scene::Problem<3>& problem, const Rows& rows, const PlainLoads& loads, double least,
                            const std::set<Corner>& barred) {
  const auto& mesh = problem.mesh;
  const auto floats = [&](int facet) {
    return facet >= 0 && rows.of_body[mesh.cell_component[mesh.boundary[facet].cell]] >= 0;
  };
  std::vector<double> area;
  double largest_area = 0;
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    area.push_back(scene::area_vector<3>(positions(mesh, mesh.boundary[f].vertices)).norm());
    largest_area = std::max(largest_area, area.back());
  }
  std::vector<Spread> result;
  for (int f = 0; f < static_cast<int>(problem.facets.size()); ++f)
    for (int i = 0; i < 3 && problem.facets[f].support == Support::sliding && floats(f); ++i)
      result.push_back({f, i, -1, -1, area[f] / largest_area, true});
  std::vector<double> largest;  // of each pair
  for (const auto& pair : problem.contact) {
    largest.resize(std::max<std::size_t>(largest.size(), pair.pair + 1), 0);
    for (const double p : loads.along_normal[pair.first]) largest[pair.pair] = std::max(largest[pair.pair], p);
  }
  const std::vector<char> carrying = carrying_pairs(problem, loads);
  for (const auto& pair : problem.contact) {
    if (!carrying[pair.pair] || !(floats(pair.first) || floats(pair.second))) continue;
    for (int i = 0; i < 3; ++i) {
      if (barred.contains({pair.first, i})) continue;
      const int meets = pair.second < 0 ? -1 : pair.meets[i];
      if (pair.law.two_sided) {
        result.push_back({pair.first, i, pair.second, meets, area[pair.first] / largest_area, true});
        continue;
      }
      const double share = std::max(loads.along_normal[pair.first][i] / largest[pair.pair], least);
      if (share > 0) result.push_back({pair.first, i, pair.second, meets, share * share, false});
    }
  }
  return result;
}

std::vector<int> chosen_corrections(const scene::Problem<3>& problem, const std::vector<Reference>& about,
                                    const Rows& rows, const std::vector<Spread>& spreads, int count) {
  const scene::Problem<3>& first = scene::first_of(problem);
  std::vector<int> chosen(first.corrections.size());
  std::iota(chosen.begin(), chosen.end(), 0);
  if (count == static_cast<int>(chosen.size()) || rows.count == 0) return chosen;
  const auto columns = [&](std::size_t n) { return Eigen::MatrixXd::Zero(rows.count, static_cast<Eigen::Index>(n)); };
  const auto put = [](Eigen::MatrixXd& matrix, int row, std::size_t column, const std::array<double, 6>& entry) {
    for (int i = 0; i < 6 && row >= 0; ++i) matrix(row + i, static_cast<Eigen::Index>(column)) += entry[i];
  };
  Eigen::MatrixXd of_spreads = columns(std::max<std::size_t>(1, spreads.size())), rest = columns(chosen.size());
  for (std::size_t s = 0; s < spreads.size(); ++s) {
    const auto& [row, entry] = effect<double>(problem, about, rows, spreads[s]);
    for (int side = 0; side < 2; ++side) put(of_spreads, row[side], s, entry[side]);
  }
  for (std::size_t k = 0; k < chosen.size(); ++k) {
    const auto& [facet, unit] = first.corrections[k];
    put(rest, rows.of_body[first.mesh.cell_component[first.mesh.boundary[facet].cell]], k,
        entries_of_load<double>(first, about, facet,
                                {vector3<double>(unit[0]), vector3<double>(unit[1]), vector3<double>(unit[2])}));
  }
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(of_spreads);
  qr.setThreshold(1e-9);  // as scene::free_motions()
  const Eigen::MatrixXd q = qr.householderQ();
  const Eigen::MatrixXd beside = q.rightCols(rows.count - qr.rank()).transpose() * rest;
  if (beside.rows() > 0) {
    const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> order(beside);
    for (std::size_t k = 0; k < chosen.size(); ++k)
      chosen[k] = static_cast<int>(order.colsPermutation().indices()[static_cast<Eigen::Index>(k)]);
  }
  chosen.resize(count);
  return chosen;
}

bool drop_barred_pairs(const scene::Problem<3>& problem, const std::set<Corner>& barred, PlainLoads& loads) {
  std::set<int> pairs;
  for (const auto& facet : problem.contact)
    for (int i = 0; i < 3; ++i)
      if (barred.contains({facet.first, i}) && loads.along_normal[facet.first][i] > 0) pairs.insert(facet.pair);
  for (const auto& facet : problem.contact)
    if (pairs.contains(facet.pair)) loads.along_normal[facet.first] = {0, 0, 0};
  return !pairs.empty();
}

}  // namespace bracket::bounds::space
