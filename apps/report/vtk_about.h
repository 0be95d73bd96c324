// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "apps/report/report.h"
#include "apps/report/vtk_file.h"

namespace bracket::apps {

/// What holds of a run so far, as field data: names, units, bounds. \param drawn_factor by which pictures magnify
template <int dim> std::vector<VtkField> about(const ReportOf<dim>& report, double drawn_factor);

/// The components of a symmetric vtk_tensor, as VTK has them.
inline const std::vector<std::string> vtk_tensor = {"xx", "yy", "zz", "xy", "yz", "xz"};

}  // namespace bracket::apps
