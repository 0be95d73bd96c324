# Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
# Functions for make.sh: what a run has found (-v results=FOLDER), and rows of a case's table that compare it with what
# is known. Intervals are printed outward, in units of their widths' first digit and at least of the seventh digit of their
# ends: the digits behind those differ between processors.

# The interval of the last mesh, of the energy and of each quantity; the names of these in their order.
function read_results(    line, fields, column, i) {
  getline line < (results "/history.csv")
  split(line, fields, ",")
  for (i in fields) column[fields[i]] = i
  while ((getline line < (results "/history.csv")) > 0) {
    split(line, fields, ",")
    lower["energy"] = fields[column["lower"]] + 0
    upper["energy"] = fields[column["upper"]] + 0
  }
  getline line < (results "/quantities.csv")
  while ((getline line < (results "/quantities.csv")) > 0) {
    if (line ~ /inf/) continue  # no interval
    split(line, fields, "\"")  # "name",kind,cells,lower,upper,…
    i = fields[2]
    if (!(i in lower)) quantity[++quantities] = i
    split(fields[3], fields, ",")
    lower[i] = fields[4] + 0
    upper[i] = fields[5] + 0
  }
}

# The decimal exponent of x as printed, so that 0.1 − 1e-17 has that of 0.1.
function exponent(x) { return substr(sprintf("%.3e", x), length(sprintf("%.3e", x)) - 2) + 0 }

function floor(x) { return int(x) > x ? int(x) - 1 : int(x) }

function size(x) { return x < 0 ? -x : x }

# n 10^unit.
function decimal(n, unit,    digits) {
  if (n == 0) return "0"
  if (unit <= 0 && unit >= -12) return sprintf("%." (-unit) "f", n * 10^unit)
  digits = exponent(n * 10^unit) - unit
  return sprintf("%." (digits < 0 ? 0 : digits) "e", n * 10^unit)
}

# A thousandth of the unit more on either side: an end that is a multiple of the unit but for rounding is one less, or
# more, on every processor.
function interval(low, high,    unit, least) {
  least = exponent(size(low) > size(high) ? low : high) - 6
  unit = high > low ? exponent(high - low) : least
  if (unit < least) unit = least
  return "[" decimal(low == 0 ? 0 : floor(low / 10^unit - 1e-3), unit) ", " decimal(high == 0 ? 0 : -floor(-high / 10^unit - 1e-3), unit) "]"
}

function row(name, value, verdict) {
  printf "| %s | %s | %s | %s |\n", name, value, interval(lower[name], upper[name]), verdict
  if (verdict ~ /OUTSIDE/) failed = 1
}

function known(name) {
  if (name in lower) return 1
  printf "| %s | | the run has no such quantity | OUTSIDE |\n", name
  failed = 1
  return 0
}

# An exact value of the scene's own problem: it has to be inside.
function exact(name, value) {
  if (known(name)) row(name, sprintf("%.10g", value), lower[name] <= value && value <= upper[name] ? "inside" : "OUTSIDE")
}

# The exact value of a problem that the scene's comes near to: how far it is from the interval's middle.
function limit(name, value,    off) {
  if (!known(name)) return
  off = 100 * size(0.5 * (lower[name] + upper[name]) / value - 1)
  row(name, sprintf("%.10g, of the limit", value), off < 1e-4 ? "differs by less than 0.0001 %" : sprintf("differs by %.1g %%", off))
}

# Another interval that holds the exact value: the two have to meet.
function meets(name, low, high) {
  if (known(name))
    row(name, "in [" sprintf("%.12g, %.12g", low, high) "]", lower[name] <= high && low <= upper[name] ? "meets" : "OUTSIDE")
}
