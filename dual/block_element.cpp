// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "dual/block_element.h"

#include "scene/voigt.h"

namespace bracket::dual {

namespace {

using scene::area_vector;
using scene::Simplex;
using scene::traction;
using scene::Vector;
using scene::Voigt;

constexpr std::array<std::array<int, 2>, 6> voigt_pairs = {{{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}}};

/// Where edge e begins and ends.
std::array<Vector<2>, 2> ends(const Triangle& t, int e) {
  const auto& [from, to] = Simplex<2>::edges[e];
  return {t[from], t[to]};
}

/// The corners of part k: the ends of edge k, centroid.
Triangle part(const Triangle& t, int k) {
  const auto [from, to] = ends(t, k);
  return {from, to, (t[0] + t[1] + t[2]) / 3};
}

/// The seven parameters of a divergence-free linear stress, M(K) of [HH81, §2.1], at x.
Eigen::Matrix<double, 3, 7> linear_stress(const Vector<2>& x) {
  Eigen::Matrix<double, 3, 7> m;
  m << 1, x[0], x[1], 0, 0, 0, 0,  //
      0, 0, 0, 1, x[0], x[1], 0,   //
      0, -x[1], 0, 0, 0, -x[0], 1;
  return m;
}

/// Corner values of all 21 parameters of the three parts: row 9 k + 3 corner + component of part k.
Eigen::MatrixXd corner_values(const Triangle& t) {
  Eigen::MatrixXd values = Eigen::MatrixXd::Zero(27, 21);
  const Vector<2> centroid = (t[0] + t[1] + t[2]) / 3;
  for (int k = 0; k < 3; ++k)
    for (int c = 0; c < 3; ++c) values.block<3, 7>(9 * k + 3 * c, 7 * k) = linear_stress(part(t, k)[c] - centroid);
  return values;
}

/// The jump of the traction at both ends of the three inner edges, by the parameters: 12 × 21, of full rank.
Eigen::MatrixXd continuity(const Triangle& t, const Eigen::MatrixXd& values) {
  Eigen::MatrixXd jump(12, 21);
  const Vector<2> centroid = (t[0] + t[1] + t[2]) / 3;
  for (int v = 0; v < 3; ++v) {
    // Vertex v is corner 1 of part v+1 and corner 0 of part v+2.
    const Vector<2> n = area_vector<2>({centroid, t[v]});
    const std::array<int, 2> parts = {(v + 1) % 3, (v + 2) % 3};
    for (int end = 0; end < 2; ++end) {
      const int first = 9 * parts[0] + 3 * (end == 0 ? 1 : 2), second = 9 * parts[1] + 3 * (end == 0 ? 0 : 2);
      const Eigen::MatrixXd difference = values.middleRows<3>(first) - values.middleRows<3>(second);
      jump.row(4 * v + 2 * end) = n[0] * difference.row(0) + n[1] * difference.row(2);
      jump.row(4 * v + 2 * end + 1) = n[0] * difference.row(2) + n[1] * difference.row(1);
    }
  }
  return jump;
}

/// ∫ φ_i over an edge, times the length-carrying normal, of the tractions of corner stresses.
LoadVector edge_loads(const Triangle& t, const Corners& stress) {
  LoadVector loads;
  for (int e = 0; e < 3; ++e) {
    const Vector<2> n = area_vector<2>(ends(t, e));
    const std::array<Vector<2>, 2> at = {traction<2>(stress[3 * e], n), traction<2>(stress[3 * e + 1], n)};
    for (int i = 0; i < 2; ++i) loads.segment<2>(4 * e + 2 * i) = scene::hat_moment(at, i);
  }
  return loads;
}

/// Nine independent side loads in equilibrium, in small integers. A linear side load acts like the forces ∫ φ_i λn at
/// the ends of its edge: so opposite forces of the two edges that meet at a vertex balance, and so do opposite forces
/// along an edge at its ends.
LoadMatrix balanced_loads(const Triangle& t) {
  LoadMatrix loads = LoadMatrix::Zero();
  int mode = 0;
  for (int v = 0; v < 3; ++v)
    for (int c = 0; c < 2; ++c, ++mode) {
      loads(4 * ((v + 2) % 3) + c, mode) = 1;       // edge v+2 begins at vertex v
      loads(4 * ((v + 1) % 3) + 2 + c, mode) = -1;  // edge v+1 ends there
    }
  for (int e = 0; e < 3; ++e, ++mode) {
    const auto [from, to] = ends(t, e);
    const Vector<2> along = to - from;
    loads.block<2, 1>(4 * e, mode) = -along;
    loads.block<2, 1>(4 * e + 2, mode) = along;
  }
  return loads;
}

/// The modes are those of balanced_loads(), one each [HH81, Theorem 2.1]. Their corner values are integers, so that
/// they are held exactly: rounded modes would act as a body force, the same in all cells of one shape.
ReferenceBlock make_reference_block() {
  const Triangle t = {Vector<2>(0, 0), Vector<2>(1, 0), Vector<2>(0, 1)};
  const Eigen::MatrixXd values = corner_values(t);
  const Eigen::MatrixXd q =
      Eigen::ColPivHouseholderQR<Eigen::MatrixXd>(continuity(t, values).transpose()).householderQ();
  const Eigen::MatrixXd basis = values.lazyProduct(q.rightCols(n_modes));  // no jumps
  const auto corners = [](const auto& column) {
    Corners stress;
    for (int c = 0; c < 9; ++c) stress[c] = column.template segment<3>(3 * c);
    return stress;
  };
  Eigen::MatrixXd basis_loads(n_loads, n_modes);
  for (int m = 0; m < n_modes; ++m) basis_loads.col(m) = edge_loads(t, corners(basis.col(m)));

  ReferenceBlock reference;
  reference.loads = balanced_loads(t);
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> amplitudes(basis_loads);
  const Eigen::MatrixXd balanced = amplitudes.solve(Eigen::MatrixXd(reference.loads));
  const Eigen::MatrixXd modes = basis.lazyProduct(balanced).array().round();
  for (int m = 0; m < n_modes; ++m) reference.modes[m] = corners(modes.col(m));
  const auto component = [&](int mode, int k, int a) {
    const Corners& m = reference.modes[mode];
    return std::array<double, 3>{m[3 * k][a], m[3 * k + 1][a], m[3 * k + 2][a]};
  };
  const double part_area = 1.0 / 6;
  for (std::size_t p = 0; p < voigt_pairs.size(); ++p) {
    const auto [a, b] = voigt_pairs[p];
    ModeMatrix mass = ModeMatrix::Zero();
    for (int i = 0; i < n_modes; ++i)
      for (int j = 0; j < n_modes; ++j)
        for (int k = 0; k < 3; ++k)
          mass(i, j) += scene::integral_of_product(component(i, k, a), component(j, k, b), part_area);
    reference.mass[p] = a == b ? mass : ModeMatrix(mass + mass.transpose());
  }
  return reference;
}

}  // namespace

const ReferenceBlock& reference_block() {
  static const ReferenceBlock reference = make_reference_block();
  return reference;
}

BlockElement block_element(const Triangle& t, const scene::Elasticity<2>& compliance) {
  const ReferenceBlock& reference = reference_block();
  Eigen::Matrix2d b;
  b << t[1] - t[0], t[2] - t[0];
  const double det = b.determinant();

  BlockElement block;
  block.piola << b(0, 0) * b(0, 0), b(0, 1) * b(0, 1), 2 * b(0, 0) * b(0, 1),  //
      b(1, 0) * b(1, 0), b(1, 1) * b(1, 1), 2 * b(1, 0) * b(1, 1),             //
      b(0, 0) * b(1, 0), b(0, 1) * b(1, 1), b(0, 0) * b(1, 1) + b(0, 1) * b(1, 0);
  block.piola /= det;

  const Eigen::Matrix3d pulled_back = det * (block.piola.transpose() * compliance * block.piola);
  block.compliance.setZero();
  for (std::size_t p = 0; p < voigt_pairs.size(); ++p)
    block.compliance += pulled_back(voigt_pairs[p][0], voigt_pairs[p][1]) * reference.mass[p];

  // λn ds = B τ̂ n̂ dŝ: each end's pair of rows is the reference one times B.
  for (int r = 0; r < n_loads; r += 2) block.loads.middleRows<2>(r) = b * reference.loads.middleRows<2>(r);
  return block;
}

Eigen::Matrix<double, n_modes, n_loads> half_stiffness(const Eigen::LLT<ModeMatrix>& compliance,
                                                       const LoadMatrix& loads) {
  return compliance.matrixL().solve(loads.transpose());
}

Corners stress_at_corners(const Eigen::Matrix3d& piola, const ModeVector& amplitudes) {
  const ReferenceBlock& reference = reference_block();
  Corners stress;
  for (int c = 0; c < 9; ++c) {
    Voigt<2> sum = Voigt<2>::Zero();
    for (int m = 0; m < n_modes; ++m) sum += amplitudes[m] * reference.modes[m][c];
    stress[c] = piola * sum;
  }
  return stress;
}

ModeVector coupling(const Triangle& t, const Eigen::Matrix3d& piola, const scene::Elasticity<2>& compliance,
                    const Corners& stress) {
  const Vector<2> u = t[1] - t[0], v = t[2] - t[0];
  const double part_area = (u[0] * v[1] - u[1] * v[0]) / 6;
  ModeVector result = ModeVector::Zero();
  for (int m = 0; m < n_modes; ++m) {
    const Corners mode = stress_at_corners(piola, ModeVector::Unit(m));
    for (int k = 0; k < 3; ++k)
      for (int a = 0; a < 3; ++a) {
        std::array<double, 3> strain, of_mode;
        for (int c = 0; c < 3; ++c) {
          strain[c] = compliance.row(a) * stress[3 * k + c];
          of_mode[c] = mode[3 * k + c][a];
        }
        result[m] += scene::integral_of_product(strain, of_mode, part_area);
      }
  }
  return result;
}

Particular particular(const Triangle& t, const Eigen::Matrix3d& piola, const scene::Elasticity<2>& compliance,
                      const scene::Vector<2>& force) {
  const Vector<2> centroid = (t[0] + t[1] + t[2]) / 3;
  Particular field;
  for (int k = 0; k < 3; ++k)
    for (int c = 0; c < 3; ++c) {
      const Vector<2> x = part(t, k)[c] - centroid;
      field.stress[3 * k + c] = {-force[0] * x[0], -force[1] * x[1], 0};
    }
  field.coupling = coupling(t, piola, compliance, field.stress);
  field.loads = edge_loads(t, field.stress);
  return field;
}

}  // namespace bracket::dual
