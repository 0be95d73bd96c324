// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <optional>

#include "bounds/certificate/arithmetic.h"
#include "bounds/certificate/elastic_form.h"
#include "bounds/certificate/geometry.h"
#include "scene/offsets.h"
#include "scene/parallel.h"

/// Displacements that are in K exactly, and their energy: real numbers that `Number` encloses or holds exactly.
namespace bracket::bounds {

/// What a perturbation adds to the displacements prescribed at the ends of a facet of the first mesh.
struct Added {
  std::array<scene::TwofoldVector<2>, 2> end = {};  ///< U
  std::array<double, 2> normal = {0, 0};            ///< of U_n beside U·n
  double factor = 0;                                ///< 0: nothing
};

/// The displacement that a facet of Γ_u on the first mesh prescribes, at a point of it.
struct Held {
  std::array<scene::Vector<2>, 2> end = {scene::Vector<2>::Zero(), scene::Vector<2>::Zero()};  ///< at its vertices
  double t = 0;  ///< the point: 0 at vertex 0, 1 at vertex 1
  Added added = {};
};
/// U there.
template <class Number> Vector2<Number> added(const Held& held) {
  return between_ends(vector2<Number>(held.added.end[0]), vector2<Number>(held.added.end[1]), held.t);
}

/// What a facet of Γ_0 on the first mesh prescribes along its normal, at a point of it: linear between its vertices. At
/// a vertex that is fixed it is what that displacement has along the normal.
struct Slide {
  scene::Vector<2> normal = scene::Vector<2>::Zero();
  std::array<double, 2> end = {0, 0};
  std::array<bool, 2> fixed = {false, false};
  std::array<scene::Vector<2>, 2> displacement = {scene::Vector<2>::Zero(), scene::Vector<2>::Zero()};  ///< where fixed
  double t = 0;
  Added added = {};
};
/// U_n there.
template <class Number> Number added(const Slide& slide) {
  const Vector2<Number> n = vector2<Number>(slide.normal);
  std::array<Number, 2> end;
  for (int i = 0; i < 2; ++i) end[i] = dot(vector2<Number>(slide.added.end[i]), n) + Number(slide.added.normal[i]);
  return between_ends(end[0], end[1], slide.t);
}
template <class Number> Number value(const Slide& slide) {
  std::array<Number, 2> end;
  for (int i = 0; i < 2; ++i)
    end[i] = slide.fixed[i] ? dot(vector2<Number>(slide.displacement[i]), vector2<Number>(slide.normal))
                            : Number(slide.end[i]);
  const Number own = between_ends(end[0], end[1], slide.t);
  return slide.added.factor == 0 ? own : own + Number(slide.added.factor) * added<Number>(slide);
}

/// What the supports prescribe at a vertex.
struct VertexSupport {
  bool fixed = false;
  Held held;       ///< if fixed
  int slides = 0;  ///< else: u·normal = value, for up to two normals
  std::array<Slide, 2> slide;
};
std::vector<VertexSupport> vertex_supports(const scene::Problem<2>& problem);

/// Of each vertex of the first mesh: the facet of Γ_u that holds it, −1: none, and which of its ends it is.
struct FacetEnd {
  int facet = -1;
  int end = 0;
};
std::vector<FacetEnd> fixed_vertices(const scene::Problem<2>& first);
/// What is prescribed at the ends of a facet of Γ_0. \param fixed as fixed_vertices() has them
std::array<Slide, 2> slides_of(const scene::Problem<2>& problem, const std::vector<FacetEnd>& fixed, int facet);
/// What is prescribed at the ends of a facet of Γ_u.
std::array<Held, 2> holds_of(const scene::Problem<2>& problem, int facet);
template <class Number> std::array<Vector2<Number>, 2> held_at(const scene::Problem<2>& problem, int facet) {
  std::array<Vector2<Number>, 2> u;
  const auto holds = holds_of(problem, facet);
  for (int i = 0; i < 2; ++i) {
    const auto& [a, b] = holds[i].end;
    u[i] = between_ends(vector2<Number>(a), vector2<Number>(b), holds[i].t);
    if (holds[i].added.factor != 0) u[i] = u[i] + Number(holds[i].added.factor) * added<Number>(holds[i]);
  }
  return u;
}

/// Displacements as plain numbers: a linear field and what is added to its Bernstein coefficients (scene/offsets.h).
/// The field they stand for is moved onto the supports exactly by shift(), and offsets on Γ_0 by onto(), which are of
/// the size of rounding.
struct PlainField {
  int degree = 1;
  std::vector<scene::Vector<2>> vertex = {};
  scene::Offsets<scene::Vector<2>> offset = {};
};

/// The vector along `normal` that moves u onto u·normal = value.
template <class Number>
Vector2<Number> onto(const Vector2<Number>& u, const scene::Vector<2>& normal, const Number& value) {
  const Vector2<Number> n = vector2<Number>(normal);
  const Number missing = value - dot(n, u);
  return (missing / dot(n, n)) * n;
}

/// What is to be added to a vertex's plain displacement.
template <class Number> Vector2<Number> shift(const VertexSupport& support, const scene::Vector<2>& displacement) {
  const Vector2<Number> u = vector2<Number>(displacement);
  if (support.fixed) {  // in this order: the first difference is small, the second may be smaller still
    const auto& [a, b] = support.held.end;
    const Vector2<Number> from = between<Number>(displacement, a);
    const double t = support.held.t;
    const Vector2<Number> own = t == 0   ? from
                                : t == 1 ? between<Number>(displacement, b)
                                         : from + Number(t) * between<Number>(a, b);
    const double factor = support.held.added.factor;
    return factor == 0 ? own : own + Number(factor) * added<Number>(support.held);
  }
  if (support.slides == 0) return {};
  if (support.slides == 1) return onto(u, support.slide[0].normal, value<Number>(support.slide[0]));
  const Vector2<Number> a = vector2<Number>(support.slide[0].normal), b = vector2<Number>(support.slide[1].normal);
  const Number of_a = value<Number>(support.slide[0]) - dot(a, u), of_b = value<Number>(support.slide[1]) - dot(b, u);
  const Number determinant = cross(a, b);
  return {(of_a * b.y - of_b * a.y) / determinant, (of_b * a.x - of_a * b.x) / determinant};
}

/// u·d of a vertex. Along a normal of its support it is the prescribed value, to the last bit.
template <class Number>
Number component(const VertexSupport& support, const scene::Vector<2>& displacement, const scene::Vector<2>& d) {
  for (int i = 0; i < support.slides; ++i) {
    if (support.slide[i].normal == d) return value<Number>(support.slide[i]);
    if (support.slide[i].normal == -d) return -value<Number>(support.slide[i]);
  }
  const Vector2<Number> along = vector2<Number>(d);
  return dot(vector2<Number>(displacement), along) + dot(shift<Number>(support, displacement), along);
}

/// (u' − u'')·d at a vertex of a contact's first side and that of the second on it (−1: a wall): what moves both alike
/// leaves it zero to the last bit.
template <class Number>
Number approach(const std::vector<VertexSupport>& supports, const PlainField& field, int first, int second,
                const scene::Vector<2>& d) {
  const auto along = [&](int vertex) { return component<Number>(supports[vertex], field.vertex[vertex], d); };
  if (second < 0) return along(first);
  if (supports[first].slides > 0 || supports[second].slides > 0) return along(first) - along(second);
  const Vector2<Number> moved =
      shift<Number>(supports[first], field.vertex[first]) - shift<Number>(supports[second], field.vertex[second]);
  return dot(between<Number>(field.vertex[second], field.vertex[first]) + moved, vector2<Number>(d));
}

/// The plain offset k of a boundary facet, seen along it.
inline const scene::Vector<2>& offset_on(const scene::Mesh<2>& mesh, const PlainField& field, int facet, int k) {
  const auto& at = mesh.boundary[facet];
  return field.offset.edge[scene::place_inside_edge(mesh, field.degree, at.edge, at.vertices[0], k)];
}

/// r of one contact facet, as Bernstein coefficients of degree 2 or more from its vertex 0 to its vertex 1.
template <class Number>
std::vector<Number> approach_on(const scene::Problem<2>& problem, const std::vector<VertexSupport>& supports,
                                const PlainField& field, const scene::ContactFacet& pair) {
  const auto& mesh = problem.mesh;
  const auto& first = mesh.boundary[pair.first];
  const scene::Vector<2>& d = problem.facets[pair.first].normal;
  std::array<Number, 2> end;
  for (int i = 0; i < 2; ++i) {
    const int across = pair.second < 0 ? -1 : mesh.boundary[pair.second].vertices[1 - i];
    end[i] = approach<Number>(supports, field, first.vertices[i], across, d);
  }
  std::vector<Number> r;
  for (int k = 0; k <= field.degree; ++k) {
    r.push_back(scene::linear_coefficient<Number>(end[0], end[1], field.degree, k));
    if (k == 0 || k == field.degree) continue;
    r[k] += dot(vector2<Number>(offset_on(mesh, field, pair.first, k)), vector2<Number>(d));
    if (pair.second >= 0)
      r[k] -= dot(vector2<Number>(offset_on(mesh, field, pair.second, field.degree - k)), vector2<Number>(d));
  }
  return scene::raised_to<Number>(2, std::move(r));
}

/// A gap on a contact facet, as coefficients of such a degree. \param bound lower or upper
template <class Number> std::vector<Number> gap_on(const std::array<double, 3>& bound, int degree) {
  return scene::raised_to<Number>(degree, std::vector<Number>{Number(bound[0]), Number(bound[1]), Number(bound[2])});
}

/// r − g of one contact facet, g the lower gap, likewise. In K all are ≤ 0.
template <class Number>
std::vector<Number> penetration(const scene::Problem<2>& problem, const std::vector<VertexSupport>& supports,
                                const PlainField& field, const scene::ContactFacet& pair) {
  std::vector<Number> r = approach_on<Number>(problem, supports, field, pair);
  const std::vector<Number> gap = gap_on<Number>(pair.lower, field.degree);
  for (std::size_t k = 0; k < r.size(); ++k) r[k] -= gap[k];
  return r;
}

/// Displacements onto the supports: what is prescribed on Γ_u is set, up to rounding; the rest shift() does.
PlainField plain_field(const scene::Problem<2>& problem, const scene::Displacement<2>& displacement,
                       const std::vector<VertexSupport>& supports);

/// The displacements of a solution, moved by no more than rounding, so that they are in K with certainty.
/// \return nothing where the prescribed displacements leave no room; then `reason`
struct AdmissibleField {
  std::optional<PlainField> field;
  std::string reason;
};
AdmissibleField admissible_field(const scene::Problem<2>& problem, const scene::Displacement<2>& displacement,
                                 const std::vector<VertexSupport>& supports);

template <class Number> struct FieldEnergy {
  Number strain;  ///< ½ A(v,v)
  Number total;   ///< L(v)
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

/// All that is prescribed on a facet of Γ_τ, per unit of its parameter.
template <class Number>
FacetLoad<Number> prescribed_load(const scene::Problem<2>& problem, const std::vector<Corrected<Number>>& corrections,
                                  int facet) {
  FacetLoad<Number> load = given_load<Number>(problem, facet);
  add_corrections(problem, corrections, facet, load);
  return load;
}

/// Whether anything is prescribed on a facet of Γ_τ.
template <class Number>
bool carries_load(const scene::Problem<2>& problem, const std::vector<Corrected<Number>>& corrections, int facet) {
  const int of = scene::piece_of_facet(problem, facet).of;
  return scene::is_loaded(scene::first_of(problem).facets[of]) || has_perturbing_load(problem, facet) ||
         std::any_of(corrections.begin(), corrections.end(), [&](const auto& one) { return one.facet == of; });
}

/// The field that a plain one stands for.
template <class Number> struct MovedField {
  std::vector<Vector2<Number>> shifts;      ///< of all vertices, to be added to the plain displacements
  scene::Offsets<Vector2<Number>> offsets;  ///< moved onto the supports
};
template <class Number>
MovedField<Number> moved(const scene::Problem<2>& problem, const std::vector<VertexSupport>& supports,
                         const PlainField& field) {
  MovedField<Number> result;
  for (std::size_t v = 0; v < field.vertex.size(); ++v)
    result.shifts.push_back(shift<Number>(supports[v], field.vertex[v]));
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

/// ∫ T·u dτ over a facet of Γ_τ or Γ_K, T linear.
template <class Number>
Number facet_work(const scene::Mesh<2>& mesh, const PlainField& field, const MovedField<Number>& moved, int facet,
                  const std::array<Vector2<Number>, 2>& load) {
  std::array<Vector2<Number>, 2> u;
  for (int i = 0; i < 2; ++i) {
    const int v = mesh.boundary[facet].vertices[i];
    u[i] = vector2<Number>(field.vertex[v]) + moved.shifts[v];
  }
  Number work = linear_product(load, u);
  for (int k = 1; k < field.degree; ++k) {
    Vector2<Number> moment;
    for (int i = 0; i < 2; ++i)
      moment = moment + scene::number<Number>(scene::bernstein_mass(field.degree, k, 1, i)) * load[i];
    work += dot(moment, vector2<Number>(offset_on(mesh, field, facet, k)));
  }
  return work;
}

/// L of the field that `field` stands for [HH81 §1].
/// \param corrections as corrected() has them   \tparam Sum with add() and value()
template <class Number, class Sum>
FieldEnergy<Number> field_energy(const scene::Problem<2>& problem, const std::vector<VertexSupport>& supports,
                                 const PlainField& field, const std::vector<Corrected<Number>>& corrections) {
  const auto& mesh = problem.mesh;
  const MovedField<Number> all = moved<Number>(problem, supports, field);
  const auto forms = elastic_forms<Number>(problem);
  const auto of_cells = [&](int begin, int end) {
    check_arithmetic();
    Sum of_strain, of_force;
    for (int cell = begin; cell < end; ++cell) {
      const int body = mesh.cell_body[cell];
      of_strain.add(cell_strain_energy(problem, forms[body], field, all, cell));
      if (has_force(problem, body))
        of_force.add(cell_work(problem, field, all, body_force<Number>(problem, body), cell));
    }
    return std::array<Number, 2>{of_strain.value(), of_force.value()};
  };
  Sum strain, work;
  using Parts = std::array<Number, 2>;
  for (const auto& [of_strain, of_force] : scene::of_chunks<Parts>(static_cast<int>(mesh.cells.size()), of_cells)) {
    strain.add(of_strain);
    work.add(of_force);
  }
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    const int facet = static_cast<int>(f);
    if (!carries_load(problem, corrections, facet)) continue;
    work.add(facet_work<Number>(mesh, field, all, facet, prescribed_load(problem, corrections, facet)));
  }
  for (const auto& pair : problem.contact) {
    if (!problem.perturbed.by) break;
    const Number factor(problem.perturbed.loads);
    const auto [at0, at1] = opening_load<Number>(problem, pair);
    work.add(factor * scene::bernstein_product(std::vector<Number>{at0, at1},
                                               approach_on<Number>(problem, supports, field, pair)));
  }
  const Number half_a = strain.value();
  return {half_a, half_a - work.value()};
}

}  // namespace bracket::bounds
