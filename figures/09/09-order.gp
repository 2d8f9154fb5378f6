# 09-order.gp - gnuplot -e "csv='...'; png='...'" figures/09/09-order.gp
# Blocks of the data: as listed; along the paper's lists.
set encoding utf8
set terminal pngcairo size 1800,800 font "DejaVu Sans,22" linewidth 2 background "#ffffff"
set output png
set datafile separator comma
listed = "#606060"; ordered = "#d55e00"
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
set rmargin 3
set lmargin 11

set origin 0,0
set size 0.5,1
set title "Constraints relaxed a step" font "DejaVu Sans,26" offset 0,-0.3
set yrange [0:4000]
set ytics ("0" 0, "1,000" 1000, "2,000" 2000, "3,000" 3000, "4,000" 4000)
set label 1 "as listed" at 66,1750 textcolor rgb listed
set label 2 "along the paper’s lists" at 6,3000 textcolor rgb ordered font "DejaVu Sans Bold,22"
set label 3 "half of “as listed”:\nwhat the paper reports" at 40,480 textcolor rgb listed font "DejaVu Sans,19"
plot csv index 0 using 2:($3/2) with lines lc rgb listed lw 1 dt 3, \
     csv index 0 using 2:3 with linespoints pt 6 ps 1.1 lc rgb listed lw 1.6, \
     csv index 1 using 2:3 with linespoints pt 7 ps 1.1 lc rgb ordered lw 2.4
unset label

set origin 0.5,0
set title "Constraints looked at a step" offset 0,-0.3
set yrange [0:20000]
set ytics ("0" 0, "5,000" 5000, "10,000" 10000, "15,000" 15000, "20,000" 20000)
set label 1 "as listed" at 66,7800 textcolor rgb listed
set label 2 "along the paper’s lists" at 6,14800 textcolor rgb ordered font "DejaVu Sans Bold,22"
plot csv index 0 using 2:4 with linespoints pt 6 ps 1.1 lc rgb listed lw 1.6, \
     csv index 1 using 2:4 with linespoints pt 7 ps 1.1 lc rgb ordered lw 2.4
unset multiplot
