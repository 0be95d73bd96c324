// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bounds/certificate/admissible_displacement.h"
#include "bounds/certificate/arithmetic.h"
#include "bounds/certificate/elastic_form.h"
#include "bounds/certificate/laws.h"
#include "scene/parallel.h"

/// The energy of displacements: real numbers that `Number` encloses or holds exactly.
namespace bracket::bounds {

template <class Number> struct FieldEnergy {
  Number strain;  ///< ½ A(v,v)
  Number total;   ///< L(v), and what contact laws add, not below
};

/// A correction of the first mesh's loads, by its true amount.
template <class Number> struct Corrected {
  int facet;  ///< of the first mesh
  FacetLoad<Number> load;
};

/// Adds what corrections have on a facet of Γ_τ to a load on it.
template <class Number>
void add_corrections(const scene::Problem<2>& problem, const std::vector<Corrected<Number>>& corrections, int facet,
                     FacetLoad<Number>& load) {
  if (corrections.empty()) return;
  const auto [of, corner] = scene::piece_of_facet(problem, facet);
  const Number width(corner[1][0] - corner[0][0]);
  for (const auto& [corrected, added] : corrections)
    for (int i = 0; i < 2 && corrected == of; ++i)
      load[i] = load[i] + width * between_ends(added[0], added[1], corner[i][0]);
}

/// All that is prescribed as the load of a facet, per unit of its parameter.
template <class Number>
WholeLoad<Number> prescribed_load(const scene::Problem<2>& problem, const std::vector<Corrected<Number>>& corrections,
                                  int facet) {
  WholeLoad<Number> load = given_load<Number>(problem, facet);
  add_corrections(problem, corrections, facet, load.linear);
  return load;
}

/// Whether anything is prescribed as its load.
template <class Number>
bool carries_load(const scene::Problem<2>& problem, const std::vector<Corrected<Number>>& corrections, int facet) {
  const int of = scene::piece_of_facet(problem, facet).of;
  return scene::is_loaded(scene::first_of(problem).facets[of]) || has_perturbing_load(problem, facet) ||
         std::any_of(corrections.begin(), corrections.end(), [&](const auto& one) { return one.facet == of; });
}

/// The field that a plain one stands for.
template <class Number> struct MovedField {
  std::vector<Vector2<Number>> shifts;      ///< of all vertices, to be added to the plain displacements
  scene::Offsets<Vector2<Number>> offsets;  ///< moved onto supports and ties
};
template <class Number>
MovedField<Number> moved(const scene::Problem<2>& problem, const Supports& supports, const PlainField& field) {
  MovedField<Number> result;
  for (std::size_t v = 0; v < field.vertex.size(); ++v)
    result.shifts.push_back(shift<Number>(supports, field, static_cast<int>(v)));
  for (const auto& w : field.offset.edge) result.offsets.edge.push_back(vector2<Number>(w));
  for (const auto& w : field.offset.cell) result.offsets.cell.push_back(vector2<Number>(w));
  const int n = scene::n_inside_edge(field.degree);
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    if (problem.facets[f].support != scene::Support::sliding) continue;
    for (int k = 0; k < n; ++k) {
      Vector2<Number>& w = result.offsets.edge[n * problem.mesh.boundary[f].edge + k];
      w = w + onto(w, problem.facets[f].normal, Number(0));
    }
  }
  for (const auto& pair : problem.contact) {
    if (!keeps_together(pair.law) || n == 0) continue;
    const auto factors = tied_offsets<Number>(problem, supports, field, pair);
    const Vector2<Number> d = vector2<Number>(problem.facets[pair.first].normal);
    const auto at = [&](int facet, int k) -> Vector2<Number>& {
      const auto& on = problem.mesh.boundary[facet];
      return result.offsets.edge[scene::place_inside_edge(problem.mesh, field.degree, on.edge, on.vertices[0], k)];
    };
    for (int k = 1; k <= n; ++k) {
      at(pair.first, k) = at(pair.first, k) + factors[k] * d;
      if (pair.second >= 0) at(pair.second, field.degree - k) = at(pair.second, field.degree - k) - factors[k] * d;
    }
  }
  return result;
}

