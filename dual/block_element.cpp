// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "dual/block_element.h"

#include "scene/block_fields.h"
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

/// The means of products of the Bernstein polynomials of a triangle.
template <int degree> Eigen::Matrix<double, scene::n_bernstein(degree), scene::n_bernstein(degree)> bernstein_means() {
  constexpr int n = scene::n_bernstein(degree);
  Eigen::Matrix<double, n, n> means;
  const auto& indices = scene::bernstein_indices(degree);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) means(i, j) = scene::number<double>(scene::bernstein_mean(indices[i], indices[j]));
  return means;
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

/// ∫ B_i over an edge, times the length-carrying normal, of the tractions of a stress.
template <int degree> LoadVector<degree> edge_loads(const Triangle& t, const BlockStress<degree>& stress) {
  constexpr int n = degree + 1, whole = scene::bernstein_mass(degree, 0, degree, degree).whole;
  LoadVector<degree> loads = LoadVector<degree>::Zero();
  for (int e = 0; e < 3; ++e) {
    const Vector<2> normal = area_vector<2>(ends(t, e));
    for (int j = 0; j < n; ++j) {
      const Vector<2> at = traction<2>(stress[scene::n_bernstein(degree) * e + j], normal);
      for (int i = 0; i < n; ++i) {  // over one divisor, so that integers are summed exactly
        const auto [part, of] = scene::bernstein_mass(degree, i, degree, j);
        loads.template segment<2>(2 * n * e + 2 * i) += at * (part * whole / of);
      }
    }
  }
  return loads / whole;
}

