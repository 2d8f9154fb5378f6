# 00b-carts.gp - sh figures/draw/chart.sh figures/00b/00b-carts.gp DATA.csv CHART.svg
high = 320
load "figures/draw/chart.gp"
set multiplot
eval box(58, 345, 50, 285)
set title "The force of the buffer"
set xlabel "time, s"
set ylabel "N" offset 1.5,0
set xrange [0:0.6]
set yrange [0:85]
set xtics 0.2
set label 1 "hard" at 0.2,60 textcolor rgb orange
set label 2 "soft" at 0.4,20 textcolor rgb blue
set label 3 "both areas: 4 N s" at 0.28,35 textcolor rgb ink
plot csv index 1 using 1:2 with filledcurves y1=0 lc rgb pale(orange, 0.25), \
     csv index 0 using 1:2 with filledcurves y1=0 lc rgb pale(blue, 0.25), \
     csv index 1 using 1:2 with lines lc rgb orange lw 2, \
     csv index 0 using 1:2 with lines lc rgb blue lw 2
unset label
eval box(415, 700, 50, 285)
set title "Energy, with the soft buffer"
set ylabel "J" offset 1.5,0
set yrange [0:10.5]
set label 1 "sum" at 0.02,9.55 textcolor rgb green
set label 2 "of motion" at 0.45,7.6 left textcolor rgb orange
set label 3 "in the buffer" at 0.42,1.9 left textcolor rgb blue
plot csv index 0 using 1:3 with lines lc rgb orange lw 2, \
     csv index 0 using 1:4 with lines lc rgb blue lw 2, \
     csv index 0 using 1:($3+$4) with lines lc rgb green lw 1.5
unset multiplot
