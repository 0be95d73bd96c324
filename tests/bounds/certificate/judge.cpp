// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "bounds/certificate/functional.h"
#include "tests/bounds/certificate/judge_parts.h"

namespace bracket::bounds {

using scene::Support;

ExactDisplacement exact_displacement(const scene::Problem<2>& problem, const PlainField& field) {
  return exact_displacement(problem, field, supports_of(problem));
}

ExactDisplacement exact_displacement(const scene::Problem<2>& problem, const PlainField& field,
                                     const Supports& supports) {
  const auto& mesh = problem.mesh;
  const MovedField<Exact> all = moved<Exact>(problem, supports, field);
  const auto& indices = scene::bernstein_indices(field.degree);
  ExactDisplacement u;
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    std::array<Point, 3> at;
    for (int k = 0; k < 3; ++k) {
      const int v = mesh.cells[c][k];
      at[k] = vector2<Exact>(field.vertex[v]) + all.shifts[v];
    }
    Field own = {Polynomial::linear({at[0].x, at[1].x, at[2].x}), Polynomial::linear({at[0].y, at[1].y, at[2].y})};
    const auto offset = scene::on_cell(mesh, field.degree, all.offsets.edge, all.offsets.cell, static_cast<int>(c));
    for (std::size_t i = 0; i < offset.size(); ++i) {
      own[0] = own[0] + Polynomial::monomial(3, indices[i], Exact(scene::trinomial(indices[i])) * offset[i].x);
      own[1] = own[1] + Polynomial::monomial(3, indices[i], Exact(scene::trinomial(indices[i])) * offset[i].y);
    }
    u.cell.push_back(own);
  }
  return u;
}

ExactStress exact_stress(const scene::Problem<2>& problem, const EdgeLoads<Exact>& loads,
                         const std::vector<Corrected<Exact>>& added) {
  const auto& mesh = problem.mesh;
  ExactStress stress;
  stress.added = added;
  const auto& indices = scene::bernstein_indices(loads.degree);
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    LoadedCell<Exact> cell = loaded_cell(problem, loads, static_cast<int>(c));
    const Point force = vector2<Exact>(problem.bodies[mesh.cell_body[c]].force);
    // −(F_x y, F_y x) as shear stress and its like: −(0, 0, F_x y + F_y x) has the divergence −F.
    const auto carried = [&](const Point& x) { return -(force.x * x.y + force.y * x.x); };
    for (int i = 0; i < 3; ++i) {
      const Point n = outward(cell.x[(i + 1) % 3] - cell.x[i]);
      for (int end = 0; end < 2; ++end) {
        const Exact shear = carried(cell.x[(i + end) % 3]);
        cell.load[i][end] = cell.load[i][end] - Point{shear * n.y, shear * n.x};
      }
    }
    const auto linear = stress_of_balanced(cell.x, cell.load);
    const Point centroid = third * (cell.x[0] + cell.x[1] + cell.x[2]);
    std::array<StressField, 3> parts;
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k) {
        parts[i][k] = Polynomial::linear({linear[i][0][k], linear[i][1][k], linear[i][2][k]});
        if (k == 2)
          parts[i][k] =
              parts[i][k] + Polynomial::linear({carried(cell.x[i]), carried(cell.x[(i + 1) % 3]), carried(centroid)});
      }
    if (loads.degree > 1) {
      const auto higher = stress_of_higher(loads.degree, cell.x, higher_on(cell, loads), loads.bubbles[c]);
      for (int i = 0; i < 3; ++i)
        for (std::size_t place = 0; place < indices.size(); ++place)
          for (int k = 0; k < 3; ++k)
            parts[i][k] =
                parts[i][k] +
                Polynomial::monomial(3, indices[place], Exact(scene::trinomial(indices[place])) * higher[i][place][k]);
    }
    stress.cell.push_back(parts);
  }
  return stress;
}

namespace {

/// The field of a cell on its edges, from the lower vertex to the higher.
template <class OfCell> std::vector<std::vector<Field>> on_edges(const scene::Mesh<2>& mesh, const OfCell& of_cell) {
  std::vector<std::vector<Field>> result(mesh.edges.size());
  for (std::size_t c = 0; c < mesh.cells.size(); ++c)
    for (int i = 0; i < 3; ++i) {
      const int edge = mesh.cell_edges[c][(i + 2) % 3];
      const Field own = of_cell(static_cast<int>(c), i);
      result[edge].push_back(mesh.edges[edge][0] == mesh.cells[c][i] ? own : reversed(own));
    }
  return result;
}

}  // namespace