/// Nine independent side loads in equilibrium, in small integers. A linear side load acts like the forces ∫ φ_i λn at
/// the ends of its edge: so opposite forces of the two edges that meet at a vertex balance, and so do opposite forces
/// along an edge at its ends.
LoadMatrix<1> balanced_loads(const Triangle& t) {
  LoadMatrix<1> loads = LoadMatrix<1>::Zero();
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

/// The modes of degree 1 are those of balanced_loads(), one each [HH81, Theorem 2.1].
std::vector<Corners> linear_modes() {
  const Triangle t = {Vector<2>(0, 0), Vector<2>(1, 0), Vector<2>(0, 1)};
  const Eigen::MatrixXd values = corner_values(t);
  const Eigen::MatrixXd q =
      Eigen::ColPivHouseholderQR<Eigen::MatrixXd>(continuity(t, values).transpose()).householderQ();
  const Eigen::MatrixXd basis = values.lazyProduct(q.rightCols(n_modes(1)));  // no jumps
  const auto corners = [](const auto& column) {
    Corners stress;
    for (int c = 0; c < 9; ++c) stress[c] = column.template segment<3>(3 * c);
    return stress;
  };
  Eigen::MatrixXd basis_loads(n_loads(1), n_modes(1));
  for (int m = 0; m < n_modes(1); ++m) basis_loads.col(m) = edge_loads<1>(t, corners(basis.col(m)));
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> amplitudes(basis_loads);
  const Eigen::MatrixXd balanced = amplitudes.solve(Eigen::MatrixXd(balanced_loads(t)));
  const Eigen::MatrixXd rounded = basis.lazyProduct(balanced).array().round();
  std::vector<Corners> modes;
  for (int m = 0; m < n_modes(1); ++m) modes.push_back(corners(rounded.col(m)));
  return modes;
}

template <int degree> BlockStress<degree> stress_of(const scene::BlockField& field) {
  BlockStress<degree> stress;
  for (int i = 0; i < n_coefficients(degree); ++i)
    stress[i] = {double(field[3 * i]), double(field[3 * i + 1]), double(field[3 * i + 2])};
  return stress;
}

/// A stress of one degree less; `scale` times it has integer coefficients where those are integers.
template <int degree> BlockStress<degree> raised(const BlockStress<degree - 1>& lower, int scale) {
  constexpr int below = scene::n_bernstein(degree - 1), above = scene::n_bernstein(degree);
  BlockStress<degree> stress;
  for (int part = 0; part < 3; ++part) {
    std::vector<Voigt<2>> c(lower.begin() + part * below, lower.begin() + (part + 1) * below);
    for (Voigt<2>& value : c) value *= scale;
    const auto r = scene::raised_on_triangle<double>(c, degree - 1);
    for (int i = 0; i < above; ++i) stress[part * above + i] = r[i];
  }
  return stress;
}

/// As far as a linear field has them, the coefficients of another degree, times an integer that makes integers of them.
template <int degree> BlockStress<degree> scaled_linear(const Corners& corners) {
  if constexpr (degree == 1) {
    return corners;
  } else {
    BlockStress<degree> stress = raised<degree>(scaled_linear<degree - 1>(corners), degree);
    for (Voigt<2>& value : stress) value = value.array().round();  // of (1/3) 3
    return stress;
  }
}

/// The linear ones, and those of block_fields().
template <int degree> std::vector<BlockStress<degree>> make_modes() {
  std::vector<BlockStress<degree>> modes;
  for (const Corners& mode : linear_modes()) modes.push_back(scaled_linear<degree>(mode));
  if constexpr (degree > 1) {
    const scene::BlockFields& fields = scene::block_fields(degree);
    for (const auto& sides : fields.load)
      for (const auto& side : sides)
        for (const auto& field : side) modes.push_back(stress_of<degree>(field));
    for (const auto& field : fields.bubbles) modes.push_back(stress_of<degree>(field));
  }
  return modes;
}

template <int degree> ModeMatrix<degree> mass(const std::vector<BlockStress<degree>>& modes, int a, int b) {
  constexpr int n = scene::n_bernstein(degree);
  const double part_area = 1.0 / 6;
  ModeMatrix<degree> result = ModeMatrix<degree>::Zero();
  Eigen::Matrix<double, n_modes(degree), n> of_a, of_b;
  const Eigen::Matrix<double, n, n> means = bernstein_means<degree>();
  for (int part = 0; part < 3; ++part) {
    for (int m = 0; m < n_modes(degree); ++m)
      for (int i = 0; i < n; ++i) {
        of_a(m, i) = modes[m][n * part + i][a];
        of_b(m, i) = modes[m][n * part + i][b];
      }
    result += part_area * (of_a * means).lazyProduct(of_b.transpose());
  }
  return result;
}

template <int degree> ReferenceBlock<degree> make_reference_block() {
  const Triangle t = {Vector<2>(0, 0), Vector<2>(1, 0), Vector<2>(0, 1)};
  const std::vector<BlockStress<degree>> modes = make_modes<degree>();
  ReferenceBlock<degree> reference;
  std::copy(modes.begin(), modes.end(), reference.modes.begin());
  for (int m = 0; m < n_modes(degree); ++m) reference.loads.col(m) = edge_loads<degree>(t, modes[m]);
  for (std::size_t p = 0; p < voigt_pairs.size(); ++p) {
    const auto [a, b] = voigt_pairs[p];
    const ModeMatrix<degree> own = mass<degree>(modes, a, b);
    reference.mass[p] = a == b ? own : ModeMatrix<degree>(own + own.transpose());
  }
  return reference;
}

/// As far as a linear field on a cell has them, the coefficients of degree `degree` of each of its parts.
template <int degree> BlockStress<degree> of_linear(const Corners& corners) {
  if constexpr (degree == 1)
    return corners;
  else
    return raised<degree>(of_linear<degree - 1>(corners), 1);
}

}  // namespace

template <int degree> const ReferenceBlock<degree>& reference_block() {
  static const ReferenceBlock<degree> reference = make_reference_block<degree>();
  return reference;
}

template <int degree> BlockElement<degree> block_element(const Triangle& t, const scene::Elasticity<2>& compliance) {
  const ReferenceBlock<degree>& reference = reference_block<degree>();
  Eigen::Matrix2d b;
  b << t[1] - t[0], t[2] - t[0];
  const double det = b.determinant();

  BlockElement<degree> block;
  block.piola << b(0, 0) * b(0, 0), b(0, 1) * b(0, 1), 2 * b(0, 0) * b(0, 1),  //
      b(1, 0) * b(1, 0), b(1, 1) * b(1, 1), 2 * b(1, 0) * b(1, 1),             //
      b(0, 0) * b(1, 0), b(0, 1) * b(1, 1), b(0, 0) * b(1, 1) + b(0, 1) * b(1, 0);
  block.piola /= det;

  const Eigen::Matrix3d pulled_back = det * (block.piola.transpose() * compliance * block.piola);
  block.compliance.setZero();
  for (std::size_t p = 0; p < voigt_pairs.size(); ++p)
    block.compliance += pulled_back(voigt_pairs[p][0], voigt_pairs[p][1]) * reference.mass[p];

  // λn ds = B τ̂ n̂ dŝ: each pair of rows is the reference one times B.
  for (int r = 0; r < n_loads(degree); r += 2)
    block.loads.template middleRows<2>(r) = b * reference.loads.template middleRows<2>(r);
  return block;
}

