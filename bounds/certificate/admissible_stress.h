// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "bounds/certificate/block_stress.h"
#include "bounds/certificate/displacement_energy.h"
#include "scene/fields.h"
#include "scene/parallel.h"

/// Edge loads in balance with the data exactly, and the energy of their stresses: real numbers that `Number` encloses
/// or holds exactly.
namespace bracket::bounds {

/// The loads on all edges as plain numbers, per unit of the parameter along the edge, from its first vertex a to its
/// second b, on the cell that lies to the left of ab; on the other cell they are opposite. So tractions are continuous.
/// On Γ_τ, where the data say what they are, they are left out.
struct PlainLoads {
  int degree = 1;                                          ///< of the stresses, 1 to 3
  std::vector<std::array<scene::Vector<2>, 2>> edge = {};  ///< at a and b; zero on Γ_τ, Γ_0 and Γ_K
  /// What is not linear: degree − 1 coefficients of Legendre's polynomials each, from a to b; zero there, too.
  std::vector<scene::Vector<2>> higher = {};
  /// Of each facet, degree + 1 Bernstein coefficients from its vertex 0 to its vertex 1: Γ_0: along the outward normal;
  /// Γ_K, first sides only: the pressure, ≥ 0 but for two-sided ones.
  std::vector<std::vector<double>> along_normal = {};
  /// On first sides with friction likewise the shear, within its bound; else empty.
  std::vector<std::vector<double>> along_tangent = {};
  std::vector<std::vector<double>> bubbles = {};  ///< of each cell, of scene::block_fields(); degree 1: none
};
PlainLoads plain_loads(const scene::Problem<2>& problem, const scene::Stress<2>& stress);
/// The loads of the data alone. \param pressure on all of Γ_K
PlainLoads no_loads(const scene::Problem<2>& problem, double pressure = 0);
/// Which contact pairs press anywhere, or may as well pull. The others have no shear.
std::vector<char> carrying_pairs(const scene::Problem<2>& problem, const PlainLoads& loads);
/// Takes the shear off the pairs that carry nothing.
void drop_idle_shear(const scene::Problem<2>& problem, PlainLoads& loads);

/// The same loads with `Number`, those of the data included.
template <class Number> struct EdgeLoads {
  int degree = 1;
  std::vector<SideLoad<Number>> edge = {};
  std::vector<Vector2<Number>> higher = {};
  std::vector<std::vector<Number>> along_normal = {};
  std::vector<std::vector<Number>> along_tangent = {};
  std::vector<std::vector<double>> bubbles = {};
};

/// A load on a facet, by Bernstein coefficients along it, as what is linear of it and the coefficients of Legendre's
/// polynomials beside that.
template <class Value> struct SplitLoad {
  std::array<Value, 2> linear;
  std::vector<Value> higher;
};
template <class Number, class Value> SplitLoad<Value> split(const std::vector<Value>& c) {
  const auto times = [](int part, int whole, const Value& v) { return scene::share<Number, Value>(v, part, whole); };
  if (c.size() == 2) return {{c[0], c[1]}, {}};
  if (c.size() == 3) {  // P_2 = 6 t² − 6 t + 1 is 1 at both ends
    const Value second = times(1, 6, Value(c[0] - c[1] - c[1] + c[2]));
    return {{Value(c[0] - second), Value(c[2] - second)}, {second}};
  }
  const Value bend = Value(c[1] - c[2] + c[1] - c[2] + c[1] - c[2]);  // P_3 = 20 t³ − 30 t² + 12 t − 1
  const Value third = times(1, 20, Value(c[3] - c[0] + bend));
  const Value second = Value(times(1, 2, Value(c[0] - c[1] - c[1] + c[2])) + times(5, 1, third));
  return {{Value(c[0] - second + third), Value(c[3] - second - third)}, {second, third}};
}

/// Whether a facet runs as its edge does, from the lower vertex to the higher.
inline bool forward(const scene::Mesh<2>::Facet& facet) { return facet.vertices[0] < facet.vertices[1]; }

/// A load given in the order of a facet's or side's ends, in that of its edge, and the other way round.
template <class Number> SideLoad<Number> oriented(const SideLoad<Number>& load, bool forward) {
  return forward ? load : SideLoad<Number>{-load[1], -load[0]};
}

/// The same for the coefficients of Legendre's polynomials of degree 2, 3: the even ones do not change with the sense.
template <class Number> Vector2<Number> oriented_higher(const Vector2<Number>& coefficient, int k, bool forward) {
  return forward || k % 2 == 1 ? coefficient : -coefficient;
}

/// \param load its `higher` counts as far as the loads' degree, above which there is none
template <class Number>
void set_whole_load(EdgeLoads<Number>& loads, const scene::Mesh<2>& mesh, int facet, const WholeLoad<Number>& load) {
  const auto& at = mesh.boundary[facet];
  loads.edge[at.edge] = oriented(load.linear, forward(at));
  for (int k = 2; k <= loads.degree; ++k)
    loads.higher[(loads.degree - 1) * at.edge + k - 2] = oriented_higher(load.higher[k - 2], k, forward(at));
}
template <class Number>
void set_boundary_load(EdgeLoads<Number>& loads, const scene::Mesh<2>& mesh, int facet, const SideLoad<Number>& load) {
  loads.edge[mesh.boundary[facet].edge] = oriented(load, forward(mesh.boundary[facet]));
}

/// What a perturbation has on a facet of Γ_0 or Γ_K beside what acts there: it is linear.
template <class Number> SideLoad<Number> beside(const scene::Problem<2>& problem, int facet) {
  SideLoad<Number> load = perturbing_load<Number>(problem, facet).linear;
  for (auto& end : load) end = Number(problem.perturbed.loads) * end;
  return load;
}

/// Writes the loads of Γ_0 and Γ_K into the edges.
template <class Number> void spread_loads(const scene::Problem<2>& problem, EdgeLoads<Number>& loads) {
  const auto along = [&](int facet, const std::vector<Number>& coefficients) {
    const auto& at = problem.mesh.boundary[facet];
    const Vector2<Number> n = vector2<Number>(problem.facets[facet].normal);
    const auto [linear, higher] = split<Number>(coefficients);
    set_boundary_load(loads, problem.mesh, facet, {linear[0] * n, linear[1] * n});
    for (int k = 2; k <= loads.degree; ++k)
      loads.higher[(loads.degree - 1) * at.edge + k - 2] = oriented_higher(higher[k - 2] * n, k, forward(at));
  };
  const auto add_shear = [&](int facet, const std::vector<Number>& coefficients) {
    const auto& at = problem.mesh.boundary[facet];
    const Vector2<Number> t = turned(vector2<Number>(problem.facets[facet].normal));
    const auto [linear, higher] = split<Number>(coefficients);
    const SideLoad<Number> added = oriented<Number>({linear[0] * t, linear[1] * t}, forward(at));
    for (int end = 0; end < 2; ++end) loads.edge[at.edge][end] = loads.edge[at.edge][end] + added[end];
    for (int k = 2; k <= loads.degree; ++k) {
      auto& of_edge = loads.higher[(loads.degree - 1) * at.edge + k - 2];
      of_edge = of_edge + oriented_higher(higher[k - 2] * t, k, forward(at));
    }
  };
  for (std::size_t f = 0; f < problem.facets.size(); ++f)
    if (problem.facets[f].support == scene::Support::sliding) along(static_cast<int>(f), loads.along_normal[f]);
  for (const auto& pair : problem.contact) {
    std::vector<Number> load = loads.along_normal[pair.first];
    const auto [at0, at1] = opening_load<Number>(problem, pair);
    for (int k = 0; k <= loads.degree; ++k) {
      load[k] = -load[k];
      if (problem.perturbed.by)
        load[k] += Number(problem.perturbed.loads) * scene::linear_coefficient<Number>(at0, at1, loads.degree, k);
    }
    along(pair.first, load);
    std::reverse(load.begin(), load.end());
    if (pair.second >= 0) along(pair.second, load);  // its normal is the opposite
    if (loads.along_tangent[pair.first].empty()) continue;
    std::vector<Number> shear;
    const auto [shear0, shear1] = shear_load<Number>(problem, pair);
    for (int k = 0; k <= loads.degree; ++k) {
      shear.push_back(-loads.along_tangent[pair.first][k]);
      if (problem.perturbed.by)
        shear[k] +=
            Number(problem.perturbed.loads) * scene::linear_coefficient<Number>(shear0, shear1, loads.degree, k);
    }
    add_shear(pair.first, shear);
    std::reverse(shear.begin(), shear.end());
    if (pair.second >= 0) add_shear(pair.second, shear);
  }
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    const int facet = static_cast<int>(f);
    if (problem.facets[f].support == scene::Support::traction || !has_perturbing_load(problem, facet)) continue;
    const auto& at = problem.mesh.boundary[f];
    const SideLoad<Number> added = oriented(beside<Number>(problem, facet), forward(at));
    for (int end = 0; end < 2; ++end) loads.edge[at.edge][end] = loads.edge[at.edge][end] + added[end];
  }
}

