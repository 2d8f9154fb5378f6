# 01-order.gp - gnuplot -e "csv='...'; png='...'" figures/01/01-order.gp
set encoding utf8
set terminal pngcairo size 1400,1300 font "DejaVu Sans,22" linewidth 2 background "#ffffff"
set output png
set datafile separator whitespace
set logscale xy 10
set border 3 lc rgb "#808080" lw 0.7
set tics nomirror textcolor rgb "#404040"
set grid ytics xtics lc rgb "#e4e4e4" lw 0.5
set format y "10^{%L}"
unset key
set lmargin 11
set rmargin 19
set multiplot

set origin 0,0.42
set size 1,0.58
set title "A planet after an orbit and a quarter" font "DejaVu Sans,26" offset 0,-0.3
set xlabel "time to compute (Verlet, 1000 steps an orbit = 1)" textcolor rgb "#404040"
set ylabel "error of its position" textcolor rgb "#404040"
set xrange [0.025:400]
set yrange [1e-9:10]
set xtics (0.1, 1, 10, 100)
set label 1 "explicit Euler" at 370,2.4e-3 textcolor rgb "#d55e00"
set label 2 "symplectic Euler\nand, in circles,\nVerlet with a\ncareless start" at 370,5e-5 textcolor rgb "#e69f00"
set label 3 "Verlet" at 370,4.7e-9 textcolor rgb "#0072b2" font "DejaVu Sans Bold,24"
set label 4 "slope −1" at 3.2,1.15e-2 textcolor rgb "#808080"
set label 5 "slope −2" at 6,8e-5 textcolor rgb "#808080"
plot csv index 0 using 2:3 with linespoints pt 7 ps 0.8 lc rgb "#d55e00" lw 1.5, \
     csv index 1 using 2:3 with linespoints pt 7 ps 0.8 lc rgb "#e69f00" lw 1.5, \
     csv index 3 using 2:3 with points pt 6 ps 1.6 lc rgb "#cc79a7" lw 1, \
     csv index 2 using 2:3 with linespoints pt 7 ps 0.8 lc rgb "#0072b2" lw 2
unset label

set origin 0,0
set size 1,0.42
set title "Its energy, 200 steps an orbit" offset 0,-0.3
set xlabel "orbits"
set ylabel "relative error"
set xrange [0.05:100]
set yrange [1e-5:3]
set xtics (0.1, 1, 10, 100)
set label 1 "explicit Euler" at 110,0.9 textcolor rgb "#d55e00"
set label 2 "symplectic Euler" at 110,1.5e-2 textcolor rgb "#e69f00"
set label 3 "Verlet" at 110,4e-4 textcolor rgb "#0072b2" font "DejaVu Sans Bold,24"
plot csv index 4 using 1:2 with lines lc rgb "#d55e00" lw 1.5, \
     csv index 5 using 1:2 with lines lc rgb "#e69f00" lw 1.5, \
     csv index 6 using 1:2 with lines lc rgb "#0072b2" lw 2
unset multiplot
