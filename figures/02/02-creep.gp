# 02-creep.gp - gnuplot -e "csv='...'; png='...'" figures/02/02-creep.gp
set encoding utf8
set terminal pngcairo size 1400,820 font "DejaVu Sans,22" linewidth 2 background "#ffffff"
set output png
set datafile separator whitespace
set border 3 lc rgb "#808080" lw 0.7
set tics nomirror textcolor rgb "#404040"
unset key
set multiplot layout 1,2 margins 0.08,0.965,0.13,0.88 spacing 0.1
set title "The error of each stick" font "DejaVu Sans,25"
set xrange [0:51]
set yrange [0:1.1]
set xtics 10
set ytics 0.5
set xlabel "stick" textcolor rgb "#404040"
set label 1 "at first" at 25.5,1.05 center textcolor rgb "#808080"
set label 2 "after 10 iterations" at 22,0.93 center textcolor rgb "#e69f00"
set label 3 "100" at 25.5,0.77 center textcolor rgb "#d55e00"
set label 4 "300" at 25.5,0.355 center textcolor rgb "#0072b2"
set label 5 "1000" at 25.5,0.08 center textcolor rgb "#009e73"
plot csv index 0 using 1:2 with linespoints pt 7 ps 0.6 lc rgb "#808080" lw 1.4, \
     csv index 1 using 1:2 with linespoints pt 7 ps 0.6 lc rgb "#e69f00" lw 1.8, \
     csv index 2 using 1:2 with linespoints pt 7 ps 0.6 lc rgb "#d55e00" lw 1.8, \
     csv index 3 using 1:2 with linespoints pt 7 ps 0.6 lc rgb "#0072b2" lw 1.8, \
     csv index 4 using 1:2 with linespoints pt 7 ps 0.6 lc rgb "#009e73" lw 1.8
unset label
set title "The largest error" font "DejaVu Sans,25"
set xrange [0:2000]
set yrange [3e-4:1.3]
set logscale y
set xtics 500
set ytics ("1" 1, "10^{−1}" 0.1, "10^{−2}" 0.01, "10^{−3}" 1e-3)
set xlabel "iterations"
set label 1 "cos²(π/51)\nan iteration" at 1180,0.08 textcolor rgb "#606060"
rho = cos(pi / 51) ** 2
plot csv index 5 using 1:2 with lines lc rgb "#0072b2" lw 2.5, \
     2.2 * rho ** x with lines dt 2 lc rgb "#606060" lw 1.4
unset multiplot
