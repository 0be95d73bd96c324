// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "apps/plots/picture.h"
#include "apps/report/report.h"
#include "bounds/assess.h"

namespace bracket::apps {

/// Those of a run that have something to show: closing and error with two levels or more, contact with a contact,
/// mesh unless error_is_rounding().
/// \pre a guarantee, the run has ended
std::vector<Picture> pictures(const Report& report);

Picture closing_picture(const Report& report);  ///< the bounds about the middle of the final bracket, against cells
/// The same of each quantity, quantity_1 and so on, that two meshes or more have put between bounds.
std::vector<Picture> quantity_pictures(const Report& report);
Picture error_picture(const Report& report);  ///< the guaranteed relative error against cells and seconds
Picture mesh_picture(const Report& report);   ///< the mesh coloured by the density of the indicator
/// Where a displacement from another program is wrong: its mesh coloured by the density of its squared error.
Picture error_cells_picture(const scene::Scene<2>& scene, const bounds::Assessment& assessment);
Picture stress_picture(const Report& report);   ///< the deformed bodies coloured by a stress
Picture contact_picture(const Report& report);  ///< pressures and gap along each contact line

/// A point of a curve on logarithmic axes.
struct Sample {
  double cells;
  double error;
};
/// The observed order: the slope of log error by log cells, least squares over the last half of the samples (at least
/// two). NaN where they do not say, as of fewer than three.
double observed_order(const std::vector<Sample>& samples);

/// Colours that every picture uses: dark blue for stresses and lower bounds, orange for displacements and upper bounds.
inline constexpr const char* stress_colour = "#1f5a94";
inline constexpr const char* displacement_colour = "#d95f0e";

/// Lines that set up axes as all pictures have them.
std::string plot_style();

/// gnuplot's label for the units of a scene, in the lower right corner; empty without units.
std::string units_label(const std::string& units);

/// Lines that make the axis "x" or "y" logarithmic, wide enough for all values, none of them on its ends.
/// \pre at least one value, all > 0
std::string log_axis(const std::string& axis, const std::vector<double>& values);

}  // namespace bracket::apps
