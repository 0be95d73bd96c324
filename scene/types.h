// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <stdexcept>
#include <string>

/// Plain types, in the units of the scene, and what users are told.
namespace bracket::scene {

/// A point, displacement, force or traction, in the units of the scene.
template <int dim> using Vector = Eigen::Matrix<double, dim, 1>;
template <int dim> inline constexpr int n_voigt = dim*(dim + 1) / 2;
/// A stress (s11, s22, s12) or a strain (e11, e22, 2 e12).
template <int dim> using Voigt = Eigen::Matrix<double, n_voigt<dim>, 1>;
/// A stiffness (stress by strain) or a compliance (strain by stress) in the notation of `Voigt`.
template <int dim> using Elasticity = Eigen::Matrix<double, n_voigt<dim>, n_voigt<dim>>;

/// How a command ends; the values are the exit statuses of the program.
enum class Status { done = 0, internal = 1, input = 2, mesh = 3, ill_posed = 4, budget = 5, not_guaranteed = 6 };

/// Something that the user can mend. what() is one line: where, what is wrong, what was expected.
class Error : public std::runtime_error {
 public:
  Error(Status status, const std::string& message) : Error(status, "", message) {}
  Error(Status status, const std::string& where, const std::string& message)
      : std::runtime_error(where.empty() ? message : where + ": " + message), status_(status), where_(where) {}
  Status status() const { return status_; }
  /// "file", "file:line", "file:line:column", or "--set key=value", the override that it comes from; empty: no place.
  const std::string& where() const { return where_; }
  /// what() without the place.
  std::string message() const { return what() + (where_.empty() ? 0 : where_.size() + 2); }

 private:
  Status status_;
  std::string where_;
};

}  // namespace bracket::scene
