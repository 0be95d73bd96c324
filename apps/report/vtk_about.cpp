// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/report/vtk_about.h"

namespace bracket::apps {

template <int dim> std::vector<VtkField> about(const ReportOf<dim>& report, double drawn_factor) {
  const bounds::Outcome<dim>& outcome = report.outcome;
  std::vector<VtkField> fields = {{"title", {}, 1, {report.scene.title}},
                                  {"units", {}, 1, {report.scene.units}},
                                  {"guarantee", {}, 1, {outcome.guarantee}},
                                  {"energy", {outcome.lower, outcome.upper}, 2},
                                  {"relative_error_bound", {outcome.relative_error_bound}},
                                  {"drawn_factor", {drawn_factor}},
                                  {"body_names", {}, 1, outcome.problem.mesh.bodies}};
  VtkField pairs{"pair_names", {}, 1}, names{"quantity_names", {}, 1}, quantities{"quantities", {}, 2};
  for (const auto& pair : report.scene.contact) pairs.texts.push_back(pair_name(pair));
  for (const bounds::QuantityInterval& each : outcome.quantities) {
    names.texts.push_back(each.name);
    quantities.numbers.insert(quantities.numbers.end(), {each.lower, each.upper});
  }
  fields.insert(fields.end(), {pairs, names, quantities});
  return fields;
}

template std::vector<VtkField> about(const ReportOf<2>&, double);
template std::vector<VtkField> about(const ReportOf<3>&, double);

}  // namespace bracket::apps