/// The strain on a cell (xx, yy and twice xy), by Bernstein coefficients of one degree less.
template <class Number>
std::vector<std::array<Number, 3>> cell_strain(const scene::Problem<2>& problem, const PlainField& field,
                                               const MovedField<Number>& moved, int cell) {
  const auto& mesh = problem.mesh;
  const auto& v = mesh.cells[cell];
  const std::array<Vector2<Number>, 3> x = corners<Number>(problem, cell);
  const Number by_doubled_area = Number(1) / doubled_area(x);
  std::array<Vector2<Number>, 3> gradient;  // of φ
  for (int k = 0; k < 3; ++k) gradient[k] = by_doubled_area * turned(x[(k + 2) % 3] - x[(k + 1) % 3]);
  std::array<Number, 3> linear = {Number(0), Number(0), Number(0)};
  const auto add = [&](std::array<Number, 3>& strain, const Vector2<Number>& slope, int k) {
    strain[0] += slope.x * gradient[k].x;
    strain[1] += slope.y * gradient[k].y;
    strain[2] += slope.x * gradient[k].y + slope.y * gradient[k].x;
  };
  for (int j = 1; j < 3; ++j)
    add(linear, between<Number>(field.vertex[v[0]], field.vertex[v[j]]) + (moved.shifts[v[j]] - moved.shifts[v[0]]), j);
  if (field.degree == 1) return {linear};
  const auto offset = scene::on_cell(mesh, field.degree, moved.offsets.edge, moved.offsets.cell, cell);
  const Number factor(field.degree);
  std::vector<std::array<Number, 3>> strain;
  for (const auto& i : scene::bernstein_indices(field.degree - 1)) {
    strain.push_back(linear);
    for (int k = 0; k < 3; ++k) {
      if (i[k] == field.degree - 1) continue;  // that of a vertex is zero
      std::array<int, 3> above = i;
      ++above[k];
      add(strain.back(), factor * offset[scene::bernstein_place(above)], k);
    }
  }
  return strain;
}

/// The strain energy of one cell.
template <class Number>
Number cell_strain_energy(const scene::Problem<2>& problem, const ElasticForm<Number>& form, const PlainField& field,
                          const MovedField<Number>& moved, int cell) {
  return integral([&](const std::array<Number, 3>& e) { return form.strain_energy(e); },
                  cell_strain(problem, field, moved, cell), doubled_area(corners<Number>(problem, cell)));
}

/// ∫ F·u over a cell.
template <class Number>
Number cell_work(const scene::Problem<2>& problem, const PlainField& field, const MovedField<Number>& moved,
                 const Vector2<Number>& force, int cell) {
  const auto& mesh = problem.mesh;
  Vector2<Number> linear, beside;  // three times its mean, and n times that of what is beside
  for (const int v : mesh.cells[cell]) linear = linear + vector2<Number>(field.vertex[v]) + moved.shifts[v];
  if (field.degree > 1)
    for (const auto& w : scene::on_cell(mesh, field.degree, moved.offsets.edge, moved.offsets.cell, cell))
      beside = beside + w;
  const Vector2<Number> mean =
      (Number(1) / Number(3)) * linear + (Number(1) / Number(scene::n_bernstein(field.degree))) * beside;
  return doubled_area(corners<Number>(problem, cell)) / Number(2) * dot(force, mean);
}

