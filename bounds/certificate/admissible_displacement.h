// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <optional>

#include "bounds/certificate/elastic_form.h"
#include "bounds/certificate/geometry.h"
#include "scene/fields.h"

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

/// Displacements as plain numbers: u = Σ vertex φ_v + Σ bubble 4 φ_a φ_b over the edges ab. The field they stand for is
/// moved onto the supports exactly by shift(), and bubbles on Γ_0 by onto(), which are of the size of rounding.
struct PlainField {
  std::vector<scene::Vector<2>> vertex;
  std::vector<scene::Vector<2>> bubble;  ///< of each edge; empty for degree 1
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

/// r of one contact facet, as Bernstein coefficients: at its vertex 0, in the middle and at its vertex 1.
template <class Number>
std::array<Number, 3> approach_on(const scene::Problem<2>& problem, const std::vector<VertexSupport>& supports,
                                  const PlainField& field, const scene::ContactFacet& pair) {
  const auto& mesh = problem.mesh;
  const auto& first = mesh.boundary[pair.first];
  const scene::Vector<2>& d = problem.facets[pair.first].normal;
  std::array<Number, 3> r;
  for (int i = 0; i < 2; ++i) {
    const int across = pair.second < 0 ? -1 : mesh.boundary[pair.second].vertices[1 - i];
    r[2 * i] = approach<Number>(supports, field, first.vertices[i], across, d);
  }
  Number bubble(0);
  if (!field.bubble.empty()) {
    bubble += dot(vector2<Number>(field.bubble[first.edge]), vector2<Number>(d));
    if (pair.second >= 0)
      bubble -= dot(vector2<Number>(field.bubble[mesh.boundary[pair.second].edge]), vector2<Number>(d));
  }
  r[1] = (r[0] + r[2]) / Number(2) + Number(2) * bubble;
  return r;
}

/// r − g of one contact facet, g the lower gap, likewise. In K all are ≤ 0.
template <class Number>
std::array<Number, 3> penetration(const scene::Problem<2>& problem, const std::vector<VertexSupport>& supports,
                                  const PlainField& field, const scene::ContactFacet& pair) {
  std::array<Number, 3> r = approach_on<Number>(problem, supports, field, pair);
  for (int i = 0; i < 3; ++i) r[i] -= Number(pair.lower[i]);
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

/// The strain at the corners of a cell: xx, yy and twice xy.
/// \param shifts of all vertices, as shift() gives them: they are added to the plain displacements
/// \param bubbles of all edges, moved onto the supports; empty for degree 1
template <class Number>
std::array<std::array<Number, 3>, 3> cell_strain(const scene::Problem<2>& problem, const PlainField& field,
                                                 const std::vector<Vector2<Number>>& shifts,
                                                 const std::vector<Vector2<Number>>& bubbles, int cell) {
  const auto& mesh = problem.mesh;
  const auto& v = mesh.cells[cell];
  const std::array<Vector2<Number>, 3> x = corners<Number>(problem, cell);
  const Number doubled = doubled_area(x);
  std::array<Vector2<Number>, 3> gradient;  // of φ
  for (int k = 0; k < 3; ++k) {
    const Vector2<Number> opposite = x[(k + 2) % 3] - x[(k + 1) % 3];
    gradient[k] = (Number(1) / doubled) * turned(opposite);
  }
  std::array<std::array<Number, 3>, 3> strain;
  for (int m = 0; m < 3; ++m) {
    Number xx(0), yy(0), xy(0);
    for (int j = 0; j < 3; ++j) {
      if (j == m) continue;
      Vector2<Number> slope = between<Number>(field.vertex[v[m]], field.vertex[v[j]]) + (shifts[v[j]] - shifts[v[m]]);
      if (!bubbles.empty())
        slope = slope + Number(4) * bubbles[mesh.cell_edges[cell][scene::Simplex<2>::edge_between(m, j)]];
      xx += slope.x * gradient[j].x;
      yy += slope.y * gradient[j].y;
      xy += slope.x * gradient[j].y + slope.y * gradient[j].x;
    }
    strain[m] = {xx, yy, xy};
  }
  return strain;
}

/// The strain energy of one cell. \param shifts, bubbles as for cell_strain()
template <class Number>
Number cell_strain_energy(const scene::Problem<2>& problem, const ElasticForm<Number>& form, const PlainField& field,
                          const std::vector<Vector2<Number>>& shifts, const std::vector<Vector2<Number>>& bubbles,
                          int cell) {
  return integral([&](const std::array<Number, 3>& e) { return form.strain_energy(e); },
                  cell_strain(problem, field, shifts, bubbles, cell), doubled_area(corners<Number>(problem, cell)));
}

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

/// The field that a plain one stands for: what is added to it.
template <class Number> struct MovedField {
  std::vector<Vector2<Number>> shifts;   ///< of all vertices, to the plain displacements
  std::vector<Vector2<Number>> bubbles;  ///< of all edges, moved onto the supports; empty for degree 1
};
template <class Number>
MovedField<Number> moved(const scene::Problem<2>& problem, const std::vector<VertexSupport>& supports,
                         const PlainField& field) {
  MovedField<Number> result;
  for (std::size_t v = 0; v < field.vertex.size(); ++v)
    result.shifts.push_back(shift<Number>(supports[v], field.vertex[v]));
  for (const auto& w : field.bubble) result.bubbles.push_back(vector2<Number>(w));
  for (std::size_t f = 0; f < problem.facets.size() && !result.bubbles.empty(); ++f)
    if (Vector2<Number>& w = result.bubbles[problem.mesh.boundary[f].edge];
        problem.facets[f].support == scene::Support::sliding)
      w = w + onto(w, problem.facets[f].normal, Number(0));
  return result;
}

/// ∫ F·u over a cell.
template <class Number>
Number cell_work(const scene::Problem<2>& problem, const PlainField& field, const MovedField<Number>& moved,
                 const Vector2<Number>& force, int cell) {
  Vector2<Number> u;  // three times its mean
  for (int k = 0; k < 3; ++k) {
    const int v = problem.mesh.cells[cell][k];
    u = u + vector2<Number>(field.vertex[v]) + moved.shifts[v];
    if (!moved.bubbles.empty()) u = u + moved.bubbles[problem.mesh.cell_edges[cell][k]];
  }
  return doubled_area(corners<Number>(problem, cell)) / Number(6) * dot(force, u);
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
  const Number linear = linear_product(load, u);
  if (field.bubble.empty()) return linear;
  return linear + dot(load[0] + load[1], vector2<Number>(field.bubble[mesh.boundary[facet].edge])) / Number(3);
}

/// ∫ f r dτ over a contact facet. \param f linear, at the vertices   \param r Bernstein coefficients
template <class Number> Number integral_of_product(const std::array<Number, 2>& f, const std::array<Number, 3>& r) {
  const Number two(2), three(3);
  return (f[0] * (three * r[0] + two * r[1] + r[2]) + f[1] * (r[0] + two * r[1] + three * r[2])) / Number(12);
}

/// L of the field that `field` stands for [HH81 §1].
/// \param corrections as corrected() has them   \tparam Sum with add() and value()
template <class Number, class Sum>
FieldEnergy<Number> field_energy(const scene::Problem<2>& problem, const std::vector<VertexSupport>& supports,
                                 const PlainField& field, const std::vector<Corrected<Number>>& corrections) {
  const auto& mesh = problem.mesh;
  const MovedField<Number> all = moved<Number>(problem, supports, field);
  const auto forms = elastic_forms<Number>(problem);
  Sum strain, work;
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    const int cell = static_cast<int>(c), body = mesh.cell_body[c];
    strain.add(cell_strain_energy(problem, forms[body], field, all.shifts, all.bubbles, cell));
    if (has_force(problem, body)) work.add(cell_work(problem, field, all, body_force<Number>(problem, body), cell));
  }
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    const int facet = static_cast<int>(f);
    if (!carries_load(problem, corrections, facet)) continue;
    work.add(facet_work<Number>(mesh, field, all, facet, prescribed_load(problem, corrections, facet)));
  }
  for (const auto& pair : problem.contact) {
    if (!problem.perturbed.by) break;
    const Number factor(problem.perturbed.loads);
    work.add(factor * integral_of_product(opening_load<Number>(problem, pair),
                                          approach_on<Number>(problem, supports, field, pair)));
  }
  const Number half_a = strain.value();
  return {half_a, half_a - work.value()};
}

}  // namespace bracket::bounds
