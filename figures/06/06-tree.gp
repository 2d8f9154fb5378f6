# 06-tree.gp - sh figures/draw/chart.sh figures/06/06-tree.gp DATA.csv CHART.svg
high = 770
load "figures/draw/chart.gp"
set multiplot

set origin 0,0.46
set size 1,0.54
set lmargin 10
set rmargin 12
set logscale xy 10
set title "Which particles of a cloth are near each other?"
set xlabel "leaves" textcolor rgb ink
set ylabel "ms" textcolor rgb ink
set xrange [80:32000]
set yrange [4e-3:60]
set xtics (100, 400, 1600, 6400, 25600)
set ytics ("0.01" 0.01, "0.1" 0.1, "1" 1, "10" 10)
set label 1 "all pairs" at 3200,17 right textcolor rgb orange
set label 2 "folded" at 28000,16.5 textcolor rgb blue
set label 3 "draped" at 28000,8.6 textcolor rgb green
set label 4 "flat" at 28000,5.4 textcolor rgb pale(blue, 0.5)
set label 5 "refit only" at 28000,0.95 textcolor rgb grey
plot csv index 3 using 1:2 with linespoints pt 7 ps 0.52 lc rgb orange lw 1.5, \
     csv index 2 using 1:2 with lines dt 3 lc rgb grey lw 1.2, \
     csv index 0 using 1:4 with linespoints pt 7 ps 0.52 lc rgb pale(blue, 0.5) lw 1.5, \
     csv index 1 using 1:4 with linespoints pt 7 ps 0.52 lc rgb green lw 1.5, \
     csv index 2 using 1:4 with linespoints pt 7 ps 0.52 lc rgb blue lw 1.5
unset label
unset logscale

set origin 0,0
set size 0.55,0.45
set rmargin 3
set title "Pairs that are none"
set xlabel "gap between the layers, in h"
set ylabel "pairs a triangle"
set xrange [0:1.6]
set yrange [0:14]
set xtics 0.4
set ytics 4
set label 1 "spheres overlap" at 0.62,10.6 textcolor rgb orange
set label 2 "triangles nearer\nthan 0.12 h" at 0.19,2.2 textcolor rgb blue
plot csv index 4 using 1:2 with steps lc rgb orange lw 1.5, \
     csv index 4 using 1:3 with lines lc rgb blue lw 2

set origin 0.55,0
set size 0.45,0.45
set lmargin 8
set rmargin 4
set title "How tight?"
set xlabel "level below the root"
set ylabel "radius, m"
unset label
set logscale y 2
set xrange [-0.3:10.3]
set yrange [0.004:3]
set xtics 2
set ytics (0.01, 0.1, 1)
set label 1 "layered" at 3.4,0.95 textcolor rgb orange
set label 2 "wrapped" at 0.6,0.16 textcolor rgb blue
plot csv index 5 using 1:3 with linespoints pt 7 ps 0.52 lc rgb orange lw 1.5, \
     csv index 5 using 1:2 with linespoints pt 7 ps 0.52 lc rgb blue lw 1.5
unset multiplot
