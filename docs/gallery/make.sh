#!/bin/sh
# Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
# sh docs/gallery/make.sh [PROGRAM [DOCS [SCENE…]]]: solves every SCENE (all of apps/scenes and of its folder space) with
# PROGRAM (bracket), writes DOCS/gallery.md (DOCS: docs) and, where pngquant is installed, which makes them small, and, in
# space, rsvg-convert, the pictures DOCS/images/gallery/NAME.png.
# The question of a scene is its second line, "# Question: …".
set -eu
here=$(cd "$(dirname "$0")" && pwd)
program=${1:-bracket}
docs=${2:-$here/..}
if [ $# -gt 2 ]; then shift 2; else set -- "$here"/../../apps/scenes/*.toml "$here"/../../apps/scenes/space/*.toml; fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$docs/images/gallery/space" "$work/space"

text() { sed -n "s/^$1 *= *\"\(.*\)\"\$/\1/p" "$2"; }  # of a key of a scene

{
  echo '# Gallery'
  echo
  echo '<!-- Written by docs/gallery/make.sh. -->'
  echo
  echo 'Every scene of [apps/scenes](../apps/scenes), those in space last, with its question, what the last mesh'"'"'s interval is, and the command. A scene begins with'
  echo 'what it shows and what to try. `sh docs/gallery/make.sh` solves them and writes this page.'
  for scene; do
    name=$(basename "$scene" .toml)
    case $scene in */space/*) name=space/$name ;; esac
    "$program" run "$scene" -o "$work/$name" --png --quiet > "$work/out" || { cat "$work/out" >&2; exit 1; }
    picture=$work/$name/stress.png
    if [ ! -f "$picture" ] && command -v rsvg-convert > /dev/null; then
      rsvg-convert "$work/$name/stress.svg" -o "$picture"
    fi
    if [ -f "$picture" ] && command -v pngquant > /dev/null; then
      pngquant --strip 64 --force --output "$docs/images/gallery/$name.png" "$picture"
    fi
    printf '\n## %s\n\n%s\n\n' "$(text title "$scene")" "$(sed -n 's/^# Question: //p' "$scene")"
    printf '![Stress in the bodies as they deform](images/gallery/%s.png)\n\n' "$name"
    units=$(text units "$scene")
    printf '| %s | interval |\n|---|---|\n' "${units:-without units}"
    awk -v results="$work/$name" -f "$here/../verification/case.awk" -f "$here/rows.awk"
    printf '\n`bracket run apps/scenes/%s.toml`\n' "$name"
  done
} > "$work/page"
cp "$work/page" "$docs/gallery.md"
