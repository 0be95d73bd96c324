// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// In space: any number of boundary facets meet at a vertex, two at an edge.
#include "scene/problem/support.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "scene/problem/space/face_gap.h"
#include "scene/text.h"

namespace bracket::scene {

namespace {

/// A boundary facet at a vertex, and which of its vertices that is.
struct FacetCorner {
  int facet, corner;
};

std::vector<std::vector<FacetCorner>> corners_at_vertices(const Mesh<3>& mesh) {
  std::vector<std::vector<FacetCorner>> corners(mesh.vertices.size());
  for (std::size_t f = 0; f < mesh.boundary.size(); ++f)
    for (int i = 0; i < 3; ++i) corners[mesh.boundary[f].vertices[i]].push_back({static_cast<int>(f), i});
  return corners;
}

/// What is prescribed at a vertex along a direction.
struct Row {
  Vector<3> normal;
  double value;
  int facet;
};

/// The displacement that has these components, and by how much it misses one at most.
struct Fitted {
  Vector<3> displacement;
  double miss;
};
Fitted fitted(const std::vector<Row>& rows) {
  Eigen::MatrixX3d normals(rows.size(), 3);
  Eigen::VectorXd values(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    normals.row(static_cast<Eigen::Index>(i)) = rows[i].normal.transpose();
    values[static_cast<Eigen::Index>(i)] = rows[i].value;
  }
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixX3d> solver(normals);
  solver.setThreshold(1e-9);
  const Vector<3> u = solver.solve(values);
  return {u, (normals * u - values).cwiseAbs().maxCoeff()};
}

/// Makes agree what the facets at a vertex prescribe.
class Agreement {
 public:
  Agreement(const Mesh<3>& mesh, std::vector<FacetData<3>>& facets, const std::vector<const Condition<3>*>& conditions,
            double largest)
      : mesh_(mesh), facets_(facets), conditions_(conditions), tolerance_(1e-9 * largest) {}

  void at(const std::vector<FacetCorner>& corners) {
    const FacetCorner* fixed = nullptr;
    for (const FacetCorner& at : corners)
      if (facets_[at.facet].support == Support::fixed && fixed == nullptr) fixed = &at;
    if (fixed != nullptr)
      follow(facets_[fixed->facet].displacement[fixed->corner], fixed->facet, corners);
    else
      slide(corners);
  }

 private:
  void expect(double difference, const FacetCorner& one, int other) const {
    if (difference <= tolerance_) return;
    const auto& facet = mesh_.boundary[one.facet];
    fail(Status::input, conditions_[facet.part]->where,
         fmt::format("the displacements prescribed on '{}' and '{}' contradict each other at {}: they differ by {:.3g}",
                     mesh_.parts[mesh_.boundary[other].part], mesh_.parts[facet.part],
                     point(mesh_.vertices[facet.vertices[one.corner]]), difference));
  }

  /// Where one facet fixes the displacement.
  void follow(const Vector<3>& u, int by, const std::vector<FacetCorner>& corners) {
    for (const FacetCorner& at : corners) {
      FacetData<3>& data = facets_[at.facet];
      if (data.support == Support::fixed) {
        expect((data.displacement[at.corner] - u).norm(), at, by);
        data.displacement[at.corner] = u;
      } else if (data.support == Support::sliding) {
        const double value = data.normal.dot(u);
        expect(std::abs(data.normal_displacement[at.corner] - value), at, by);
        data.normal_displacement[at.corner] = value;
      }
    }
  }

