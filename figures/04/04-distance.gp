# 04-distance.gp - sh figures/draw/chart.sh figures/04/04-distance.gp DATA.csv CHART.svg
high = 390
load "figures/draw/chart.gp"
stats csv index 0 using 2 nooutput
most = STATS_max
set logscale y 10
set yrange [1e-18:20]
set ytics ("1" 1, "10^{−3}" 1e-3, "10^{−6}" 1e-6, "10^{−9}" 1e-9, "10^{−12}" 1e-12, "10^{−15}" 1e-15, "none" 1e-17)
# Once the answer is exact, more iterations are no more work.
done = 0
shown(e) = done ? NaN : e < 1e-16 ? (done = 1, 1e-17) : e
cold = orange; warm = blue
set multiplot
eval box(62, 365, 50, 354)
set xrange [0:9.5]
set xtics 1
set xlabel "iterations at most" textcolor rgb ink
set title "Mean relative error of the distance"
set label 1 "cold" at 6.1,4e-1 textcolor rgb cold font bold
set label 2 "carried" at 1.45,3e-9 textcolor rgb warm font bold
done = 0
plot csv index 0 using 1:(shown($3)) with linespoints pt 7 ps 0.78 lc rgb cold lw 1.5, \
     csv index 0 using ($0 == 0 ? (done = 0, $1) : $1):(shown($5)) with linespoints pt 7 ps 0.78 lc rgb warm lw 1.5
eval box(400, 708, 50, 354)
set xrange [0:most*1.12]
set xtics 200
set xlabel "time of a query, ns" textcolor rgb ink
set title "The same, against time"
set ytics ("" 1, "" 1e-3, "" 1e-6, "" 1e-9, "" 1e-12, "" 1e-15, "" 1e-17)
set label 1 "cold" at most*0.70,2e-2 textcolor rgb cold font bold
set label 2 "carried" at most*0.29,3e-9 textcolor rgb warm font bold
done = 0
plot csv index 0 using 2:(shown($3)) with linespoints pt 7 ps 0.78 lc rgb cold lw 1.5, \
     csv index 0 using ($0 == 0 ? (done = 0, $4) : $4):(shown($5)) with linespoints pt 7 ps 0.78 lc rgb warm lw 1.5
unset multiplot
