// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bounds/space/judge.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace bracket::bounds::space {

using scene::Simplex;
using scene::Support;

namespace {

const Exact half(Rational(1, 2)), quarter(Rational(1, 4));

bool is_zero(const Point& v) { return is_zero(v[0]) && is_zero(v[1]) && is_zero(v[2]); }
/// The value of what is linear on a facet's whole at a corner of its piece.
template <class Value> Value on_facet(const std::array<Value, 3>& v, const std::array<double, 2>& at) {
  const Exact s(at[0]), t(at[1]);
  return (Exact(1) - s - t) * v[0] + s * v[1] + t * v[2];
}
Point point_of(const scene::Vector<3>& v) { return {Exact(v[0]), Exact(v[1]), Exact(v[2])}; }

/// Where a cell's corners are: by the first mesh's coordinates.
std::array<Point, 4> corners_of(const scene::Problem<3>& problem, int cell) {
  const auto [of, corner] = scene::piece_of_cell(problem, cell);
  const auto& first = scene::first_of(problem).mesh;
  std::array<Point, 4> x;
  for (int i = 0; i < 4; ++i) {
    Exact rest(1);
    for (int k = 0; k < 3; ++k) rest -= Exact(corner[i][k]);
    x[i] = rest * point_of(first.vertices[first.cells[of][0]]);
    for (int k = 0; k < 3; ++k) x[i] = x[i] + Exact(corner[i][k]) * point_of(first.vertices[first.cells[of][k + 1]]);
  }
  return x;
}

Exact volume(const std::array<Point, 4>& x) { return dot(x[1] - x[0], cross(x[2] - x[0], x[3] - x[0])) / Exact(6); }
std::array<Point, 4> gradients(const std::array<Point, 4>& x) {
  std::array<Point, 4> g;
  for (int k = 0; k < 4; ++k) {
    const auto& [a, b, c] = Simplex<3>::facets[k];
    const Point n = cross(x[b] - x[a], x[c] - x[a]);
    g[k] = (Exact(1) / dot(n, x[k] - x[a])) * n;
  }
  return g;
}
/// Outward, as long as the area.
Point area_of(const std::array<Point, 4>& x, int k) {
  const auto& [a, b, c] = Simplex<3>::facets[k];
  return half * cross(x[b] - x[a], x[c] - x[a]);
}

Point times(const Tensor& s, const Point& n) {
  Point result;
  for (int k = 0; k < 6; ++k) {
    const auto [i, j] = Simplex<3>::voigt[k];
    result[i] += s[k] * n[j];
    if (i != j) result[j] += s[k] * n[i];
  }
  return result;
}

using Matrix = std::array<std::array<Exact, 6>, 6>;
Matrix stiffness(const scene::Material<3>& material) {
  Matrix c;
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j) c[i][j] = Exact(material.stiffness()(i, j));
  const auto& constants = material.constants();
  if (!constants) return c;
  const Exact young(constants->young), poisson(constants->poisson), one(1), two(2);
  const Exact mu = young / (two * (one + poisson)),
              lambda = young * poisson / ((one + poisson) * (one - two * poisson));
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j) {
      c[i][j] = i < 3 && j < 3 ? lambda : Exact(0);
      if (i == j) c[i][j] += i < 3 ? two * mu : mu;
    }
  return c;
}
Tensor times(const Matrix& m, const Tensor& e) {
  Tensor result;
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j) result[i] += m[i][j] * e[j];
  return result;
}
/// C⁻¹ s
Tensor strain_of(const Matrix& hooke, const Tensor& s) {
  std::vector<std::vector<Exact>> a;
  for (const auto& row : hooke) a.emplace_back(row.begin(), row.end());
  const auto e = solution(a, {s.begin(), s.end()}).value();
  Tensor result;
  for (int i = 0; i < 6; ++i) result[i] = e[i];
  return result;
}
Exact product(const Tensor& a, const Tensor& b) {
  Exact sum;
  for (int i = 0; i < 6; ++i) sum += a[i] * b[i];
  return sum;
}
/// ∫ by the volume of the product of what is linear on a tetrahedron, given at its corners.
Exact mean_product(const std::array<Tensor, 4>& a, const std::array<Tensor, 4>& b) {
  Exact sum;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) sum += Exact(i == j ? 2 : 1) * product(a[i], b[j]);
  return sum / Exact(20);
}