  /// Where all slide: equal normals have equal values, and more than determine a displacement have its components.
  void slide(const std::vector<FacetCorner>& corners) {
    std::vector<Row> rows;
    for (const FacetCorner& at : corners) {
      FacetData<3>& data = facets_[at.facet];
      if (data.support != Support::sliding) continue;
      double& value = data.normal_displacement[at.corner];
      const auto same = std::find_if(rows.begin(), rows.end(), [&](const Row& row) {
        return row.normal == data.normal || row.normal == -data.normal;
      });
      if (same == rows.end()) {
        rows.push_back({data.normal, value, at.facet});
        continue;
      }
      const double expected = same->normal == data.normal ? same->value : -same->value;
      expect(std::abs(value - expected), at, same->facet);
      value = expected;
    }
    if (rows.size() < 3) return;
    const Fitted fit = fitted(rows);
    for (const FacetCorner& at : corners) {
      FacetData<3>& data = facets_[at.facet];
      if (data.support == Support::sliding) expect(fit.miss, at, rows.front().facet);
    }
  }

  const Mesh<3>& mesh_;
  std::vector<FacetData<3>>& facets_;
  const std::vector<const Condition<3>*>& conditions_;
  double tolerance_;
};

}  // namespace

std::vector<FacetData<3>> with_agreement(const Mesh<3>& mesh, std::vector<FacetData<3>> facets,
                                         const std::vector<const Condition<3>*>& conditions, double largest) {
  Agreement agreement(mesh, facets, conditions, largest);
  for (const auto& corners : corners_at_vertices(mesh)) agreement.at(corners);
  return facets;
}

namespace {

/// What is prescribed along a direction.
struct Along {
  Enclosure value;
  double size = 0;  ///< of the whole
};

/// \return nothing where the displacement along d is free
std::optional<Along> along(const FacetData<3>& data, int corner, const Vector<3>& d) {
  if (data.support == Support::fixed) {
    const Vector<3>& u = data.displacement[corner];
    Along result{{}, u.norm()};
    for (int c = 0; c < 3; ++c) result.value = result.value + Enclosure(u[c]) * Enclosure(d[c]);
    return result;
  }
  const double u = data.normal_displacement[corner];
  if (data.support == Support::sliding && data.normal == d) return Along{u, std::abs(u)};
  if (data.support == Support::sliding && data.normal == -d) return Along{-u, std::abs(u)};
  return {};
}

/// What the facets at a vertex prescribe along d: one of them, or several that slide along planes whose normals span d.
std::optional<Along> along(const std::vector<FacetData<3>>& facets, const std::vector<FacetCorner>& corners,
                           const Vector<3>& d) {
  std::vector<Row> rows;
  for (const FacetCorner& at : corners) {
    const FacetData<3>& data = facets[at.facet];
    if (const auto one = along(data, at.corner, d)) return one;
    if (data.support == Support::sliding) rows.push_back({data.normal, data.normal_displacement[at.corner], at.facet});
  }
  if (rows.size() < 2) return {};
  // d = Σ c_i n_i, then u·d = Σ c_i u_i
  Eigen::Matrix3Xd normals(3, rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) normals.col(static_cast<Eigen::Index>(i)) = rows[i].normal;
  Eigen::CompleteOrthogonalDecomposition<Eigen::Matrix3Xd> solver(normals);
  solver.setThreshold(1e-9);
  const Eigen::VectorXd c = solver.solve(d);
  if ((normals * c - d).norm() > 1e-12) return {};
  Along result;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    result.value = result.value + Enclosure(c[static_cast<Eigen::Index>(i)]) * Enclosure(rows[i].value);
    result.size += std::abs(c[static_cast<Eigen::Index>(i)] * rows[i].value);
  }
  result.value.radius += std::numeric_limits<double>::epsilon() * result.size;  // of the c_i
  return result;
}

Along middle_of(const Along& one, const Along& other) {
  const Enclosure sum = one.value + other.value;
  return {{sum.middle / 2, sum.radius / 2}, std::max(one.size, other.size)};
}

/// What is prescribed along the normal of a contact's first facet on both of its sides, as Bernstein coefficients.
class Prescribed {
 public:
  explicit Prescribed(const Problem<3>& problem)
      : problem_(problem),
        corners_(corners_at_vertices(problem.mesh)),
        facets_at_edge_(problem.mesh.edges.size(), {-1, -1}) {
    for (std::size_t f = 0; f < problem.mesh.boundary.size(); ++f)
      for (const int edge : facet_edges(problem.mesh, problem.mesh.boundary[f]))
        facets_at_edge_[edge][facets_at_edge_[edge][0] == -1 ? 0 : 1] = static_cast<int>(f);
  }

