// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/certificate/space/links.h"

#include <algorithm>
#include <map>

#include "bounds/certificate/space/exact_rank.h"

namespace bracket::bounds::space {

namespace {

using scene::Support;
using scene::Vector;

int component(const scene::Problem<3>& problem, int facet) {
  return problem.mesh.cell_component[problem.mesh.boundary[facet].cell];
}

/// Of two bodies, or a body and the ground, independent directions along which they cannot move against each other.
/// More say nothing: one that depends on those forbids no other motion.
using Links = std::map<std::array<int, 2>, std::vector<Vector<3>>>;

void add(Links& links, int one, int other, const Vector<3>& d) {
  if (one == other) return;
  auto& known = links[{std::min(one, other), std::max(one, other)}];
  if (known.size() == 3 || std::ranges::find(known, d) != known.end()) return;
  std::vector<Row> rows;
  for (const auto& one_of : known) rows.push_back(exact_row(one_of));
  rows.push_back(exact_row(d));
  if (rank(rows) == static_cast<int>(rows.size())) known.push_back(d);
}

}  // namespace

int unheld_motions(const scene::Problem<3>& problem, const std::vector<char>& carrying) {
  const int bodies = static_cast<int>(problem.mesh.components.size()), ground = bodies;
  std::vector<int> is(bodies);  // bodies on Γ_u are as good as the ground
  for (int body = 0; body < bodies; ++body) is[body] = body;
  const auto facets = static_cast<int>(problem.facets.size());
  for (int f = 0; f < facets; ++f)
    if (problem.facets[f].support == Support::fixed) is[component(problem, f)] = ground;
  Links links;
  for (int f = 0; f < facets; ++f)
    if (problem.facets[f].support == Support::sliding)
      add(links, is[component(problem, f)], ground, problem.facets[f].normal);
  for (const auto& pair : problem.contact) {
    if (!carrying[pair.pair] && !pair.law.two_sided) continue;
    const int other = pair.second < 0 ? ground : is[component(problem, pair.second)];
    add(links, is[component(problem, pair.first)], other, problem.facets[pair.first].normal);
  }
  std::vector<Row> rows;
  for (const auto& [between, directions] : links) {
    const auto add_row = [&](int column, const std::array<Rational, 3>& v) {
      Row row(6 * bodies);
      for (int c = 0; c < 3; ++c) {
        row[6 * between[0] + column + c] = v[c];
        if (between[1] < ground) row[6 * between[1] + column + c] = -v[c];
      }
      rows.push_back(std::move(row));
    };
    for (const Vector<3>& d : directions) {
      const std::array<Rational, 3> v = {Rational(d[0]), Rational(d[1]), Rational(d[2])}, none = {0, 0, 0};
      add_row(0, v);
      for (int c = 0; c < 3; ++c) {  // moments at right angles to d: d × the axes
        std::array<Rational, 3> moment = none;
        moment[(c + 1) % 3] = v[(c + 2) % 3];
        moment[(c + 2) % 3] = -v[(c + 1) % 3];
        add_row(3, moment);
      }
    }
  }
  const auto moving = static_cast<int>(std::ranges::count_if(is, [&](int body) { return body < ground; }));
  return 6 * moving - rank(std::move(rows));
}

}  // namespace bracket::bounds::space
