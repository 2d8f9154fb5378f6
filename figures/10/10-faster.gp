# 10-faster.gp - gnuplot -e "csv='...'; png='...'" figures/10/10-faster.gp
set encoding utf8
set terminal pngcairo size 1500,760 font "DejaVu Sans,22" linewidth 2 background "#ffffff"
set output png
set datafile separator whitespace
set logscale x 10
set xrange [60:60000]
set yrange [5.6:0.3]
set xtics ("0.1 µs" 100, "1 µs" 1000, "10 µs" 10000)
set ytics ("distance, cold" 1, "distance, carried" 2, "depth, cold" 3, "depth, carried" 4, "distance of balls\nof 642 corners" 5)
set grid xtics lc rgb "#e4e4e4" lw 0.5
set border 1 lc rgb "#808080" lw 0.7
set tics nomirror textcolor rgb "#404040"
set lmargin 20
set xlabel "time of a query" textcolor rgb "#404040"
set title "The same answers, sooner" font "DejaVu Sans,26" offset 0,-0.3
unset key
set label 1 "plain: chapters 04 and 05" at graph 0.98,0.95 right textcolor rgb "#d55e00" font "DejaVu Sans Bold,22"
set label 2 "fast: this chapter" at graph 0.98,0.88 right textcolor rgb "#0072b2" font "DejaVu Sans Bold,22"
plot csv using 3:1:($2-$3):(0) with vectors nohead lc rgb "#b0b0b0" lw 2, \
     csv using 2:1 with points pt 7 ps 2.4 lc rgb "#d55e00", \
     csv using 3:1 with points pt 7 ps 2.4 lc rgb "#0072b2", \
     csv using ($2*1.14):1:(sprintf("%.1f times", $2/$3)) with labels left textcolor rgb "#404040" font "DejaVu Sans,20"
