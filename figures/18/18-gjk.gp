# 18-gjk.gp - gnuplot -e "csv='...'; png='...'" figures/18/18-gjk.gp
set encoding utf8
set terminal pngcairo size 1800,900 font "DejaVu Sans,22" linewidth 2 background "#ffffff"
set output png
set datafile separator whitespace
set border 3 lc rgb "#808080" lw 0.7
set tics nomirror textcolor rgb "#404040"
set grid ytics xtics lc rgb "#dcdcdc" lw 0.5 dt 1
unset key
cold = "#d55e00"; warm = "#0072b2"; grey = "#606060"
bold = "DejaVu Sans Bold,22"
small = "DejaVu Sans,18"
stats csv index 0 using 2 nooutput
most = STATS_max
stats csv index 0 using 4 nooutput
carried = STATS_median
set multiplot
set lmargin 10
set rmargin 2
set size 0.5,1

# What is only rounding is drawn at the bottom.
none = 1e-16
shown(e) = e > none ? e : none
set origin 0,0
set title "Icosahedra 5 cm apart: error of the distance" font "DejaVu Sans,26" offset 0,-0.3
set xlabel "ns a query" textcolor rgb "#404040"
set xrange [0:most*1.15]
set logscale y 10
set yrange [2e-17:2]
set ytics ("1" 1, "10^{−3}" 1e-3, "10^{−6}" 1e-6, "10^{−9}" 1e-9, "10^{−12}" 1e-12, "rounding" none)
set label 1 "cold" at most*0.92,1e-11 right textcolor rgb cold
set label 2 "carried from\nthe last frame" at carried+most*0.03,1e-11 left textcolor rgb warm font bold
plot csv index 0 using 2:(shown($3)) with linespoints pt 7 ps 1.1 lc rgb cold lw 1.5, \
     csv index 0 using 4:(shown($5)) with linespoints pt 7 ps 1.1 lc rgb warm lw 2
unset label

set origin 0.5,0
set title "Round bodies: a cold query" offset 0,-0.3
set xlabel "corners of each body"
set logscale xy 10
set xrange [6:900]
set xtics (8, 12, 42, 162, 642)
set yrange [1e2:7e4]
set ytics ("0.1 µs" 1e2, "1 µs" 1e3, "10 µs" 1e4)
set label 1 "scanning" at 300,5.5e3 right textcolor rgb cold
set label 2 "climbing" at 330,5.2e2 center textcolor rgb warm font bold
plot csv index 1 using 1:2 with linespoints pt 7 ps 1.1 lc rgb cold lw 1.5, \
     csv index 1 using 1:3 with linespoints pt 7 ps 1.1 lc rgb warm lw 2
unset multiplot
