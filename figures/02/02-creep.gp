# 02-creep.gp - sh figures/draw/chart.sh figures/02/02-creep.gp DATA.csv CHART.svg
high = 420
load "figures/draw/chart.gp"
set multiplot layout 1,2 margins 0.08,0.965,0.155,0.9 spacing 0.1
set title "The error of each stick"
set xrange [0:51]
set yrange [0:1.1]
set xtics 10
set ytics 0.5
set xlabel "stick" textcolor rgb ink
set label 1 "at first" at 25.5,1.05 center textcolor rgb grey
set label 2 "after 10 iterations" at 22,0.93 center textcolor rgb purple
set label 3 "100" at 25.5,0.77 center textcolor rgb orange
set label 4 "300" at 25.5,0.355 center textcolor rgb blue
set label 5 "1000" at 25.5,0.08 center textcolor rgb green
plot csv index 0 using 1:2 with linespoints pt 7 ps 0.39 lc rgb grey lw 1.4, \
     csv index 1 using 1:2 with linespoints pt 7 ps 0.39 lc rgb purple lw 1.8, \
     csv index 2 using 1:2 with linespoints pt 7 ps 0.39 lc rgb orange lw 1.8, \
     csv index 3 using 1:2 with linespoints pt 7 ps 0.39 lc rgb blue lw 1.8, \
     csv index 4 using 1:2 with linespoints pt 7 ps 0.39 lc rgb green lw 1.8
unset label
set title "The largest error"
set xrange [0:2000]
set yrange [3e-4:1.3]
set logscale y
set xtics 500
set ytics ("1" 1, "10^{−1}" 0.1, "10^{−2}" 0.01, "10^{−3}" 1e-3)
set xlabel "iterations"
set label 1 "cos²(π/51)\nan iteration" at 1180,0.08 textcolor rgb quiet
rho = cos(pi / 51) ** 2
plot csv index 5 using 1:2 with lines lc rgb blue lw 2.5, \
     2.2 * rho ** x with lines dt 2 lc rgb quiet lw 1.4
unset multiplot