std::vector<std::string> faults(const scene::Problem<2>& problem, const ExactDisplacement& u) {
  const auto& mesh = problem.mesh;
  std::vector<std::string> result;
  const auto edges = on_edges(mesh, [&](int c, int i) { return on_side(u.cell[c], i, (i + 1) % 3); });
  for (std::size_t e = 0; e < edges.size(); ++e)
    if (edges[e].size() == 2 && !is_zero(edges[e][0] - edges[e][1]))
      result.push_back(fmt::format("displacements jump across edge {}", e));
  std::vector<char> fixed(mesh.vertices.size(), 0);
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    const auto& data = problem.facets[f];
    if (data.support != Support::fixed) continue;
    for (const int v : mesh.boundary[f].vertices) fixed[v] = 1;
    const Field given = between_points(vector2<Exact>(data.displacement[0]), vector2<Exact>(data.displacement[1]));
    if (!is_zero(displacement_on(mesh, u, static_cast<int>(f)) - given))
      result.push_back(fmt::format("fixed facet {}", f));
  }
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    const auto& data = problem.facets[f];
    if (data.support != Support::sliding) continue;
    const auto& [a, b] = mesh.boundary[f].vertices;
    const Point n = vector2<Exact>(data.normal);
    const Field on = displacement_on(mesh, u, static_cast<int>(f));
    std::array<Exact, 2> ends = {Exact(data.normal_displacement[0]), Exact(data.normal_displacement[1])};
    if (fixed[a]) ends[0] = dot(on, n).at_end(0);  // where a fixed facet begins, that one rules
    if (fixed[b]) ends[1] = dot(on, n).at_end(1);
    if (!is_zero(dot(on, n) - Polynomial::linear({ends[0], ends[1]})))
      result.push_back(fmt::format("sliding facet {}", f));
  }
  for (const auto& pair : problem.contact) {
    if (scene::has_springs(pair.law)) continue;
    const Polynomial r = approach(problem, u, pair);
    if (!pair.law.two_sided && !(r - gap_of(pair.lower)).is_not_positive())
      result.push_back(fmt::format("into contact facet {}", pair.first));
    if (pair.law.two_sided && !is_zero(r - gap(problem, pair)))
      result.push_back(fmt::format("apart on contact facet {}", pair.first));
    const Polynomial rounding = Polynomial::constant(2, Exact(1e-14 * problem.length_scale));
    if (pair.law.two_sided && (!(r - gap_of(pair.upper) - rounding).is_not_positive() ||
                               !(gap_of(pair.lower) - r - rounding).is_not_positive()))
      result.push_back(fmt::format("not along the gap of contact facet {}", pair.first));
  }
  return result;
}

namespace {

/// Whether a part of a cell is in equilibrium with the body force.
bool in_equilibrium(const StressField& s, const Corners& x, const Point& force) {
  const std::array<Point, 3> d = gradients(x);
  Field divergence = {Polynomial::constant(3, force.x), Polynomial::constant(3, force.y)};
  for (int k = 0; k < 3; ++k)
    divergence = divergence + on_normal({s[0].derivative(k), s[1].derivative(k), s[2].derivative(k)}, d[k]);
  return is_zero(divergence);
}

void check_cells(const scene::Problem<2>& problem, const ExactStress& stress, std::vector<std::string>& result) {
  const auto& mesh = problem.mesh;
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    const Corners x = corners_of(mesh, static_cast<int>(c));
    const Point centroid = third * (x[0] + x[1] + x[2]);
    const auto& s = stress.cell[c];
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3;
      if (!in_equilibrium(s[i], {x[i], x[j], centroid}, vector2<Exact>(problem.bodies[mesh.cell_body[c]].force)))
        result.push_back(fmt::format("no equilibrium in cell {}", c));
      const Point inner = outward(centroid - x[j]);  // between the parts i and j
      if (!is_zero(on_side(on_normal(s[i], inner), 1, 2) - on_side(on_normal(s[j], inner), 0, 2)))
        result.push_back(fmt::format("tractions jump in cell {}", c));
    }
  }
  const auto edges = on_edges(mesh, [&](int c, int i) {
    const Corners x = corners_of(mesh, c);
    return on_side(on_normal(stress.cell[c][i], outward(x[(i + 1) % 3] - x[i])), 0, 1);
  });
  for (std::size_t e = 0; e < edges.size(); ++e)
    if (edges[e].size() == 2 && !is_zero(edges[e][0] + edges[e][1]))
      result.push_back(fmt::format("tractions jump across edge {}", e));
}

}  // namespace

