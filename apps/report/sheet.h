// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "apps/report/report.h"

/// A run on one page, for a quality file, in the words of ASME V&V 10 (verification of the calculation, validation) and
/// V&V 20 (numerical uncertainty).
namespace bracket::apps {

/// A file that was read.
struct FileRead {
  std::string file;
  std::string sha256;  ///< of its bytes, in hexadecimal digits; empty: not known
};

/// What a run was given that its scene does not tell.
struct Given {
  std::vector<FileRead> files;         ///< the scene, and its mesh file where it has one
  std::vector<std::string> overrides;  ///< "key=value", by which the scene differs from its file
  std::string ended;                   ///< when it ended, "2026-01-31T12:00:00Z"; empty: not told
};

/// sheet.html: one page of A4 when it is printed, so that of long lists it has the first lines and says how many more
/// there are.
template <int dim> std::string sheet_html(const ReportOf<dim>& report, const Given& given);

/// sheet.json: the same with all of their lines, and numbers that read back to the same double; schema 1.
template <int dim> std::string sheet_json(const ReportOf<dim>& report, const Given& given);

}  // namespace bracket::apps
