# 09-order.gp - gnuplot -e "csv='...'; png='...'" figures/09/09-order.gp
# Blocks of the data: listed, breadth, repeated, work list, largest first.
set encoding utf8
set terminal pngcairo size 1800,860 font "DejaVu Sans,22" linewidth 2 background "#ffffff"
set output png
set datafile separator comma
colour = "#606060 #0072b2 #d55e00 #009e73 #cc79a7"
c(k) = word(colour, k + 1)

# What the listed order needs, by number of bodies: the others are seen beside
# it.  (The head of the columns is no number.)
array relaxed[20000]; array tested[20000]
set table $nothing
plot csv index 0 using (valid(2) ? (relaxed[int($2)] = $3, tested[int($2)] = $4, $2) : NaN):3 with points
unset table

set border 3 lc rgb "#808080" lw 0.7
set tics nomirror textcolor rgb "#404040"
set grid ytics xtics lc rgb "#dcdcdc" lw 0.5 dt 1
set xrange [0:108]
set xtics 0,20,100
set xlabel "bodies" textcolor rgb "#404040"
unset key
set multiplot
set bmargin 3.6
set tmargin 3
set rmargin 15

set origin 0,0
set size 0.5,1
set lmargin 9
set title "Sticks relaxed a step" font "DejaVu Sans,26" offset 0,-0.3
set yrange [0:1.3]
set ytics ("0" 0, "half" 0.5, "listed\norder" 1)
set arrow 1 from 0,0.5 to 101,0.5 nohead lc rgb c(0) lw 0.8 dt 3
set label 1 "the paper’s\nreport" at 104,0.52 textcolor rgb c(0)
set label 2 "its lists, with\nrepeats" at 104,1.17 textcolor rgb c(2) font "DejaVu Sans Bold,22"
set label 3 "breadth first;\nwork list" at 104,0.98 textcolor rgb c(1)
set label 4 "largest first" at 104,0.77 textcolor rgb c(4)
plot csv index 0 using 2:(1) with lines lc rgb c(0) lw 1.6, \
     csv index 1 using 2:($3/relaxed[int($2)]) with linespoints pt 7 ps 1.1 lc rgb c(1) lw 1.8, \
     csv index 4 using 2:($3/relaxed[int($2)]) with linespoints pt 7 ps 1.1 lc rgb c(4) lw 1.8, \
     csv index 2 using 2:($3/relaxed[int($2)]) with linespoints pt 7 ps 1.1 lc rgb c(2) lw 2.4
unset label
unset arrow

set origin 0.5,0
set title "Sticks looked at a step" offset 0,-0.3
set yrange [0:2.6]
set ytics ("0" 0, "half" 0.5, "listed\norder" 1, "twice" 2)
set label 1 "listed" at 104,1.06 textcolor rgb c(0)
set label 2 "its lists, with\nrepeats" at 104,1.38 textcolor rgb c(2) font "DejaVu Sans Bold,22"
set label 3 "breadth first" at 104,0.93 textcolor rgb c(1)
set label 4 "largest first" at 104,2.18 textcolor rgb c(4)
set label 5 "work list" at 104,0.74 textcolor rgb c(3)
plot csv index 0 using 2:(1) with lines lc rgb c(0) lw 1.6, \
     csv index 1 using 2:($4/tested[int($2)]) with linespoints pt 7 ps 1.1 lc rgb c(1) lw 1.8, \
     csv index 3 using 2:($4/tested[int($2)]) with linespoints pt 7 ps 1.1 lc rgb c(3) lw 1.8, \
     csv index 4 using 2:($4/tested[int($2)]) with linespoints pt 7 ps 1.1 lc rgb c(4) lw 1.8, \
     csv index 2 using 2:($4/tested[int($2)]) with linespoints pt 7 ps 1.1 lc rgb c(2) lw 2.4
unset multiplot