/// \param corrections as corrected() has them
template <class Number>
EdgeLoads<Number> loads_of(const scene::Problem<2>& problem, const PlainLoads& given,
                           const std::vector<Corrected<Number>>& corrections) {
  EdgeLoads<Number> loads{.degree = given.degree, .bubbles = given.bubbles};
  for (const auto& [a, b] : given.edge) loads.edge.push_back({vector2<Number>(a), vector2<Number>(b)});
  for (const auto& coefficient : given.higher) loads.higher.push_back(vector2<Number>(coefficient));
  for (const auto& coefficients : given.along_normal)
    loads.along_normal.emplace_back(coefficients.begin(), coefficients.end());
  for (const auto& coefficients : given.along_tangent)
    loads.along_tangent.emplace_back(coefficients.begin(), coefficients.end());
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    const int facet = static_cast<int>(f);
    if (carries_load(problem, corrections, facet))
      set_whole_load(loads, problem.mesh, facet, prescribed_load(problem, corrections, facet));
  }
  spread_loads(problem, loads);
  return loads;
}

/// A cell's corners as seen from its first, and the loads on its sides i → i + 1.
template <class Number> struct LoadedCell {
  std::array<Vector2<Number>, 3> x;
  std::array<SideLoad<Number>, 3> load;
  std::array<int, 3> edge;
  std::array<bool, 3> forward;
};
/// What the loads have beside what is linear, likewise.
template <class Number>
std::array<std::vector<Vector2<Number>>, 3> higher_on(const LoadedCell<Number>& cell, const EdgeLoads<Number>& loads) {
  std::array<std::vector<Vector2<Number>>, 3> higher;
  for (int i = 0; i < 3; ++i)
    for (int k = 2; k <= loads.degree; ++k) {
      const auto& of_edge = loads.higher[(loads.degree - 1) * cell.edge[i] + k - 2];
      higher[i].push_back(oriented_higher(of_edge, k, cell.forward[i]));
    }
  return higher;
}
template <class Number>
LoadedCell<Number> loaded_cell(const scene::Problem<2>& problem, const EdgeLoads<Number>& loads, int cell) {
  const auto& mesh = problem.mesh;
  LoadedCell<Number> result;
  result.x = corners<Number>(problem, cell);
  const auto& v = mesh.cells[cell];
  for (int i = 0; i < 3; ++i) {
    result.edge[i] = mesh.cell_edges[cell][(i + 2) % 3];
    result.forward[i] = mesh.edges[result.edge[i]][0] == v[i];
    result.load[i] = oriented(loads.edge[result.edge[i]], result.forward[i]);
  }
  return result;
}

