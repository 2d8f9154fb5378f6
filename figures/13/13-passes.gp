# 13-passes.gp - gnuplot -e "csv='...'; png='...'" figures/13/13-passes.gp
set encoding utf8
set terminal pngcairo size 1800,860 font "DejaVu Sans,22" linewidth 2 background "#ffffff"
set output png
set datafile separator whitespace
set border 3 lc rgb "#808080" lw 0.7
set tics nomirror textcolor rgb "#404040"
set grid ytics xtics lc rgb "#dcdcdc" lw 0.5 dt 1
unset key
momentum = "#0072b2"; both = "#009e73"; forward = "#d55e00"
bold = "DejaVu Sans Bold,22"
set multiplot
set bmargin 3.6
set tmargin 3
set logscale y 10

set origin 0,0
set size 0.5,1
set lmargin 11
set rmargin 2
set title "One substep, cold: left of gravity’s move" font "DejaVu Sans,26" offset 0,-0.3
set xrange [0:205]
set xtics 0,50,200
set xlabel "passes" textcolor rgb "#404040"
set yrange [2e-4:1.2]
set ytics ("0.001" 0.001, "0.01" 0.01, "0.1" 0.1, "1" 1)
set label 1 "forward and backward" at 60,0.26 textcolor rgb both
set label 2 "forward only" at 130,0.03 textcolor rgb forward
set label 3 "with\nmomentum" at 8,0.008 textcolor rgb momentum font bold
plot csv index 0 using 1:2 with lines lc rgb forward lw 1.6 dt (8,5), \
     csv index 0 using 1:3 with lines lc rgb both lw 1.6, \
     csv index 0 using 1:4 with lines lc rgb momentum lw 2
unset label

set origin 0.5,0
set title "Ten seconds, warm: drift of a cube" offset 0,-0.3
set logscale x 2
set xrange [0.85:40]
set xtics (1, 2, 4, 8, 16, 32)
set xlabel "passes a substep"
set yrange [0.02:3000]
set ytics ("0.1 mm" 0.1, "1 mm" 1, "1 cm" 10, "10 cm" 100, "1 m" 1000)
set label 1 "forward only" at 4,60 textcolor rgb forward
set label 2 "and backward" at 12,0.85 textcolor rgb both
set label 3 "with\nmomentum" at 5,0.13 textcolor rgb momentum font bold
plot csv index 1 using 1:2 with linespoints pt 6 ps 1.2 lc rgb forward lw 1.6 dt (8,5), \
     csv index 2 using 1:2 with linespoints pt 6 ps 1.2 lc rgb both lw 1.6, \
     csv index 3 using 1:2 with linespoints pt 7 ps 1.2 lc rgb momentum lw 2
unset multiplot
