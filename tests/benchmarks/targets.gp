# Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
# gnuplot -e "rows='ROWS'" tests/benchmarks/targets.gp > docs/images/performance.svg, ROWS what targets.sh printed.
set terminal svg size 1000,520 font 'sans-serif,13' background '#ffffff'
set multiplot layout 2,4 title 'Degree 2: blue, dots. 3: orange, squares. 4: red, triangles.'
set key off
set logscale xy
set xrange [0.02:100]
set yrange [5e-5:0.2]
set format x '%g'
set format y '10^{%T}'
set mxtics 1
set mytics 1
set grid xtics ytics lc rgb '#dddddd'
of(scene, degree) = sprintf("< awk -F'|' '{ gsub(/ /, \"\"); if ($2 == \"%s\" && $3 == \"%s\") print $6, $4 }' %s", scene, degree, rows)
do for [scene in 'two_blocks three_halves westergaard l_shape cook example_1 example_2 gravity'] {
  set title scene noenhanced
  set xlabel 'CPU seconds'
  set ylabel 'guaranteed error'
  plot of(scene, '2') with linespoints lc rgb '#3060c0' pt 7 title 'degree 2', \
       of(scene, '3') with linespoints lc rgb '#e0a030' pt 5 title '3', \
       of(scene, '4') with linespoints lc rgb '#c03060' pt 9 title '4'
}
unset multiplot
