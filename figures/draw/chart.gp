# chart.gp - what all charts have in common.  A chart says how high it is, in
# pixels, and then: load "figures/draw/chart.gp".  chart.awk knows the colours.
set encoding utf8
if (!exists("wide")) wide = 720
set terminal svg size wide,high font "sans-serif,13"
blue = "#1f6fb4"; orange = "#c8570b"; green = "#2c7d3f"; purple = "#7b4ba8"
red = "#b8252f"; grey = "#6b7078"
ink = "#22252a"; quiet = "#5d636d"; rule = "#d9d6cd"; page = "#fffefb"
# The same colour, so much of it: pale(blue, 0.2).
pale(colour, share) = sprintf("#%02x%s", 255 * (1 - share), colour[2:7])
bold = ":Bold"
small = ",12"
# Axes; `eval axes` brings them back.
axes = "set border 3 lc rgb quiet lw 0.7; set tics nomirror scale 0.5 textcolor rgb quiet; set xtics nomirror; set ytics nomirror; set grid xtics ytics lt 1 lc rgb rule lw 0.7"
eval axes
set title textcolor rgb ink font bold offset 0,-0.4
set xlabel textcolor rgb ink offset 0,0.45
set ylabel textcolor rgb ink
unset key
# The place of one of several plots, in pixels from below: eval box(60, 350, 50, 300).
box(left, right, bottom, top) = sprintf("set lmargin at screen %g; set rmargin at screen %g; set bmargin at screen %g; set tmargin at screen %g", 1.0 * left / wide, 1.0 * right / wide, 1.0 * bottom / high, 1.0 * top / high)
# A colour as a number, for `lc rgb variable`.
number(colour) = int(real("0x" . colour[2:7]))
