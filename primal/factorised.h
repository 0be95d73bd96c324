// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>

#include "primal/primal.h"
#include "primal/systems.h"

namespace bracket::primal {

template <int dim> struct Solver<dim>::Factorised {
  Nodes<dim> nodes;
  bool any_gap;
  std::vector<Row> rows;
  std::vector<Eigen::SparseMatrix<double>> held;  ///< as Systems::held
  contact::Bodies bodies;
  double order, assemble;  ///< seconds

  /// The nodes of a problem, with its prescribed displacements. \throw std::invalid_argument where others are unknown
  Nodes<dim> own_nodes(const scene::Problem<dim>& problem) const {
    Nodes<dim> own = make_nodes(problem, nodes.degree);
    if (own.body_nodes != nodes.body_nodes)
      throw std::invalid_argument("primal: the problem has other unknowns than the one that was factorised");
    return own;
  }
  /// f of each body. \param of the problem's own nodes
  std::vector<Eigen::VectorXd> forces(const scene::Problem<dim>& problem, const Nodes<dim>& of) const {
    std::vector<Eigen::VectorXd> result = loads(problem, of);
    const Eigen::VectorXd given = prescribed(of);
    for (std::size_t b = 0; b < result.size(); ++b) result[b] -= held[b] * given;
    if (const auto& systems = bodies.systems(); systems.size() > result.size())  // springs
      result.push_back(Eigen::VectorXd::Zero(systems.back().stiffness.rows()));
    return result;
  }
};

/// The values at equally spaced points of the polynomials with the coefficients found.
template <int dim>
scene::Displacement<dim> recover(const scene::Mesh<dim>& mesh, const Nodes<dim>& nodes,
                                 const std::vector<Eigen::VectorXd>& unknowns);

}  // namespace bracket::primal