template <int degree>
BlockStress<degree> block_stress(const Eigen::Matrix3d& piola, const ModeVector<degree>& amplitudes) {
  const ReferenceBlock<degree>& reference = reference_block<degree>();
  BlockStress<degree> stress;
  for (int c = 0; c < n_coefficients(degree); ++c) {
    Voigt<2> sum = Voigt<2>::Zero();
    for (int m = 0; m < n_modes(degree); ++m) sum += amplitudes[m] * reference.modes[m][c];
    stress[c] = piola * sum;
  }
  return stress;
}

template <int degree>
ModeVector<degree> coupling(const Triangle& t, const Eigen::Matrix3d& piola, const scene::Elasticity<2>& compliance,
                            const BlockStress<degree>& stress) {
  constexpr int n = scene::n_bernstein(degree);
  const ReferenceBlock<degree>& reference = reference_block<degree>();
  const Vector<2> u = t[1] - t[0], v = t[2] - t[0];
  const double part_area = (u[0] * v[1] - u[1] * v[0]) / 6;
  static const Eigen::Matrix<double, n, n> means = bernstein_means<degree>();
  ModeVector<degree> result = ModeVector<degree>::Zero();
  for (int part = 0; part < 3; ++part) {
    Eigen::Matrix<double, 3, n> strain;
    for (int i = 0; i < n; ++i) strain.col(i) = compliance * stress[n * part + i];
    const Eigen::Matrix<double, 3, n> against = part_area * (piola.transpose() * strain * means);
    for (int m = 0; m < n_modes(degree); ++m)
      for (int i = 0; i < n; ++i) result[m] += reference.modes[m][n * part + i].dot(against.col(i));
  }
  return result;
}

template <int degree>
Particular<degree> particular(const Triangle& t, const Eigen::Matrix3d& piola, const scene::Elasticity<2>& compliance,
                              const scene::Vector<2>& force) {
  const Vector<2> centroid = (t[0] + t[1] + t[2]) / 3;
  Corners linear;
  for (int k = 0; k < 3; ++k)
    for (int c = 0; c < 3; ++c) {
      const Vector<2> x = part(t, k)[c] - centroid;
      linear[3 * k + c] = {-force[0] * x[0], -force[1] * x[1], 0};
    }
  Particular<degree> field;
  field.stress = of_linear<degree>(linear);
  field.coupling = coupling<degree>(t, piola, compliance, field.stress);
  field.loads = edge_loads<degree>(t, field.stress);
  return field;
}

#define BRACKET_BLOCK_ELEMENT(degree)                                                                                  \
  template const ReferenceBlock<degree>& reference_block<degree>();                                                    \
  template BlockElement<degree> block_element<degree>(const Triangle&, const scene::Elasticity<2>&);                   \
  template BlockStress<degree> block_stress<degree>(const Eigen::Matrix3d&, const ModeVector<degree>&);                \
  template ModeVector<degree> coupling<degree>(const Triangle&, const Eigen::Matrix3d&, const scene::Elasticity<2>&,   \
                                               const BlockStress<degree>&);                                            \
  template Particular<degree> particular<degree>(const Triangle&, const Eigen::Matrix3d&, const scene::Elasticity<2>&, \
                                                 const scene::Vector<2>&);
BRACKET_BLOCK_ELEMENT(1)
BRACKET_BLOCK_ELEMENT(2)
BRACKET_BLOCK_ELEMENT(3)
#undef BRACKET_BLOCK_ELEMENT

}  // namespace bracket::dual