/// What is left of a cell's loads and its body force, about its first corner.
template <class Number>
Wrench<Number> imbalance(const scene::Problem<2>& problem, const LoadedCell<Number>& block, int cell) {
  Wrench<Number> sum;
  for (int i = 0; i < 3; ++i) {
    const auto part = resultant(block.load[i], block.x[i], block.x[(i + 1) % 3] - block.x[i]);
    sum.force = sum.force + part.force;
    sum.moment += part.moment;
  }
  const int body = problem.mesh.cell_body[cell];
  if (!has_force(problem, body)) return sum;
  const Vector2<Number> weight = (doubled_area(block.x) / Number(2)) * body_force<Number>(problem, body);
  sum.force = sum.force + weight;
  sum.moment += cross(block.x[1] + block.x[2], weight) / Number(3);
  return sum;
}

/// What is linear of the stress of a cell in balance. A body force F is carried by −(F_x ξ, F_y η, 0), ξ, η from the
/// centroid.
template <class Number>
BlockStress<Number> linear_block_stress(const scene::Problem<2>& problem, LoadedCell<Number> block, int cell) {
  const int body = problem.mesh.cell_body[cell];
  std::array<std::array<Number, 2>, 3> carried;  // xx, yy at the corners
  const bool heavy = has_force(problem, body);
  if (heavy) {
    const Vector2<Number> f = body_force<Number>(problem, body);
    const Vector2<Number> centroid = (Number(1) / Number(3)) * (block.x[0] + block.x[1] + block.x[2]);
    for (int i = 0; i < 3; ++i) carried[i] = {f.x * (centroid.x - block.x[i].x), f.y * (centroid.y - block.x[i].y)};
    for (int i = 0; i < 3; ++i) {
      const Vector2<Number> e = block.x[(i + 1) % 3] - block.x[i];  // n ds = (e_y, −e_x)
      for (int end = 0; end < 2; ++end) {
        const auto& [xx, yy] = carried[(i + end) % 3];
        block.load[i][end] = block.load[i][end] - Vector2<Number>{xx * e.y, -(yy * e.x)};
      }
    }
  }
  BlockStress<Number> stress = stress_of_balanced(block.x, block.load);
  for (int i = 0; heavy && i < 3; ++i)
    for (int end = 0; end < 2; ++end)
      for (int k = 0; k < 2; ++k) stress[i][end][k] += carried[(i + end) % 3][k];
  return stress;
}

