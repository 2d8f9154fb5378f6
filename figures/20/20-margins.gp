# 20-margins.gp - gnuplot -e "csv='...'; png='...'" figures/20/20-margins.gp
set encoding utf8
stats csv index 0 using 2 nooutput
rows = STATS_records
set terminal pngcairo size 1600,(200 + 50 * rows) font "DejaVu Sans,22" linewidth 2 background "#ffffff"
set output png
set datafile separator whitespace
unset key
set border 1 lc rgb "#808080" lw 0.7
set lmargin at screen 0.405
set rmargin at screen 0.965
set tmargin at screen 1 - 90.0 / (200 + 50 * rows)
set bmargin at screen 100.0 / (200 + 50 * rows)
set logscale x 10
set xrange [7e-10:1e3]
set yrange [0.3:rows + 0.7]
set ytics 1 format "" scale 0
set grid xtics ytics lt 1 lc rgb "#ededed" lw 0.8
set xtics nomirror textcolor rgb "#404040" ("0" 1e-9, "10^{−6}" 1e-6, "10^{−4}" 1e-4, "1 %%" 1e-2, "target" 1, "100 times" 100)
set title "Every number, as a part of its target" font "DejaVu Sans,26" offset -11,0.3
set object 1 rectangle from 1,graph 0 to 1e3,graph 1 fc rgb "#fbe6dc" fs solid noborder behind
set arrow 1 from 1,graph 0 to 1,graph 1 nohead lc rgb "#d55e00" lw 1.2 back
set label 1 "falls short" at 30,rows + 1.05 center textcolor rgb "#d55e00"
ours = 0x0072b2
theirs = 0xd55e00
plot csv index 0 using (7e-10):2:(sprintf("%d.  %s", $1, strcol(3))) with labels right offset -1,0 textcolor rgb "#303030", \
     csv index 1 using 2:1 with points pt 7 ps 0.75 lc rgb "#a9cfe6", \
     csv index 2 using 2:1:($2 > 1 ? theirs : ours) with points pt 7 ps 1.8 lc rgb variable
