// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/hybrid.h"

#include <limits>

#include "dual/local/star.h"

namespace bracket::tests {

namespace {

using dual::CellVector;
using dual::FacetVector;
using scene::Support;
using scene::Vector;

template <int dim> inline constexpr int one = dual::n_facet_loads<dim>;
template <int dim> inline constexpr int n_motions = scene::Simplex<dim>::n_rigid_motions;

/// The displacements of a facet, by moments: prescribed + free · unknowns.
template <int dim> struct Displaced {
  FacetVector<dim> prescribed = FacetVector<dim>::Zero();
  Eigen::MatrixXd free = Eigen::MatrixXd::Identity(one<dim>, one<dim>);
  int component = -1, node = -1, unknown = -1;
};

template <int dim> Vector<dim> along_normal(const scene::FacetData<dim>& data, double value) {
  return value / data.normal.squaredNorm() * data.normal;
}

/// Directions at right angles to d.
template <int dim> Eigen::MatrixXd tangents(const Vector<dim>& d) {
  const Eigen::MatrixXd column = d;
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(column);
  const Eigen::MatrixXd q = qr.householderQ();
  return q.rightCols(dim - 1);
}

template <int dim>
std::vector<Displaced<dim>> displaced(const scene::Problem<dim>& problem, const dual::Facets<dim>& facets,
                                      std::vector<std::vector<int>>& nodes) {
  const auto& mesh = problem.mesh;
  std::vector<Displaced<dim>> result(facets.facet.size());
  const Eigen::Matrix<double, dim, dim> masses = dual::hat_masses<dim>();
  nodes.assign(mesh.components.size(), {0});
  for (std::size_t c = 0; c < mesh.cells.size(); ++c)
    for (const int f : cell_facets(mesh, static_cast<int>(c))) {
      Displaced<dim>& own = result[f];
      if (own.component >= 0) continue;
      own.component = mesh.cell_component[c];
      const int boundary = facets.facet[f].boundary;
      if (boundary >= 0) {
        const auto& data = problem.facets[boundary];
        const bool fixed = data.support == Support::fixed, slides = data.support == Support::sliding;
        for (int k = 0; k < dim && (fixed || slides); ++k) {
          const Vector<dim> u = fixed ? data.displacement[k] : along_normal<dim>(data, data.normal_displacement[k]);
          const int at = dual::slot(facets, f, mesh.boundary[boundary].vertices[k]);
          for (int j = 0; j < dim; ++j) own.prescribed.template segment<dim>(dim * j) += masses(j, at) * u;
        }
        if (fixed) own.free.resize(one<dim>, 0);
        if (slides) {
          own.free = Eigen::MatrixXd::Zero(one<dim>, dim * (dim - 1));
          for (int k = 0; k < dim; ++k)
            own.free.block(dim * k, (dim - 1) * k, dim, dim - 1) = tangents<dim>(data.normal);
        }
      }
      auto& offsets = nodes[own.component];
      own.node = static_cast<int>(offsets.size()) - 1;
      own.unknown = offsets.back();
      offsets.push_back(offsets.back() + static_cast<int>(own.free.cols()));
    }
  return result;
}

/// D = response · (μ − gradient) + forced of a cell's loads D.
template <int dim> struct CellResponse {
  Eigen::MatrixXd response;
  CellVector<dim> rest;  ///< of μ = 0
};
template <int dim> CellResponse<dim> response_of(const scene::Problem<dim>& problem, int cell) {
  const auto& mesh = problem.mesh;
  const dual::Energy<dim> energy = dual::energy_of(problem, cell);
  const Vector<dim> centre = mesh.vertices[mesh.cells[cell][0]];
  Eigen::MatrixXd balance(n_motions<dim>, dual::n_cell_loads<dim>);
  Vector<dim> arm = Vector<dim>::Zero();
  for (int i = 0; i <= dim; ++i) {
    std::array<Vector<dim>, dim> x;
    const auto corners = dual::sorted_corners<dim>(mesh.cells[cell], i);
    for (int k = 0; k < dim; ++k) x[k] = mesh.vertices[mesh.cells[cell][corners[k]]] - centre;
    balance.middleCols(one<dim> * i, one<dim>) = dual::resultants<dim>(x);
    arm += (mesh.vertices[mesh.cells[cell][i]] - centre) / (dim + 1);
  }
  const Vector<dim> weight = scene::volume(mesh, cell) * body_of(problem, cell).force;
  Eigen::VectorXd resultant(n_motions<dim>);
  resultant.head(dim) = -weight;
  for (int r = 0; r < scene::Simplex<dim>::n_rotations; ++r) {
    const auto [i, j] = scene::Simplex<dim>::rotations[r];
    resultant[dim + r] = -(arm[i] * weight[j] - arm[j] * weight[i]);
  }
  Eigen::MatrixXd form(balance.cols(), balance.cols());
  for (int i = 0; i <= dim; ++i)
    for (int k = 0; k <= dim; ++k)
      form.block(one<dim> * i, one<dim> * k, one<dim>, one<dim>) = energy.loads.rows_of(i, k);
  const Eigen::LLT<Eigen::MatrixXd> factor(form);
  const Eigen::MatrixXd inverse = factor.solve(Eigen::MatrixXd::Identity(balance.cols(), balance.cols()));
  const Eigen::MatrixXd lifted = inverse * balance.transpose();
  const Eigen::MatrixXd schur = (balance * lifted).inverse();
  CellResponse<dim> result;
  result.response = inverse - lifted * schur * lifted.transpose();
  result.rest = lifted * schur * resultant - result.response * (energy.by_body_force * body_of(problem, cell).force);
  return result;
}

template <int dim> double gap_moment(const scene::Mesh<dim>& mesh, const scene::ContactFacetOf<dim>& pair, int k) {
  const double size = scene::area_vector<dim>(scene::positions(mesh, mesh.boundary[pair.first].vertices)).norm();
  double sum = 0;
  for (std::size_t i = 0; i < pair.upper.size(); ++i) {
    const int at = static_cast<int>(i);
    if (dim == 2) {  // from end to end
      sum += (at == 1 ? 2 : at == 2 * k ? 3 : 1) / 12.0 * pair.upper[i];
    } else {  // vertices, then the edges opposite to them
      sum += (at < 3 ? (at == k ? 3 : 1) : (at - 3 == k ? 1 : 2)) / 30.0 * pair.upper[i];
    }
  }
  return size * sum;
}

}  // namespace

template <int dim> Hybrid<dim> hybrid(const scene::Problem<dim>& problem) {
  const auto& mesh = problem.mesh;
  const dual::Facets<dim> facets = dual::facets_of(problem);
  std::vector<std::vector<int>> nodes;
  const std::vector<Displaced<dim>> at = displaced(problem, facets, nodes);
  const std::size_t bodies = mesh.components.size();
  std::vector<std::vector<Eigen::Triplet<double>>> stiffness(bodies), rows(bodies);
  std::vector<Eigen::VectorXd> loads;
  for (const auto& offsets : nodes) loads.push_back(Eigen::VectorXd::Zero(offsets.back()));
  std::vector<CellResponse<dim>> responses;
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    const int cell = static_cast<int>(c);
    responses.push_back(response_of(problem, cell));
    CellVector<dim> prescribed;
    for (int i = 0; i <= dim; ++i)
      prescribed.template segment<one<dim>>(one<dim> * i) = at[cell_facets(mesh, cell)[i]].prescribed;
    const CellVector<dim> known = responses.back().response * prescribed + responses.back().rest;
    const int body = mesh.cell_component[c];
    for (int i = 0; i <= dim; ++i) {
      const Displaced<dim>& own = at[cell_facets(mesh, cell)[i]];
      loads[body].segment(own.unknown, own.free.cols()) -=
          own.free.transpose() * known.template segment<one<dim>>(one<dim> * i);
      for (int k = 0; k <= dim; ++k) {
        const Displaced<dim>& other = at[cell_facets(mesh, cell)[k]];
        const Eigen::MatrixXd block =
            own.free.transpose() *
            responses.back().response.template block<one<dim>, one<dim>>(one<dim> * i, one<dim> * k) * other.free;
        for (Eigen::Index r = 0; r < block.rows(); ++r)
          for (Eigen::Index s = 0; s < block.cols(); ++s)
            if (own.unknown + r >= other.unknown + s)
              stiffness[body].emplace_back(own.unknown + r, other.unknown + s, block(r, s));
      }
    }
  }
  const auto number = [&](int f) { return cell_facets(mesh, mesh.boundary[f].cell)[mesh.boundary[f].local]; };
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    if (!scene::is_loaded(problem.facets[f])) continue;
    const auto given = scene::load(problem, static_cast<int>(f));
    const Displaced<dim>& own = at[number(f)];
    for (int k = 0; k < dim; ++k)
      loads[own.component].segment(own.unknown + dim * dual::slot(facets, number(f), mesh.boundary[f].vertices[k]),
                                   dim) += given[k];
  }
  const auto n_rows = static_cast<Eigen::Index>(dim * problem.contact.size());
  Eigen::VectorXd gaps(n_rows);
  contact::Limits limits{Eigen::VectorXd::Zero(n_rows),
                         Eigen::VectorXd::Constant(n_rows, std::numeric_limits<double>::infinity())};
  for (std::size_t j = 0; j < problem.contact.size(); ++j) {
    const auto& pair = problem.contact[j];
    const double size = scene::area_vector<dim>(scene::positions(mesh, mesh.boundary[pair.first].vertices)).norm();
    for (int k = 0; k < dim; ++k) {
      const int row = dim * static_cast<int>(j) + k;
      gaps[row] = gap_moment(mesh, pair, k);
      if (pair.law.two_sided) limits.lower[row] = -limits.upper[row];
      const auto add = [&](int f, int vertex, double sign) {
        const Displaced<dim>& own = at[number(f)];
        const int first = own.unknown + dim * dual::slot(facets, number(f), mesh.boundary[f].vertices[vertex]);
        for (int c = 0; c < dim; ++c)
          rows[own.component].emplace_back(row, first + c, sign * size * problem.facets[pair.first].normal[c]);
      };
      add(pair.first, k, 1);
      if (pair.second >= 0) add(pair.second, pair.meets[k], -1);
    }
  }
  std::vector<contact::System> systems(bodies);
  for (std::size_t b = 0; b < bodies; ++b) {
    const int n = nodes[b].back();
    systems[b].nodes = nodes[b];
    systems[b].stiffness.resize(n, n);
    systems[b].stiffness.setFromTriplets(stiffness[b].begin(), stiffness[b].end());
    systems[b].rows.resize(n_rows, n);
    systems[b].rows.setFromTriplets(rows[b].begin(), rows[b].end());
    const auto motions = scene::free_motions(problem, static_cast<int>(b));
    systems[b].rigid = Eigen::MatrixXd::Zero(n, motions.size());
    const Eigen::Matrix<double, dim, dim> masses = dual::hat_masses<dim>();
    for (std::size_t f = 0; f < at.size(); ++f)
      for (std::size_t m = 0; m < motions.size() && at[f].component == static_cast<int>(b); ++m) {
        FacetVector<dim> moved = FacetVector<dim>::Zero();
        for (int k = 0; k < dim; ++k)
          for (int j = 0; j < dim; ++j)
            moved.template segment<dim>(dim * j) +=
                masses(j, k) * displacement(motions[m], mesh.vertices[facets.facet[f].vertices[k]]);
        systems[b].rigid.block(at[f].unknown, m, at[f].free.cols(), 1) = at[f].free.transpose() * moved;
      }
  }
  const contact::Bodies all(std::move(systems));
  const contact::Solution solution = all.solve(loads, gaps, {}, limits);
  Hybrid<dim> result{solution.termination, {}};
  if (solution.termination != contact::Termination::solved) return result;
  result.stress.cell.resize(mesh.cells.size());
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    const int cell = static_cast<int>(c);
    CellVector<dim> displacement;
    for (int i = 0; i <= dim; ++i) {
      const Displaced<dim>& own = at[cell_facets(mesh, cell)[i]];
      displacement.template segment<one<dim>>(one<dim> * i) =
          own.prescribed + own.free * solution.elastic[own.component].segment(own.unknown, own.free.cols());
    }
    const auto block =
        dual::stress_of<dim>(mesh.cells[c], dual::geometry_of(mesh, cell),
                             responses[c].response * displacement + responses[c].rest, body_of(problem, cell).force);
    for (const auto& part : block)
      for (const auto& tensor : part)
        result.stress.cell[c].push_back(Eigen::Map<const scene::Voigt<dim>>(tensor.data()));
  }
  return result;
}

template Hybrid<2> hybrid(const scene::Problem<2>&);
template Hybrid<3> hybrid(const scene::Problem<3>&);

}  // namespace bracket::tests
