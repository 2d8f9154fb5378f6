# 06-tree.gp - gnuplot -e "csv='...'; png='...'" figures/06/06-tree.gp
set encoding utf8
set terminal pngcairo size 1400,1500 font "DejaVu Sans,22" linewidth 2 background "#ffffff"
set output png
set datafile separator whitespace
set border 3 lc rgb "#808080" lw 0.7
set tics nomirror textcolor rgb "#404040"
set grid ytics xtics lc rgb "#e4e4e4" lw 0.5
unset key
set multiplot

set origin 0,0.46
set size 1,0.54
set lmargin 10
set rmargin 12
set logscale xy 10
set title "Which particles of a cloth are near each other?" font "DejaVu Sans,26" offset 0,-0.3
set xlabel "leaves" textcolor rgb "#404040"
set ylabel "ms" textcolor rgb "#404040"
set xrange [80:32000]
set yrange [4e-3:60]
set xtics (100, 400, 1600, 6400, 25600)
set ytics ("0.01" 0.01, "0.1" 0.1, "1" 1, "10" 10)
set label 1 "all pairs" at 3200,17 right textcolor rgb "#d55e00"
set label 2 "folded" at 28000,16.5 textcolor rgb "#0072b2"
set label 3 "draped" at 28000,8.6 textcolor rgb "#009e73"
set label 4 "flat" at 28000,5.4 textcolor rgb "#56b4e9"
set label 5 "refit only" at 28000,0.95 textcolor rgb "#808080"
plot csv index 3 using 1:2 with linespoints pt 7 ps 0.8 lc rgb "#d55e00" lw 1.5, \
     csv index 2 using 1:2 with lines dt 3 lc rgb "#808080" lw 1.2, \
     csv index 0 using 1:4 with linespoints pt 7 ps 0.8 lc rgb "#56b4e9" lw 1.5, \
     csv index 1 using 1:4 with linespoints pt 7 ps 0.8 lc rgb "#009e73" lw 1.5, \
     csv index 2 using 1:4 with linespoints pt 7 ps 0.8 lc rgb "#0072b2" lw 1.5
unset label
unset logscale

set origin 0,0
set size 0.55,0.45
set rmargin 3
set title "Pairs that are none" offset 0,-0.3
set xlabel "gap between the layers, in h"
set ylabel "pairs a triangle"
set xrange [0:1.6]
set yrange [0:14]
set xtics 0.4
set ytics 4
set label 1 "spheres overlap" at 0.62,10.6 textcolor rgb "#d55e00"
set label 2 "triangles nearer\nthan 0.12 h" at 0.19,2.2 textcolor rgb "#0072b2"
plot csv index 4 using 1:2 with steps lc rgb "#d55e00" lw 1.5, \
     csv index 4 using 1:3 with lines lc rgb "#0072b2" lw 2

set origin 0.55,0
set size 0.45,0.45
set lmargin 8
set rmargin 4
set title "How tight?" offset 0,-0.3
set xlabel "level below the root"
set ylabel "radius, m"
unset label
set logscale y 2
set xrange [-0.3:10.3]
set yrange [0.004:3]
set xtics 2
set ytics (0.01, 0.1, 1)
set label 1 "layered" at 3.4,0.95 textcolor rgb "#d55e00"
set label 2 "wrapped" at 0.6,0.16 textcolor rgb "#0072b2"
plot csv index 5 using 1:3 with linespoints pt 7 ps 0.8 lc rgb "#d55e00" lw 1.5, \
     csv index 5 using 1:2 with linespoints pt 7 ps 0.8 lc rgb "#0072b2" lw 1.5
unset multiplot
