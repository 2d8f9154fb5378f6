# 05-bounds.gp - sh figures/draw/chart.sh figures/05/05-bounds.gp DATA.csv CHART.svg
high = 390
load "figures/draw/chart.gp"
set datafile separator comma
set logscale y 10
set format y "10^{%L}"
set yrange [1e-4:30]
set xrange [0.6:10.4]
set xtics 1
set xlabel "iterations at most" textcolor rgb ink
set ylabel "mean relative error of the bound" textcolor rgb ink
set label 1 "upper bound: how far A − B\nreaches along the normal" at 4.4,7.5 textcolor rgb green font bold
set label 2 "lower bound:\nthe closest face" at 1.15,0.075 textcolor rgb orange font bold
plot csv every ::1 using 1:3 with linespoints pt 7 ps 0.91 lc rgb orange lw 1.6, \
     csv every ::1 using 1:4 with linespoints pt 7 ps 0.91 lc rgb green lw 1.6
