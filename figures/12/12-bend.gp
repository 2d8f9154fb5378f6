# 12-bend.gp - gnuplot -e "csv='...'; png='...'" figures/12/12-bend.gp
set encoding utf8
set terminal pngcairo size 1400,1000 font "DejaVu Sans,22" linewidth 2 background "#ffffff"
set output png
set datafile separator whitespace
set border 3 lc rgb "#808080" lw 0.7
set tics nomirror textcolor rgb "#404040"
set grid ytics xtics lc rgb "#e4e4e4" lw 0.5
unset key
set multiplot
set logscale x 10
set xrange [0.09:400]
set xtics ("0.1" 0.1, "1" 1, "10" 10, "100" 100)
set lmargin at screen 0.1
set rmargin at screen 0.97
set tmargin at screen 0.93
set bmargin at screen 0.42
set title "A strip held level at one end: how far its free end hangs down" font "DejaVu Sans,26"
set ylabel "sag / length" textcolor rgb "#404040"
set yrange [0:1.05]
set format x ""
set xtics ("" 0.1, "" 1, "" 10, "" 100)
set arrow 1 from 0.18,0 to 0.18,0.2 nohead lc rgb "#808080" dt 2
set arrow 2 from 39,0 to 39,0.83 nohead lc rgb "#808080" dt 2
set arrow 3 from 118,0 to 118,0.88 nohead lc rgb "#808080" dt 2
set label 1 "card" at 0.195,0.16 textcolor rgb "#404040"
set label 2 "denim" at 36,0.3 right textcolor rgb "#404040"
set label 3 "silk" at 126,0.3 textcolor rgb "#404040"
set label 4 "theory" at 3.4,0.31 textcolor rgb "#404040"
set label 5 "5 links" at 0.42,0.93 textcolor rgb "#d55e00"
set label 6 "10" at 0.95,0.93 textcolor rgb "#e69f00"
set label 7 "20" at 1.4,0.93 textcolor rgb "#009e73"
set label 8 "40" at 2.05,0.93 textcolor rgb "#0072b2"
plot csv using 1:2 with lines lc rgb "#808080" lw 3, \
     csv using 1:3 with points pt 7 ps 1.1 lc rgb "#d55e00", \
     csv using 1:4 with points pt 7 ps 1.0 lc rgb "#e69f00", \
     csv using 1:5 with points pt 7 ps 0.9 lc rgb "#009e73", \
     csv using 1:6 with points pt 7 ps 0.8 lc rgb "#0072b2"
unset label
unset arrow
unset title
set tmargin at screen 0.37
set bmargin at screen 0.1
set format x
set xtics ("0.1" 0.1, "1" 1, "10" 10, "100" 100)
set xlabel "load  q L³ / (E I)" textcolor rgb "#404040"
set ylabel "off theory" textcolor rgb "#404040"
set logscale y 10
set yrange [1e-5:0.5]
set ytics ("10 %%" 0.1, "1 %%" 0.01, "0.1 %%" 1e-3, "0.01 %%" 1e-4)
plot for [k=3:6] csv using 1:(abs(column(k)/$2-1)) with linespoints pt 7 ps 0.7 lw 1.3 lc rgb word("x x #d55e00 #e69f00 #009e73 #0072b2",k)
unset multiplot
