// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/certificate/admissible_stress.h"

#include <algorithm>

#include "scene/voigt.h"

namespace bracket::bounds {

using scene::Support;
using scene::Vector;

namespace {

/// A pressure below this part of the largest traction on either body is rounding of their stresses. It has to go: on a
/// body that nothing holds it would be a load, which the data do not have.
constexpr double noise = 1e-11;

void drop_noise(const scene::Problem<2>& problem, PlainLoads& loads) {
  const auto& mesh = problem.mesh;
  std::vector<double> largest(mesh.components.size(), 0);  // traction in each body
  for (std::size_t c = 0; c < mesh.cells.size(); ++c)
    for (const int edge : mesh.cell_edges[c]) {
      const double length = (mesh.vertices[mesh.edges[edge][1]] - mesh.vertices[mesh.edges[edge][0]]).norm();
      for (const Vector<2>& load : loads.edge[edge])
        largest[mesh.cell_component[c]] = std::max(largest[mesh.cell_component[c]], load.norm() / length);
    }
  for (const auto& pair : problem.contact) {
    double traction = largest[mesh.cell_component[mesh.boundary[pair.first].cell]];
    if (pair.second >= 0) traction = std::max(traction, largest[mesh.cell_component[mesh.boundary[pair.second].cell]]);
    const double least = noise * traction * scene::length(mesh, pair.first);
    for (double& p : loads.along_normal[pair.first])
      if (p <= least && (!pair.law.two_sided || p >= -least)) p = 0;
    for (double& t : loads.along_tangent[pair.first])
      if (std::abs(t) <= least) t = 0;
  }
}

}  // namespace

namespace {

/// λn of every edge, the mean of both sides: Bernstein coefficients from its lower vertex to its higher.
std::vector<std::vector<Vector<2>>> tractions(const scene::Mesh<2>& mesh, const scene::Stress<2>& stress) {
  const int degree = stress.degree;
  std::vector<std::vector<Vector<2>>> edges(mesh.edges.size(),
                                            std::vector<Vector<2>>(degree + 1, Vector<2>(Vector<2>::Zero())));
  std::vector<char> sides(mesh.edges.size(), 0);
  for (std::size_t c = 0; c < mesh.cells.size(); ++c)
    for (int k = 0; k < 3; ++k) {
      const int edge = mesh.cell_edges[c][k];
      const auto ends = scene::facet_vertices(mesh, static_cast<int>(c), k);
      const Vector<2> normal = scene::area_vector<2>(scene::positions(mesh, ends));
      const bool along = mesh.edges[edge][0] == ends[0];
      const auto own = scene::stress_of_part(stress, static_cast<int>(c), k);
      for (int i = 0; i <= degree; ++i) {
        const Vector<2> traction = scene::traction<2>(own[i], normal);
        edges[edge][along ? i : degree - i] += along ? traction : Vector<2>(-traction);
      }
      ++sides[edge];
    }
  for (std::size_t e = 0; e < sides.size(); ++e)
    for (Vector<2>& load : edges[e]) load /= sides[e];
  return edges;
}

/// By the pseudo-inverse of all fields of the reference block: the amplitudes of the bubbles, a row each.
Eigen::MatrixXd bubble_amplitudes(int degree) {
  const scene::BlockFields& fields = scene::block_fields(degree);
  const std::array<Vector2<double>, 3> x = {{{0, 0}, {1, 0}, {0, 1}}};
  const auto n = 3 * static_cast<Eigen::Index>(scene::n_bernstein(degree));
  Eigen::MatrixXd all(3 * n, 0);
  const auto append = [&](const auto& value) {
    all.conservativeResize(Eigen::NoChange, all.cols() + 1);
    for (Eigen::Index i = 0; i < 3 * n; ++i) all(i, all.cols() - 1) = value(i);
  };
  for (const auto& bubble : fields.bubbles) append([&](Eigen::Index i) { return bubble[i]; });
  for (const auto& sides : fields.load)
    for (const auto& side : sides)
      for (const auto& field : side) append([&](Eigen::Index i) { return field[i]; });
  const auto sides_of = [](const Eigen::VectorXd& at_ends) {  // x and y at both ends of each
    std::array<SideLoad<double>, 3> sides;
    for (int side = 0; side < 3; ++side)
      for (int end = 0; end < 2; ++end)
        sides[side][end] = {at_ends[4 * side + 2 * end], at_ends[4 * side + 2 * end + 1]};
    return sides;
  };
  Eigen::MatrixXd resultants = Eigen::MatrixXd::Zero(3, 12);
  for (Eigen::Index i = 0; i < 12; ++i)
    for (int side = 0; side < 3; ++side) {
      const auto [force, moment] =
          resultant(sides_of(Eigen::VectorXd::Unit(12, i))[side], x[side], x[(side + 1) % 3] - x[side]);
      resultants.col(i) += Eigen::Vector3d(force.x, force.y, moment);
    }
  const Eigen::MatrixXd balanced = Eigen::FullPivLU<Eigen::MatrixXd>(resultants).kernel();
  for (const auto& at_ends : balanced.colwise()) {
    const BlockStress<double> linear = stress_of_balanced(x, sides_of(at_ends));
    std::vector<double> values;
    for (int part = 0; part < 3; ++part)
      for (const auto& value : raised(linear[(part + 1) % 3], 1, degree))
        values.insert(values.end(), value.begin(), value.end());
    append([&](Eigen::Index i) { return values[i]; });
  }
  return all.completeOrthogonalDecomposition().pseudoInverse().topRows(fields.bubbles.size());
}

/// The amplitudes of the bubbles in each cell: those of the stress without the linear field that carries the body
/// force.
std::vector<std::vector<double>> bubbles(const scene::Problem<2>& problem, const scene::Stress<2>& stress) {
  static const std::array<Eigen::MatrixXd, 2> amplitudes = {bubble_amplitudes(2), bubble_amplitudes(3)};
  const auto& mesh = problem.mesh;
  std::vector<std::vector<double>> result;
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    const auto x = scene::positions(mesh, mesh.cells[c]);
    Eigen::Matrix2d b;
    b << x[1] - x[0], x[2] - x[0];
    const Eigen::Matrix2d inverse = b.inverse();
    const Vector<2>& force = problem.bodies[mesh.cell_body[c]].force;
    const Vector<2> centroid = (x[1] - x[0] + x[2] - x[0]) / 3;
    Eigen::VectorXd pulled_back(3 * stress.cell[c].size());
    for (int part = 0, place = 0; part < 3; ++part) {
      const auto own = scene::stress_of_part(stress, static_cast<int>(c), part);
      const auto& [from, to] = scene::Simplex<2>::edges[part];
      const auto& indices = scene::bernstein_indices(stress.degree);
      for (std::size_t i = 0; i < own.size(); ++i, place += 3) {
        const Vector<2> at =
            (indices[i][0] * (x[from] - x[0]) + indices[i][1] * (x[to] - x[0]) + indices[i][2] * centroid) /
                stress.degree -
            centroid;
        Eigen::Matrix2d value;
        value << own[i][0] + force[0] * at[0], own[i][2], own[i][2], own[i][1] + force[1] * at[1];
        const Eigen::Matrix2d reference = b.determinant() * inverse * value * inverse.transpose();
        pulled_back.segment<3>(place) << reference(0, 0), reference(1, 1), reference(0, 1);
      }
    }
    const Eigen::VectorXd own = amplitudes.at(stress.degree - 2) * pulled_back;
    result.emplace_back(own.begin(), own.end());
  }
  return result;
}

}  // namespace

