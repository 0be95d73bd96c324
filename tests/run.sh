#!/bin/sh
# Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
# sh tests/run.sh: installs what is missing, builds and runs all tests in two configurations:
#   release  what users run: optimized, without assertions; all tests, with the program and the installed package
#   asan     the libraries as Debug with the address and undefined-behaviour sanitizers: assert, the assertions of the
#            standard library and those of deal.II, whose debug library makes the reference elements; the tests of
#            libraries again, by release's programs, which are compiled once and assert in both
# The preset debug is asan without sanitizers, for debuggers: it checks nothing more and is not run here.
# Before, that every file is formatted. Ends with the count of GoogleTest's cases over both.
set -eu

project=$(cd "$(dirname "$0")/.." && pwd)
more_packages="clang-format-14 mkdocs"
. "$project/apps/setup.sh"
cd "$project"

# First what takes a second: every file is as .clang-format has it.
find apps bounds contact dual primal scene tests \( -name '*.h' -o -name '*.cpp' \) -exec clang-format-14 --dry-run -Werror {} +

passed=0
failed=0
for preset in release asan; do
  cmake --preset "$preset"
  cmake --build --preset "$preset"
  log=build/$preset/Testing/Temporary/LastTest.log
  rm -f "$log"
  ctest --preset "$preset" --parallel 2 || true  # failures are counted below
  # Of each process what GoogleTest says at its end; one that does not get there is a failure, whatever its status.
  counts=$(awk '
    function close_process() {
      if (open && (!ended || (bad && !failures))) ++failures
      passed += successes; failed += failures
      open = ended = bad = successes = failures = 0
    }
    /^[0-9]+\/[0-9]+ Testing: / { close_process(); open = 1 }
    /^\[  PASSED  \] [0-9]+ tests?\.$/ { successes = $4; ended = 1 }
    /^\[  FAILED  \] [0-9]+ tests?, listed below:$/ { failures = $4 }
    /^Test Failed\.$/ { bad = 1 }
    END { close_process(); print passed + 0, failed + 0 }' "$log") || exit 1
  [ "$counts" != "0 0" ] || { echo "no tests were run in $preset" >&2; exit 1; }
  passed=$((passed + ${counts% *}))
  failed=$((failed + ${counts#* }))
done

echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