/// ε(u) at the corners of a cell, by the nodal basis of quadratics: shear twice.
std::array<Tensor, 4> strain(const Judged& exact, int cell) {
  const auto g = gradients(exact.x[cell]);
  std::array<Tensor, 4> result;
  for (int corner = 0; corner < 4; ++corner)
    for (int node = 0; node < 10; ++node) {
      Point slope;  // of the node's function, at the corner
      if (node < 4) {
        slope = Exact(node == corner ? 3 : -1) * g[node];
      } else {
        const auto& [a, b] = Simplex<3>::edges[node - 4];
        if (a == corner) slope = Exact(4) * g[b];
        if (b == corner) slope = Exact(4) * g[a];
      }
      const Point& u = exact.displacement[cell][node];
      for (int k = 0; k < 6; ++k) {
        const auto [i, j] = Simplex<3>::voigt[k];
        result[corner][k] += i == j ? u[i] * slope[i] : u[i] * slope[j] + u[j] * slope[i];
      }
    }
  return result;
}

/// Values at the vertices and the middles of the edges of a boundary facet, edges as Simplex<2>::edges.
std::array<Point, 6> on_boundary(const scene::Mesh<3>& mesh, const Judged& exact, int facet) {
  const auto& at = mesh.boundary[facet];
  const auto& corners = Simplex<3>::facets[at.local];
  std::array<Point, 6> u;
  for (int i = 0; i < 3; ++i) u[i] = exact.displacement[at.cell][corners[i]];
  for (int e = 0; e < 3; ++e) {
    const auto& [a, b] = Simplex<2>::edges[e];
    u[3 + e] = exact.displacement[at.cell][4 + Simplex<3>::edge_between(corners[a], corners[b])];
  }
  return u;
}
/// Bernstein coefficients of a quadratic by its values at nodes.
std::array<Exact, 6> bernstein(const std::array<Exact, 6>& v) {
  std::array<Exact, 6> c = v;
  for (int e = 0; e < 3; ++e) {
    const auto& [a, b] = Simplex<2>::edges[e];
    c[3 + e] = Exact(2) * v[3 + e] - half * (v[a] + v[b]);
  }
  return c;
}
std::array<Exact, 6> approach_of(const scene::Problem<3>& problem, const Judged& exact,
                                 const scene::ContactFacetOf<3>& pair) {
  const Point d = point_of(problem.facets[pair.first].normal);
  const auto u = on_boundary(problem.mesh, exact, pair.first);
  std::array<Exact, 6> r;
  for (int k = 0; k < 6; ++k) r[k] = dot(u[k], d);
  if (pair.second >= 0) {
    const auto v = on_boundary(problem.mesh, exact, pair.second);
    for (int k = 0; k < 3; ++k) r[k] -= dot(v[pair.meets[k]], d);
    for (int e = 0; e < 3; ++e) {
      const auto& [a, b] = Simplex<2>::edges[e];
      r[3 + e] -= dot(v[3 + Simplex<2>::edge_between(pair.meets[a], pair.meets[b])], d);
    }
  }
  return bernstein(r);
}
/// λn times the area at the vertices of a boundary facet.
std::array<Point, 3> load_on(const scene::Mesh<3>& mesh, const Judged& exact, int facet) {
  const auto& at = mesh.boundary[facet];
  const Point n = area_of(exact.x[at.cell], at.local);
  const auto& s = exact.stress[at.cell][at.local];
  return {times(s[0], n), times(s[1], n), times(s[2], n)};
}
/// p times the area at the vertices of a contact's first facet.
std::array<Exact, 3> pressure_on(const scene::Problem<3>& problem, const Judged& exact,
                                 const scene::ContactFacetOf<3>& pair) {
  const Point d = point_of(problem.facets[pair.first].normal);
  const auto load = load_on(problem.mesh, exact, pair.first);
  std::array<Exact, 3> p;
  for (int i = 0; i < 3; ++i) p[i] = -dot(load[i], d) / dot(d, d);
  return p;
}
/// ∫ f g by the area: f linear, g by Bernstein coefficients, which have moments of 1/10, 1/15 and 1/30.
Exact facet_product(const std::array<Exact, 3>& f, const std::array<Exact, 6>& g) {
  Exact sum;
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) sum += f[i] * g[k] / Exact(i == k ? 10 : 30);
    for (int e = 0; e < 3; ++e) sum += f[i] * g[3 + e] / Exact(e == i ? 30 : 15);
  }
  return sum;
}
Exact facet_work_of(const std::array<Point, 3>& load, const std::array<Point, 6>& u) {
  Exact sum;
  for (int c = 0; c < 3; ++c) {
    std::array<Exact, 6> values;
    for (int k = 0; k < 6; ++k) values[k] = u[k][c];
    sum += facet_product({load[0][c], load[1][c], load[2][c]}, bernstein(values));
  }
  return sum;
}
std::array<Point, 3> data_load(const scene::Problem<3>& problem, const Judged& exact, int facet) {
  const auto [of, corner] = scene::piece_of_facet(problem, facet);
  const auto& data = scene::first_of(problem).facets[of];
  const auto& at = problem.mesh.boundary[facet];
  const Point n = area_of(exact.x[at.cell], at.local);
  bool has_traction = false;
  for (const auto& t : data.traction) has_traction |= !t.isZero(0);
  const Exact area = has_traction ? root(dot(n, n)) : Exact(0);
  std::array<Point, 3> load;
  for (int i = 0; i < 3; ++i) {
    const auto& t = data.traction;
    const auto& p = data.pressure;
    load[i] = area * on_facet<Point>({point_of(t[0]), point_of(t[1]), point_of(t[2])}, corner[i]) -
              on_facet<Exact>({Exact(p[0]), Exact(p[1]), Exact(p[2])}, corner[i]) * n;
  }
  for (const auto& [corrected, added] : exact.corrections) {
    if (corrected != of) continue;
    const auto& first = scene::first_of(problem).mesh;
    const auto& v = first.boundary[of].vertices;
    const Point whole = half * cross(point_of(first.vertices[v[1]]) - point_of(first.vertices[v[0]]),
                                     point_of(first.vertices[v[2]]) - point_of(first.vertices[v[0]]));
    const Exact part = dot(n, whole) / dot(whole, whole);
    for (int i = 0; i < 3; ++i) load[i] = load[i] + part * on_facet<Point>(added, corner[i]);
  }
  return load;
}

}  // namespace