PlainLoads plain_loads(const scene::Problem<2>& problem, const scene::Stress<2>& stress) {
  const auto& mesh = problem.mesh;
  const int degree = stress.degree;
  PlainLoads loads{.degree = degree};
  const auto edges = tractions(mesh, stress);
  for (const auto& edge : edges) {
    const auto [linear, higher] = split<double>(edge);
    loads.edge.push_back(linear);
    loads.higher.insert(loads.higher.end(), higher.begin(), higher.end());
  }
  if (degree > 1) loads.bubbles = bubbles(problem, stress);

  loads.along_normal.assign(problem.facets.size(), std::vector<double>(degree + 1, 0));
  loads.along_tangent.resize(problem.facets.size());
  const auto on_facet = [&](int facet, const Vector<2>& n) {
    const auto& edge = edges[mesh.boundary[facet].edge];
    const bool along = forward(mesh.boundary[facet]);
    std::vector<double> result;
    for (int k = 0; k <= degree; ++k) result.push_back((along ? edge[k] : Vector<2>(-edge[degree - k])).dot(n));
    if (!has_perturbing_load(problem, facet)) return result;
    const auto [at0, at1] = beside<double>(problem, facet);
    for (int k = 0; k <= degree; ++k)
      result[k] -=
          scene::linear_coefficient<double>(dot(at0, vector2<double>(n)), dot(at1, vector2<double>(n)), degree, k);
    return result;
  };
  const auto normal = [&](int facet) -> const Vector<2>& { return problem.facets[facet].normal; };
  for (std::size_t f = 0; f < problem.facets.size(); ++f)
    if (problem.facets[f].support == Support::sliding)
      loads.along_normal[f] = on_facet(static_cast<int>(f), problem.facets[f].normal);
  const FirstContacts contacts = first_contacts(problem);
  for (const auto& pair : problem.contact) {
    auto& pressure = loads.along_normal[pair.first];
    pressure = on_facet(pair.first, normal(pair.first));
    if (pair.second >= 0) {
      const auto across = on_facet(pair.second, normal(pair.second));
      for (int k = 0; k <= degree; ++k) pressure[k] = (pressure[k] + across[degree - k]) / 2;
    }
    const auto [at0, at1] = opening_load<double>(problem, pair);
    for (int k = 0; k <= degree; ++k) {
      const double opening = problem.perturbed.loads * scene::linear_coefficient<double>(at0, at1, degree, k);
      pressure[k] = pair.law.two_sided ? opening - pressure[k] : std::max(0.0, opening - pressure[k]);
    }
    if (!scene::has_friction(pair.law)) continue;
    auto& shear = loads.along_tangent[pair.first];
    shear = on_facet(pair.first, scene::tangent(normal(pair.first)));
    if (pair.second >= 0) {
      const auto across = on_facet(pair.second, scene::tangent(normal(pair.second)));
      for (int k = 0; k <= degree; ++k) shear[k] = (shear[k] + across[degree - k]) / 2;
    }
    const auto bound = shear_bound<Enclosure>(problem, contacts, pair, degree);
    const auto [shear0, shear1] = shear_load<double>(problem, pair);
    for (int k = 0; k <= degree; ++k) {
      const double most = std::max(0.0, lower(bound[k]));
      const double given = problem.perturbed.loads * scene::linear_coefficient<double>(shear0, shear1, degree, k);
      shear[k] = std::clamp(given - shear[k], -most, most);
    }
  }
  drop_noise(problem, loads);
  drop_idle_shear(problem, loads);
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    if (problem.facets[f].support == Support::fixed) continue;
    const int edge = mesh.boundary[f].edge;
    loads.edge[edge] = {Vector<2>::Zero(), Vector<2>::Zero()};
    for (int k = 2; k <= degree; ++k) loads.higher[(degree - 1) * edge + k - 2].setZero();
  }
  return loads;
}

