# 16-threads.gp - figures/16/16-threads.csv as a picture.

set terminal pngcairo size 1400,800 font "DejaVu Sans,20" linewidth 2
set output png
set logscale x
set xrange [80:6000]
set yrange [0.4:1]
set xtics (100, 300, 1000, 3000)
set xlabel "bodies in the room"
set ylabel "two threads, in parts of one thread's time"
set grid ytics lc rgb "#dddddd"
set border 3
set tics nomirror
unset key
set arrow 1 from 80,0.6 to 6000,0.6 nohead dt 2 lc rgb "#888888"
set label 1 "target" at 85,0.585 tc rgb "#888888"
set label 4 "wall-clock time" at 330,0.72 tc rgb "#D55E00"
set label 2 "the longer half\nof each call" at 84,0.665 tc rgb "#0072B2"
set label 3 "halves that are equal" at 1050,0.525 tc rgb "#009E73"
plot csv using 1:(1 - $2 / 2) with linespoints pt 7 ps 1.5 lc rgb "#009E73", \
     csv using 1:4 with linespoints pt 7 ps 1.5 lc rgb "#D55E00", \
     csv using 1:3 with linespoints pt 7 ps 1.5 lc rgb "#0072B2"
