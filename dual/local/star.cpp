// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "dual/local/star.h"

#include <limits>

namespace bracket::dual {

namespace {

using scene::Support;
using scene::Vector;

/// The displacement of a facet's vertices by rigid motions about a point, rotations by `size`.
template <int dim>
Eigen::Matrix<double, n_facet_loads<dim>, scene::Simplex<dim>::n_rigid_motions> motions_of(
    const std::array<Vector<dim>, dim>& x, double size) {
  using Table = scene::Simplex<dim>;
  Eigen::Matrix<double, n_facet_loads<dim>, Table::n_rigid_motions> result;
  result.setZero();
  for (int j = 0; j < dim; ++j) {
    result.template block<dim, dim>(dim * j, 0).setIdentity();
    for (int r = 0; r < Table::n_rotations; ++r) {
      const auto [a, b] = Table::rotations[r];
      result(dim * j + a, dim + r) = -x[j][b] / size;
      result(dim * j + b, dim + r) = x[j][a] / size;
    }
  }
  return result;
}

}  // namespace

template <int dim> Facets<dim> facets_of(const scene::Problem<dim>& problem) {
  const auto& mesh = problem.mesh;
  Facets<dim> facets;
  facets.facet.resize(n_facets(mesh));
  for (std::size_t c = 0; c < mesh.cells.size(); ++c)
    for (int i = 0; i <= dim; ++i) {
      auto& vertices = facets.facet[cell_facets(mesh, static_cast<int>(c))[i]].vertices;
      const auto corners = sorted_corners<dim>(mesh.cells[c], i);
      for (int k = 0; k < dim; ++k) vertices[k] = mesh.cells[c][corners[k]];
    }
  for (std::size_t f = 0; f < mesh.boundary.size(); ++f) {
    auto& facet = facets.facet[cell_facets(mesh, mesh.boundary[f].cell)[mesh.boundary[f].local]];
    facet.boundary = static_cast<int>(f);
    facet.support = problem.facets[f].support;
  }
  return facets;
}

template <int dim> Stars stars_of(const scene::Mesh<dim>& mesh) {
  Stars stars;
  stars.first.assign(mesh.vertices.size() + 1, 0);
  for (const auto& cell : mesh.cells)
    for (const int v : cell) ++stars.first[v + 1];
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) stars.first[v + 1] += stars.first[v];
  stars.cell.resize(stars.first.back());
  std::vector<int> next(stars.first.begin(), stars.first.end() - 1);
  for (std::size_t c = 0; c < mesh.cells.size(); ++c)
    for (const int v : mesh.cells[c]) stars.cell[next[v]++] = static_cast<int>(c);
  return stars;
}

template <int dim>
Star<dim>::Star(const scene::Problem<dim>& problem, const Facets<dim>& facets, const Stars& stars, int vertex)
    : problem_(problem), facets_(facets), vertex_(vertex) {
  const auto& mesh = problem.mesh;
  const Vector<dim>& centre = mesh.vertices[vertex];
  cells_.assign(stars.cell.begin() + stars.first[vertex], stars.cell.begin() + stars.first[vertex + 1]);
  for (const int c : cells_) {
    const auto& vertices = mesh.cells[c];
    corner_.push_back(static_cast<int>(std::find(vertices.begin(), vertices.end(), vertex) - vertices.begin()));
    for (const int v : vertices) size_ = std::max(size_, (mesh.vertices[v] - centre).norm());
    for (int i = 0; i <= dim; ++i)
      if (i != corner_.back()) spokes_.push_back(cell_facets(mesh, c)[i]);
  }
  std::sort(spokes_.begin(), spokes_.end());
  spokes_.erase(std::unique(spokes_.begin(), spokes_.end()), spokes_.end());
  bool held = false;
  std::vector<Eigen::Matrix<double, 1, scene::Simplex<dim>::n_rigid_motions>> slides;
  for (const int f : spokes_) {
    const auto& facet = facets.facet[f];
    if (facet.boundary < 0) continue;
    held = held || facet.support == Support::fixed;
    if (facet.support != Support::sliding) continue;
    std::array<Vector<dim>, dim> x;
    for (int k = 0; k < dim; ++k) x[k] = mesh.vertices[facet.vertices[k]] - centre;
    const auto moved = motions_of<dim>(x, size_);
    for (int k = 0; k < dim; ++k)
      slides.push_back(problem.facets[facet.boundary].normal.transpose() * moved.template middleRows<dim>(dim * k));
  }
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    std::array<int, dim> own;
    for (int k = 0, place = 0; k <= dim; ++k) {
      if (k == corner_[i]) continue;
      const int f = cell_facets(mesh, cells_[i])[k];
      own[place++] = static_cast<int>(std::lower_bound(spokes_.begin(), spokes_.end(), f) - spokes_.begin());
    }
    cell_spokes_.push_back(own);
  }
  constexpr int m = scene::Simplex<dim>::n_rigid_motions;
  if (held) {
    motions_.resize(m, 0);
  } else if (slides.empty()) {
    motions_ = Motions<dim>::Identity(m, m);
  } else {
    Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(std::max<std::size_t>(m, slides.size()), m);
    for (std::size_t i = 0; i < slides.size(); ++i) rows.row(i) = slides[i];
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(rows, Eigen::ComputeFullV);
    int free = 0;
    constexpr double negligible = 1e-9;  // as scene::free_motions()
    for (int i = 0; i < m; ++i) free += svd.singularValues()[i] <= negligible * svd.singularValues()[0];
    motions_ = svd.matrixV().rightCols(free);
  }
}