PlainLoads no_loads(const scene::Problem<2>& problem, double pressure) {
  PlainLoads none;
  none.edge.assign(problem.mesh.edges.size(), {Vector<2>::Zero(), Vector<2>::Zero()});
  none.along_normal.assign(problem.facets.size(), {0, 0});
  none.along_tangent.resize(problem.facets.size());
  for (const auto& pair : problem.contact) {
    none.along_normal[pair.first] = {pressure, pressure};
    if (scene::has_friction(pair.law)) none.along_tangent[pair.first] = {0, 0};
  }
  return none;
}

std::vector<char> carrying_pairs(const scene::Problem<2>& problem, const PlainLoads& loads) {
  std::vector<char> carrying;
  for (const auto& pair : problem.contact) {
    carrying.resize(std::max<std::size_t>(carrying.size(), pair.pair + 1), 0);
    carrying[pair.pair] |= pair.law.two_sided;
    for (const double p : loads.along_normal[pair.first]) carrying[pair.pair] |= p > 0;
  }
  return carrying;
}

void drop_idle_shear(const scene::Problem<2>& problem, PlainLoads& loads) {
  const std::vector<char> carrying = carrying_pairs(problem, loads);
  for (const auto& pair : problem.contact)
    if (!carrying[pair.pair])
      for (double& t : loads.along_tangent[pair.first]) t = 0;
}

}  // namespace bracket::bounds
