// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/paper/paper.h"

#include <fmt/format.h>

#include <iostream>

#include "apps/commands/commands.h"
#include "apps/commands/folder.h"
#include "apps/commands/progress.h"

namespace bracket::apps {

void paper(const std::filesystem::path& given_folder) {
  const std::filesystem::path folder = results_folder(given_folder, "bracket", ".paper");
  const Descriptor in_use = prepare_folder(folder);
  std::vector<Table> tables;
  const auto add = [&](const std::string& name, const std::function<Table()>& make) {
    {
      const Progress progress;
      progress.show(name);
      tables.push_back(make());
    }
    std::cout << table_text(tables.back()) << std::flush;
    write_file(folder, "paper.json", paper_json(tables));
    return tables.back();
  };
  add("Theorem 2.1", stress_by_loads);
  const Table projected = add("Theorem 2.2", interpolation);
  std::vector<Measured> measured;
  {
    const Progress progress;
    for (const Example& example : examples()) {
      const auto meshes = measure(example, {2, 4, 8, 16, 32}, [&](const std::string& stage) { progress.show(stage); });
      measured.insert(measured.end(), meshes.begin(), meshes.end());
    }
  }
  const Table solved = add("Theorem 2.3", [&] { return stress_error(measured); });
  add("Lemma 1.6", admissible_stresses);
  add("(1.15)", [&] { return equal_energies(measured); });
  add("both formulations", [&] { return two_formulations(measured); });
  write_picture(folder, paper_picture(projected, solved));
  std::cout << fmt::format("Tables and plot: {}\n", folder.string());
}

}  // namespace bracket::apps
