# 02-rope.gp - sh figures/draw/chart.sh figures/02/02-rope.gp DATA.csv CHART.svg
high = 716
load "figures/draw/chart.gp"
set datafile missing "nan"
set logscale xy 10
set xtics (0.1, 1, 10)
set xrange [0.09:40]
set multiplot

eval box(80, 545, 411, 681)
set title "A hanging rope of 50 sticks: its largest strain"
set yrange [5e-5:30]
set ytics ("1000 %%" 10, "100 %%" 1, "10 %%" 0.1, "1 %%" 0.01, "0.1 %%" 1e-3, "0.01 %%" 1e-4)
set label 1 "n iterations\nof one step" at 43,5e-2 textcolor rgb ink
set label 2 "n small steps\nof one iteration" at 43,1.6e-4 textcolor rgb ink font bold
set label 3 "PBD, exact root" at 0.11,2.2e-3 textcolor rgb blue
set label 4 "PBD, approximate root" at 0.11,7e-4 textcolor rgb purple
set label 5 "SHAKE" at 0.11,2.2e-4 textcolor rgb green
plot csv index 0 using 2:3 with linespoints pt 6 ps 0.59 lc rgb blue lw 1.2 dt 2, \
     csv index 1 using 2:3 with linespoints pt 6 ps 0.59 lc rgb purple lw 1.2 dt 2, \
     csv index 2 using 2:3 with linespoints pt 6 ps 0.59 lc rgb green lw 1.2 dt 2, \
     csv index 3 using 2:3 with linespoints pt 7 ps 0.59 lc rgb blue lw 2, \
     csv index 4 using 2:3 with linespoints pt 7 ps 0.59 lc rgb purple lw 2, \
     csv index 5 using 2:3 with linespoints pt 7 ps 0.59 lc rgb green lw 2
unset label

eval box(80, 545, 52, 325)
set title "The rope let go at 30°: the share of its energy lost in 5 s"
set xlabel "time a frame (10 iterations of PBD = 1)" textcolor rgb ink
set yrange [3e-4:2]
set ytics ("100 %%" 1, "10 %%" 0.1, "1 %%" 0.01, "0.1 %%" 1e-3)
set label 1 "n iterations" at 43,0.8 textcolor rgb ink
set label 2 "PBD\n(exact and\napproximate root)" at 43,1.5e-2 textcolor rgb blue
set label 3 "SHAKE" at 43,5.5e-4 textcolor rgb green font bold
plot csv index 0 using 2:5 with linespoints pt 6 ps 0.59 lc rgb blue lw 1.2 dt 2, \
     csv index 1 using 2:5 with linespoints pt 6 ps 0.59 lc rgb purple lw 1.2 dt 2, \
     csv index 3 using 2:5 with linespoints pt 7 ps 0.59 lc rgb blue lw 2, \
     csv index 4 using 2:5 with linespoints pt 7 ps 0.59 lc rgb purple lw 2, \
     csv index 5 using 2:5 with linespoints pt 7 ps 0.59 lc rgb green lw 2
unset multiplot