Judged judged(const scene::Problem<3>& problem, const scene::Displacement<3>& displacement,
              const scene::Stress<3>& stress) {
  const auto& mesh = problem.mesh;
  Judged result;
  result.supports = supports_of(problem, displacement.degree);
  auto [field, reason] = admissible_field(problem, displacement, result.supports);
  auto [corrections, unbalanced] = corrected<Exact, RationalSum>(scene::first_of(problem));
  const auto faces = faces_of(mesh);
  auto [loads, unheld] = balanced<Exact, RationalSum>(problem, faces, corrections, plain_loads(problem, faces, stress));
  result.reason = reason + unbalanced + unheld;
  if (!result.reason.empty()) return result;
  result.field = std::move(*field);
  result.loads = std::move(*loads);
  result.corrections = std::move(corrections);
  const auto moved = shifts<Exact>(result.supports, result.field);
  for (int cell = 0; cell < static_cast<int>(mesh.cells.size()); ++cell) {
    result.x.push_back(corners_of(problem, cell));
    std::array<Point, 10> u;
    for (int i = 0; i < 4; ++i) u[i] = at_node(result.field, moved, mesh.cells[cell][i]);
    for (int e = 0; e < 6; ++e) {
      const auto& [a, b] = Simplex<3>::edges[e];
      u[4 + e] = half * (u[a] + u[b]);
      if (displacement.degree == 2)
        u[4 + e] = u[4 + e] + half * at_node(result.field, moved, node_of_edge(mesh, mesh.cell_edges[cell][e]));
    }
    result.displacement.push_back(u);
    result.stress.push_back(
        block_stress(problem, loaded_cell(problem, faces, result.loads, cell), mesh.cell_body[cell]));
  }
  return result;
}

