#!/bin/sh
# Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
# sh docs/verification/others/make.sh [PROGRAM [PAGE]]: solves the scenes of this folder with PROGRAM (bracket) and writes
# PAGE (docs/against-others.md), with what other programs found beside it. Status 1 if a value is outside. What
# they found stands in the comments of a scene:
#   # Other: NAME = FILE, CASE, COLUMN, PROGRAM   the value of the last row of this case in FILE, which a script of this
#                                                 folder wrote for PROGRAM; NAME is energy or a quantity's name
set -eu
here=$(cd "$(dirname "$0")" && pwd)
program=${1:-bracket}
page=${2:-$here/../../against-others.md}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

status=0
for scene in "$here"/*.toml; do
  name=$(basename "$scene" .toml)
  "$program" run "$scene" -o "$work/$name" --no-report --quiet > "$work/out" || { cat "$work/out"; exit 1; }
  {
    echo "BEGIN { read_results()"
    sed -n 's/^# Other: \(.*\) = \(.*\), \(.*\), \(.*\), \(.*\)$/other("\1", "\2", \3, \4, "\5")/p' "$scene"
    echo "exit failed }"
  } > "$work/known.awk"
  if [ "$(grep -c '^# Other: ' "$scene")" -ne "$(grep -c '^other(' "$work/known.awk")" ]; then
    echo "$scene: expected # Other: NAME = FILE, CASE, COLUMN, PROGRAM" >&2
    exit 1
  fi
  {
    printf '\n## %s\n\n' "$(sed -n 's/^title *= "\(.*\)"$/\1/p' "$scene")"
    sed -n -e '2s/^# Question: //p' -e '3,${/^# Other/q;s/^# //p}' "$scene"
    printf '\n| [%s](verification/others/%s) | program | cells | value | moved by | extrapolated | this version | cells | |\n' \
      "$name.toml" "$name.toml"
    echo '|---|---|---|---|---|---|---|---|---|'
    awk -v results="$work/$name" -v folder="$here" -f "$here/../case.awk" -f "$here/other.awk" -f "$work/known.awk" ||
      status=1
  } >> "$work/cases"
done
cat "$here/head.md" "$work/cases" > "$page"
exit "$status"
