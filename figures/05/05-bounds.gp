# 05-bounds.gp - gnuplot -e "csv='...'; png='...'" figures/05/05-bounds.gp
set encoding utf8
set terminal pngcairo size 1400,760 font "DejaVu Sans,22" linewidth 2 background "#ffffff"
set output png
set datafile separator comma
unset key
set logscale y 10
set format y "10^{%L}"
set yrange [1e-4:30]
set xrange [0.6:10.4]
set xtics 1
set grid ytics xtics lc rgb "#e4e4e4" lw 0.5
set border 3 lc rgb "#808080" lw 0.7
set tics nomirror textcolor rgb "#404040"
set xlabel "iterations at most" textcolor rgb "#404040"
set ylabel "mean relative error of the bound" textcolor rgb "#404040"
set label 1 "upper bound: how far A − B\nreaches along the normal" at 4.4,7.5 textcolor rgb "#009e73" font "DejaVu Sans Bold,22"
set label 2 "lower bound:\nthe closest face" at 1.15,0.075 textcolor rgb "#d55e00" font "DejaVu Sans Bold,22"
plot csv every ::1 using 1:3 with linespoints pt 7 ps 1.4 lc rgb "#d55e00" lw 1.6, \
     csv every ::1 using 1:4 with linespoints pt 7 ps 1.4 lc rgb "#009e73" lw 1.6
