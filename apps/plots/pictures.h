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
/// They, drawn; in space those of levels after those of the bodies, which are SVG alone.
Drawings drawn(const Report& report, bool png);
Drawings drawn(const ReportOf<3>& report, bool png);
/// Of pictures() closing, those of quantities and error, which a run in space has too.
template <int dim> std::vector<Picture> level_pictures(const ReportOf<dim>& report);

template <int dim>
Picture closing_picture(
    const ReportOf<dim>& report);  ///< the bounds about the middle of the final bracket, against cells
/// The same of each quantity, quantity_1 and so on, that two meshes or more have put between bounds.
template <int dim> std::vector<Picture> quantity_pictures(const ReportOf<dim>& report);
template <int dim>
Picture error_picture(const ReportOf<dim>& report);  ///< the guaranteed relative error against cells and seconds
Picture mesh_picture(const Report& report);          ///< the mesh coloured by the density of the indicator
/// Where a displacement from another program is wrong: its mesh coloured by the density of its squared error.
Picture error_cells_picture(const scene::Scene<2>& scene, const bounds::Assessment& assessment);
/// The deformed bodies (apps/report/deformed.h) coloured by the equivalent stress, with supports, loads, names, contact
/// lines and pressures. Where the stress across the plane is not known: by the largest shear stress.
Picture bodies_picture(const Report& report);
Picture shear_picture(const Report& report);  ///< the same, without what is around, by the largest shear stress
/// Pressures and gap along the contact line of a pair, with what is certain of its zones. Its name is "contact" or,
/// where there are several, "contact_1" and so on.
Picture contact_picture(const Report& report, int pair);

/// The pressure up to which a pair is drawn: near the largest, but where it is singular less, or nothing else would be
/// seen. Three hundredths of the pressed length may reach beyond.
double drawn_pressure(const Report& report, int pair);

/// Colours that every picture uses: dark blue for stresses and lower bounds, orange for displacements and upper bounds.
inline constexpr const char* stress_colour = "#1f5a94";
inline constexpr const char* displacement_colour = "#d95f0e";

/// Lines that set up axes as all pictures have them.
std::string plot_style();

/// The units that a scene's label names (apps/report/units.h); empty: not known.
std::string length_unit(const std::string& units);
std::string stress_unit(const std::string& units);
/// gnuplot's string for what has this unit: 'x [mm]', or without one 'x'.
std::string with_unit(const std::string& what, const std::string& unit);

/// Lines that make the axis "x" or "y" logarithmic, wide enough for all values, none of them on its ends.
/// \pre at least one value, all > 0
std::string log_axis(const std::string& axis, const std::vector<double>& values);

}  // namespace bracket::apps
