# 09-bodies.gp - gnuplot -e "csv='...'; png='...'" figures/09/09-bodies.gp
set encoding utf8
set terminal pngcairo size 1800,860 font "DejaVu Sans,22" linewidth 2 background "#ffffff"
set output png
set datafile separator comma
set logscale y 10
set border 3 lc rgb "#808080" lw 0.7
set tics nomirror textcolor rgb "#404040"
set grid ytics xtics lc rgb "#dcdcdc" lw 0.5 dt 1
set xrange [0:108]
set xtics 0,20,100
set xlabel "bodies" textcolor rgb "#404040"
unset key
ours = "#0072b2"; paper = "#d55e00"; grey = "#606060"
set multiplot
set bmargin 3.6
set tmargin 3

set origin 0,0
set size 0.5,1
set lmargin 10
set rmargin 3
set title "Speed: frames a second" font "DejaVu Sans,26" offset 0,-0.3
set yrange [10:150000]
set ytics ("10" 10, "20" 20, "60" 60, "100" 100, "1,000" 1000, "10,000" 10000, "100,000" 100000)
set label 1 "the paper’s way" at 30,1300 textcolor rgb paper
set label 2 "ours" at 34,33000 textcolor rgb ours font "DejaVu Sans Bold,22"
set label 3 "as published in 2005,\nPentium 4, 1.8 GHz" \
    at 53,23 textcolor rgb paper font "DejaVu Sans,19"
set label 4 "real time at 60 Hz" at 3,75 textcolor rgb grey font "DejaVu Sans,19"
set arrow 1 from 0,60 to 108,60 nohead lc rgb grey lw 0.8 dt 3
$published << EOD
50,20
EOD
plot csv using 1:(1000/$5) with linespoints pt 6 ps 1.1 lc rgb paper lw 1.6 dt (8,5), \
     csv using 1:(1000/$2) with linespoints pt 7 ps 1.1 lc rgb ours lw 2, \
     $published using 1:2 with points pt 9 ps 2.2 lc rgb paper
unset label
unset arrow

set origin 0.5,0
# Nothing at all is drawn at the bottom.
none = 0.05
shown(x) = x > none ? x : none
set title "Error: deepest overlap, of a radius" offset 0,-0.3
set yrange [0.04:150]
set ytics ("none" none, "0.1 %%" 0.1, "1 %%" 1, "10 %%" 10, "100 %%" 100)
set label 1 "the paper’s way" at 56,26 textcolor rgb paper
set label 2 "ours" at 84,0.3 textcolor rgb ours font "DejaVu Sans Bold,22"
plot csv using 1:6 with linespoints pt 6 ps 1.1 lc rgb paper lw 1.6 dt (8,5), \
     csv using 1:(shown($3)) with linespoints pt 7 ps 1.1 lc rgb ours lw 2
unset multiplot
