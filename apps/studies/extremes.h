// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "apps/plots/picture.h"
#include "bounds/bounds.h"

namespace bracket::apps {

/// One parameter of a scene, driven to its limit.
struct Sweep {
  std::string name;
  std::vector<double> parameters;                           ///< > 0
  std::function<scene::Problem<2>(double parameter)> make;  ///< \throw scene::Error
  std::function<double(double parameter)> energy_factor;    ///< of L(u), exactly; empty: it is another problem
  std::string left_out;                                     ///< why the scene does not allow it; empty: it does
};
/// \param benign fix_data() of the scene on its own mesh
std::vector<Sweep> extreme_sweeps(const scene::Scene<2>& scene, const scene::Problem<2>& benign);

struct Interval {
  double lower = 0, upper = 0;
  double relative_width() const;  ///< width by the larger of its ends' sizes; [0, 0]: 0
};

/// A point of a sweep.
struct Extreme {
  std::string sweep;
  double parameter;
  scene::Status status = scene::Status::done;
  std::string reason = "";                ///< if there is no interval: one line
  std::optional<Interval> interval = {};  ///< of L(u)
  /// An interval known to hold L(u) as well: that of the benign scene times the factor of the change or, where the
  /// problem is another, its own on the mesh with all edges halved.
  std::optional<Interval> reference = {};
  double slack = 0;  ///< what rounding of the coordinates of that mesh may do to L(u)
  double seconds = 0;
};

/// Whether interval and reference meet; nothing where one of them is missing.
std::optional<bool> contains_reference(const Extreme& extreme);

struct Extremes {
  Interval benign;
  std::vector<Extreme> rows;
  std::vector<std::string> left_out;  ///< "sweep: reason"
};

/// A line per point.
std::string extremes_text(const Extremes& extremes);
std::string extremes_csv(const Extremes& extremes);
std::string extremes_json(const scene::Scene<2>& scene, const Extremes& extremes);

/// The relative width against the parameters, a curve per sweep.
/// \pre some interval has a width
Picture extremes_picture(const Extremes& extremes);
/// Whether extremes_picture() has something to show.
bool has_picture(const Extremes& extremes);

}  // namespace bracket::apps
