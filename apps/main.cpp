// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/program.h"

int main(int argc, char** argv) { return bracket::apps::program(argc, argv); }
