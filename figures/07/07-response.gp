# 07-response.gp - gnuplot -e "csv='...'; png='...'" figures/07/07-response.gp
set encoding utf8
set terminal pngcairo size 1400,1500 font "DejaVu Sans,22" linewidth 2 background "#ffffff"
set output png
set datafile separator whitespace
set border 3 lc rgb "#808080" lw 0.7
set tics nomirror textcolor rgb "#404040"
set grid ytics xtics lc rgb "#e4e4e4" lw 0.5
unset key
set lmargin 12
set rmargin 20
set multiplot

set origin 0,0.5
set size 1,0.5
set logscale xy 10
set title "How much of an overlap is left, after how much work" font "DejaVu Sans,26" offset 0,-0.3
set xlabel "passes, each a push and a sweep of the sticks" textcolor rgb "#404040"
set ylabel "overlap left" textcolor rgb "#404040" offset 1,0
set logscale x 2
set xrange [0.9:70]
set yrange [1e-5:1.5]
set xtics (1, 2, 4, 8, 16, 32, 64)
set ytics ("100 %%" 1, "10 %%" 0.1, "1 %%" 1e-2, "0.1 %%" 1e-3, "10^{−4}" 1e-4, "10^{−5}" 1e-5)
set label 1 "push once,\nthen sweep\n(the paper)" at 74,1.3 textcolor rgb "#d55e00"
set label 2 "push by mass\neach pass" at 74,7e-4 textcolor rgb "#0072b2" font "DejaVu Sans Bold,22"
set label 3 "by bodies" at 74,8e-5 textcolor rgb "#e69f00"
set label 4 "gain 2" at 46,2.4e-5 textcolor rgb "#56b4e9"
set label 5 "gain 4" at 20,6e-5 right textcolor rgb "#009e73"
plot csv index 0 using 1:3 with linespoints pt 7 ps 0.8 lc rgb "#d55e00" lw 2, \
     csv index 1 using 1:3 with linespoints pt 7 ps 0.8 lc rgb "#e69f00" lw 1.5, \
     csv index 2 using 1:3 with linespoints pt 7 ps 0.8 lc rgb "#0072b2" lw 2, \
     csv index 3 using 1:3 with linespoints pt 7 ps 0.8 lc rgb "#56b4e9" lw 1.5, \
     csv index 4 using 1:3 with linespoints pt 7 ps 0.8 lc rgb "#009e73" lw 1.5
unset label

set origin 0,0
set size 1,0.5
set title "Momentum made from nothing by one push" font "DejaVu Sans,26" offset 0,-0.3
set xlabel "B is so many times heavier than A" textcolor rgb "#404040"
set ylabel "momentum / (mass of A × overlap)" textcolor rgb "#404040" offset 1,0
set logscale x 10
set xrange [0.9:11000]
set yrange [1e-17:1e5]
set xtics ("1" 1, "10" 10, "100" 100, "1000" 1000, "10 000" 10000)
set ytics ("1000" 1e3, "1" 1, "10^{−3}" 1e-3, "10^{−6}" 1e-6, "10^{−9}" 1e-9, "10^{−12}" 1e-12, "10^{−15}" 1e-15)
set label 1 "by bodies,\nas printed" at 13000,1.3e3 textcolor rgb "#d55e00"
set label 2 "by bodies" at 13000,6e-2 textcolor rgb "#e69f00"
set label 3 "by mass:\nrounding" at 13000,1e-12 textcolor rgb "#0072b2" font "DejaVu Sans Bold,22"
plot csv index 5 using 1:2 with linespoints pt 7 ps 0.8 lc rgb "#d55e00" lw 2, \
     csv index 5 using 1:3 with linespoints pt 7 ps 0.8 lc rgb "#e69f00" lw 2, \
     csv index 5 using 1:4 with linespoints pt 7 ps 0.8 lc rgb "#0072b2" lw 2
