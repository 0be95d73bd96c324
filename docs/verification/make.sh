#!/bin/sh
# Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
# sh docs/verification/make.sh [PROGRAM [PAGE]]: solves the scenes of this folder with PROGRAM (bracket) and writes PAGE
# (docs/verification.md). Status 1 if a value that is known lies outside of its interval. What is known stands in the
# comments of a scene:
#   # Question: and # Answer:           up to the next such line or the end of the comment
#   # Exact: NAME = FORMULA             the value of this very problem; NAME is energy or a quantity's name
#   # Limit: NAME = FORMULA             the value of a problem that this one comes near to
#   # Meets: NAME = LOWER, UPPER        another interval of the same value
set -eu
here=$(cd "$(dirname "$0")" && pwd)
program=${1:-bracket}
page=${2:-$here/../verification.md}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

text() {  # of "# KEY: …" in a scene, its lines joined
  awk -v key="$1" '
    !/^#/ { exit }
    /^# [A-Z][a-z]*: / { inside = index($0, "# " key ": ") == 1; if (inside) sub(/^# [A-Z][a-z]*: /, "# ") }
    inside { print substr($0, 3) }' "$2"
}

status=0
number=0
for scene in "$here"/*.toml; do
  name=$(basename "$scene" .toml)
  number=$((number + 1))
  "$program" run "$scene" -o "$work/$name" --no-report --quiet > "$work/out" || { cat "$work/out"; exit 1; }
  {
    echo "BEGIN { pi = atan2(0, -1); read_results()"
    sed -n -e 's/^# Exact: \(.*\) = \(.*\)$/exact("\1", \2)/p' -e 's/^# Limit: \(.*\) = \(.*\)$/limit("\1", \2)/p' \
      -e 's/^# Meets: \(.*\) = \(.*\), \(.*\)$/meets("\1", \2, \3)/p' "$scene"
    echo "exit failed }"
  } > "$work/known.awk"
  {
    printf '\n## %d. %s\n\n' "$number" "$(sed -n 's/^title *= "\(.*\)"$/\1/p' "$scene")"
    text Question "$scene"
    echo
    text Answer "$scene"
    printf '\n| [%s](verification/%s) | known | this version | |\n|---|---|---|---|\n' "$name.toml" "$name.toml"
    awk -v results="$work/$name" -f "$here/case.awk" -f "$work/known.awk" || status=1
  } >> "$work/cases"
done

count() { grep -c "| $1" "$work/cases" || true; }
{
  cat "$here/head.md"
  printf '\n%d cases: %d exact values of which %d lie in their intervals, %d intervals of other computations of which %d meet, %d values of limits.\n' \
    "$number" "$(cat "$here"/*.toml | grep -c '^# Exact:')" "$(count 'inside |')" \
    "$(cat "$here"/*.toml | grep -c '^# Meets:')" "$(count 'meets |')" "$(count 'differs')"
  cat "$work/cases"
} > "$page"
exit "$status"