std::vector<std::string> displacement_faults(const scene::Problem<3>& problem, const Judged& exact) {
  std::vector<std::string> result;
  const auto& first = scene::first_of(problem);
  std::vector<std::optional<Point>> prescribed(first.mesh.vertices.size());
  for (std::size_t f = 0; f < first.facets.size(); ++f)
    for (int i = 0; i < 3 && first.facets[f].support == Support::fixed; ++i)
      prescribed[first.mesh.boundary[f].vertices[i]] = point_of(first.facets[f].displacement[i]);
  for (int f = 0; f < static_cast<int>(problem.facets.size()); ++f) {
    const auto [of, corner] = scene::piece_of_facet(problem, f);
    const auto& data = first.facets[of];
    const auto u = on_boundary(problem.mesh, exact, f);
    const Point n = point_of(data.normal);
    std::array<Point, 3> held;
    std::array<Exact, 3> along;
    for (int i = 0; i < 3; ++i) {
      held[i] = point_of(data.displacement[i]);
      const auto& at = prescribed[first.mesh.boundary[of].vertices[i]];
      along[i] = at ? dot(*at, n) : Exact(data.normal_displacement[i]);
    }
    for (int k = 0; k < 6; ++k) {
      std::array<double, 2> at = k < 3 ? corner[k] : std::array<double, 2>{};
      if (k >= 3)
        for (int c = 0; c < 2; ++c)
          at[c] = 0.5 * (corner[Simplex<2>::edges[k - 3][0]][c] + corner[Simplex<2>::edges[k - 3][1]][c]);
      if (data.support == Support::fixed && !is_zero(u[k] - on_facet(held, at)))
        result.push_back(fmt::format("displacement of facet {}, node {}", f, k));
      if (data.support == Support::sliding && !is_zero(dot(u[k], n) - on_facet(along, at)))
        result.push_back(fmt::format("normal displacement of facet {}, node {}", f, k));
    }
  }
  for (const auto& pair : problem.contact) {
    const auto r = approach_of(problem, exact, pair);
    const auto kept = gap_paid<Exact>(problem, exact.supports, pair);
    for (int k = 0; k < 6; ++k)
      if (pair.law.two_sided ? !is_zero(r[k] - kept[k]) : r[k] > Exact(pair.lower[k]))
        result.push_back(fmt::format("approach of facet {}, node {}", pair.first, k));
  }
  return result;
}

