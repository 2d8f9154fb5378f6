# 18-threads.gp - sh figures/draw/chart.sh figures/18/18-threads.gp DATA.csv CHART.svg

high = 400
load "figures/draw/chart.gp"
set logscale x
set xrange [80:7500]
set yrange [0.3:1.1]
set xlabel "bodies in the room; share of a frame that can be shared" offset 0,-0.4
set title "Time of a frame, in parts of one thread's"
eval box(50, 700, 84, 364)
set grid ytics lc rgb rule
# Where each column stands in the end: labels beside the curves.
stats csv using 3 every ::3::3 nooutput; two = STATS_max
stats csv using 4 every ::3::3 nooutput; four = STATS_max
stats csv using 5 every ::3::3 nooutput; wall = STATS_max
wall = wall - two < 0.06 ? two + 0.06 : wall
set label 1 "two threads,\nwall-clock time" at 3300,wall + 0.02 tc rgb orange
set label 2 "two, if handing\nout were free" at 3300,two - 0.01 tc rgb blue
set label 3 "four, if handing\nout were free" at 3300,four + 0.01 tc rgb green
plot csv using 1:3:xtic(sprintf("%d\n%.0f %%", $1, 100 * $2)) with linespoints pt 7 ps 0.98 lc rgb blue, \
     csv using 1:4 with linespoints pt 7 ps 0.98 lc rgb green, \
     csv using 1:6 with points pt 6 ps 1.17 lc rgb green, \
     csv using 1:5 with linespoints pt 7 ps 0.98 lc rgb orange