template <int dim> std::array<Vector<dim>, dim> Star<dim>::arms(int spoke) const {
  std::array<Vector<dim>, dim> x;
  for (int k = 0; k < dim; ++k)
    x[k] = problem_.mesh.vertices[facets_.facet[spokes_[spoke]].vertices[k]] - problem_.mesh.vertices[vertex_];
  return x;
}

template <int dim> const scene::FacetData<dim>* Star<dim>::data(int spoke) const {
  const int boundary = facets_.facet[spokes_[spoke]].boundary;
  return boundary < 0 ? nullptr : &problem_.facets[boundary];
}

template <int dim>
StarData<dim>::StarData(const Star<dim>& star)
    : gradient(star.cells().size(), Spokes::Zero()),
      resultant(star.cells().size(), Eigen::Matrix<double, scene::Simplex<dim>::n_rigid_motions, 1>::Zero()),
      sum(star.spokes().size(), FacetVector<dim>::Zero()),
      prescribed(star.spokes().size(), FacetVector<dim>::Zero()) {}

template <int dim>
StarSystem<dim>::StarSystem(const Star<dim>& star, const std::vector<Energy<dim>>& energy)
    : star_(star),
      unknown_(star.spokes().size(), -1),
      normal_(star.spokes().size(), nullptr),
      response_(star.cells().size()),
      forced_(star.cells().size()) {
  for (std::size_t c = 0; c < star.cells().size(); ++c) set_form(c, energy[star.cells()[c]].loads);
  int n = 0, last = -1;
  for (std::size_t f = 0; f < star.spokes().size(); ++f) {
    const scene::FacetData<dim>* data = star.data(static_cast<int>(f));
    if (data && data->support == Support::fixed) continue;
    unknown_[f] = n++;
    if (data && data->support == Support::sliding)
      normal_[f] = &data->normal;
    else
      last = unknown_[f];
  }
  if (n == 0) return;
  matrix_ = BlockCholesky<Block>(n);
  for (std::size_t c = 0; c < star.cells().size(); ++c)
    for (const int f : star.spokes_of(c))
      for (const int g : star.spokes_of(c))
        if (unknown_[f] >= 0 && unknown_[g] >= 0) matrix_.connect(unknown_[f], unknown_[g]);
  matrix_.order(last < 0 ? n - 1 : last);
  assemble();
  if (!matrix_.factorise()) throw NotDefinite{star.vertex()};
}

/// By Cholesky: H = L Lᵀ, B L⁻ᵀ = (Q R)ᵀ for the resultants B of the loads.
template <int dim> void StarSystem<dim>::set_form(std::size_t cell, const CellForm<dim>& energy) {
  constexpr int n = n_spoke_loads<dim>, one = n_facet_loads<dim>, m = scene::Simplex<dim>::n_rigid_motions;
  const auto facet = [&](int i) { return i < star_.corner(cell) ? i : i + 1; };
  Response own;
  for (int i = 0; i < dim; ++i)
    for (int j = 0; j < dim; ++j)
      own.template block<one, one>(one * i, one * j) = energy.template block<one, one>(one * facet(i), one * facet(j));
  Eigen::Matrix<double, n, m> balance;
  for (int i = 0; i < dim; ++i)
    balance.template middleRows<one>(one * i) = resultants<dim>(star_.arms(star_.spokes_of(cell)[i])).transpose();
  const Eigen::LLT<Response> factor(own);
  Response inverse = Response::Identity();
  factor.matrixL().solveInPlace(inverse);
  const Eigen::HouseholderQR<Eigen::Matrix<double, n, m>> qr(factor.matrixL().solve(balance));
  const Eigen::Matrix<double, n, m> q = qr.householderQ() * Eigen::Matrix<double, n, m>::Identity();
  const Eigen::Matrix<double, m, m> upper = qr.matrixQR().template topRows<m>();
  forced_[cell] = inverse.transpose() *
                  upper.template triangularView<Eigen::Upper>().transpose().template solve<Eigen::OnTheRight>(q);
  inverse -= (q * (q.transpose() * inverse)).eval();
  response_[cell].noalias() = inverse.transpose() * inverse;
}

