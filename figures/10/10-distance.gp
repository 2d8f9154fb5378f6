# 10-distance.gp - gnuplot -e "csv='...'; png='...'" figures/10/10-distance.gp
set encoding utf8
set terminal pngcairo size 1400,900 font "DejaVu Sans,22" linewidth 2 background "#ffffff"
set output png
set datafile separator whitespace
stats csv index 0 using 2 nooutput
cold = STATS_max
stats csv index 0 using 4 nooutput
warm = STATS_max
stats csv index 4 using 1 nooutput
plain = STATS_max
plain_warm = STATS_min
set logscale y 10
set yrange [1e-18:50]
set xrange [0:*]
set ytics ("10" 10, "10^{−3}" 1e-3, "10^{−6}" 1e-6, "10^{−9}" 1e-9, "10^{−12}" 1e-12, "10^{−15}" 1e-15, "none" 1e-17)
set grid ytics xtics lc rgb "#e4e4e4" lw 0.5
set border 3 lc rgb "#808080" lw 0.7
set tics nomirror textcolor rgb "#404040"
set xlabel "time of a query, ns" textcolor rgb "#404040"
set ylabel "mean relative error of the distance" textcolor rgb "#404040"
set title "GJK, stopped after 1, 2, 3 ... support points" font "DejaVu Sans,26" offset 0,-0.3
unset key
shown(e) = e < 1e-17 ? 1e-17 : e
set xrange [0:plain*1.12]
set label 3 "plain,\ncarried" at plain_warm,2e-13 center textcolor rgb "#009e73" font "DejaVu Sans Bold,22"
set label 4 "plain,\ncold" at plain,2e-13 center textcolor rgb "#009e73" font "DejaVu Sans Bold,22"
set label 1 "cold" at cold*0.72,1e-4 textcolor rgb "#d55e00" font "DejaVu Sans Bold,24"
set label 2 "carried from\nthe last frame" at warm+22,1e-9 textcolor rgb "#0072b2" font "DejaVu Sans Bold,24"
plot csv index 4 using 1:(shown($2)) with points pt 7 ps 2.2 lc rgb "#009e73", \
     csv index 0 using ($1<=7 ? $2 : 1/0):(shown($3)) with linespoints pt 7 ps 1.2 lc rgb "#d55e00" lw 1.5, \
     csv index 0 using ($1<=5 ? $4 : 1/0):(shown($5)) with linespoints pt 7 ps 1.2 lc rgb "#0072b2" lw 1.5, \
     csv index 0 using ($1<=7 ? $2+cold*0.015 : 1/0):(shown($3)*2.5):1 with labels font "DejaVu Sans,17" textcolor rgb "#d55e00"
