// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "primal/primal.h"

namespace bracket::apps {

/// What main() of a program does: perform() for its arguments; diagnostics go to standard error.
/// \param engine who has the displacements of a run; null: the program itself   \return the exit status
int program(int argc, char** argv, const primal::Engine<3>* engine = nullptr);

}  // namespace bracket::apps
