# 09-bodies.gp - gnuplot -e "csv='...'; png='...'" figures/09/09-bodies.gp
set encoding utf8
set terminal pngcairo size 1800,860 font "DejaVu Sans,22" linewidth 2 background "#ffffff"
set output png
set datafile separator comma
set logscale y 10
set border 3 lc rgb "#808080" lw 0.7
set tics nomirror textcolor rgb "#404040"
set grid ytics xtics lc rgb "#dcdcdc" lw 0.5 dt 1
set xrange [0:208]
set xtics 0,50,200
set xlabel "bodies" textcolor rgb "#404040"
unset key
mended = "#0072b2"; printed = "#d55e00"; engine = "#009e73"; grey = "#606060"
set multiplot
set bmargin 3.6
set tmargin 3

set origin 0,0
set size 0.5,1
set lmargin 10
set rmargin 3
set title "Speed: frames a second" font "DejaVu Sans,26" offset 0,-0.3
set yrange [10:300000]
set ytics ("10" 10, "20" 20, "60" 60, "100" 100, "1,000" 1000, "10,000" 10000, "100,000" 100000)
set label 1 "as printed" at 118,2000 textcolor rgb printed
set label 2 "as mended" at 26,520 textcolor rgb mended font "DejaVu Sans Bold,22"
set label 3 "as published in 2005,\nPentium 4, 1.8 GHz" at 60,23 textcolor rgb printed font "DejaVu Sans,19"
set label 4 "real time at 60 Hz" at 106,75 textcolor rgb grey font "DejaVu Sans,19"
set label 5 "the engine of Part II" at 60,45000 textcolor rgb engine
set arrow 1 from 0,60 to 208,60 nohead lc rgb grey lw 0.8 dt 3
$published << EOD
50,20
EOD
plot csv using 1:(1000/$2) with linespoints pt 6 ps 1.1 lc rgb printed lw 1.6 dt (8,5), \
     csv using 1:(1000/$6) with linespoints pt 5 ps 1.1 lc rgb engine lw 1.6, \
     csv using 1:(1000/$4) with linespoints pt 7 ps 1.1 lc rgb mended lw 2.4, \
     $published using 1:2 with points pt 9 ps 2.2 lc rgb printed
unset label
unset arrow

set origin 0.5,0
set title "Error: deepest overlap, of a radius" offset 0,-0.3
set yrange [0.04:250]
set ytics ("0.1 %%" 0.1, "1 %%" 1, "10 %%" 10, "100 %%" 100)
set label 1 "as printed" at 100,38 textcolor rgb printed
set label 2 "as mended" at 100,6.2 textcolor rgb mended font "DejaVu Sans Bold,22"
set label 5 "the engine of Part II" at 100,0.45 textcolor rgb engine
plot csv using 1:3 with linespoints pt 6 ps 1.1 lc rgb printed lw 1.6 dt (8,5), \
     csv using 1:7 with linespoints pt 5 ps 1.1 lc rgb engine lw 1.6, \
     csv using 1:5 with linespoints pt 7 ps 1.1 lc rgb mended lw 2.4
unset multiplot
