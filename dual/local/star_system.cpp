// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "dual/local/star_system.h"

#include <limits>

namespace bracket::dual {

using scene::Support;
using scene::Vector;

template <int dim>
StarData<dim>::StarData(const Star<dim>& star)
    : gradient(star.cells().size(), Spokes::Zero()),
      resultant(star.cells().size(), Eigen::Matrix<double, scene::Simplex<dim>::n_rigid_motions, 1>::Zero()),
      sum(star.spokes().size(), FacetVector<dim>::Zero()),
      prescribed(star.spokes().size(), FacetVector<dim>::Zero()) {}

template <int dim>
StarSystem<dim>::StarSystem(const Star<dim>& star, const Energies<dim>& energy)
    : star_(star),
      energy_(energy),
      unknown_(star.spokes().size(), -1),
      normal_(star.spokes().size(), nullptr),
      opposite_(star.cells().size()),
      balance_root_(star.cells().size()) {
  int n = 0, last = -1;
  for (std::size_t f = 0; f < star.spokes().size(); ++f) {
    const auto& spoke = star.spoke(f);
    if (spoke.boundary >= 0 && spoke.support == Support::fixed) continue;
    unknown_[f] = n++;
    if (spoke.boundary >= 0 && spoke.support == Support::sliding)
      normal_[f] = &spoke.normal;
    else
      last = unknown_[f];
  }
  matrix_ = BlockCholesky<Block>(n);
  for (std::size_t c = 0; c < star.cells().size(); ++c)
    for (const int f : star.spokes_of(c))
      for (const int g : star.spokes_of(c))
        if (unknown_[f] >= 0 && unknown_[g] >= 0) matrix_.connect(unknown_[f], unknown_[g]);
  matrix_.order(last < 0 ? n - 1 : last);
  in_lanes([&](auto lanes) {
    for (std::size_t c = 0; c < star.cells().size(); ++c) add(c, this->template set_form<lanes>(c));
  });
  if (n == 0) return;
  hold_what_slides();
  if (!in_lanes([&](auto lanes) { return matrix_.template factorise<lanes>(); })) throw NotDefinite{star.vertex()};
}

/// The resultants of the loads on a cell's spokes, moments about the vertex.
template <int dim> typename StarSystem<dim>::Balance StarSystem<dim>::balance(std::size_t cell) const {
  constexpr int one = n_facet_loads<dim>;
  Balance result;
  for (int i = 0; i < dim; ++i)
    result.template middleCols<one>(one * i) = resultants<dim>(star_.arms(star_.spokes_of(cell)[i]));
  return result;
}

/// The facet opposite to the vertex moves such that its loads are zero.
template <int dim> template <int lanes> typename StarSystem<dim>::Response StarSystem<dim>::set_form(std::size_t cell) {
  const int corner = star_.corner(cell);
  const CellForm<dim>& stiffness = energy_[star_.cells()[cell]].stiffness;
  Block& opposite = opposite_[cell];
  opposite = stiffness.at(corner, corner);
  if (!dual::factorise(opposite)) throw NotDefinite{star_.vertex()};
  Response response;
  std::array<Block, dim> by_opposite;
  for (int i = 0; i < dim; ++i) {
    by_opposite[i] = stiffness.rows_of(facet_at(corner, i), corner);
    divide<lanes>(by_opposite[i], opposite);
    for (int k = 0; k <= i; ++k) response.at(i, k) = stiffness.at(facet_at(corner, i), facet_at(corner, k));
    for (int k = 0; k < i; ++k) subtract_product<lanes>(response.at(i, k), by_opposite[i], by_opposite[k]);
    subtract_square<lanes>(response.at(i, i), by_opposite[i]);
  }
  const Balance of_cell = balance(cell);
  balance_root_[cell] = of_cell.lazyProduct(of_cell.transpose());
  if (!dual::factorise(balance_root_[cell])) throw NotDefinite{star_.vertex()};
  return response;
}

/// The same response, without a matrix of its own.
template <int dim>
typename StarSystem<dim>::Spokes StarSystem<dim>::respond(std::size_t cell, const Spokes& slope) const {
  const int corner = star_.corner(cell);
  const CellForm<dim>& stiffness = energy_[star_.cells()[cell]].stiffness;
  FacetVector<dim> motion = -opposite_times<dim>(stiffness, corner, slope);
  solve_lower(opposite_[cell], motion);
  solve_upper(opposite_[cell], motion);
  Spokes loads = times<dim>(stiffness, corner, slope);
  add_by_opposite<dim>(stiffness, corner, motion, loads);
  return loads;
}

/// Adds to the loads of a cell the smallest that have a resultant. \param of_cell its balance
template <int dim>
void StarSystem<dim>::add_shortest(std::size_t cell, const Balance& of_cell, const Resultant& resultant,
                                   Spokes& loads) const {
  Resultant amount = resultant;
  solve_lower(balance_root_[cell], amount);
  solve_upper(balance_root_[cell], amount);
  loads += of_cell.transpose().lazyProduct(amount);
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

template <int dim> void StarSystem<dim>::add(std::size_t cell, const Response& response) {
  const auto& own = star_.spokes_of(cell);
  for (int i = 0; i < dim; ++i)
    for (int k = 0; k <= i; ++k) {
      if (unknown_[own[i]] < 0 || unknown_[own[k]] < 0) continue;
      if (!normal_[own[i]] && !normal_[own[k]]) {
        matrix_.add(unknown_[own[i]], unknown_[own[k]], response.at(i, k));
        continue;
      }
      Block block = response.at(i, k);
      if (i == k) block = response.at(i, i).template selfadjointView<Eigen::Lower>();
      make_tangential(own[i], block);
      block.transposeInPlace();
      make_tangential(own[k], block);
      matrix_.add(unknown_[own[k]], unknown_[own[i]], block);
    }
}

template <int dim> void StarSystem<dim>::hold_what_slides() {
  constexpr int one = n_facet_loads<dim>;
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
  Solution found{std::vector<Spokes>(opposite_.size()), data.prescribed};
  for (std::size_t f = 0; f < unknown_.size(); ++f)
    if (unknown_[f] >= 0 && !normal_[f]) found.displacement[f].setZero();
  for (std::size_t c = 0; c < opposite_.size(); ++c) {
    Spokes slope = -data.gradient[c];
    for (int i = 0; i < dim; ++i) slope.template segment<one>(one * i) += found.displacement[star_.spokes_of(c)[i]];
    Spokes& loads = found.loads[c];
    loads.setZero();
    if (!data.resultant[c].isZero(0)) {
      add_shortest(c, balance(c), data.resultant[c], loads);
      slope -= times<dim>(energy_[star_.cells()[c]].loads, star_.corner(c), loads);
    }
    loads += respond(c, slope);
  }
  // Rounding of the cells' stiffness leaves a balance worth less than the loads' last digits: what is lacking is handed
  // out in the same way, until that is of no more use.
  double before = handed_out(data, found), lacking = handed_out(data, found);
  while (lacking > 0 && lacking < before / 2) {
    before = lacking;
    lacking = handed_out(data, found);
  }
  return found;
}

/// Hands out what the loads of a solution lack, in two steps: to each cell by itself, then between them.
/// \return the largest load or resultant (moments by the star's size) that was lacking; 0: none that is more than
///     rounding of their sums, and nothing was done between the cells
template <int dim> double StarSystem<dim>::handed_out(const StarData<dim>& data, Solution& found) const {
  constexpr int one = n_facet_loads<dim>;
  double lacking = 0, largest = 0;
  std::vector<FacetVector<dim>> right(matrix_.size());
  for (std::size_t f = 0; f < unknown_.size(); ++f)
    if (unknown_[f] >= 0) right[unknown_[f]] = data.sum[f];
  for (std::size_t c = 0; c < opposite_.size(); ++c) {
    const Balance of_cell = balance(c);
    const Resultant rest = data.resultant[c] - of_cell.lazyProduct(found.loads[c]);
    lacking = std::max(
        {lacking, rest.template head<dim>().template lpNorm<Eigen::Infinity>(),
         rest.template tail<scene::Simplex<dim>::n_rotations>().template lpNorm<Eigen::Infinity>() / star_.size()});
    add_shortest(c, of_cell, rest, found.loads[c]);
    largest = std::max(largest, found.loads[c].template lpNorm<Eigen::Infinity>());
    for (int i = 0; i < dim; ++i)
      if (const int f = unknown_[star_.spokes_of(c)[i]]; f >= 0)
        right[f] -= found.loads[c].template segment<one>(one * i);
  }
  for (std::size_t f = 0; f < unknown_.size(); ++f) {
    if (unknown_[f] < 0) continue;
    make_tangential(static_cast<int>(f), right[unknown_[f]]);
    lacking = std::max(lacking, right[unknown_[f]].template lpNorm<Eigen::Infinity>());
  }
  constexpr double rounding = n_spoke_loads<dim> * std::numeric_limits<double>::epsilon();
  if (right.empty() || lacking <= rounding * largest) return 0;
  matrix_.solve(right);
  for (std::size_t f = 0; f < unknown_.size(); ++f) {
    if (unknown_[f] < 0) continue;
    make_tangential(static_cast<int>(f), right[unknown_[f]]);
    found.displacement[f] += right[unknown_[f]];
  }
  for (std::size_t c = 0; c < opposite_.size(); ++c) {
    Spokes added = Spokes::Zero();
    for (int i = 0; i < dim; ++i)
      if (const int f = unknown_[star_.spokes_of(c)[i]]; f >= 0) added.template segment<one>(one * i) = right[f];
    found.loads[c] += respond(c, added);
  }
  return lacking;
}

template <int dim>
std::vector<FacetVector<dim>> StarSystem<dim>::moved_by(int spoke, const FacetVector<dim>& sum) const {
  std::vector<FacetVector<dim>> right(matrix_.size(), FacetVector<dim>::Zero());
  right[unknown_[spoke]] = sum;
  matrix_.solve(right);
  std::vector<FacetVector<dim>> moved(unknown_.size(), FacetVector<dim>::Zero());
  for (std::size_t f = 0; f < unknown_.size(); ++f) {
    if (unknown_[f] < 0) continue;
    moved[f] = right[unknown_[f]];
    make_tangential(static_cast<int>(f), moved[f]);
  }
  return moved;
}

template struct StarData<2>;
template struct StarData<3>;
template class StarSystem<2>;
template class StarSystem<3>;

}  // namespace bracket::dual
