# 18-threads.gp - figures/18/18-threads.csv as a picture.

set encoding utf8
set terminal pngcairo size 1400,800 font "DejaVu Sans,20" linewidth 2
set output png
set logscale x
set xrange [80:7500]
set yrange [0.3:1.1]
set bmargin 5
set xlabel "bodies in the room; share of a frame that can be shared" offset 0,-0.8
set ylabel "time, in parts of one thread's"
set grid ytics lc rgb "#dddddd"
set border 3
set tics nomirror
unset key
# Where each column stands in the end: labels beside the curves.
stats csv using 3 every ::3::3 nooutput; two = STATS_max
stats csv using 4 every ::3::3 nooutput; four = STATS_max
stats csv using 5 every ::3::3 nooutput; wall = STATS_max
wall = wall - two < 0.06 ? two + 0.06 : wall
set label 1 "two threads,\nwall-clock time" at 3300,wall + 0.02 tc rgb "#D55E00"
set label 2 "two, if handing\nout were free" at 3300,two - 0.01 tc rgb "#0072B2"
set label 3 "four, if handing\nout were free" at 3300,four + 0.01 tc rgb "#009E73"
set arrow 1 from 800,0.6 to 1250,0.6 nohead dt 2 lc rgb "#555555"
set label 4 "target" at 840,0.575 tc rgb "#555555"
plot csv using 1:3:xtic(sprintf("%d\n%.0f %%", $1, 100 * $2)) with linespoints pt 7 ps 1.5 lc rgb "#0072B2", \
     csv using 1:4 with linespoints pt 7 ps 1.5 lc rgb "#009E73", \
     csv using 1:6 with points pt 6 ps 1.8 lc rgb "#009E73", \
     csv using 1:5 with linespoints pt 7 ps 1.5 lc rgb "#D55E00"
