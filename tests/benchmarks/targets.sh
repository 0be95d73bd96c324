#!/bin/sh
# Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
# sh tests/benchmarks/targets.sh [PROGRAM]: what eight scenes cost to guaranteed relative errors of 1e-2, 1e-3, 1e-4 with
# degrees 2, 3 and 4, adaptive, the whole program without report and quantities: the rows of docs/performance.md. A target
# that takes more than two minutes or 400 000 cells is left out, and the ones after it.
set -eu

project=$(cd "$(dirname "$0")/../.." && pwd)
program=${1:-$project/build/release/apps/bracket}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

printf '| scene | degree | error | cells | seconds | width by the energy |\n|---|---|---|---|---|---|\n'
for scene in two_blocks three_halves westergaard l_shape cook example_1 example_2 gravity; do
  # Without [[quantity]], and beside the mesh that it names.
  awk '/^\[/ { skip = ($0 == "[[quantity]]") } !skip' "$project/apps/scenes/$scene.toml" > "$folder/$scene.toml"
  cp "$project/apps/scenes/$scene.msh" "$folder" 2>/dev/null || true
  for degree in 2 3 4; do
    for target in 1e-2 1e-3 1e-4; do
      began=$(date +%s.%N)
      "$program" run "$folder/$scene.toml" --no-report --quiet -o "$folder/$scene.out" --set solve.degree=$degree \
        --set refine.strategy=adaptive --set refine.target=$target --set refine.max_levels=60 \
        --set refine.max_cells=400000 --set refine.max_seconds=120 > /dev/null 2>&1 || break
      ended=$(date +%s.%N)
      tail -n 1 "$folder/$scene.out/history.csv" | awk -F, -v scene=$scene -v degree=$degree -v target=$target \
        -v seconds="$(echo "$began $ended" | awk '{ print $2 - $1 }')" \
        '{ printf "| %s | %d | %s | %d | %.2f | %.1e |\n", scene, degree, target, $2, seconds, $7 }'
    done
  done
done
