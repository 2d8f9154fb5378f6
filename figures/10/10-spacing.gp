# 10-spacing.gp - gnuplot -e "csv='...'; png='...'" figures/10/10-spacing.gp
set encoding utf8
set terminal pngcairo size 1400,900 font "DejaVu Sans,22" linewidth 2 background "#ffffff"
set output png
set datafile separator whitespace
set logscale xy 10
set xrange [9.7656e-4:1.6777e7]
set yrange [1e-20:1e2]
set xtics ("1 mm" 1e-3, "1 m" 1, "1 km" 1e3, "1000 km" 1e6)
set ytics ("1 m" 1, "1 mm" 1e-3, "1 µm" 1e-6, "1 nm" 1e-9, "10^{−12} m" 1e-12, "10^{−15} m" 1e-15, "10^{−18} m" 1e-18)
set grid ytics xtics lc rgb "#e4e4e4" lw 0.5
set border 3 lc rgb "#808080" lw 0.7
set tics nomirror textcolor rgb "#404040"
set xlabel "distance from the origin" textcolor rgb "#404040"
set title "The smallest move that a coordinate can make" font "DejaVu Sans,26" offset 0,-0.3
unset key
set label 1 "float" at 1.4e-3,1.2e-8 textcolor rgb "#d55e00" font "DejaVu Sans Bold,24"
set label 2 "double" at 1.4e-3,3e-17 textcolor rgb "#0072b2" font "DejaVu Sans Bold,24"
set label 3 "g dt², 60 steps a second"   at 1.4e-3,2.725e-3*6 textcolor rgb "#009e73"
set label 4 "600 steps a second"  at 1.4e-3,2.725e-5*6 textcolor rgb "#009e73"
set label 5 "6000 steps a second" at 1.4e-3,2.725e-7*6 textcolor rgb "#009e73"
plot csv index 1 using (9.7656e-4):2:(1.6e7):(0) with vectors nohead lc rgb "#009e73" lw 1.2 dt 2, \
     csv index 0 using 1:2 with steps lc rgb "#d55e00" lw 2, \
     csv index 0 using 1:3 with steps lc rgb "#0072b2" lw 2
