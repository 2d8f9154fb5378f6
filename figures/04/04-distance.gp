# 04-distance.gp - sh figures/draw/chart.sh figures/04/04-distance.gp DATA.csv CHART.svg
high = 390
load "figures/draw/chart.gp"
stats csv index 0 using 2 nooutput
most = STATS_max
set logscale y 10
set yrange [1e-18:20]
set ytics ("1" 1, "10^{−3}" 1e-3, "10^{−6}" 1e-6, "10^{−9}" 1e-9, "10^{−12}" 1e-12, "10^{−15}" 1e-15, "none" 1e-17)
shown(e) = e < 1e-17 ? 1e-17 : e
cold = orange; warm = blue
set multiplot
set tmargin at screen 0.955
set bmargin at screen 0.155
set lmargin at screen 0.115
set rmargin at screen 0.52
set xrange [0:9.5]
set xtics 1
set xlabel "iterations at most" textcolor rgb ink
set ylabel "mean relative error of the distance" textcolor rgb ink
set label 1 "cold" at 6.1,4e-1 textcolor rgb cold font bold
set label 2 "carried" at 1.45,3e-9 textcolor rgb warm font bold
plot csv index 0 using 1:(shown($3)) with linespoints pt 7 ps 0.78 lc rgb cold lw 1.5, \
     csv index 0 using 1:(shown($5)) with linespoints pt 7 ps 0.78 lc rgb warm lw 1.5
set lmargin at screen 0.575
set rmargin at screen 0.98
set xrange [0:most*1.12]
set xtics 200
set xlabel "time of a query, ns" textcolor rgb ink
unset ylabel
set ytics ("" 1, "" 1e-3, "" 1e-6, "" 1e-9, "" 1e-12, "" 1e-15, "" 1e-17)
set label 1 "cold" at most*0.70,2e-2 textcolor rgb cold font bold
set label 2 "carried" at most*0.29,3e-9 textcolor rgb warm font bold
plot csv index 0 using 2:(shown($3)) with linespoints pt 7 ps 0.78 lc rgb cold lw 1.5, \
     csv index 0 using 4:(shown($5)) with linespoints pt 7 ps 0.78 lc rgb warm lw 1.5
unset multiplot
