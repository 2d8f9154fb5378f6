# 03-cube.gp - sh figures/draw/chart.sh figures/03/03-cube.gp DATA.csv CHART.svg
high = 640
load "figures/draw/chart.gp"
array colour[5] = [orange, purple, blue, green, grey]
array name[4] = ["12: edges", "16: and 4 main diagonals", "18: edges, 6 of sides", "22: and 4 main diagonals"]
array sticks[4] = [12, 16, 18, 22]
set multiplot

# The cubes as they lie.
unset border
unset tics
set size ratio -1
do for [c=1:4] {
  set lmargin at screen 0.015 + 0.245 * (c - 1)
  set rmargin at screen 0.015 + 0.245 * c
  set bmargin at screen 0.66
  set tmargin at screen 0.93
  set xrange [-1.1:1.1]
  set yrange [-0.55:1.6]
  set title name[c] textcolor rgb colour[c] font small
  n = sticks[c]
  plot csv index 0 using ($1==n ? $2 : NaN):3:($4-$2):($5-$3) with vectors nohead lw 1.6 lc rgb colour[c], \
       csv index 0 using ($1==n ? $2 : NaN):3 with points pt 7 ps 0.85 lc rgb ink, \
       csv index 0 using ($1==n ? $4 : NaN):5 with points pt 7 ps 0.85 lc rgb ink
}

set size noratio
eval box(48, 288, 60, 370)
eval axes

# Rank.
set title "Rank, as sticks are added" textcolor rgb ink font bold
set xrange [8:28]
set yrange [8:20]
set xtics 8,4,28
set ytics 8,2,20
set xlabel "sticks" textcolor rgb ink
set label 1 "18 = 3 n − 6: rigid" at 27.8,18.6 right textcolor rgb ink
set label 2 "sides first" at 15.2,16.8 right textcolor rgb blue
set label 3 "main diagonals\nfirst: 16 sticks,\nrank 15" at 17.2,14.1 left textcolor rgb purple
plot 18 with lines lc rgb grey lw 0.8 dt 2, \
     csv index 2 using 1:2 with linespoints pt 7 ps 0.59 lw 1.4 lc rgb colour[2], \
     csv index 1 using 1:2 with linespoints pt 7 ps 0.59 lw 1.4 lc rgb colour[3]
unset label

# Speed against error.
eval box(385, 650, 60, 370)
set title "Error of the shape, 1 to 256 iterations" textcolor rgb ink font bold
set logscale xy
set xrange [90:60000]
set yrange [1e-9:3]
set xtics ("0.1" 100, "1" 1000, "10" 10000)
set ytics ("1" 1, "10^{−2}" 1e-2, "10^{−4}" 1e-4, "10^{−6}" 1e-6, "10^{−8}" 1e-8)
set xlabel "time of a step, µs" textcolor rgb ink
set label 1 "12 sticks" at 4e3,0.45 left textcolor rgb colour[1]
set label 2 "16" at 1.6e4,7.5e-2 left textcolor rgb purple
set label 3 "18" at 1.5e2,5e-2 right textcolor rgb colour[3]
set label 4 "22" at 6.5e3,2.5e-7 left textcolor rgb colour[4]
set label 5 "28: every\npair" at 9e2,3e-6 right textcolor rgb colour[5]
plot for [c=1:5] csv index 2+c using 3:4 with linespoints pt 7 ps 0.59 lw 1.4 lc rgb colour[c]
unset multiplot
