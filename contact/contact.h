// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <Eigen/Sparse>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

/// Elastic bodies in contact, reduced to their common interface (docs/theory.md §5): bodies as sparse systems in,
/// pressures, displacements and rigid motions out. Knows no finite element: both formulations come here.
namespace bracket::contact {

/// One body: K u = f − Bᵀ p, where u are its unknowns, f the load and p the multipliers of all contact rows.
struct System {
  Eigen::SparseMatrix<double> stiffness;  ///< K, n × n, lower triangle; its kernel is spanned by `rigid`
  std::vector<int> nodes;  ///< unknowns nodes[i] … nodes[i+1]−1 share their neighbours; begins with 0, ends
                           ///< with n
  Eigen::SparseMatrix<double> rows;  ///< B, m × n; the approach is r = Σ B u over the bodies
  Eigen::MatrixXd rigid;             ///< R, n × k: the rigid motions that the supports leave, k = 0 … 6
  std::vector<int> sequence = {};    ///< in which the nodes are eliminated, but for contact's; empty: as they are
};

/// Limits of the multipliers, row by row: lower ≤ p ≤ upper, −∞ or ∞ where there is none. Both empty: all [0, ∞).
///     [0, ∞)   unilateral contact: the row may open
///     (−∞, ∞)  bilateral: the row stays closed, p of either sign
///     [−b, b]  friction up to b ≥ 0: the row sticks while |p| < b; with b = 0 it carries nothing
struct Limits {
  Eigen::VectorXd lower, upper;
};

/// Seconds spent, by phase.
struct Phases {
  double assemble = 0;
  double order = 0;  ///< fill-reducing ordering and symbolic factorisation
  double factorise = 0;
  double contact = 0;  ///< condensation and the interface problem
  double recover = 0;  ///< the fields
};

/// What one formulation had to solve on one mesh, and what it took.
struct Statistics {
  int unknowns = 0;  ///< displacements, of nodes or edges, that are not prescribed
  int rows = 0;      ///< of contact
  int active_rows = 0;
  int iterations = 0;    ///< of the active set, or Uzawa's
  double imbalance = 0;  ///< see Solution
  Phases seconds;
};

enum class Termination {
  solved,
  no_equilibrium,  ///< no p within its limits balances the loads: `motion` gains energy without end
  contradiction,   ///< no u satisfies all rows: r ≤ g, or r = g where p has no limits, cannot be met
  not_converged,   ///< an iteration in place of Bodies::solve() came to its limit; that itself ends after finitely many
                   ///< steps
  not_definite     ///< in floating point a stiffness is not positive definite beside its rigid motions (`body` says
                   ///< which) or the contact holds a rigid motion by rounding only (`body` is −1)
};

struct Solution {
  Termination termination = Termination::solved;
  std::vector<Eigen::VectorXd> displacement;  ///< u of each body
  /// u less its rigid motion: strains and stresses come from it free of the rounding that a large motion brings (a
  /// stiff body on a soft one).
  std::vector<Eigen::VectorXd> elastic;
  Eigen::VectorXd pressure;  ///< p, m; within its limits exactly, off the active rows at one of them (or at 0, between
                             ///< them, where r = g without the row's help)
  std::vector<char> active;  ///< m: 1 where r = g is held by a p that may be between its limits: closed, or sticking
  int iterations = 0;        ///< of the active set
  /// Largest imbalance of load along a rigid motion that no contact row resists, by the size of the loads; at rounding
  /// level, else `no_equilibrium`.
  double imbalance = 0;
  /// no_equilibrium: coefficients y of each body's `rigid`, as Balance has it: G y ≤ 0 and eᵀy > 0 where p ≥ 0 only,
  /// and else what friction cannot hold.
  std::vector<Eigen::VectorXd> motion;
  int body = -1;   ///< not_definite
  Phases seconds;  ///< with those of the factorisation that it used
};

/// Bodies and their contact, each stiffness factorised once, to be solved for any loads and gaps:
///     min Σ (½ uᵀK u − fᵀu)  subject to  Σ B u ≤ g,  by the problem in the multipliers,
///     min ½ pᵀF p − pᵀ(Σ B K⁺ f − g)  over  p ≥ 0, Gᵀp = e;   F = Σ B K⁺ Bᵀ, G = [B R], e = Rᵀf.
/// With other limits of p than [0, ∞) it is the latter, and the slack g − r is ≥ 0 where p is at its lower limit, ≤ 0
/// at its upper one, 0 between: in place of r ≤ g the energy has Σ max(lower (r − g), upper (r − g)). Without rows (m =
/// 0) each body is just solved; without rigid motions nothing is balanced.
class Bodies {
 public:
  /// Factorises them, the unknowns that rows touch last.
  /// \param rows_may_depend whether rows that depend on each other are to be expected in numbers: then those that are
  ///     closed have the p of least norm, in place of a search row by row
  /// \pre at least one; matrices compressed, their rows sorted
  /// \throw std::bad_alloc, also where it is CHOLMOD that the memory does not suffice for; so below; and, before
  ///     anything is factorised, where the factors and the dense matrices of the rows exceed what the machine has
  explicit Bodies(std::vector<System> systems, bool rows_may_depend = false);
  Bodies(Bodies&&) noexcept;
  Bodies& operator=(Bodies&&) noexcept;
  ~Bodies();

