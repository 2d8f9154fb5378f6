# 11-manifold.gp - sh figures/draw/chart.sh figures/11/11-manifold.gp DATA.csv CHART.svg
high = 770
load "figures/draw/chart.gp"
vermilion = orange
set multiplot

set origin 0,0.43
set size 1,0.57
set lmargin 4
set rmargin 4
set title "Two faces seen along the normal, and what they share"
set size ratio -1
set xrange [-1.05:1.6]
set yrange [-0.62:1.0]
unset border
unset xtics
unset ytics
unset grid
set label 1 "face of B" at -0.46,-0.43 textcolor rgb quiet front
set label 2 "face of A" at 0.62,0.7 right textcolor rgb quiet front
set label 3 "a vertex of A\nover B" at -0.54,0.47 right textcolor rgb green front
set label 4 "a vertex of\nB under A" at 0.45,0.42 right textcolor rgb blue front
set label 5 "an edge of A\nover one of B" at 0.56,-0.37 left textcolor rgb vermilion front
set label 6 "ringed: the touches\nthat are kept" at 1.0,0.62 left textcolor rgb ink front
set label 7 "×: where GJK found\nthem nearest" at 1.0,0.4 left textcolor rgb ink front
plot csv index 2 using 1:2 with filledcurves closed fc rgb pale(quiet, 0.1), \
     csv index 3 using 1:2 with filledcurves closed fc rgb pale(blue, 0.15) fs transparent solid 0.6, \
     csv index 2 using 1:2 with lines lc rgb quiet lw 1.2, \
     csv index 3 using 1:2 with lines lc rgb quiet lw 1.2, \
     csv index 4 using 1:($3==0?$2:1/0) with points pt 7 ps 1.43 lc rgb green, \
     csv index 4 using 1:($3==1?$2:1/0) with points pt 7 ps 1.43 lc rgb blue, \
     csv index 4 using 1:($3==2?$2:1/0) with points pt 7 ps 1.43 lc rgb vermilion, \
     csv index 5 using 1:2 with points pt 6 ps 2.6 lw 1.4 lc rgb ink, \
     csv index 6 using 1:2 with points pt 2 ps 1.3 lw 1.4 lc rgb ink
unset label

set origin 0,0
set size 1,0.43
set size noratio
set lmargin 12
set rmargin 20
set title "A flat box set down on a table, leaning by half a degree"
set xlabel "seconds" textcolor rgb ink
set ylabel "tilt, degrees" textcolor rgb ink offset 1,0
set logscale y 10
set xrange [0:3]
set yrange [1e-15:300]
set xtics 0,0.5,3 nomirror textcolor rgb ink
set ytics nomirror ("10" 10, "0.1" 0.1, "10^{−3}" 1e-3, "10^{−6}" 1e-6, "10^{−9}" 1e-9, "10^{−12}" 1e-12, "10^{−15}" 1e-15)
set label 1 "one point" at 3.05,3 textcolor rgb vermilion
set label 2 "up to four" at 3.05,7e-15 textcolor rgb blue font bold
plot csv index 0 using 1:2 with lines lc rgb vermilion lw 2, \
     csv index 1 using 1:2 with lines lc rgb blue lw 2
