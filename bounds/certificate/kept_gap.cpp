// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/certificate/kept_gap.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>

namespace bracket::bounds {

using scene::Vector;

namespace {

/// What two numbers may differ by, for rounding: as scene::fix_data() allows where it makes gaps and displacements
/// agree.
double rounding_of(double size) { return 8 * std::numeric_limits<double>::epsilon() * size; }

double size_of(const scene::Problem<2>& problem, const KeptGap& gap) {
  double size = problem.length_scale;
  for (const double g : gap.lower) size = std::max(size, std::abs(g));
  return size;
}

/// By how much enclosed numbers differ at least.
double distance(const Enclosure& a, const Enclosure& b) {
  const Enclosure difference = a - b;
  return std::max({0.0, lower(difference), lower(-difference)});
}

double size_of(const VertexSupport& support) {
  double size = 0;
  for (const Vector<2>& u : support.held.end) size = std::max(size, u.norm());
  for (const Slide& slide : support.slide) size = std::max({size, std::abs(slide.end[0]), std::abs(slide.end[1])});
  return size;
}

bool may_be_linear(const std::array<Enclosure, 3>& c, double rounding) {
  return distance(c[1], (c[0] + c[2]) / Enclosure(2)) <= rounding;
}

std::string point(const scene::Problem<2>& problem, int vertex) {
  const Vector<2>& at = problem.mesh.vertices[vertex];
  return fmt::format("({:.6g}, {:.6g})", at[0], at[1]);
}

/// Takes note of an end of the first mesh's facet at which neither side can move. \return what is wrong
std::string hold(const scene::Problem<2>& problem, const std::vector<VertexSupport>& supports, KeptGap& gap, int end,
                 int first, int second) {
  if (!holds(supports[first], gap.d) || (second >= 0 && !holds(supports[second], gap.d))) return "";
  gap.held[end] = HeldEnd{supports[first], {}};
  double size = size_of(problem, gap) + size_of(supports[first]);
  if (second >= 0) {
    gap.held[end]->second = supports[second];
    size += size_of(supports[second]);
  }
  const Enclosure own = prescribed_approach<Enclosure>(*gap.held[end], gap.d, own_part);
  const double wrong = distance(own, between_bounds<Enclosure>(gap.lower[2 * end], gap.upper[2 * end]));
  if (wrong > rounding_of(size))
    return fmt::format("the displacements prescribed at {} miss the gap of sides that keep together by {:.3g}",
                       point(problem, first), wrong);
  if (gap.factor == 0) return "";
  const Enclosure added = prescribed_approach<Enclosure>(*gap.held[end], gap.d, added_part);
  const Enclosure psi = scene::psi<Enclosure>(gap.added, gap.d, scene::whole<1>(0))[2 * end];
  if (distance(added, psi) > rounding_of(magnitude(added) + magnitude(psi)))
    return fmt::format("the perturbation of the gap is not that of the displacements prescribed at {}",
                       point(problem, first));
  return "";
}

/// Makes one number of the gap at a vertex where two facets have the same direction. \return whether they agree
bool unite(KeptGap& one, int end, KeptGap& other, int other_end, double rounding) {
  double &lower = one.lower[2 * end], &upper = one.upper[2 * end];
  double &other_lower = other.lower[2 * other_end], &other_upper = other.upper[2 * other_end];
  const double apart = std::max(lower - other_upper, other_lower - upper);
  if (apart > rounding) return false;
  lower = other_lower = apart > 0 ? std::min(lower, other_lower) : std::max(lower, other_lower);
  upper = other_upper = apart > 0 ? std::max(upper, other_upper) : std::min(upper, other_upper);
  return true;
}

/// Settles the ends of the first mesh's facets. \return what is wrong
std::string settle_ends(const scene::Problem<2>& problem, const std::vector<VertexSupport>& supports,
                        FirstContacts& contacts) {
  std::map<Facing, std::pair<int, int>> met;  // contact of the first mesh and its end
  for (const auto& pair : problem.contact) {
    if (!keeps_together(pair.law)) continue;
    const auto [of, corner] = scene::piece_of_facet(problem, pair.first);
    const int contact = contacts.of_facet[of];
    for (int end = 0; end < 2; ++end) {
      if (corner[end][0] != end) continue;  // no vertex of the first mesh's facet
      const int first = problem.mesh.boundary[pair.first].vertices[end];
      const int second = pair.second < 0 ? -1 : problem.mesh.boundary[pair.second].vertices[1 - end];
      KeptGap& gap = contacts.kept[contact];
      if (std::string fault = hold(problem, supports, gap, end, first, second); !fault.empty()) return fault;
      const auto [known, is_new] = met.insert({facing(problem, pair, end), {contact, end}});
      if (is_new || gap.held[end]) continue;
      const auto [other, other_end] = known->second;
      if (!unite(gap, end, contacts.kept[other], other_end, rounding_of(size_of(problem, gap))))
        return fmt::format("the gap of sides that keep together jumps at {}", point(problem, first));
    }
  }
  return "";
}

}  // namespace

Facing facing(const scene::Problem<2>& problem, const scene::ContactFacet& pair, int end) {
  const Vector<2>& d = problem.facets[pair.first].normal;
  const int first = problem.mesh.boundary[pair.first].vertices[end];
  if (pair.second < 0) return {first, -1, {d[0], d[1]}};
  const int second = problem.mesh.boundary[pair.second].vertices[1 - end];
  return first < second ? Facing{first, second, {d[0], d[1]}} : Facing{second, first, {-d[0], -d[1]}};
}

FirstContacts first_contacts(const scene::Problem<2>& problem, const std::vector<VertexSupport>& supports) {
  FirstContacts result;
  if (std::ranges::none_of(problem.contact, [](const auto& pair) { return has_law(pair.law); })) return result;
  const scene::Problem<2>& first = scene::first_of(problem);
  result.of_facet = scene::contacts_by_first(first);
  if (std::ranges::none_of(first.contact, [](const auto& pair) { return pair.law.two_sided; })) return result;
  const auto& [by, loads, kinematics] = problem.perturbed;
  for (std::size_t j = 0; j < first.contact.size(); ++j) {
    const auto& pair = first.contact[j];
    KeptGap gap{pair.lower, pair.upper};
    gap.d = first.facets[pair.first].normal;
    if (by) gap.added = by->contact[j];
    if (by) gap.factor = kinematics;
    result.kept.push_back(std::move(gap));
  }
  result.fault = settle_ends(problem, supports, result);
  for (KeptGap& gap : result.kept) {
    std::array<Enclosure, 3> own;
    for (int i = 0; i < 3; ++i) own[i] = between_bounds<Enclosure>(gap.lower[i], gap.upper[i]);
    gap.is_linear = may_be_linear(own, rounding_of(size_of(problem, gap)));
    gap.is_psi_linear = may_be_linear(scene::psi<Enclosure>(gap.added, gap.d, scene::whole<1>(0)), 0);
  }
  return result;
}

FirstContacts first_contacts(const scene::Problem<2>& problem) {
  if (std::ranges::none_of(problem.contact, [](const auto& pair) { return pair.law.two_sided; }))
    return first_contacts(problem, {});
  return first_contacts(problem, vertex_supports(problem));
}

}  // namespace bracket::bounds
