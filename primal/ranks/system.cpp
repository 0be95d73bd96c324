// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "primal/ranks/system.h"

#include <fmt/format.h>
#include <petscksp.h>

#include <algorithm>
#include <stdexcept>

#include "primal/elasticity.h"
#include "scene/bernstein.h"

namespace bracket::primal {

/// Something of PETSc's, destroyed with the object.
template <class T, PetscErrorCode (*destroy)(T*)> struct Owned {
  T is = nullptr;
  Owned() = default;
  Owned(const Owned&) = delete;
  Owned& operator=(const Owned&) = delete;
  ~Owned() { destroy(&is); }
};
using OwnedMat = Owned<Mat, MatDestroy>;
using OwnedVec = Owned<Vec, VecDestroy>;
using OwnedKsp = Owned<KSP, KSPDestroy>;
using OwnedScatter = Owned<VecScatter, VecScatterDestroy>;
using OwnedIndices = Owned<IS, ISDestroy>;
using OwnedNullSpace = Owned<MatNullSpace, MatNullSpaceDestroy>;

namespace {

using scene::Vector;
using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

void check(PetscErrorCode error) {
  if (error == 0) return;
  if (error == PETSC_ERR_MEM) throw std::bad_alloc();
  const char* text = nullptr;
  PetscErrorMessage(error, &text, nullptr);
  throw std::runtime_error(fmt::format("PETSc: {} ({})", text == nullptr ? "an error" : text, error));
}

/// Says why MUMPS made no factors.
[[noreturn]] void fail_to_factorise(PC preconditioner) {
  Mat factor = nullptr;
  PetscInt why = 0;
  check(PCFactorGetMatrix(preconditioner, &factor));
  check(MatMumpsGetInfog(factor, 1, &why));
  constexpr int no_memory = -13;
  if (why == no_memory) throw std::bad_alloc();
  throw std::runtime_error(fmt::format("MUMPS cannot factorise the stiffness ({})", why));
}

/// A cell with its nodes' ties worked in.
struct Tied {
  std::vector<int> nodes;  ///< that it depends on
  Eigen::MatrixXd map;     ///< T: from their unknowns to the coefficients of the cell's nodes; empty: one
  Eigen::VectorXd offset;  ///< of those; empty: none
};

/// \return the place in `tied`, null: the node is free
const TiedNode* find(const std::vector<TiedNode>& tied, int node) {
  const auto at = std::lower_bound(tied.begin(), tied.end(), node,
                                   [](const TiedNode& one, int wanted) { return one.node < wanted; });
  return at != tied.end() && at->node == node ? &*at : nullptr;
}

}  // namespace

struct System::Parts {
  MPI_Comm comm;
  int rank = 0;
  Piece piece;
  std::vector<scene::Elasticity<3>> materials;
  OwnedVec unknowns, load, all;  ///< `all`: of all nodes, on the root
  OwnedScatter to_root;

