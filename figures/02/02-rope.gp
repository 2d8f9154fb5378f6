# 02-rope.gp - gnuplot -e "csv='...'; png='...'" figures/02/02-rope.gp
set encoding utf8
set terminal pngcairo size 1400,1500 font "DejaVu Sans,22" linewidth 2 background "#ffffff"
set output png
set datafile separator whitespace
set datafile missing "nan"
set logscale xy 10
set border 3 lc rgb "#808080" lw 0.7
set tics nomirror textcolor rgb "#404040"
set grid ytics xtics lc rgb "#e4e4e4" lw 0.5
set xtics (0.1, 1, 10)
set xrange [0.09:40]
unset key
set lmargin 12
set rmargin 21
set multiplot

set origin 0,0.5
set size 1,0.5
set title "A hanging rope of 50 sticks: how far it stretches" font "DejaVu Sans,26" offset 0,-0.3
set ylabel "largest strain" textcolor rgb "#404040"
set yrange [5e-5:30]
set ytics ("1000 %%" 10, "100 %%" 1, "10 %%" 0.1, "1 %%" 0.01, "0.1 %%" 1e-3, "0.01 %%" 1e-4)
set label 1 "n iterations\nof one step" at 33,5e-2 textcolor rgb "#404040"
set label 2 "n small steps\nof one iteration" at 33,1.6e-4 textcolor rgb "#404040" font "DejaVu Sans Bold,22"
set label 3 "PBD, exact root" at 0.11,2.2e-3 textcolor rgb "#0072b2"
set label 4 "PBD, approximate root" at 0.11,7e-4 textcolor rgb "#e69f00"
set label 5 "SHAKE" at 0.11,2.2e-4 textcolor rgb "#009e73"
plot csv index 0 using 2:3 with linespoints pt 6 ps 0.9 lc rgb "#0072b2" lw 1.2 dt 2, \
     csv index 1 using 2:3 with linespoints pt 6 ps 0.9 lc rgb "#e69f00" lw 1.2 dt 2, \
     csv index 2 using 2:3 with linespoints pt 6 ps 0.9 lc rgb "#009e73" lw 1.2 dt 2, \
     csv index 3 using 2:3 with linespoints pt 7 ps 0.9 lc rgb "#0072b2" lw 2, \
     csv index 4 using 2:3 with linespoints pt 7 ps 0.9 lc rgb "#e69f00" lw 2, \
     csv index 5 using 2:3 with linespoints pt 7 ps 0.9 lc rgb "#009e73" lw 2
unset label

set origin 0,0
set size 1,0.5
set title "The rope let go at 30°: the energy it loses in 5 s" offset 0,-0.3
set xlabel "time a frame (10 iterations of PBD = 1)" textcolor rgb "#404040"
set ylabel "fraction of its energy"
set yrange [3e-4:2]
set ytics ("100 %%" 1, "10 %%" 0.1, "1 %%" 0.01, "0.1 %%" 1e-3)
set label 1 "n iterations" at 33,0.8 textcolor rgb "#404040"
set label 2 "PBD\n(exact and\napproximate root)" at 33,1.5e-2 textcolor rgb "#0072b2"
set label 3 "SHAKE" at 33,5.5e-4 textcolor rgb "#009e73" font "DejaVu Sans Bold,22"
plot csv index 0 using 2:5 with linespoints pt 6 ps 0.9 lc rgb "#0072b2" lw 1.2 dt 2, \
     csv index 1 using 2:5 with linespoints pt 6 ps 0.9 lc rgb "#e69f00" lw 1.2 dt 2, \
     csv index 3 using 2:5 with linespoints pt 7 ps 0.9 lc rgb "#0072b2" lw 2, \
     csv index 4 using 2:5 with linespoints pt 7 ps 0.9 lc rgb "#e69f00" lw 2, \
     csv index 5 using 2:5 with linespoints pt 7 ps 0.9 lc rgb "#009e73" lw 2
unset multiplot