std::vector<std::string> faults(const scene::Problem<2>& problem, const ExactStress& stress) {
  std::vector<std::string> result;
  check_cells(problem, stress, result);
  std::vector<char> rubs(problem.facets.size(), 0);
  for (const auto& pair : problem.contact)
    for (const int side : {pair.first, pair.second})
      if (side >= 0) rubs[side] = scene::has_friction(pair.law);
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    const auto& data = problem.facets[f];
    const int facet = static_cast<int>(f);
    const Field load = load_on(problem.mesh, stress, facet);
    if (data.support == Support::traction && !is_zero(load - traction_on(problem, stress.added, facet)))
      result.push_back(fmt::format("traction on facet {}", f));
    const Point n = vector2<Exact>(data.normal);
    if ((data.support == Support::sliding || (data.support == Support::contact && !rubs[f])) &&
        !is_zero(dot(reaction_on(problem, stress, facet), turned(n))))
      result.push_back(fmt::format("shear on facet {}", f));
  }
  for (const auto& pair : problem.contact) {
    if (!pair.law.two_sided && !(Exact(-1) * pressure(problem, stress, pair)).is_not_positive())
      result.push_back(fmt::format("tension on facet {}", pair.first));
    if (scene::has_friction(pair.law)) {
      const Polynomial t = shear(problem, stress, pair), most = length_of(problem, pair) * linear_on(pair.law.friction);
      if (!(t - most).is_not_positive() || !(Exact(-1) * t - most).is_not_positive())
        result.push_back(fmt::format("shear beyond its bound on facet {}", pair.first));
    }
    if (pair.second >= 0 &&
        !is_zero(reaction_on(problem, stress, pair.first) + reversed(reaction_on(problem, stress, pair.second))))
      result.push_back(fmt::format("pressures differ on facet {}", pair.first));
  }
  return result;
}

Judged judged(const scene::Problem<2>& problem, const scene::Displacement<2>& displacement,
              const scene::Stress<2>& stress) {
  Judged result;
  result.field = admissible_field(problem, displacement, supports_of(problem)).field.value();
  const auto [corrections, reason] = corrected<Exact, RationalSum>(scene::first_of(problem));
  EXPECT_EQ(reason, "");
  result.loads = balanced<Exact, RationalSum>(problem, corrections, plain_loads(problem, stress)).loads.value();
  result.displacement = exact_displacement(problem, result.field);
  result.stress = exact_stress(problem, result.loads, corrections);
  return result;
}

std::vector<std::string> faults(const scene::Problem<2>& problem, const Certificate& certificate, const Judged& exact) {
  std::vector<std::string> result = faults(problem, exact.displacement);
  for (std::string& fault : faults(problem, exact.stress)) result.push_back(std::move(fault));
  const Exact l = potential_energy(problem, exact.displacement, exact.stress.added);
  const Exact s = complementary_energy(problem, exact.stress, exact.displacement);
  if (Exact(certificate.lower) > -s - law_complementary_energy(problem, exact.stress).lower)
    result.emplace_back("the lower bound is above −S");
  if (Exact(certificate.upper) < l + law_energy(problem, exact.displacement).lower)
    result.emplace_back("the upper bound is below L");
  return result;
}

void expect_holds_exactly(const scene::Problem<2>& problem, const Certificate& certificate, const Judged& exact) {
  EXPECT_EQ(faults(problem, certificate, exact), std::vector<std::string>{});
  const Exact l = potential_energy(problem, exact.displacement, exact.stress.added);
  const Exact s = complementary_energy(problem, exact.stress, exact.displacement);
  EXPECT_EQ(l + s, distance(problem, exact.stress, exact.displacement));
  // What the certificate evaluates is this identity with ∫ φ and ∫ φ* from above.
  const Supports supports = supports_of(problem);
  const Exact phi = field_energy<Exact, RationalSum>(problem, supports, exact.field, exact.stress.added).total - l;
  const Exact conjugate = stress_energy<Exact, RationalSum>(problem, exact.loads) - s;
  const Exact kappa = contact_work<Exact, RationalSum>(problem, supports, exact.field, exact.loads);
  EXPECT_EQ(kappa, phi + conjugate + contact_term(problem, exact.stress, exact.displacement));
  EXPECT_GE(kappa, Exact(0));
  EXPECT_GE(Exact(certificate.contact), kappa);
  const Around of_displacement = law_energy(problem, exact.displacement);
  const Around of_stress = law_complementary_energy(problem, exact.stress);
  EXPECT_GE(phi, of_displacement.lower);
  EXPECT_GE(conjugate, of_stress.lower);
}

}  // namespace bracket::bounds
