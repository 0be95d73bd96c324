# Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
# Completion of bracket(1) for bash.

_bracket() {
  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} command=${COMP_WORDS[1]}
  local commands="run study extremes paper mesh assess check info init help"
  local options=
  case $command in
    study|extremes) options="--set -o" ;;
    paper) options="-o" ;;
    mesh) options="--set -o --refine --degree --force" ;;
    assess) options="--set -o --json --quiet" ;;
    check) options="--set --json" ;;
    info) options="--json" ;;
    init|help) ;;
    *) options="--set -o --json --quiet --all-levels --last-level --png --no-report --ranks" ;;
  esac
  compopt -o filenames 2>/dev/null
  if ((COMP_CWORD == 1)); then
    mapfile -t COMPREPLY < <(compgen -W "$commands --help --version" -- "$word"; compgen -f -X '!*.toml' -- "$word"; compgen -d -- "$word")
  elif [[ $before == -o ]]; then
    mapfile -t COMPREPLY < <(compgen -f -- "$word")
  elif [[ $word == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$options --help" -- "$word")
  elif [[ $command == help ]]; then
    mapfile -t COMPREPLY < <(compgen -W "scene $commands" -- "$word")
  elif [[ $command == init ]]; then
    mapfile -t COMPREPLY < <(compgen -d -- "$word")
  elif [[ $command == info ]] || [[ $command == assess && $COMP_CWORD -gt 2 ]]; then
    mapfile -t COMPREPLY < <(compgen -f -- "$word")
  else
    mapfile -t COMPREPLY < <(compgen -f -X '!*.toml' -- "$word"; compgen -d -- "$word")
  fi
}
complete -F _bracket bracket
