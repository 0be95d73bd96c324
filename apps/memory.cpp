// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <jemalloc/jemalloc.h>

// What jemalloc reads when it starts: memory comes in pages of 2 MB where the system has them to give. Arrays of
// factors are written once and read a few times; in pages of 4 KB a third of a run's time goes to getting them one by
// one.
const char* malloc_conf = "thp:always";
