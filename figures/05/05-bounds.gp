# 05-bounds.gp - sh figures/draw/chart.sh figures/05/05-bounds.gp DATA.csv CHART.svg
high = 380
load "figures/draw/chart.gp"
set datafile separator comma
stats csv every ::1 using 2 nooutput
lower = orange; upper = green
set logscale y 10
set yrange [1e-4:30]
set ytics ("10" 10, "1" 1, "0.1" 0.1, "0.01" 0.01, "0.001" 1e-3, "0.0001" 1e-4)
set multiplot
eval box(66, 360, 52, 344)
set title "Mean relative error of the bounds"
set xrange [0.6:10.4]
set xtics 1
set xlabel "iterations at most"
set label 1 "upper: how far A − B\nreaches along the normal" at 3.6,12 textcolor rgb upper font bold
set label 2 "lower: the\nclosest face" at 1.05,0.07 textcolor rgb lower font bold
plot csv every ::1 using 1:3 with linespoints pt 7 ps 0.8 lc rgb lower lw 1.6, \
     csv every ::1 using 1:4 with linespoints pt 7 ps 0.8 lc rgb upper lw 1.6
unset label
eval box(430, 700, 52, 344)
set title "The same, against time"
set xrange [0:STATS_max / 1000 * 1.12]
set xtics 0.5
set xlabel "time of a query, µs"
plot csv every ::1 using ($2/1000):3 with linespoints pt 7 ps 0.8 lc rgb lower lw 1.6, \
     csv every ::1 using ($2/1000):4 with linespoints pt 7 ps 0.8 lc rgb upper lw 1.6
unset multiplot
