// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bounds/certificate/judge_given.h"

#include <gtest/gtest.h>

#include "tests/bounds/certificate/judge_parts.h"

namespace bracket::bounds {

ExactDisplacement from_nodes(const scene::Mesh<2>& mesh, const scene::Displacement<2>& displacement) {
  std::array<Polynomial, 3> hat;
  for (int k = 0; k < 3; ++k) hat[k] = Polynomial::linear({Exact(k == 0), Exact(k == 1), Exact(k == 2)});
  ExactDisplacement result;
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    Field own;
    const auto add = [&](const Polynomial& shape, const scene::Vector<2>& value) {
      own = own + Field{Exact(value[0]) * shape, Exact(value[1]) * shape};
    };
    for (int k = 0; k < 3; ++k) {
      const Polynomial quadratic = Exact(2) * hat[k] * hat[k] - hat[k];
      add(displacement.degree == 1 ? hat[k] : quadratic, displacement.vertex[mesh.cells[c][k]]);
    }
    for (const int e : mesh.cell_edges[c]) {
      if (displacement.degree == 1) break;
      Polynomial both = Polynomial::constant(3, Exact(4));
      for (int k = 0; k < 3; ++k)
        if (mesh.cells[c][k] == mesh.edges[e][0] || mesh.cells[c][k] == mesh.edges[e][1]) both = both * hat[k];
      add(both, displacement.edge[e]);
    }
    result.cell.push_back(own);
  }
  return result;
}

namespace {

std::array<Exact, 3> barycentric(const Corners& of, const Point& at) {
  std::array<Exact, 3> result;
  for (int k = 0; k < 3; ++k) {
    const Point &a = of[(k + 1) % 3], &b = of[(k + 2) % 3];
    result[k] = cross(b - a, at - a) / cross(of[1] - of[0], of[2] - of[0]);
  }
  return result;
}

/// The coordinates of the cell of a mesh that contains these corners, as functions of theirs; nothing: not this cell.
std::optional<std::array<Polynomial, 3>> coordinates_of(const Corners& cell, const Corners& part) {
  std::array<std::vector<Exact>, 3> at;
  for (const Point& corner : part) {
    const auto coordinates = barycentric(cell, corner);
    for (int k = 0; k < 3; ++k) {
      if (coordinates[k] < Exact(0)) return {};
      at[k].push_back(coordinates[k]);
    }
  }
  return {{Polynomial::linear(at[0]), Polynomial::linear(at[1]), Polynomial::linear(at[2])}};
}

}  // namespace

ExactDisplacement on_finer(const scene::Mesh<2>& mesh, const ExactDisplacement& displacement,
                           const scene::Mesh<2>& finer) {
  ExactDisplacement result;
  for (std::size_t c = 0; c < finer.cells.size(); ++c) {
    const Corners part = corners_of(finer, static_cast<int>(c));
    for (std::size_t of = 0; of < mesh.cells.size() && result.cell.size() == c; ++of)
      if (const auto at = coordinates_of(corners_of(mesh, static_cast<int>(of)), part))
        result.cell.push_back({displacement.cell[of][0].of(*at), displacement.cell[of][1].of(*at)});
    EXPECT_EQ(result.cell.size(), c + 1) << "a cell that lies in none";
  }
  return result;
}

ExactDisplacement combination(const Exact& a, const ExactDisplacement& u, const Exact& b, const ExactDisplacement& v) {
  ExactDisplacement result;
  for (std::size_t c = 0; c < u.cell.size(); ++c)
    result.cell.push_back({a * u.cell[c][0] + b * v.cell[c][0], a * u.cell[c][1] + b * v.cell[c][1]});
  return result;
}

ExactDisplacement on_supports(const scene::Problem<2>& first, const scene::Displacement<2>& given) {
  return exact_displacement(first, plain_field(first, given, supports_of(first)));
}

std::vector<Exact> squared_distances(const scene::Problem<2>& problem, const Judged& own,
                                     const ExactDisplacement& given) {
  auto result = misfits(problem, own.stress, combination(Exact(2), given, Exact(-1), own.displacement));
  for (Exact& square : result) square = half * square;
  return result;
}

Exact squared_distance_by_energies(const scene::Problem<2>& problem, const Judged& own,
                                   const ExactDisplacement& given) {
  const ExactDisplacement w = combination(Exact(2), given, Exact(-1), own.displacement);
  return half * (potential_energy(problem, w, own.stress.added) + complementary_energy(problem, own.stress, w) -
                 contact_term(problem, own.stress, w));
}

void expect_root_inside(double lower, double upper, const Exact& square) {
  EXPECT_LE(lower, upper);
  EXPECT_TRUE(lower <= 0 || Exact(lower) * Exact(lower) <= square)
      << lower << " is above the root of " << square << " by " << lower - std::sqrt(rounded(square));
  EXPECT_TRUE(upper == std::numeric_limits<double>::infinity() || (upper >= 0 && Exact(upper) * Exact(upper) >= square))
      << upper << " is below the root of " << square << " by " << std::sqrt(rounded(square)) - upper;
}

}  // namespace bracket::bounds
