# The pressures on the top of the upper block, for *DLOAD: of each side of an element that the surface upper.top has, by
# where its middle is. P1 is the load on side S1.
BEGIN { FS = ", *" }
/^\*/ { card = $0; next }
card ~ /^\*NODE/ { x[$1] = $2 }
card ~ /^\*ELEMENT/ { for (side = 1; side <= 3; ++side) middle[$1, "S" side] = (x[$(1 + side)] + x[$(2 + side % 3)]) / 2 }
card ~ /NAME=upper.top$/ { print $1 ", P" substr($2, 2) ", " (middle[$1, $2] < 0.5 ? 0.1 : -0.09) }