  /// The same bodies, on the factors that there are, with other rows that may depend on each other, and that give way:
  ///     min ½ pᵀ(F + A) p − pᵀ(Σ B K⁺ f − g);  between the limits of p the approach is r = g + A p.
  /// \param rows B of each body, m × n, sorted; of unknowns that the rows touch with which it was factorised
  /// \param added A, m × m, symmetric and positive semidefinite
  /// \throw std::invalid_argument where they touch others
  Bodies with_rows(std::vector<Eigen::SparseMatrix<double>> rows, Eigen::SparseMatrix<double> added) const;

  const std::vector<System>& systems() const;                    ///< as they were factorised
  const std::vector<Eigen::SparseMatrix<double>>& rows() const;  ///< B of each body
  /// \param loads f of each body   \param gap g, m
  /// \param guess rows expected to be active (m entries, or empty: all)   \param limits of p (m entries each)
  Solution solve(const std::vector<Eigen::VectorXd>& loads, const Eigen::VectorXd& gap,
                 const std::vector<char>& guess = {}, const Limits& limits = {}) const;
  /// K⁺ f of one body; what f has of a resultant along a free motion is left out. For corrections by a residual that
  /// the caller can evaluate better than from u. \pre solve() did not end as not_definite
  Eigen::VectorXd respond(int body, const Eigen::VectorXd& force) const;

 private:
  struct Elastic;
  struct WithRows;
  explicit Bodies(std::unique_ptr<const WithRows> with_rows);
  std::unique_ptr<const WithRows> with_rows_;
};

/// While it lives, BLAS uses so many threads in the whole process; then as many as before. One where they are solved in
/// several threads at once: they would wait for each other. Without effect where BLAS is not OpenBLAS.
class BlasThreads {
 public:
  explicit BlasThreads(int count);
  ~BlasThreads();
  BlasThreads(const BlasThreads&) = delete;
  BlasThreads& operator=(const BlasThreads&) = delete;

  static int now();  ///< 0: not OpenBLAS

 private:
  int before_;
};

/// What the machine has, in bytes.
double physical_memory();

/// Lets BLAS take the memory that it needs to be called from `callers` threads at once, where it has not yet. Without
/// memory for it BLAS itself would try for ever.
/// \throw std::bad_alloc
void reserve_blas_memory(int callers);

/// Of that solve; what the caller spent itself it adds.
Statistics statistics(const Bodies& bodies, const Solution& solution);

/// What the termination means, in one line; empty: solved, or not_converged.
/// \param unknown what was solved for, with which the line begins   \param bodies their names
/// \param no_equilibrium, contradiction what these mean for that unknown
std::string reason(const Solution& solution, const std::string& unknown, const std::vector<std::string>& bodies,
                   const std::string& no_equilibrium, const std::string& contradiction);

/// Whether forces can be balanced by pressures: lower ≤ p ≤ upper with Gᵀp = e.
struct Balance {
  bool possible = true;
  Eigen::VectorXd pressure;  ///< one such p (m); at a limit or at 0 but for at most k rows, independent ones of G
  /// Else y (k) with  Σ max(lower_i (G y)_i, upper_i (G y)_i) < eᵀy:  no p within the limits does as much work against
  /// this motion as the forces do along it. G y ≤ 0 where p ≥ 0, G y = 0 where p is free (Farkas; HH81 (1.16)).
  Eigen::VectorXd motion;
};

/// Bounded-variable least squares for Gᵀp = e; ends after finitely many steps.
/// \param rows G, m × k   \param load e, k   \param explained residual that is taken for rounding
Balance balance(const Eigen::MatrixXd& rows, const Eigen::VectorXd& load, double explained, const Limits& limits = {});

/// An order of elimination with little fill: what each part of a nested dissection has to itself, before what separates
/// it from the next one.
/// \param cell_paths of each cell, from the highest bit on: into which of two parts it belongs, of these again, …; a
/// cell
///     is a part of its own   \param cell_nodes as in Assembly
std::vector<int> elimination(std::span<const std::uint64_t> cell_paths, std::span<const int> cell_nodes, int n_nodes);

/// Sums dense symmetric cell matrices into a sparse one. The pattern is laid out once, from nodes.
class Assembly {
 public:
  /// \param nodes as in System
  /// \param cell_nodes the nodes of all cells, `nodes_per_cell` each, one cell after the other
  Assembly(std::vector<int> nodes, std::span<const int> cell_nodes, int nodes_per_cell);
  /// Adds a cell's matrix. \param unknowns its rows' places in the sum; −1: the row and column are left out
  void add(std::span<const int> unknowns, const Eigen::Ref<const Eigen::MatrixXd>& cell);
  /// The sum, lower triangle, rows sorted; leaves the object empty.
  Eigen::SparseMatrix<double> take();

 private:
  Eigen::SparseMatrix<double> matrix_;
};

}  // namespace bracket::contact
