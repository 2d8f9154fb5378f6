# 14-broad.gp - sh figures/draw/chart.sh figures/14/14-broad.gp DATA.csv CHART.svg
high = 698
load "figures/draw/chart.gp"
stats csv index 0 using 6 name "PAIRS" nooutput
stats csv index 0 using 7 name "WRONG" nooutput
set multiplot

eval box(72, 590, 374, 664)
set logscale xy 10
set title "Which bodies of a room may meet? Time of a frame"
set xlabel "bodies" textcolor rgb ink
set xrange [9:11000]
set yrange [0.15:200000]
set xtics ("10" 10, "30" 30, "100" 100, "300" 300, "1,000" 1000, "3,000" 3000, "10,000" 10000)
set ytics ("1 µs" 1, "10 µs" 10, "100 µs" 100, "1 ms" 1000, "10 ms" 10000, "100 ms" 100000)
set label 1 "every pair" at 12500,180000 textcolor rgb orange
set label 2 "the tree" at 12500,3000 textcolor rgb blue font bold
set label 3 "one sorted line" at 12500,11000 textcolor rgb quiet
set label 4 sprintf("%.2f million pairs\nin all frames; not by\nall three ways: %.0f", PAIRS_sum / 1e6, WRONG_sum) at 11,90000 textcolor rgb ink
plot csv index 0 using 1:3 with linespoints pt 7 ps 0.52 lc rgb orange lw 2, \
     csv index 0 using 1:4 with lines dt 3 lc rgb quiet lw 1.5, \
     csv index 0 using 1:2 with linespoints pt 7 ps 0.52 lc rgb blue lw 2
unset label

eval box(130, 640, 52, 282)
unset logscale y
set title "A thousand bodies, in a room and elsewhere: time of a frame"
set xlabel "time of a frame"
set xrange [9:40000]
set xtics ("100 µs" 100, "1 ms" 1000, "10 ms" 10000)
set grid noytics
set label 1 "the tree" at 90,-0.8 center textcolor rgb blue font bold
set label 2 "every pair" at 2300,-0.8 center textcolor rgb orange
set yrange [6.6:-1.3]
unset ytics
set ytics scale 0 textcolor rgb ink
plot csv index 1 using 2:0:($3-$2):(0) with vectors nohead lc rgb pale(grey, 0.4) lw 2, \
     csv index 1 using 2:0:ytic(1) with points pt 7 ps 1.3 lc rgb blue, \
     csv index 1 using 4:0 with points pt 6 ps 1.1 lc rgb quiet, \
     csv index 1 using 3:0 with points pt 7 ps 1.3 lc rgb orange
unset multiplot
