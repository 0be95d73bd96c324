#!/bin/sh
# Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
# sh tests/benchmarks/targets.sh [PROGRAM]: what eight scenes cost to guaranteed relative errors of 1e-1, …, 1e-4 with
# degrees 2, 3 and 4 and the one that "auto" chooses, adaptive, the whole program without report and quantities: the rows
# of docs/performance.md. Seconds are of CPU, of both cores. A target that takes more than a minute or 400 000 cells is
# left out, and the ones after it.
set -eu

project=$(cd "$(dirname "$0")/../.." && pwd)
program=${1:-$project/build/release/apps/bracket}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# The CPU seconds of all programs until `times` wrote a file.
spent() {
  awk 'NR == 2 { gsub("s", ""); split($1, user, "m"); split($2, own, "m")
                 print 60 * (user[1] + own[1]) + user[2] + own[2] }' "$1"
}

printf '| scene | degree | error | cells | CPU seconds | width by the energy |\n|---|---|---|---|---|---|\n'
for scene in two_blocks three_halves westergaard l_shape cook example_1 example_2 gravity; do
  # Without [[quantity]], and beside the mesh that it names.
  awk '/^\[/ { skip = ($0 == "[[quantity]]") } !skip' "$project/apps/scenes/$scene.toml" > "$folder/$scene.toml"
  cp "$project/apps/scenes/$scene.msh" "$folder" 2>/dev/null || true
  for degree in 2 3 4 '"auto"'; do
    for target in 1e-1 1e-2 1e-3 1e-4; do
      times > "$folder/began"
      "$program" run "$folder/$scene.toml" --no-report --quiet -o "$folder/$scene.out" --set solve.degree=$degree \
        --set refine.strategy=adaptive --set refine.target=$target --set refine.max_levels=60 \
        --set refine.max_cells=400000 --set refine.max_seconds=60 > /dev/null 2>&1 || break
      times > "$folder/ended"
      tail -n 1 "$folder/$scene.out/history.csv" | awk -F, -v scene=$scene -v degree="$(echo $degree | tr -d '\"')" -v target=$target \
        -v seconds="$(echo "$(spent "$folder/began") $(spent "$folder/ended")" | awk '{ print $2 - $1 }')" \
        '{ printf "| %s | %s | %s | %d | %.2f | %.1e |\n", scene, degree, target, $2, seconds, $7 }'
    done
  done
done