  /// \param facet a side of a contact   \param i as in FacetQuadratic
  std::optional<Along> coefficient(int facet, int i, const Vector<3>& d) const {
    const auto& own = problem_.mesh.boundary[facet];
    if (i < 3) return along(problem_.facets, corners_[own.vertices[i]], d);
    const int edge = facet_edges(problem_.mesh, own)[i - 3];
    const auto& [one, other] = facets_at_edge_[edge];
    const int beside = one == facet ? other : one;
    std::array<std::optional<Along>, 2> ends;
    for (int end = 0; end < 2; ++end) {
      const auto& vertices = problem_.mesh.boundary[beside].vertices;
      const auto at = std::find(vertices.begin(), vertices.end(), problem_.mesh.edges[edge][end]) - vertices.begin();
      ends[end] = along(problem_.facets[beside], static_cast<int>(at), d);
    }
    if (!ends[0] || !ends[1]) return {};
    return middle_of(*ends[0], *ends[1]);
  }

 private:
  const Problem<3>& problem_;
  std::vector<std::vector<FacetCorner>> corners_;
  std::vector<std::array<int, 2>> facets_at_edge_;
};

/// The coefficient on the second facet that belongs to one on the first.
int across(const ContactFacetOf<3>& pair, int i) {
  if (i < 3) return pair.meets[i];
  const auto& [a, b] = Simplex<2>::edges[i - 3];
  return 3 + Simplex<2>::edge_between(pair.meets[a], pair.meets[b]);
}

}  // namespace

double make_room(Problem<3>& problem) {
  const Prescribed on(problem);
  double most = 0;
  for (std::size_t c = 0; c < problem.contact.size(); ++c) {
    ContactFacetOf<3>& facet = problem.contact[c];
    GivenGap<3>& given = problem.gaps[c];
    const Vector<3>& d = problem.facets[facet.first].normal;
    const Face face = positions(problem.mesh, problem.mesh.boundary[facet.first].vertices);
    for (int i = 0; i < (given.function ? 3 : 6); ++i) {
      const auto first = on.coefficient(facet.first, i, d);
      const auto second = facet.second == -1 ? Along{} : on.coefficient(facet.second, across(facet, i), d);
      if (!first || !second) continue;
      const double gap = given.function ? lower(gap_at_corner(given.function, face, i)) : facet.lower[i];
      const double tolerance = 8 * std::numeric_limits<double>::epsilon() *
                               (first->size + second->size + std::abs(gap) + problem.length_scale);
      // Whoever computes it again comes to another middle, within the radius.
      Enclosure approach = first->value - second->value;
      approach.radius *= 4;
      if (facet.law.two_sided) {  // no displacement could make good what rounding did
        const double change =
            std::max(std::abs(facet.lower[i] - upper(approach)), std::abs(facet.upper[i] - lower(approach)));
        if (change > tolerance) continue;
        facet.lower[i] = lower(approach);
        facet.upper[i] = upper(approach);
        most = std::max(most, change);
        continue;
      }
      const double room = upper(approach);
      if (room <= gap || room - gap > tolerance) continue;
      const double raised = upper(Interval(room) - Interval(gap));
      if (given.function) {
        given.raised[i] = raised;
      } else {
        facet.lower[i] = room;
        facet.upper[i] = std::max(room, facet.upper[i]);
      }
      most = std::max(most, raised);
      problem.mesh.notes.push_back(fmt::format(
          "the gap at {} was raised by {:.2g}: the displacements prescribed there close it by rounding",
          point(i < 3 ? face[i]
                      : Vector<3>(0.5 * (face[Simplex<2>::edges[i - 3][0]] + face[Simplex<2>::edges[i - 3][1]]))),
          raised));
    }
  }
  return most;
}

}  // namespace bracket::scene
