# 10-depth.gp - gnuplot -e "csv='...'; png='...'" figures/10/10-depth.gp
set encoding utf8
set terminal pngcairo size 1400,900 font "DejaVu Sans,22" linewidth 2 background "#ffffff"
set output png
set datafile separator whitespace
set logscale xy 10
set format x "%.0f"
set xrange [95:105000]
set yrange [1e-17:10]
set xtics ("0.1 µs" 1e2, "1 µs" 1e3, "10 µs" 1e4, "100 µs" 1e5)
set ytics ("1" 1, "10^{−3}" 1e-3, "10^{−6}" 1e-6, "10^{−9}" 1e-9, "10^{−12}" 1e-12, "10^{−15}" 1e-15)
set grid ytics xtics lc rgb "#e4e4e4" lw 0.5
set border 3 lc rgb "#808080" lw 0.7
set tics nomirror textcolor rgb "#404040"
set xlabel "time of a query" textcolor rgb "#404040"
set ylabel "mean relative error of the depth" textcolor rgb "#404040"
set title "How deep?  Four ways to ask two icosahedra" font "DejaVu Sans,26" offset 0,-0.3
unset key
set label 1 "the best of 16 ... 4096 directions" at 900,2.2 textcolor rgb "#d55e00" font "DejaVu Sans Bold,24"
set label 2 "distance, then\npenetration" at 140,6e-15 textcolor rgb "#0072b2" font "DejaVu Sans Bold,24"
set label 4 "the plain GJK and hit face" at 1700,1.2e-16 textcolor rgb "#cc79a7" font "DejaVu Sans Bold,24"
set label 3 "all 245 directions\nthat can count" at 8200,6e-13 textcolor rgb "#009e73" font "DejaVu Sans Bold,24"
plot csv index 0 using 2:3 with linespoints pt 7 ps 1.2 lc rgb "#d55e00" lw 1.5, \
     csv index 1 using 3:2 with points pt 7 ps 2.2 lc rgb "#0072b2", \
     csv index 1 using 6:(abs($7)<1e-16 ? 1e-16 : abs($7)) with points pt 7 ps 2.2 lc rgb "#cc79a7", \
     csv index 1 using 4:2 with points pt 7 ps 2.2 lc rgb "#009e73"
