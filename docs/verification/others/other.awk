# Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
# Functions for make.sh, beside those of case.awk: rows of what another program found (-v folder=FOLDER of its files).

# The cells of the run's last mesh.
function cells_of_run(    line, fields) {
  close(results "/history.csv")  # read_results() has read it
  while ((getline line < (results "/history.csv")) > 0) split(line, fields, ",")
  return fields[2]
}

# The value of a case on its last mesh; by how much that differs from the one before, which is taken as its error; and the
# limit of the geometric sequence through the last three (Aitken). Inside: in the interval; near: not farther from it than
# the error.
function other(name, file, number, column, program,    line, fields, found, value, cells, error, step, before, sequence, verdict) {
  if (!known(name)) return
  while ((getline line < (folder "/" file)) > 0) {
    split(line, fields, " ")
    if (fields[1] != number) continue
    value[++found] = fields[column] + 0
    cells = fields[2]
  }
  close(folder "/" file)
  if (found < 3) {
    printf "| %s | | | %s has not three rows of case %d | | | | | OUTSIDE |\n", name, file, number
    failed = 1
    return
  }
  step = value[found] - value[found - 1]
  before = value[found - 1] - value[found - 2]
  error = size(step)
  sequence = value[found] + (step == before ? 0 : step * step / (before - step))
  verdict = lower[name] <= value[found] && value[found] <= upper[name] ? "inside" : "near"
  if (value[found] < lower[name] - error || value[found] > upper[name] + error) verdict = "OUTSIDE"
  printf "| %s | %s | %d | %.10g | %.1e | %.10g | %s | %d | %s |\n", name, program, cells, value[found], error, sequence, \
    interval(lower[name], upper[name]), cells_of_run(), verdict
  if (verdict == "OUTSIDE") failed = 1
}
