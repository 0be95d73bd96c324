// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/assess.h"

#include <fmt/format.h>

#include <iostream>

#include "apps/commands/commands.h"
#include "apps/commands/dimension.h"
#include "apps/commands/folder.h"
#include "apps/commands/say.h"
#include "apps/commands/watch.h"
#include "apps/plots/pictures.h"
#include "apps/plots/space/pictures.h"
#include "apps/report/assessment.h"
#include "apps/report/lines.h"

namespace bracket::apps {

namespace {

void write_error_cells(const std::filesystem::path& folder, const scene::Scene<2>& scene,
                       const bounds::AssessmentOf<2>& assessment) {
  write_picture(folder, error_cells_picture(scene, assessment));
}
void write_error_cells(const std::filesystem::path& folder, const scene::Scene<3>& scene,
                       const bounds::AssessmentOf<3>& assessment) {
  for (const Drawing& drawing : error_cells_pictures(scene, assessment))
    write_file(folder, drawing.name + ".svg", drawing.svg);
}

template <int dim> Ending assess_in(const AssessOptions& options) {
  const scene::Scene<dim> scene = scene::read_scene<dim>(options.scene, options.overrides);
  const std::filesystem::path folder = results_folder(options.folder, options.scene, ".assess");
  const Descriptor in_use = prepare_folder(folder);
  bounds::AssessmentOf<dim> assessment;
  {
    Watch watch(!options.quiet);
    watch.show("the displacement");
    assessment = bounds::assess<dim>(scene, scene::read_field(scene, options.field),
                                     watch.observer<dim>("", [](const bounds::Outcome<dim>&) {}));
  }
  const AssessmentReportOf<dim> report{scene, options.field.string(), assessment};
  write_file(folder, "assess.json", assessment_json(report));
  write_file(folder, "assess.vtu", assessment_vtu(assessment));
  if (assessment.guarantee != "none") write_error_cells(folder, scene, assessment);

  if (!options.quiet) {
    for (const std::string& note : assessment.field.problem.mesh.notes) say_note(note);
    for (const std::string& note : assessment.field.given.notes) say_note(note);
  }
  if (options.json) {
    std::cout << assessment_json(report);
  } else {
    std::cout << assessment_headline(report);
    if (!options.quiet)
      std::cout << assessment_text(report)
                << within_columns(fmt::format("Where it is wrong: {}, for ParaView: {}\n",
                                              (folder / "error.svg").string(), (folder / "assess.vtu").string()));
  }
  return {assessment.status, assessment.reason};
}

}  // namespace

Ending assess(const AssessOptions& options) {
  return is_in_space(options.scene, options.overrides) ? assess_in<3>(options) : assess_in<2>(options);
}

}  // namespace bracket::apps
