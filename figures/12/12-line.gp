# 12-line.gp - gnuplot -e "csv='...'; png='...'" figures/12/12-line.gp
set encoding utf8
set terminal pngcairo size 1400,1500 font "DejaVu Sans,22" linewidth 2 background "#ffffff"
set output png
set datafile separator whitespace
set border 3 lc rgb "#808080" lw 0.7
set tics nomirror textcolor rgb "#404040"
set grid ytics xtics lc rgb "#e4e4e4" lw 0.5
unset key
set multiplot

set logscale xy 10
set xrange [0.06:200]
set yrange [1e-16:1e4]
set xtics ("0.1" 0.1, "1" 1, "10" 10, "100" 100)
set tmargin at screen 0.915
set bmargin at screen 0.55
set label 10 "A hanging rope of 50 links: how far it stretches" at screen 0.5,0.978 center font "DejaVu Sans,26"
set label 11 "time a frame (10 sweeps with the exact root = 1)" at screen 0.55,0.497 center textcolor rgb "#404040"

set lmargin at screen 0.115
set rmargin at screen 0.385
set title "load 1" offset 0,-0.7
set ylabel "largest strain" textcolor rgb "#404040" offset 1,0
set ytics ("10^{3}" 1e3, "1" 1, "10^{−3}" 1e-3, "10^{−6}" 1e-6, "10^{−9}" 1e-9, "10^{−12}" 1e-12, "10^{−15}" 1e-15)
set label 1 "n sweeps" at 3,8 textcolor rgb "#d55e00"
set label 2 "n small\nsteps" at 4,3e-5 textcolor rgb "#0072b2"
set label 3 "the line\nsolved: 1,\n2, 3, 4 steps" at 1.6,1e-10 textcolor rgb "#009e73" font "DejaVu Sans Bold,21"
plot csv index 0 using 2:3 with linespoints pt 7 ps 0.7 lc rgb "#d55e00" lw 1.5, \
     csv index 1 using 2:3 with linespoints pt 7 ps 0.7 lc rgb "#0072b2" lw 1.5, \
     csv index 2 using 2:3 with linespoints pt 7 ps 1.1 lc rgb "#009e73" lw 2
unset label
unset ylabel
set format y ""
set ytics ("" 1e3, "" 1, "" 1e-3, "" 1e-6, "" 1e-9, "" 1e-12, "" 1e-15)

set lmargin at screen 0.415
set rmargin at screen 0.685
set title "load 100"
plot csv index 3 using 2:3 with linespoints pt 7 ps 0.7 lc rgb "#d55e00" lw 1.5, \
     csv index 4 using 2:3 with linespoints pt 7 ps 0.7 lc rgb "#0072b2" lw 1.5, \
     csv index 5 using 2:3 with linespoints pt 7 ps 1.1 lc rgb "#009e73" lw 2

set lmargin at screen 0.715
set rmargin at screen 0.985
set title "load 10,000"
plot csv index 6 using 2:3 with linespoints pt 7 ps 0.7 lc rgb "#d55e00" lw 1.5, \
     csv index 7 using 2:3 with linespoints pt 7 ps 0.7 lc rgb "#0072b2" lw 1.5, \
     csv index 8 using 2:3 with linespoints pt 7 ps 1.1 lc rgb "#009e73" lw 2
unset label

set tmargin at screen 0.425
set bmargin at screen 0.075
set lmargin at screen 0.115
set rmargin at screen 0.985
set title "A taut rope, touched: a zigzag after 200 steps" font "DejaVu Sans,26" offset 0,-0.3
set xlabel "T h² / (m L)" textcolor rgb "#404040"
set ylabel "grown to so many times" textcolor rgb "#404040" offset 0.5,0
set xrange [0.019:1.5]
set yrange [1e-4:1e13]
set xtics ("0.02" 0.02, "0.05" 0.05, "0.1" 0.1, "0.2" 0.2, "1/3" 1.0/3, "1" 1)
set ytics ("10^{12}" 1e12, "10^{9}" 1e9, "10^{6}" 1e6, "10^{3}" 1e3, "1" 1, "10^{−3}" 1e-3)
set label 1 "along the new links" at 0.3,2e6 right textcolor rgb "#0072b2" font "DejaVu Sans Bold,22"
set label 2 "along the old links" at 0.95,3e9 right textcolor rgb "#e69f00" font "DejaVu Sans Bold,22"
plot csv index 9 using 1:2 with lines lc rgb "#0072b2" lw 2.5, \
     csv index 10 using 1:2 with lines lc rgb "#e69f00" lw 2.5
unset multiplot
