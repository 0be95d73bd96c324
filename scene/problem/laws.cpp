// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/problem/laws.h"

#include <fmt/format.h>

#include <limits>

#include "scene/problem/projection.h"
#include "scene/range.h"
#include "scene/text.h"

namespace bracket::scene {

namespace {

/// The value of a pair's law at the ends of the edge from a to b, where it must be linear.
std::array<double, 2> law_on(const ContactPair<2>& pair, const Vector<2>& a, const Vector<2>& b) {
  const std::string called = fmt::format("contact.law.{} of '{}'", name(pair.law), name(pair.first));
  const Function<2>& given = *pair.value;
  const FacetValues<2> values = interpolate_linear(given, a, b, pair.where);
  const bool linear = given.is_enclosed() ? [&] {
    const Jet whole = along(given, a, b, 0, 1);
    return !whole.partial && whole.value().is_bounded() && whole.c[2].is_zero();
  }()
                                          : values.error <= 8 * std::numeric_limits<double>::epsilon() * values.largest;
  const auto edge = [&] { return fmt::format("the edge from {} to {}", point(a), point(b)); };
  if (!linear)
    fail(Status::input, pair.where,
         fmt::format("{} must be linear on each edge of the first mesh, and is not on {}", called, edge()));
  for (const double value : values.value) {
    if (pair.law == Law::winkler && !(value > 0))
      fail(Status::input, pair.where, fmt::format("{} must be positive, is {:.6g} on {}", called, value, edge()));
    if (!(value >= 0))
      fail(Status::input, pair.where, fmt::format("{} must not be negative, is {:.6g} on {}", called, value, edge()));
    check_size(value, pair.where, called);
  }
  if (pair.law == Law::coulomb && values.value[0] != values.value[1])
    fail(Status::input, pair.where, fmt::format("{} must be constant, and is not on {}", called, edge()));
  return values.value;
}

}  // namespace

// Shear at a distance would leave a couple: it needs sides that touch.
std::vector<ContactFacet> with_laws(const Scene<2>& scene, const Mesh<2>& mesh, std::vector<ContactFacet> contact) {
  for (ContactFacet& facet : contact) {
    const ContactPair<2>& pair = scene.contact[facet.pair];
    facet.law.two_sided = is_two_sided(pair);
    if (!pair.value) continue;
    const auto [a, b] = positions(mesh, mesh.boundary[facet.first].vertices);
    const std::array<double, 2> value = law_on(pair, a, b);
    switch (pair.law) {
      case Law::winkler: facet.law.modulus = value; break;
      case Law::tresca: facet.law.friction = value; break;
      default: facet.law.coulomb = value[0];
    }
    if (pair.law == Law::winkler || facet.second == -1) continue;
    const auto [c, d] = positions(mesh, mesh.boundary[facet.second].vertices);
    if (a != d || b != c)
      fail(Status::input, pair.where,
           fmt::format("the sides '{}' and '{}' have friction and do not coincide at {}: shear across a distance would "
                       "leave a couple; expected sides that lie on each other",
                       name(pair.first), name(pair.second), point(a != d ? a : b)));
  }
  return contact;
}

std::vector<ContactFacetOf<3>> with_laws(const Scene<3>& scene, const Mesh<3>&,
                                         std::vector<ContactFacetOf<3>> contact) {
  for (ContactFacetOf<3>& facet : contact) facet.law.two_sided = is_two_sided(scene.contact[facet.pair]);
  return contact;
}

}  // namespace bracket::scene