/// The stress of a cell in balance.
template <class Number>
BlockStress<Number> block_stress(const scene::Problem<2>& problem, const EdgeLoads<Number>& loads,
                                 const LoadedCell<Number>& block, int cell) {
  BlockStress<Number> stress = linear_block_stress(problem, block, cell);
  if (loads.degree == 1) return stress;
  const BlockStress<Number> higher =
      stress_of_higher(loads.degree, block.x, higher_on(block, loads), loads.bubbles[cell]);
  for (int i = 0; i < 3; ++i) {
    stress[i] = raised(stress[i], 1, loads.degree);
    for (std::size_t k = 0; k < stress[i].size(); ++k)
      for (int c = 0; c < 3; ++c) stress[i][k][c] += higher[i][k][c];
  }
  return stress;
}

/// S of a cell in balance.
template <class Number>
Number block_energy(const scene::Problem<2>& problem, const ElasticForm<Number>& form, const EdgeLoads<Number>& loads,
                    int cell) {
  const LoadedCell<Number> block = loaded_cell(problem, loads, cell);
  const Number part = doubled_area(block.x) / Number(3);
  Number sum(0);
  for (const auto& coefficients : block_stress(problem, loads, block, cell))
    sum += integral([&](const std::array<Number, 3>& s) { return form.stress_energy(s); }, coefficients, part);
  return sum;
}

/// The loads on edges with another kind of number, and no others.
template <class To, class From> EdgeLoads<To> on_edges(const EdgeLoads<From>& loads) {
  EdgeLoads<To> result{.degree = loads.degree, .bubbles = loads.bubbles};
  result.edge.reserve(loads.edge.size());
  for (const auto& [a, b] : loads.edge) result.edge.push_back({as<To>(a), as<To>(b)});
  result.higher.reserve(loads.higher.size());
  for (const auto& coefficient : loads.higher) result.higher.push_back(as<To>(coefficient));
  return result;
}

/// ½ ∫ λ : C⁻¹ λ of the stresses of balanced loads. \tparam Of what each cell's is computed with, to be a `Number`
template <class Number, class Sum, class Of>
Number energy_of_blocks(const scene::Problem<2>& problem, const std::vector<ElasticForm<Of>>& forms,
                        const EdgeLoads<Of>& loads) {
  const auto of_cells = [&](int begin, int end) {
    check_arithmetic();
    Sum sum;
    for (int cell = begin; cell < end; ++cell)
      sum.add(block_energy(problem, forms[problem.mesh.cell_body[cell]], loads, cell));
    return sum.value();
  };
  Sum energy;
  for (const Number& part : scene::of_chunks<Number>(static_cast<int>(problem.mesh.cells.size()), of_cells))
    energy.add(part);
  return energy.value();
}

/// What S(λ) [HH81 (1.11)] has beside it, on supports and contacts, ∫ φ* of the contact laws from above. \tparam Sum
/// with add() and value()
template <class Number, class Sum>
Number energy_of_boundary(const scene::Problem<2>& problem, const EdgeLoads<Number>& loads) {
  const auto& mesh = problem.mesh;
  Sum energy;
  const auto fixed = fixed_vertices(scene::first_of(problem));
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    const int facet = static_cast<int>(f);
    if (problem.facets[f].support == scene::Support::fixed) {
      const SideLoad<Number> load = oriented(loads.edge[mesh.boundary[f].edge], forward(mesh.boundary[f]));
      energy.add(-linear_product(load, held_at<Number>(problem, facet)));
    } else if (problem.facets[f].support == scene::Support::sliding) {
      const auto [begin, end] = slides_of(problem, fixed, facet);
      energy.add(-scene::bernstein_product(loads.along_normal[f],
                                           std::vector<Number>{value<Number>(begin), value<Number>(end)}));
    }
  }
  const FirstContacts contacts = first_contacts(problem);
  for (const auto& pair : problem.contact) {
    const std::vector<Number>& pressure = loads.along_normal[pair.first];
    energy.add(scene::bernstein_product(pressure, gap_paid<Number>(problem, contacts, pair, 2)));
    if (scene::has_springs(pair.law)) energy.add(compliance_energy(problem, contacts, pair, pressure));
    if (scene::has_friction(pair.law))
      energy.add(friction_paid(problem, contacts, pair, loads.along_tangent[pair.first]));
  }
  return energy.value();
}

/// S(λ) of the stresses of balanced loads.
template <class Number, class Sum>
Number stress_energy(const scene::Problem<2>& problem, const EdgeLoads<Number>& loads) {
  return energy_of_blocks<Number, Sum>(problem, elastic_forms<Number>(problem), loads) +
         energy_of_boundary<Number, Sum>(problem, loads);
}

}  // namespace bracket::bounds