/// ∫ T·u dτ over a facet. What is linear of u is orthogonal to what is not of T.
template <class Number>
Number facet_work(const scene::Mesh<2>& mesh, const PlainField& field, const MovedField<Number>& moved, int facet,
                  const WholeLoad<Number>& load) {
  std::array<Vector2<Number>, 2> u;
  for (int i = 0; i < 2; ++i) {
    const int v = mesh.boundary[facet].vertices[i];
    u[i] = vector2<Number>(field.vertex[v]) + moved.shifts[v];
  }
  Number work = linear_product(load.linear, u);
  for (int k = 1; k < field.degree; ++k) {
    Vector2<Number> moment;
    for (int i = 0; i < 2; ++i)
      moment = moment + scene::number<Number>(scene::bernstein_mass(field.degree, k, 1, i)) * load.linear[i];
    for (int j = 2; j <= load.degree; ++j)
      moment = moment + scene::legendre_moment<Number>(field.degree, k, j) * load.higher[j - 2];
    const auto& at = mesh.boundary[facet];
    work += dot(moment, moved.offsets.edge[scene::place_inside_edge(mesh, field.degree, at.edge, at.vertices[0], k)]);
  }
  return work;
}

/// The same moved field with another kind of number.
template <class To, class From> MovedField<To> moved_as(const MovedField<From>& moved) {
  const auto all = [](const std::vector<Vector2<From>>& vectors) {
    std::vector<Vector2<To>> result;
    result.reserve(vectors.size());
    for (const auto& v : vectors) result.push_back(as<To>(v));
    return result;
  };
  return {all(moved.shifts), {all(moved.offsets.edge), all(moved.offsets.cell)}};
}

/// ½ A(v,v). \tparam Of what each cell's is computed with, to be a `Number`   \tparam Sum with add() and value()
template <class Number, class Sum, class Of>
Number strain_energy(const scene::Problem<2>& problem, const std::vector<ElasticForm<Of>>& forms,
                     const PlainField& field, const MovedField<Of>& moved) {
  const auto of_cells = [&](int begin, int end) {
    check_arithmetic();
    Sum sum;
    for (int cell = begin; cell < end; ++cell)
      sum.add(cell_strain_energy(problem, forms[problem.mesh.cell_body[cell]], field, moved, cell));
    return sum.value();
  };
  Sum energy;
  for (const Number& part : scene::of_chunks<Number>(static_cast<int>(problem.mesh.cells.size()), of_cells))
    energy.add(part);
  return energy.value();
}

/// What L has beside it [HH81 §1]: −ℓ(v), and ∫ φ of its contact laws.
/// \param corrections as corrected() has them   \tparam Sum with add() and value()
template <class Number, class Sum>
Number load_energy(const scene::Problem<2>& problem, const Supports& supports, const PlainField& field,
                   const MovedField<Number>& all, const std::vector<Corrected<Number>>& corrections) {
  const auto& mesh = problem.mesh;
  const auto of_cells = [&](int begin, int end) {
    check_arithmetic();
    Sum sum;
    for (int cell = begin; cell < end; ++cell)
      if (const int body = mesh.cell_body[cell]; has_force(problem, body))
        sum.add(cell_work(problem, field, all, body_force<Number>(problem, body), cell));
    return sum.value();
  };
  Sum work;
  for (const Number& part : scene::of_chunks<Number>(static_cast<int>(mesh.cells.size()), of_cells)) work.add(part);
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    const int facet = static_cast<int>(f);
    if (!carries_load(problem, corrections, facet)) continue;
    work.add(facet_work<Number>(mesh, field, all, facet, prescribed_load(problem, corrections, facet)));
  }
  for (const auto& pair : problem.contact) {
    if (!problem.perturbed.by) break;
    work.add(Number(problem.perturbed.loads) * contact_load_work<Number>(problem, supports, field, pair));
  }
  Number energy = -work.value();
  for (const auto& pair : problem.contact)
    if (has_law(pair.law)) energy += law_energy<Number>(problem, supports, field, pair);
  return energy;
}

/// L of the field that `field` stands for, with ∫ φ of its contact laws.
template <class Number, class Sum>
FieldEnergy<Number> field_energy(const scene::Problem<2>& problem, const Supports& supports, const PlainField& field,
                                 const std::vector<Corrected<Number>>& corrections) {
  const MovedField<Number> all = moved<Number>(problem, supports, field);
  const Number strain = strain_energy<Number, Sum>(problem, elastic_forms<Number>(problem), field, all);
  return {strain, strain + load_energy<Number, Sum>(problem, supports, field, all, corrections)};
}

}  // namespace bracket::bounds
