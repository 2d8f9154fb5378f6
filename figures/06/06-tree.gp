# 06-tree.gp - sh figures/draw/chart.sh figures/06/06-tree.gp DATA.csv CHART.svg
high = 648
load "figures/draw/chart.gp"
set multiplot

eval box(62, 620, 338, 614)
set logscale xy 10
set title "Which particles of a cloth are near each other? Time, ms"
set xlabel "particles" textcolor rgb ink
set xrange [80:32000]
set yrange [4e-3:60]
set xtics (100, 400, 1600, 6400, 25600)
set ytics ("0.01" 0.01, "0.1" 0.1, "1" 1, "10" 10)
set label 1 "all pairs" at 3200,17 right textcolor rgb orange
set label 2 "folded" at 29500,9.9 textcolor rgb blue
set label 3 "draped" at 29500,5.5 textcolor rgb green
set label 4 "flat" at 29500,3.2 textcolor rgb purple
set label 5 "refit only" at 29500,0.98 textcolor rgb grey
plot csv index 3 using 1:2 with linespoints pt 7 ps 0.52 lc rgb orange lw 1.5, \
     csv index 2 using 1:2 with lines dt 3 lc rgb grey lw 1.2, \
     csv index 0 using 1:4 with linespoints pt 7 ps 0.52 lc rgb purple lw 1.5, \
     csv index 1 using 1:4 with linespoints pt 7 ps 0.52 lc rgb green lw 1.5, \
     csv index 2 using 1:4 with linespoints pt 7 ps 0.52 lc rgb blue lw 1.5
unset label
unset logscale

eval box(62, 345, 50, 246)
set title "Pairs listed for a triangle"
set xlabel "gap between the layers, in mesh widths h"
set xrange [0:1.6]
set yrange [0:14]
set xtics 0.4
set ytics 4
set label 1 "spheres overlap" at 0.62,10.6 textcolor rgb orange
set label 2 "triangles nearer\nthan 0.12 h" at 0.19,2.2 textcolor rgb blue
plot csv index 4 using 1:2 with steps lc rgb orange lw 1.5, \
     csv index 4 using 1:3 with lines lc rgb blue lw 2

eval box(430, 708, 50, 246)
set title "Mean radius of a sphere, m"
set xlabel "level below the root"
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
