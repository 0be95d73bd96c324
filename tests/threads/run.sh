#!/bin/sh
# Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
# sh tests/threads/run.sh: the threads of a run under the thread sanitizer. Not part of tests/run.sh, which it would make
# some minutes longer: for whoever changes them.
set -eu
project=$(cd "$(dirname "$0")/../.." && pwd)
. "$project/apps/setup.sh"
cd "$project"
cmake --preset tsan
cmake --build --preset tsan --target threads_tests
ctest --preset tsan