/// Takes what is along the normal of a spoke out of rows that are of its loads.
template <int dim> template <class Rows> void StarSystem<dim>::make_tangential(int spoke, Rows&& rows) const {
  if (!normal_[spoke]) return;
  const Vector<dim>& d = *normal_[spoke];
  for (int k = 0; k < dim; ++k) {
    auto part = rows.template middleRows<dim>(dim * k);
    part -= (d * ((d.transpose() * part) / d.squaredNorm())).eval();
  }
}

template <int dim> void StarSystem<dim>::assemble() {
  constexpr int one = n_facet_loads<dim>;
  for (std::size_t c = 0; c < response_.size(); ++c) {
    const auto& own = star_.spokes_of(c);
    for (int i = 0; i < dim; ++i)
      for (int k = 0; k <= i; ++k) {
        if (unknown_[own[i]] < 0 || unknown_[own[k]] < 0) continue;
        Block block = response_[c].template block<one, one>(one * i, one * k);
        make_tangential(own[i], block);
        block.transposeInPlace();
        make_tangential(own[k], block);
        matrix_.add(unknown_[own[k]], unknown_[own[i]], block);
      }
  }
  int last = 0;
  for (std::size_t f = 0; f < unknown_.size(); ++f) {
    if (unknown_[f] < 0) continue;
    if (unknown_[f] == matrix_.last()) last = static_cast<int>(f);
    if (!normal_[f]) continue;
    Block& diagonal = matrix_.diagonal(unknown_[f]);
    const double scale = diagonal.trace() / one;
    for (int k = 0; k < dim; ++k)
      diagonal.template block<dim, dim>(dim * k, dim * k) += scale * (*normal_[f]) * normal_[f]->transpose();
  }
  // The displacements are known up to motions that nothing holds: these are held where it costs no fill.
  if (star_.motions().cols() == 0) return;
  const Eigen::MatrixXd moved = motions_of<dim>(star_.arms(last), star_.size()) * star_.motions();
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(moved);
  const Eigen::MatrixXd q = qr.householderQ() * Eigen::MatrixXd::Identity(one, moved.cols());
  Block& diagonal = matrix_.diagonal(matrix_.last());
  diagonal += diagonal.trace() / one * q * q.transpose();
}

template <int dim> typename StarSystem<dim>::Solution StarSystem<dim>::solve(const StarData<dim>& data) const {
  constexpr int one = n_facet_loads<dim>;
  Solution found{std::vector<Spokes>(response_.size()), data.prescribed};
  std::vector<FacetVector<dim>> right(matrix_.size());
  for (std::size_t f = 0; f < unknown_.size(); ++f) {
    if (unknown_[f] >= 0 && !normal_[f]) found.displacement[f].setZero();
    if (unknown_[f] >= 0) right[unknown_[f]] = data.sum[f];
  }
  const auto displacement_of = [&](std::size_t c) {
    Spokes displacement;
    for (int i = 0; i < dim; ++i)
      displacement.template segment<one>(one * i) = found.displacement[star_.spokes_of(c)[i]];
    return displacement;
  };
  for (std::size_t c = 0; c < response_.size(); ++c) {
    found.loads[c] = response_[c] * (displacement_of(c) - data.gradient[c]) + forced_[c] * data.resultant[c];
    for (int i = 0; i < dim; ++i)
      if (const int f = unknown_[star_.spokes_of(c)[i]]; f >= 0)
        right[f] -= found.loads[c].template segment<one>(one * i);
  }
  if (right.empty()) return found;
  for (std::size_t f = 0; f < unknown_.size(); ++f)
    if (unknown_[f] >= 0) make_tangential(static_cast<int>(f), right[unknown_[f]]);
  matrix_.solve(right);
  for (std::size_t f = 0; f < unknown_.size(); ++f) {
    if (unknown_[f] < 0) continue;
    make_tangential(static_cast<int>(f), right[unknown_[f]]);
    found.displacement[f] += right[unknown_[f]];
  }
  for (std::size_t c = 0; c < response_.size(); ++c) {
    Spokes added = Spokes::Zero();
    for (int i = 0; i < dim; ++i)
      if (const int f = unknown_[star_.spokes_of(c)[i]]; f >= 0) added.template segment<one>(one * i) = right[f];
    found.loads[c].noalias() += response_[c] * added;
  }
  return found;
}

#define INSTANTIATE(dim)                                      \
  template Facets<dim> facets_of(const scene::Problem<dim>&); \
  template Stars stars_of(const scene::Mesh<dim>&);           \
  template class Star<dim>;                                   \
  template struct StarData<dim>;                              \
  template class StarSystem<dim>;
INSTANTIATE(2)
INSTANTIATE(3)
#undef INSTANTIATE

}  // namespace bracket::dual
