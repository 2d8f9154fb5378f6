# 11-manifold.gp - sh figures/draw/chart.sh figures/11/11-manifold.gp DATA.csv CHART.svg
high = 680
load "figures/draw/chart.gp"
set multiplot

eval box(30, 690, 310, 645)
set title "Two faces seen along the normal, and what they share"
set size ratio -1
set xrange [-1.05:1.6]
set yrange [-0.6:1.0]
unset border
unset xtics
unset ytics
unset grid
set label 1 "face of B" at -0.46,-0.43 textcolor rgb quiet front
set label 2 "face of A" at 0.62,0.7 right textcolor rgb quiet front
set label 3 "a vertex of A\nover B" at -0.54,0.47 right textcolor rgb green front
set label 4 "a vertex of\nB under A" at 0.45,0.42 right textcolor rgb blue front
set label 5 "an edge of A\nover one of B" at 0.56,-0.37 left textcolor rgb orange front
set label 6 "ringed: the touches that are kept;  ×: where GJK found them nearest" at 0.28,-0.68 center textcolor rgb quiet front
plot csv index 2 using 1:2 with filledcurves closed fc rgb pale(grey, 0.12), \
     csv index 3 using 1:2 with filledcurves closed fc rgb pale(blue, 0.15), \
     csv index 2 using 1:2 with lines lc rgb quiet lw 1.2, \
     csv index 3 using 1:2 with lines lc rgb quiet lw 1.2, \
     csv index 4 using 1:($3==0?$2:1/0) with points pt 7 ps 1.43 lc rgb green, \
     csv index 4 using 1:($3==1?$2:1/0) with points pt 7 ps 1.43 lc rgb blue, \
     csv index 4 using 1:($3==2?$2:1/0) with points pt 7 ps 1.43 lc rgb orange, \
     csv index 5 using 1:2 with points pt 6 ps 2.6 lw 1.4 lc rgb ink, \
     csv index 6 using 1:2 with points pt 2 ps 1.3 lw 1.4 lc rgb ink
unset label

eval box(66, 610, 50, 240)
eval axes
set size noratio
set title "A flat box set down on a table, leaning by half a degree: tilt"
set xlabel "time, s" textcolor rgb ink
set logscale y 10
set xrange [0:3]
set yrange [5e-7:300]
set xtics 0,0.5,3
set ytics nomirror ("100°" 100, "1°" 1, "0.01°" 0.01, "10^{−4} °" 1e-4, "10^{−6} °" 1e-6)
set label 1 "one point" at 3.05,80 textcolor rgb orange
set label 2 "up to four" at 3.05,6e-6 textcolor rgb blue font bold
plot csv index 0 using 1:2 with lines lc rgb orange lw 2, \
     csv index 1 using 1:2 with lines lc rgb blue lw 2
