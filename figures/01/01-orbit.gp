# 01-orbit.gp - gnuplot -e "csv='...'; png='...'" figures/01/01-orbit.gp
set encoding utf8
set terminal pngcairo size 1200,1130 font "DejaVu Sans,22" linewidth 2 background "#ffffff"
set output png
set datafile separator whitespace
set size ratio -1
unset border
unset tics
unset key
set title "Five orbits, 60 steps each" font "DejaVu Sans,26"
set xrange [-3.3:3.3]
set yrange [-3.7:2.1]
set label 1 "explicit Euler" at 1.45,1.3 textcolor rgb "#d55e00" font "DejaVu Sans,24"
set label 2 "Verlet" at -0.55,-0.55 textcolor rgb "#0072b2" font "DejaVu Sans Bold,24"
plot csv using 1:2 with linespoints pt 7 ps 0.5 lc rgb "#d55e00" lw 1.2, \
     csv using 3:4 with linespoints pt 7 ps 0.5 lc rgb "#0072b2" lw 1.5, \
     "+" using (0):(0) every ::0::0 with points pt 7 ps 3 lc rgb "#e69f00"
