#!/bin/sh
# Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
# sh apps/run.sh [SCENE]: installs what is missing, builds the program and the Python module, and solves SCENE (without
# one, the two blocks with lift-off). The results go to a folder in the current directory, named after the scene.
set -eu

project=$(cd "$(dirname "$0")/.." && pwd)
. "$project/apps/setup.sh"

cmake -S "$project" --preset release >&2
cmake --build "$project/build/release" --target apps/all >&2  # the program and the Python module

[ $# -gt 0 ] || set -- "$project/apps/scenes/two_blocks.toml"
exec "$project/build/release/apps/bracket" run "$@"
