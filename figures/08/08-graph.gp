# 08-graph.gp - sh figures/draw/chart.sh figures/08/08-graph.gp DATA.csv CHART.svg
high = 320
load "figures/draw/chart.gp"
unset border
unset tics
unset colorbox
set lmargin 0
set rmargin 0
set tmargin 2.5
set bmargin 0

set palette maxcolors 3 defined (1 orange, 2 blue, 3 green)
set cbrange [0.5:3.5]
set style fill solid 1 noborder
set multiplot

set size 0.42,1
set origin 0,0
set size ratio -1
set xrange [-1.8:1.8]
set yrange [-1.75:1.75]
set title "The constraint graph" textcolor rgb ink
set label 1 "v" at 0,1.5 center font bold textcolor rgb ink
# Names stand beside the middles of the sticks, away from the middle of all.
away(x, y, d) = d / sqrt(x * x + y * y + 1e-9)
nx(x, y, k) = k == 5 ? x - 0.28 : k == 6 ? x + 0.28 : x + x * away(x, y, 0.24)
ny(x, y, k) = k == 5 || k == 6 ? y + 0.02 : y + y * away(x, y, 0.24)
plot csv index 1 using 1:2:3:4:5 with vectors nohead lw 5 lc palette, \
     csv index 0 using 1:2 with points pt 7 ps 1.43 lc rgb ink, \
     csv index 1 using (nx($1 + $3/2, $2 + $4/2, $0)):(ny($1 + $3/2, $2 + $4/2, $0)):6:5 with labels center textcolor palette
unset label

set size 0.58,1
set origin 0.42,0
set size noratio
set xrange [-3.0:7.3]
set yrange [-6.3:2.2]
set title "The list of v" textcolor rgb ink
set label 1 "breadth first" at -0.65,0.1 right textcolor rgb ink
set label 2 "round 1" at -0.65,-2.4 right textcolor rgb ink
set label 3 "round 2" at -0.65,-3.5 right textcolor rgb ink
set label 4 "round 3" at -0.65,-4.6 right textcolor rgb ink
set label 5 "with repeats, one round after the other:" at -0.5,-1.35 textcolor rgb quiet
set label 6 "distance 1" at 0.6,1.35 center textcolor rgb orange
set label 7 "distance 2" at 3.5,1.35 center textcolor rgb blue
set label 8 "distance 3" at 6.2,1.35 center textcolor rgb green
w = 0.44
plot csv index 2 using 2:(0):($2-w):($2+w):(-w):(+w):3 with boxxyerror lc palette, \
     csv index 2 using 2:(0.03):4 with labels center textcolor rgb page, \
     csv index 3 using 2:(-2.5-1.1*$1):($2-w):($2+w):(-2.5-1.1*$1-w):(-2.5-1.1*$1+w):3 with boxxyerror lc palette, \
     csv index 3 using 2:(-2.47-1.1*$1):4 with labels center textcolor rgb page
unset multiplot
