// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "apps/commands/commands.h"

namespace bracket::apps {

/// Does what the words of a command line ask for. `SCENE` alone is `run SCENE`.
/// \param words without the program's own name   \param engine who has the displacements of a run, if not the program
/// \throw scene::Error (input), one line, of words that are not understood; and as the commands
Ending perform(std::vector<std::string> words, const primal::Engine<3>* engine = nullptr);

}  // namespace bracket::apps
