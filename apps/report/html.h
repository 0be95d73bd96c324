// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "apps/report/report.h"

/// Pieces of report.html. Every text that is not the program's own goes through escaped().
namespace bracket::apps {

/// A text as HTML shows it, whatever it holds.
std::string escaped(const std::string& text);

/// A table; cells and caption are HTML. The first column names the rows. The first `n_names` columns are set left, the
/// others right, as numbers. \param kind a class of the style sheet
std::string html_table(const std::vector<std::string>& head, const std::vector<std::vector<std::string>>& rows,
                       int n_names, const std::string& caption = "", const std::string& kind = "");

/// The scene as it was understood, all defaults filled in: bodies, boundary, contact, refinement, solution.
template <int dim> std::string html_scene(const ReportOf<dim>& report);

/// The style sheet.
extern const char* const html_style;

}  // namespace bracket::apps
