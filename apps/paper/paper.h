// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "apps/paper/examples.h"
#include "apps/plots/picture.h"

/// What Haslinger & Hlaváček state in 1981, measured: a table for each statement.
namespace bracket::apps {

/// A table that is printed and kept in paper.json.
struct Table {
  struct Column {
    std::string name;
    std::string format;  ///< of fmt, for a double, without the braces
  };
  struct Row {
    std::string label;
    std::vector<double> values;  ///< as `columns`; NaN: none
  };
  std::string key;    ///< in paper.json
  std::string claim;  ///< what the paper states and what is measured; lines
  std::vector<Column> columns;
  std::vector<Row> rows = {};
};

/// Theorem 2.1: the constant c(α) against the smallest angle.
Table stress_by_loads();
/// Theorem 2.2: the interpolation r_h of the smooth stress of Example 1 on regular and irregular meshes.
Table interpolation();
/// Theorem 2.3: the error of the stresses on the meshes of Example 1.
Table stress_error(const std::vector<Measured>& measured);
/// Lemma 1.6, both ways: stresses in K⁺_{F,P} and stresses that break one of (1.18) … (1.22).
Table admissible_stresses();
/// (1.15): −S(σ) = L(u) for the exact solution, and how −S(λ_h) and L(u_h) approach each other.
Table equal_energies(const std::vector<Measured>& measured);
/// Stresses, pressures and contact zones of the two formulations against each other.
Table two_formulations(const std::vector<Measured>& measured);

std::string table_text(const Table& table);
std::string paper_json(const std::vector<Table>& tables);

/// The errors of interpolation() and stress_error() against h.
Picture paper_picture(const Table& interpolation, const Table& stress_error);

}  // namespace bracket::apps
