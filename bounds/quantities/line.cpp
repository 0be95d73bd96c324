// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/quantities/line.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "scene/fault.h"
#include "scene/text.h"

namespace bracket::bounds {

namespace {

/// Of sums of lengths: an end of a stretch that is as close to a vertex is that vertex.
double rounding_of_arc(const ContactLine& line) { return 1e-12 * line.arc.back(); }

}  // namespace

std::vector<ContactLine> contact_lines(const scene::Problem<2>& problem, int pair) {
  const auto& mesh = problem.mesh;
  std::map<int, int> from;  // of each vertex: the contact whose first facet ends there, to its left
  std::map<int, int> into;  // … begins there
  std::vector<int> left;
  for (std::size_t j = 0; j < problem.contact.size(); ++j) {
    if (problem.contact[j].pair != pair) continue;
    const auto& [begin, end] = mesh.boundary[problem.contact[j].first].vertices;
    into[begin] = static_cast<int>(j);
    from[end] = static_cast<int>(j);
    left.push_back(static_cast<int>(j));
  }
  std::vector<ContactLine> lines;
  std::vector<char> taken(problem.contact.size(), 0);
  const auto ends = [&](int j) { return mesh.boundary[problem.contact[j].first].vertices; };
  const auto follow = [&](int j, bool closed) {
    ContactLine line{{}, {0}, closed};
    while (!taken[j]) {
      taken[j] = 1;
      line.contact.push_back(j);
      line.arc.push_back(line.arc.back() + scene::length(mesh, problem.contact[j].first));
      const auto next = from.find(ends(j)[0]);
      if (next == from.end()) break;
      j = next->second;
    }
    return line;
  };
  for (const int j : left)
    if (!into.contains(ends(j)[1])) lines.push_back(follow(j, false));
  for (const int j : left)
    if (!taken[j]) lines.push_back(follow(j, true));
  return lines;
}

ContactLine open_line(const scene::Problem<2>& first, int pair, const std::string& name, const std::string& what,
                      const std::string& where) {
  const std::vector<ContactLine> lines = contact_lines(first, pair);
  if (lines.size() == 1 && !lines[0].closed) return lines[0];
  scene::fail(scene::Status::input, where,
              fmt::format("{} a contact line with two ends, and '{}' {}", what, name,
                          lines.size() != 1 ? "consists of several lines" : "is closed"));
}

StretchWeights stretch_weights(const scene::Problem<2>& problem, const ContactLine& line,
                               const scene::LineStretch& stretch, const std::string& where) {
  const double length = line.arc.back();
  const double rounding = rounding_of_arc(line);
  if (!(stretch.from < stretch.to) || stretch.from < -rounding || stretch.to > length + rounding)
    scene::fail(scene::Status::input, where,
                fmt::format("the stretch from {} to {} is not on its contact line, which goes from 0 to {:.6g}",
                            stretch.from, stretch.to, length));
  const std::size_t n = line.contact.size();
  std::vector<char> inside(n), touched(n);
  for (std::size_t i = 0; i < n; ++i) {
    inside[i] = line.arc[i] >= stretch.from - rounding && line.arc[i + 1] <= stretch.to + rounding;
    touched[i] = line.arc[i + 1] > stretch.from + rounding && line.arc[i] < stretch.to - rounding;
  }
  StretchWeights weights{LinearWeight(problem.contact.size(), {0, 0}), LinearWeight(problem.contact.size(), {0, 0})};
  bool nothing = true;
  for (std::size_t k = 0; k <= n; ++k) {  // the vertex at arc[k], between edges k − 1 and k
    const bool before = k == 0 || inside[k - 1], after = k == n || inside[k];
    const bool below = before && after, above = (k > 0 && touched[k - 1]) || (k < n && touched[k]);
    nothing = nothing && !below;
    if (k > 0) {
      weights.below[line.contact[k - 1]][0] = below;
      weights.above[line.contact[k - 1]][0] = above;
    }
    if (k < n) {
      weights.below[line.contact[k]][1] = below;
      weights.above[line.contact[k]][1] = above;
    }
  }
  if (nothing)
    scene::fail(scene::Status::input, where,
                fmt::format("the stretch from {} to {} is too short for the edges of the first mesh: a weight that "
                            "falls to zero within an edge at each end leaves nothing of it; take a finer first mesh",
                            stretch.from, stretch.to));
  return weights;
}

std::vector<char> on_stretch(const scene::Problem<2>& problem, const ContactLine& line,
                             const scene::LineStretch& stretch) {
  const std::vector<int> contact_of = scene::contacts_by_first(scene::first_of(problem));
  std::map<int, std::size_t> place;
  for (std::size_t i = 0; i < line.contact.size(); ++i) place[line.contact[i]] = i;
  std::vector<char> result;
  for (const auto& pair : problem.contact) {
    const auto [of, corner] = scene::piece_of_facet(problem, pair.first);
    const auto found = place.find(contact_of[of]);
    result.push_back(0);
    if (found == place.end()) continue;
    const double begin = line.arc[found->second], end = line.arc[found->second + 1];
    const double from = end - corner[1][0] * (end - begin), to = end - corner[0][0] * (end - begin);
    const double rounding = rounding_of_arc(line);
    result.back() = to > stretch.from + rounding && from < stretch.to - rounding;
  }
  return result;
}

}  // namespace bracket::bounds