std::vector<std::string> stress_faults(const scene::Problem<3>& problem, const Judged& exact) {
  std::vector<std::string> result;
  const auto& mesh = problem.mesh;
  std::map<int, std::vector<std::pair<int, int>>> sides;  // of each face: cells and facets
  for (int cell = 0; cell < static_cast<int>(mesh.cells.size()); ++cell) {
    const auto& x = exact.x[cell];
    const auto& s = exact.stress[cell];
    const Point centroid = quarter * (x[0] + x[1] + x[2] + x[3]);
    for (int i = 0; i < 4; ++i) {
      sides[mesh.facet_numbers[cell][i]].emplace_back(cell, i);
      const auto& [a, b, c] = Simplex<3>::facets[i];
      const auto g = gradients({x[a], x[b], x[c], centroid});
      Point divergence = point_of(scene::body_of(problem, cell).force);
      for (int k = 0; k < 4; ++k) divergence = divergence + times(s[i][k], g[k]);
      if (!is_zero(divergence)) result.push_back(fmt::format("no equilibrium in cell {}", cell));
      for (int j = 0; j < i; ++j) {  // the face between the parts i and j: the other two vertices and the centroid
        std::vector<int> others;
        for (int k = 0; k < 4; ++k)
          if (k != i && k != j) others.push_back(k);
        const Point n = cross(x[others[0]] - centroid, x[others[1]] - centroid);
        const auto at = [&](int part, int vertex) {
          const auto& corners = Simplex<3>::facets[part];
          return s[part][std::find(corners.begin(), corners.end(), vertex) - corners.begin()];
        };
        for (const int vertex : others)
          if (!is_zero(times(at(i, vertex), n) - times(at(j, vertex), n)))
            result.push_back(fmt::format("tractions jump in cell {}", cell));
        if (!is_zero(times(s[i][3], n) - times(s[j][3], n)))
          result.push_back(fmt::format("tractions jump in cell {}", cell));
      }
    }
  }
  for (const auto& [number, cells] : sides) {
    if (cells.size() != 2) continue;
    std::map<int, Point> sum;  // by vertices
    for (const auto& [cell, i] : cells)
      for (int k = 0; k < 3; ++k) {
        Point& at = sum[mesh.cells[cell][Simplex<3>::facets[i][k]]];
        at = at + times(exact.stress[cell][i][k], area_of(exact.x[cell], i));
      }
    if (sum.size() != 3) result.push_back(fmt::format("facet {} has not three vertices", number));
    for (const auto& [vertex, jump] : sum)
      if (!is_zero(jump)) result.push_back(fmt::format("tractions jump across facet {}", number));
  }
  for (int f = 0; f < static_cast<int>(problem.facets.size()); ++f) {
    const auto load = load_on(mesh, exact, f);
    const auto support = problem.facets[f].support;
    const auto given = data_load(problem, exact, f);
    const Point n = point_of(problem.facets[f].normal);
    for (int i = 0; i < 3; ++i) {
      if (support == Support::traction && !is_zero(load[i] - given[i]))
        result.push_back(fmt::format("traction on facet {}", f));
      if ((support == Support::sliding || support == Support::contact) && !is_zero(cross(load[i], n)))
        result.push_back(fmt::format("shear on facet {}", f));
    }
  }
  for (const auto& pair : problem.contact) {
    const auto own = load_on(mesh, exact, pair.first);
    const auto p = pressure_on(problem, exact, pair);
    for (int i = 0; i < 3; ++i) {
      if (!pair.law.two_sided && p[i] < Exact(0)) result.push_back(fmt::format("tension on facet {}", pair.first));
      if (pair.second >= 0 && !is_zero(own[i] + load_on(mesh, exact, pair.second)[pair.meets[i]]))
        result.push_back(fmt::format("pressures differ on facet {}", pair.first));
    }
  }
  return result;
}

Exact strain_energy(const scene::Problem<3>& problem, const Judged& exact) {
  Exact result;
  for (int cell = 0; cell < static_cast<int>(exact.x.size()); ++cell) {
    const Matrix hooke = stiffness(scene::body_of(problem, cell).material);
    const auto e = strain(exact, cell);
    std::array<Tensor, 4> s;
    for (int k = 0; k < 4; ++k) s[k] = times(hooke, e[k]);
    result += half * volume(exact.x[cell]) * mean_product(e, s);
  }
  return result;
}

Exact potential_energy(const scene::Problem<3>& problem, const Judged& exact) {
  Exact result = strain_energy(problem, exact);
  for (int cell = 0; cell < static_cast<int>(exact.x.size()); ++cell) {
    Point mean;  // quadratics have the means −1/20 and 1/5
    for (int node = 0; node < 10; ++node)
      mean = mean + Exact(Rational(node < 4 ? -1 : 4, 20)) * exact.displacement[cell][node];
    result -= volume(exact.x[cell]) * dot(point_of(scene::body_of(problem, cell).force), mean);
  }
  for (int f = 0; f < static_cast<int>(problem.facets.size()); ++f)
    if (problem.facets[f].support == Support::traction)
      result -= facet_work_of(data_load(problem, exact, f), on_boundary(problem.mesh, exact, f));
  return result;
}

