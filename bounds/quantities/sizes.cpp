// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/certificate/geometry.h"
#include "bounds/certificate/space/geometry.h"
#include "bounds/quantities/parts.h"

namespace bracket::bounds {

using scene::Enclosure;
using scene::Problem;
using scene::Vector;

Enclosure facet_size(const Problem<2>& first, int facet) {
  const auto e = whole_facet<Enclosure>(first.mesh, facet);
  return root(dot(e, e));
}
Enclosure facet_size(const Problem<3>& first, int facet) {
  const auto n = space::whole_area_vector<Enclosure>(first.mesh, facet);
  return root(space::dot(n, n));
}

namespace {

/// The sum over a body's cells. \param of_cell what each has
template <int dim, class OfCell> Enclosure over_body(const Problem<dim>& first, int body, const OfCell& of_cell) {
  scene::LongSum sum;
  for (std::size_t c = 0; c < first.mesh.cells.size(); ++c)
    if (first.mesh.cell_body[c] == body) sum.add(of_cell(static_cast<int>(c)));
  return sum.value();
}

}  // namespace

Enclosure body_size(const Problem<2>& first, int body) {
  return over_body(first, body, [&](int c) { return doubled_area(corners<Enclosure>(first, c)) / Enclosure(2); });
}
Enclosure body_size(const Problem<3>& first, int body) {
  return over_body(first, body,
                   [&](int c) { return space::volume6(space::corners<Enclosure>(first, c)) / Enclosure(6); });
}

Enclosure mean_square(const std::array<scene::TwofoldVector<2>, 2>& v) {
  const std::array<Vector2<Enclosure>, 2> at = {vector2<Enclosure>(v[0]), vector2<Enclosure>(v[1])};
  return linear_product(at, at);
}
Enclosure mean_square(const std::array<scene::TwofoldVector<3>, 3>& v) {
  space::FacetVectors<Enclosure> at;
  for (int i = 0; i < 3; ++i) at[i] = space::vector3<Enclosure>(v[i]);
  return space::mean_product(at, at);
}

Enclosure size(const Vector<2>& x) { return root(dot(vector2<Enclosure>(x), vector2<Enclosure>(x))); }
Enclosure size(const Vector<3>& x) {
  const auto v = space::vector3<Enclosure>(x);
  return root(space::dot(v, v));
}

bool is_known_along(const Vector<2>& d, const std::vector<Vector<2>>& known) {
  return known.size() > 1 || (known.size() == 1 && (d == known[0] || d == -known[0]));
}
bool is_known_along(const Vector<3>& d, const std::vector<Vector<3>>& known) {
  constexpr double one = 1e-6;
  std::vector<Vector<3>> basis;
  const auto beside = [&](Vector<3> v) {
    for (const Vector<3>& b : basis) v -= b.dot(v) * b;
    return v;
  };
  for (const Vector<3>& n : known) {
    const Vector<3> rest = beside(n);
    if (rest.norm() > one) basis.push_back(rest.normalized());
  }
  return beside(d).norm() <= one;
}

}  // namespace bracket::bounds
