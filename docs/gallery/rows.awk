# Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
# The intervals of a run as rows of a table, the energy's last; with verification/case.awk.
BEGIN {
  read_results()
  for (i = 1; i <= quantities; ++i) printf "| %s | %s |\n", quantity[i], interval(lower[quantity[i]], upper[quantity[i]])
  printf "| energy | %s |\n", interval(lower["energy"], upper["energy"])
}
