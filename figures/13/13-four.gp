# 13-four.gp - sh figures/draw/chart.sh figures/13/13-four.gp DATA.csv CHART.svg
high = 350
load "figures/draw/chart.gp"

unset border
unset tics
set size ratio -1
set lmargin 0.5
set rmargin 0.5
set tmargin 2.6
set bmargin 0.5
set multiplot
set style arrow 1 head filled size screen 0.012,22 lc rgb blue lw 2.4
set style arrow 2 head filled size screen 0.012,22 lc rgb green lw 2.4

set origin 0,0
set size 0.56,1
set title "four particles and six sticks" textcolor rgb ink
set xrange [-1.75:1.75]
set yrange [-1.3:1.3]
plot csv index 0 using 1:2:3:4 with vectors nohead lc rgb grey lw 1.4, \
     csv index 1 using 1:2:3:4 with vectors nohead lc rgb ink lw 1.2, \
     csv index 3 using 1:2:3:4 with vectors as 1, \
     csv index 2 with points pt 7 ps 1.95 lc rgb orange

set origin 0.56,0
set size 0.44,1
set title "a straight move, and a turn"
set xrange [-0.15:1.45]
set yrange [-0.35:1.2]
set label 1 "old radius" at 0.55,-0.09 center textcolor rgb ink
set label 2 "r sin a" at 1.04,0.3 left textcolor rgb green
set label 3 "a" at 0.3,0.1 center textcolor rgb ink
set object 1 circle at 0,0 size 0.2 arc [0:40.1] nowedge fs empty border rgb ink front
plot csv index 5 using 1:2:3:4 with vectors nohead lc rgb grey lw 1.6, \
     csv index 4 every ::0::0 using 1:2:3:4 with vectors nohead lc rgb ink lw 1.4, \
     csv index 4 every ::3::3 using 1:2:3:4 with vectors nohead lc rgb ink lw 1.4, \
     csv index 4 every ::1::2 using 1:2:3:4 with vectors as 2, \
     csv index 4 every ::1::1 using 1:2 with points pt 7 ps 1.56 lc rgb orange, \
     csv index 4 every ::3::3 using ($1+$3):($2+$4) with points pt 7 ps 1.56 lc rgb orange
unset multiplot
