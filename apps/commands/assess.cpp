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
#include "apps/report/assessment.h"
#include "apps/report/lines.h"

namespace bracket::apps {

Ending assess(const AssessOptions& options) {
  refuse_space(options.scene, options.overrides, "assess");
  const scene::Scene<2> scene = scene::read_scene<2>(options.scene, options.overrides);
  const std::filesystem::path folder = results_folder(options.folder, options.scene, ".assess");
  const Descriptor in_use = prepare_folder(folder);
  bounds::Assessment assessment;
  {
    Watch watch(!options.quiet);
    watch.show("the displacement");
    assessment = bounds::assess(scene, scene::read_field(scene, options.field),
                                watch.observer("", [](const bounds::Outcome<2>&) {}));
  }
  const AssessmentReport report{scene, options.field.string(), assessment};
  write_file(folder, "assess.json", assessment_json(report));
  write_file(folder, "assess.vtu", assessment_vtu(assessment));
  if (assessment.guarantee != "none") write_picture(folder, error_cells_picture(scene, assessment));

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

}  // namespace bracket::apps
