// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// Planar: contact lines.
#pragma once

#include <array>
#include <vector>

#include "scene/scene.h"

/// Weights on contact lines.
namespace bracket::bounds {

/// The contact facets of a pair on the first mesh, in the order of its first side, and where they lie by arc length
/// from the left end as seen from inside of the first body: facet i from arc[i] to arc[i + 1]. Facets run the other
/// way: vertex 1 of facet i is at arc[i].
struct ContactLine {
  std::vector<int> contact;  ///< indices into Problem::contact
  std::vector<double> arc;
  bool closed = false;
};
/// The connected lines of which the first side of a pair consists.
std::vector<ContactLine> contact_lines(const scene::Problem<2>& problem, int pair);

/// The line of a pair that is one line with two ends.
/// \throw scene::Error (input), at `where`, else: "WHAT a contact line with two ends, and 'NAME' …"
ContactLine open_line(const scene::Problem<2>& first, int pair, const std::string& name, const std::string& what,
                      const std::string& where);

/// A weight that is linear on each contact facet of the first mesh: at vertices 0 and 1 of the first facet, as
/// Problem::contact.
using LinearWeight = std::vector<std::array<double, 2>>;

/// Weights below and above the indicator of a stretch, with ramps of a whole edge.
struct StretchWeights {
  LinearWeight below, above;
};
/// \throw scene::Error (input), at `where`, if the stretch is not on the line, or so short that `below` is zero
StretchWeights stretch_weights(const scene::Problem<2>& problem, const ContactLine& line,
                               const scene::LineStretch& stretch, const std::string& where);

/// The contact facets of a mesh that lie on a stretch, at least in part. \param line of its first mesh
std::vector<char> on_stretch(const scene::Problem<2>& problem, const ContactLine& line,
                             const scene::LineStretch& stretch);

}  // namespace bracket::bounds