  int per_cell() const { return scene::n_bernstein<3>(piece.degree); }
  int n_cells() const { return static_cast<int>(piece.cell_body.size()); }
  bool own(int node) const { return piece.first <= node && node < piece.end; }
  Tied tied_cell(int cell, const std::vector<TiedNode>& tied) const;
  void stiffness(int cell, Eigen::MatrixXd& result) const {
    const auto* x = &piece.corners[4 * static_cast<std::size_t>(cell)];
    set_cell_stiffness<3>({x[0], x[1], x[2], x[3]}, materials[piece.cell_body[cell]], piece.degree, result);
  }
  void make_matrix(const std::vector<Tied>& cells, OwnedMat& matrix) const;
  void assemble(const std::vector<TiedNode>& tied, const std::vector<Tied>& cells, Mat matrix);
  void set_near_kernel(const std::vector<TiedNode>& tied, Mat matrix) const;
  void tell(const std::vector<TiedNode>& tied, const std::vector<Tied>& cells, Answer& answer);
  Eigen::VectorXd gathered(Vec of) const;
};

Tied System::Parts::tied_cell(int cell, const std::vector<TiedNode>& tied) const {
  const int n = per_cell();
  const int* list = &piece.cell_nodes[static_cast<std::size_t>(n) * cell];
  Tied result{{list, list + n}, {}, {}};
  std::vector<const TiedNode*> ties;
  for (int i = 0; i < n; ++i) {
    ties.push_back(find(tied, list[i]));
    if (ties.back() == nullptr) continue;
    for (const auto& [j, matrix] : ties.back()->of)
      if (std::ranges::find(result.nodes, j) == result.nodes.end()) result.nodes.push_back(j);
  }
  if (std::ranges::all_of(ties, [](const TiedNode* tie) { return tie == nullptr; })) return result;
  result.map = Eigen::MatrixXd::Zero(3 * n, 3 * static_cast<Eigen::Index>(result.nodes.size()));
  result.offset = Eigen::VectorXd::Zero(3 * n);
  for (int i = 0; i < n; ++i) {
    if (ties[i] == nullptr) {
      result.map.block<3, 3>(3 * i, 3 * i).setIdentity();
      continue;
    }
    result.offset.segment<3>(3 * i) = ties[i]->offset;
    for (const auto& [j, matrix] : ties[i]->of)
      result.map.block<3, 3>(3 * i, 3 * (std::ranges::find(result.nodes, j) - result.nodes.begin())) += matrix;
  }
  return result;
}

void System::Parts::make_matrix(const std::vector<Tied>& cells, OwnedMat& matrix) const {
  const int n = piece.end - piece.first;
  std::vector<std::vector<int>> beside(n);
  for (const Tied& cell : cells)
    for (const int i : cell.nodes)
      if (own(i)) {
        auto& list = beside[i - piece.first];
        list.insert(list.end(), cell.nodes.begin(), cell.nodes.end());
        if (list.size() > 512) make_distinct(list);
      }
  std::vector<PetscInt> inside(n, 0), outside(n, 0);
  for (int i = 0; i < n; ++i) {
    make_distinct(beside[i]);
    for (const int j : beside[i]) ++(own(j) ? inside : outside)[i];
    beside[i] = {};
  }
  check(MatCreate(comm, &matrix.is));
  check(MatSetSizes(matrix.is, 3 * n, 3 * n, PETSC_DETERMINE, PETSC_DETERMINE));
  check(MatSetType(matrix.is, MATAIJ));
  check(MatSetBlockSize(matrix.is, 3));
  check(MatXAIJSetPreallocation(matrix.is, 3, inside.data(), outside.data(), nullptr, nullptr));
  check(MatSetOption(matrix.is, MAT_NO_OFF_PROC_ENTRIES, PETSC_TRUE));
}

void System::Parts::assemble(const std::vector<TiedNode>& tied, const std::vector<Tied>& cells, Mat matrix) {
  Eigen::MatrixXd stiffness;
  std::vector<double> diagonal(piece.end - piece.first, 0.0);
  const int n = per_cell();
  for (int c = 0; c < n_cells(); ++c) {
    this->stiffness(c, stiffness);
    const Tied& cell = cells[c];
    for (int i = 0; i < n; ++i)
      if (const int node = piece.cell_nodes[static_cast<std::size_t>(n) * c + i]; own(node))
        diagonal[node - piece.first] += stiffness.block<3, 3>(3 * i, 3 * i).trace() / 3;
    RowMajor entries;
    if (cell.map.size() == 0) {
      entries = stiffness;
    } else {
      const Eigen::MatrixXd moved = cell.map.transpose() * stiffness;
      entries = moved * cell.map;
      if (!cell.offset.isZero(0)) {
        const Eigen::VectorXd less = -(moved * cell.offset);
        for (std::size_t i = 0; i < cell.nodes.size(); ++i)
          if (own(cell.nodes[i]))
            check(VecSetValuesBlocked(load.is, 1, &cell.nodes[i], less.data() + 3 * i, ADD_VALUES));
      }
    }
    const auto size = static_cast<PetscInt>(cell.nodes.size());
    for (PetscInt i = 0; i < size; ++i)
      if (own(cell.nodes[i]))
        check(MatSetValuesBlocked(matrix, 1, &cell.nodes[i], size, cell.nodes.data(), entries.row(3 * i).data(),
                                  ADD_VALUES));
  }
  for (const TiedNode& node : tied) {  // unknowns that stay zero: a row of the identity, of the others' size
    if (!own(node.node)) continue;
    for (int k = 0; k < 3; ++k)
      if (node.of.front().second.col(k).isZero(0))
        check(MatSetValue(matrix, 3 * node.node + k, 3 * node.node + k, diagonal[node.node - piece.first], ADD_VALUES));
  }
  check(MatAssemblyBegin(matrix, MAT_FINAL_ASSEMBLY));
  check(MatAssemblyEnd(matrix, MAT_FINAL_ASSEMBLY));
  check(VecAssemblyBegin(load.is));
  check(VecAssemblyEnd(load.is));
}

/// The rigid motions, as far as the unknowns are free.
void System::Parts::set_near_kernel(const std::vector<TiedNode>& tied, Mat matrix) const {
  std::array<Vec, 6> motions;
  check(MatCreateVecs(matrix, &motions[0], nullptr));
  for (int m = 1; m < 6; ++m) check(VecDuplicate(motions[0], &motions[m]));
  const auto& indices = scene::bernstein_indices<3>(piece.degree);
  const int n = per_cell();
  Vector<3> middle = Vector<3>::Zero();
  for (const Vector<3>& x : piece.corners) middle += x / static_cast<double>(piece.corners.size());
  MPI_Bcast(middle.data(), 3, MPI_DOUBLE, 0, comm);
  for (int c = 0; c < n_cells(); ++c)
    for (int i = 0; i < n; ++i) {
      const int node = piece.cell_nodes[static_cast<std::size_t>(n) * c + i];
      if (!own(node)) continue;
      Vector<3> x = -middle;
      for (int v = 0; v < 4; ++v)
        x += piece.corners[4 * static_cast<std::size_t>(c) + v] * indices[i][v] / piece.degree;
      const TiedNode* tie = find(tied, node);
      for (int m = 0; m < 6; ++m) {
        Vector<3> u = m < 3 ? Vector<3>(Vector<3>::Unit(m)) : Vector<3>(Vector<3>::Unit(m - 3).cross(x));
        if (tie != nullptr) u = (tie->of.front().second.transpose() * u).eval();
        check(VecSetValuesBlocked(motions[m], 1, &node, u.data(), INSERT_VALUES));
      }
    }
  for (Vec motion : motions) {
    check(VecAssemblyBegin(motion));
    check(VecAssemblyEnd(motion));
  }
  for (int m = 0; m < 6; ++m) {  // orthonormal; a motion that is none of the unknowns' is left out
    for (int pass = 0; pass < 2; ++pass)
      for (int l = 0; l < m; ++l) {
        PetscScalar along = 0;
        check(VecDot(motions[m], motions[l], &along));
        check(VecAXPY(motions[m], -along, motions[l]));
      }
    check(VecNormalize(motions[m], nullptr));
  }
  OwnedNullSpace kernel;
  check(MatNullSpaceCreate(comm, PETSC_FALSE, 6, motions.data(), &kernel.is));
  check(MatSetNearNullSpace(matrix, kernel.is));
  for (Vec& motion : motions) check(VecDestroy(&motion));
}

Eigen::VectorXd System::Parts::gathered(Vec of) const {
  check(VecScatterBegin(to_root.is, of, all.is, INSERT_VALUES, SCATTER_FORWARD));
  check(VecScatterEnd(to_root.is, of, all.is, INSERT_VALUES, SCATTER_FORWARD));
  const PetscScalar* values = nullptr;
  check(VecGetArrayRead(all.is, &values));
  PetscInt size = 0;
  check(VecGetLocalSize(all.is, &size));
  Eigen::VectorXd result = Eigen::Map<const Eigen::VectorXd>(values, size);
  check(VecRestoreArrayRead(all.is, &values));
  return result;
}

/// Forces K u at the nodes that are asked for, each by its owner.
void System::Parts::tell(const std::vector<TiedNode>& tied, const std::vector<Tied>& cells, Answer& answer) {
  const int n = per_cell();
  std::vector<int> wanted;  // nodes whose unknowns are needed
  std::vector<char> concerned(n_cells(), 0);
  for (int c = 0; c < n_cells(); ++c) {
    for (int i = 0; i < n; ++i) {
      const int node = piece.cell_nodes[static_cast<std::size_t>(n) * c + i];
      if (!own(node)) continue;
      const TiedNode* tie = find(tied, node);
      concerned[c] |= static_cast<char>(tie != nullptr && tie->asked);
    }
    if (concerned[c]) wanted.insert(wanted.end(), cells[c].nodes.begin(), cells[c].nodes.end());
  }
  make_distinct(wanted);
  OwnedIndices from;
  check(ISCreateBlock(comm, 3, static_cast<PetscInt>(wanted.size()), wanted.data(), PETSC_COPY_VALUES, &from.is));
  OwnedVec values;
  check(VecCreateSeq(PETSC_COMM_SELF, 3 * static_cast<PetscInt>(wanted.size()), &values.is));
  OwnedScatter scatter;
  check(VecScatterCreate(unknowns.is, from.is, values.is, nullptr, &scatter.is));
  check(VecScatterBegin(scatter.is, unknowns.is, values.is, INSERT_VALUES, SCATTER_FORWARD));
  check(VecScatterEnd(scatter.is, unknowns.is, values.is, INSERT_VALUES, SCATTER_FORWARD));
  const PetscScalar* y = nullptr;
  check(VecGetArrayRead(values.is, &y));
  OwnedVec forces;
  check(VecDuplicate(unknowns.is, &forces.is));
  Eigen::MatrixXd stiffness;
  for (int c = 0; c < n_cells(); ++c) {
    if (!concerned[c]) continue;
    const Tied& cell = cells[c];
    Eigen::VectorXd u(3 * cell.nodes.size());
    for (std::size_t i = 0; i < cell.nodes.size(); ++i) {
      const auto at = std::lower_bound(wanted.begin(), wanted.end(), cell.nodes[i]) - wanted.begin();
      u.segment<3>(3 * static_cast<Eigen::Index>(i)) = Eigen::Map<const Vector<3>>(y + 3 * at);
    }
    if (cell.map.size() > 0) u = (cell.map * u + cell.offset).eval();
    this->stiffness(c, stiffness);
    const Eigen::VectorXd f = stiffness * u;
    for (int i = 0; i < n; ++i) {
      const int node = piece.cell_nodes[static_cast<std::size_t>(n) * c + i];
      const TiedNode* tie = own(node) ? find(tied, node) : nullptr;
      if (tie != nullptr && tie->asked) check(VecSetValuesBlocked(forces.is, 1, &node, f.data() + 3 * i, ADD_VALUES));
    }
  }
  check(VecRestoreArrayRead(values.is, &y));
  check(VecAssemblyBegin(forces.is));
  check(VecAssemblyEnd(forces.is));
  answer.forces = gathered(forces.is);
}

System::System(MPI_Comm processes, Piece piece, std::vector<scene::Elasticity<3>> materials)
    : parts_(std::make_unique<Parts>()) {
  Parts& of = *parts_;
  of.comm = processes;
  MPI_Comm_rank(processes, &of.rank);
  of.piece = std::move(piece);
  of.materials = std::move(materials);
  check(VecCreateMPI(processes, 3 * (of.piece.end - of.piece.first), PETSC_DETERMINE, &of.unknowns.is));
  check(VecSetBlockSize(of.unknowns.is, 3));
  check(VecDuplicate(of.unknowns.is, &of.load.is));
  check(VecScatterCreateToZero(of.unknowns.is, &of.to_root.is, &of.all.is));
}

System::System(System&&) noexcept = default;
System::~System() = default;

void start_petsc() {
  check(PetscInitializeNoArguments());
  check(PetscPopSignalHandler());  // the program's ends are its own
}
void end_petsc() { check(PetscFinalize()); }

Answer System::solve(const std::vector<TiedNode>& tied, const Way& way, const Eigen::VectorXd& load,
                     const Eigen::VectorXd& start) {
  Parts& of = *parts_;
  const auto hand_out = [&](const Eigen::VectorXd& values, Vec to) {
    if (of.rank == 0) {
      PetscScalar* into = nullptr;
      check(VecGetArray(of.all.is, &into));
      std::copy(values.begin(), values.end(), into);
      check(VecRestoreArray(of.all.is, &into));
    }
    check(VecScatterBegin(of.to_root.is, of.all.is, to, INSERT_VALUES, SCATTER_REVERSE));
    check(VecScatterEnd(of.to_root.is, of.all.is, to, INSERT_VALUES, SCATTER_REVERSE));
  };
  hand_out(load, of.load.is);
  hand_out(start, of.unknowns.is);
  std::vector<Tied> cells;
  for (int c = 0; c < of.n_cells(); ++c) cells.push_back(of.tied_cell(c, tied));
  OwnedMat matrix;
  of.make_matrix(cells, matrix);
  of.assemble(tied, cells, matrix.is);
  check(MatSetOption(matrix.is, MAT_SPD, PETSC_TRUE));

  OwnedKsp solver;
  PC preconditioner = nullptr;
  check(KSPCreate(of.comm, &solver.is));
  check(KSPSetOperators(solver.is, matrix.is, matrix.is));
  check(KSPGetPC(solver.is, &preconditioner));
  if (way.direct) {
    check(KSPSetType(solver.is, KSPPREONLY));
    check(PCSetType(preconditioner, PCCHOLESKY));
    check(PCFactorSetMatSolverType(preconditioner, MATSOLVERMUMPS));
  } else {
    check(KSPSetType(solver.is, KSPCG));
    check(KSPSetNormType(solver.is, KSP_NORM_NATURAL));
    check(KSPSetTolerances(solver.is, way.tolerance, PETSC_DEFAULT, PETSC_DEFAULT, 2000));
    check(KSPSetInitialGuessNonzero(solver.is, PETSC_TRUE));
    check(PCSetType(preconditioner, PCGAMG));
    of.set_near_kernel(tied, matrix.is);
  }
  check(KSPSetFromOptions(solver.is));
  check(KSPSetUp(solver.is));
  check(KSPSolve(solver.is, of.load.is, of.unknowns.is));
  Answer answer;
  KSPConvergedReason why = KSP_CONVERGED_ITERATING;
  check(KSPGetConvergedReason(solver.is, &why));
  check(KSPGetIterationNumber(solver.is, &answer.iterations));
  answer.converged = why > 0;
  if (way.direct && !answer.converged) fail_to_factorise(preconditioner);
  answer.unknowns = of.gathered(of.unknowns.is);
  of.tell(tied, cells, answer);
  return answer;
}

}  // namespace bracket::primal
