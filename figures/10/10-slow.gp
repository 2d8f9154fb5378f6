# 10-slow.gp - gnuplot -e "csv='...'; png='...'" figures/10/10-slow.gp
set encoding utf8
set terminal pngcairo size 1400,900 font "DejaVu Sans,22" linewidth 2 background "#ffffff"
set output png
set datafile separator ","
set logscale xy 10
set xrange [3.6:80]
set yrange [100:1e8]
set xtics (4, 6, 8, 12, 16, 24)
set ytics ("0.1 µs" 1e2, "1 µs" 1e3, "10 µs" 1e4, "0.1 ms" 1e5, "1 ms" 1e6, "10 ms" 1e7, "0.1 s" 1e8)
set grid ytics xtics lc rgb "#e4e4e4" lw 0.5
set border 3 lc rgb "#808080" lw 0.7
set tics nomirror textcolor rgb "#404040"
set xlabel "points of each body" textcolor rgb "#404040"
set ylabel "time of an answer" textcolor rgb "#404040"
set title "Every feature with every other, and the quick way" font "DejaVu Sans,26" offset 0,-0.3
unset key
set label 1 "depth: all normals and\ncrossings of edges" at 26,2.6e7 textcolor rgb "#d55e00" font "DejaVu Sans Bold,22"
set label 2 "distance: all pairs\nof features" at 26,4e6 textcolor rgb "#cc79a7" font "DejaVu Sans Bold,22"
set label 3 "depth: the hit face" at 26,6e3 textcolor rgb "#0072b2" font "DejaVu Sans Bold,22"
set label 4 "distance: GJK" at 26,1.1e3 textcolor rgb "#009e73" font "DejaVu Sans Bold,22"
plot csv using 1:3 every ::1 with linespoints pt 7 ps 1.4 lc rgb "#d55e00" lw 1.5, \
     csv using 1:2 every ::1 with linespoints pt 7 ps 1.4 lc rgb "#cc79a7" lw 1.5, \
     csv using 1:5 every ::1 with linespoints pt 7 ps 1.4 lc rgb "#0072b2" lw 1.5, \
     csv using 1:4 every ::1 with linespoints pt 7 ps 1.4 lc rgb "#009e73" lw 1.5
