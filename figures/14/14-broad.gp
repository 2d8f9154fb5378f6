# 14-broad.gp - gnuplot -e "csv='...'; png='...'" figures/14/14-broad.gp
set encoding utf8
set terminal pngcairo size 1400,1500 font "DejaVu Sans,22" linewidth 2 background "#ffffff"
set output png
set datafile separator whitespace
set border 3 lc rgb "#808080" lw 0.7
set tics nomirror textcolor rgb "#404040"
set grid ytics xtics lc rgb "#e4e4e4" lw 0.5
unset key
stats csv index 0 using 6 name "PAIRS" nooutput
stats csv index 0 using 7 name "WRONG" nooutput
set multiplot

set origin 0,0.46
set size 1,0.54
set lmargin 12
set rmargin 18
set logscale xy 10
set title "Which bodies of a room may meet?" font "DejaVu Sans,26" offset 0,-0.3
set xlabel "bodies" textcolor rgb "#404040"
set ylabel "time a frame" textcolor rgb "#404040" offset 1,0
set xrange [9:11000]
set yrange [0.15:200000]
set xtics ("10" 10, "30" 30, "100" 100, "300" 300, "1000" 1000, "3000" 3000, "10 000" 10000)
set ytics ("1 µs" 1, "10 µs" 10, "100 µs" 100, "1 ms" 1000, "10 ms" 10000, "100 ms" 100000)
set label 1 "every pair" at 12500,100000 textcolor rgb "#d55e00"
set label 2 "sorted" at 12500,9500 textcolor rgb "#0072b2" font "DejaVu Sans Bold,22"
set label 3 "the first call" at 12500,24000 textcolor rgb "#56b4e9"
set label 4 sprintf("pairs found in all frames: %.2f million\nby one way and not by the other: %.0f", PAIRS_sum / 1e6, WRONG_sum) at 11,40000 textcolor rgb "#404040"
plot csv index 0 using 1:3 with linespoints pt 7 ps 0.8 lc rgb "#d55e00" lw 2, \
     csv index 0 using 1:4 with lines dt 3 lc rgb "#56b4e9" lw 1.5, \
     csv index 0 using 1:2 with linespoints pt 7 ps 0.8 lc rgb "#0072b2" lw 2
unset label

set origin 0,0
set size 1,0.46
set lmargin 20
unset logscale y
set title "A thousand bodies, in a room and elsewhere" font "DejaVu Sans,26" offset 0,-0.3
set xlabel "time a frame"
unset ylabel
set xrange [0.5:4000]
set xtics ("1 µs" 1, "10 µs" 10, "100 µs" 100, "1 ms" 1000)
set yrange [7.6:-0.6]
set grid noytics
set label 1 "sorted" at 330,-0.8 center textcolor rgb "#0072b2" font "DejaVu Sans Bold,22"
set label 2 "every pair" at 2300,-0.8 center textcolor rgb "#d55e00"
set yrange [7.6:-1.3]
unset ytics
set ytics scale 0 textcolor rgb "#404040"
plot csv index 1 using 2:0:($3-$2):(0) with vectors nohead lc rgb "#c8c8c8" lw 2, \
     csv index 1 using 2:0:ytic(1) with points pt 7 ps 2 lc rgb "#0072b2", \
     csv index 1 using 3:0 with points pt 7 ps 2 lc rgb "#d55e00"
unset multiplot