Exact complementary_energy(const scene::Problem<3>& problem, const Judged& exact) {
  Exact result;
  for (int cell = 0; cell < static_cast<int>(exact.x.size()); ++cell) {
    const Matrix hooke = stiffness(scene::body_of(problem, cell).material);
    for (const auto& part : exact.stress[cell]) {
      std::array<Tensor, 4> e;
      for (int k = 0; k < 4; ++k) e[k] = strain_of(hooke, part[k]);
      result += half * quarter * volume(exact.x[cell]) * mean_product(e, part);
    }
  }
  // The displacements are what is prescribed there.
  for (int f = 0; f < static_cast<int>(problem.facets.size()); ++f)
    if (problem.facets[f].support == Support::fixed || problem.facets[f].support == Support::sliding)
      result -= facet_work_of(load_on(problem.mesh, exact, f), on_boundary(problem.mesh, exact, f));
  for (const auto& pair : problem.contact)
    result += facet_product(pressure_on(problem, exact, pair), gap_paid<Exact>(problem, exact.supports, pair));
  return result;
}

Exact contact_term(const scene::Problem<3>& problem, const Judged& exact) {
  Exact result;
  for (const auto& pair : problem.contact) {
    auto left = gap_paid<Exact>(problem, exact.supports, pair);
    const auto r = approach_of(problem, exact, pair);
    for (int k = 0; k < 6; ++k) left[k] -= r[k];
    result += facet_product(pressure_on(problem, exact, pair), left);
  }
  return result;
}

Exact distance(const scene::Problem<3>& problem, const Judged& exact) {
  Exact result = contact_term(problem, exact);
  for (int cell = 0; cell < static_cast<int>(exact.x.size()); ++cell) {
    const Matrix hooke = stiffness(scene::body_of(problem, cell).material);
    const auto e = strain(exact, cell);
    Tensor mean;
    for (int i = 0; i < 6; ++i) mean[i] = quarter * (e[0][i] + e[1][i] + e[2][i] + e[3][i]);
    for (int part = 0; part < 4; ++part) {
      std::array<Tensor, 4> difference, strains;
      for (int k = 0; k < 4; ++k) {
        difference[k] = times(hooke, k < 3 ? e[Simplex<3>::facets[part][k]] : mean);
        for (int i = 0; i < 6; ++i) difference[k][i] -= exact.stress[cell][part][k][i];
        strains[k] = strain_of(hooke, difference[k]);
      }
      result += half * quarter * volume(exact.x[cell]) * mean_product(strains, difference);
    }
  }
  return result;
}

void expect_holds_exactly(const scene::Problem<3>& problem, const Certificate& certificate, const Judged& exact) {
  ASSERT_EQ(exact.reason, "");
  EXPECT_EQ(displacement_faults(problem, exact), std::vector<std::string>{});
  EXPECT_EQ(stress_faults(problem, exact), std::vector<std::string>{});
  const Exact l = potential_energy(problem, exact), s = complementary_energy(problem, exact);
  EXPECT_EQ(l + s, distance(problem, exact));
  EXPECT_LE(Exact(certificate.lower), -s);
  EXPECT_GE(Exact(certificate.upper), l);
  EXPECT_LE(Exact(certificate.strain_energy), strain_energy(problem, exact));
  EXPECT_GE(Exact(certificate.contact), contact_term(problem, exact));
  // The certificate's own formulas are exact, too.
  EXPECT_EQ((field_energy<Exact, RationalSum>(problem, exact.supports, exact.field, exact.corrections).total), l);
  EXPECT_EQ((stress_energy<Exact, RationalSum>(problem, faces_of(problem.mesh), exact.supports, exact.loads)), s);
  // And its enclosures are narrow.
  const double size = std::abs(rounded(l)) + std::abs(rounded(s));
  EXPECT_LE(std::abs(certificate.upper - rounded(l)), 1e-13 * size);
  EXPECT_LE(std::abs(certificate.lower + rounded(s)), 1e-13 * size);
}

}  // namespace bracket::bounds::space
