# 01-orbit.gp - sh figures/draw/chart.sh figures/01/01-orbit.gp DATA.csv CHART.svg
high = 560
load "figures/draw/chart.gp"
set size ratio -1
unset border
unset tics
set lmargin 0
set rmargin 0
set tmargin 0
set bmargin 0
set label 3 "five orbits of 60 steps" at -0.2,-3.3 left textcolor rgb quiet
set xrange [-3.3:3.3]
set yrange [-3.6:1.95]
set label 1 "explicit Euler" at 1.45,1.3 textcolor rgb orange
set label 2 "Verlet" at -0.55,-0.55 textcolor rgb blue font bold
plot csv using 1:2 with linespoints pt 7 ps 0.33 lc rgb orange lw 1.2, \
     csv using 3:4 with linespoints pt 7 ps 0.33 lc rgb blue lw 1.5, \
     "+" using (0):(0) every ::0::0 with points pt 7 ps 1.95 lc rgb ink
