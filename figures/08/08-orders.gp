# 08-orders.gp - gnuplot -e "csv='...'; png='...'" figures/08/08-orders.gp
set encoding utf8
set terminal pngcairo size 1600,1500 font "DejaVu Sans,20" linewidth 2 background "#ffffff"
set output png
set datafile separator whitespace
set border 3 lc rgb "#808080" lw 0.7
set tics nomirror textcolor rgb "#404040"
set grid ytics xtics lc rgb "#e4e4e4" lw 0.5
unset key
set multiplot
set logscale x 10
set xrange [0.13:6e-7]
set xtics ("10 %%" 1e-1, "1 %%" 1e-2, "10^{−3}" 1e-3, "10^{−4}" 1e-4, "10^{−5}" 1e-5, "10^{−6}" 1e-6)
set lmargin 10
set rmargin 11
set size 0.5,0.5

set yrange [0:1.6]
set ytics 0.5
set arrow 1 from 0.1,0.5 to 1e-6,0.5 nohead lc rgb "#808080" lw 1 dt 2
set label 9 "the paper’s half" at 0.09,0.43 textcolor rgb "#808080"
set ylabel "relaxations (listed order = 1)" textcolor rgb "#404040" offset 1,0

relaxed = "plot csv index i using 1:($5/$2)  with linespoints pt 7 ps 0.8 lc rgb '#e69f00' lw 1.5, csv index i using 1:($8/$2)  with linespoints pt 7 ps 0.8 lc rgb '#d55e00' lw 1.5, csv index i using 1:($11/$2) with linespoints pt 6 ps 1.4 lc rgb '#0072b2' lw 1, csv index i using 1:($14/$2) with linespoints pt 7 ps 0.8 lc rgb '#009e73' lw 2, csv index i using 1:(1) with lines lc rgb '#404040' lw 1"

set origin 0,0.5
set title "Icosahedron, 36 sticks" font "DejaVu Sans,24"
set label 1 "repeated" at 5e-7,1.29 textcolor rgb "#d55e00"
set label 2 "listed" at 5e-7,1.07 textcolor rgb "#404040"
set label 3 "breadth" at 5e-7,0.97 textcolor rgb "#e69f00"
set label 4 "work list" at 5e-7,0.88 textcolor rgb "#0072b2"
set label 5 "largest" at 5e-7,0.66 textcolor rgb "#009e73"
i = 0
eval relaxed
set origin 0.5,0.5
set title "Sphere, 561 sticks" font "DejaVu Sans,24"
set label 1 "repeated" at 5e-7,1.18
set label 2 "listed" at 5e-7,1.08
set label 3 "breadth" at 5e-7,0.98
set label 4 "work list" at 5e-7,0.88
set label 5 "largest" at 5e-7,0.59
i = 1
eval relaxed
unset label
unset arrow

time = "plot csv index i using 1:($7/$4)  with linespoints pt 7 ps 0.8 lc rgb '#e69f00' lw 1.5, csv index i using 1:($10/$4)  with linespoints pt 7 ps 0.8 lc rgb '#d55e00' lw 1.5, csv index i using 1:($13/$4) with linespoints pt 6 ps 1.4 lc rgb '#0072b2' lw 1, csv index i using 1:($16/$4) with linespoints pt 7 ps 0.8 lc rgb '#009e73' lw 2, csv index i using 1:(1) with lines lc rgb '#404040' lw 1"
set logscale y 10
set yrange [0.3:60]
set ytics ("½" 0.5, "1" 1, "2" 2, "5" 5, "10" 10, "20" 20, "50" 50)
set ylabel "time (listed order = 1)" textcolor rgb "#404040" offset 0,0
set xlabel "until every stick is within" textcolor rgb "#404040"
unset title
set origin 0,0
set label 1 "largest" at 5e-7,9 textcolor rgb "#009e73"
set label 3 "repeated" at 5e-7,1.5 textcolor rgb "#d55e00"
set label 2 "work list" at 5e-7,1.08 textcolor rgb "#0072b2"
set label 4 "breadth" at 5e-7,0.78 textcolor rgb "#e69f00"
i = 0
eval time
set origin 0.5,0
set label 1 "largest" at 5e-7,36
set label 2 "work list" at 1.2e-2,0.36
set label 3 "repeated" at 5e-7,1.3
set label 4 "breadth" at 5e-7,0.95
i = 1
eval time
