#!/bin/sh
# Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
# sh tests/run.sh: installs what is missing, builds and runs all tests in Release and Debug, and those that do not spend
# their time in deal.II with the sanitizers. Ends with the count over all three.
set -eu

project=$(cd "$(dirname "$0")/.." && pwd)
. "$project/apps/setup.sh"
cd "$project"

passed=0
failed=0
for preset in release debug asan; do
  cmake --preset "$preset"
  cmake --build --preset "$preset"
  log=build/$preset/tests.log
  ctest --preset "$preset" --parallel 2 --output-log "$log" || true  # failures are counted below
  # "98% tests passed, 2 tests failed out of 100"
  counts=$(sed -n 's/.*tests passed, \([0-9]*\) tests* failed out of \([0-9]*\).*/\1 \2/p' "$log")
  [ -n "$counts" ] || { echo "no tests were run in $preset" >&2; exit 1; }
  failed=$((failed + ${counts% *}))
  passed=$((passed + ${counts#* } - ${counts% *}))
done

echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
