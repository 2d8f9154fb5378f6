# 10-ride.gp - sh figures/draw/chart.sh figures/10/10-ride.gp DATA.csv CHART.svg
# Blocks: 1 A, 2 B, 3 points, 4 gap; 5 to 8 the same later, 9 nearest then, 10
# gaps; 11 capsule, 12 core, 13 core's point and B's, 14 on the surfaces, 15 gap
# (Block 0 is the head.)
high = 310
load "figures/draw/chart.gp"
set datafile separator comma
unset border
unset tics
set size ratio -1
set style fill solid 0.25 noborder
set multiplot layout 1,3
set lmargin 0.5
set rmargin 0.5
set tmargin 2.6
set bmargin 2.6
set xrange [-0.85:0.85]
set yrange [-0.25:1.87]
set style arrow 1 head filled size screen 0.008,22 lc rgb orange lw 2.2

set title "asked"
set label 1 "A" at 0.05,1.5 center font bold textcolor rgb purple front
set label 2 "B" at 0,0.1 center font bold textcolor rgb blue front
set label 3 "s" at 0.02,0.67 textcolor rgb orange front
set label 4 "the nearest points, and s" at graph 0.5,-0.05 center textcolor rgb ink front
plot csv index 1 with filledcurves closed lc rgb purple, csv index 2 with filledcurves closed lc rgb blue, \
     csv index 1 with lines lc rgb purple, csv index 2 with lines lc rgb blue, \
     csv index 4 using 1:2:3:4 with vectors as 1, \
     csv index 3 with points pt 7 ps 0.6 lc rgb ink

set title "later"
set label 1 at -0.04,1.42 front
set label 3 at -0.3,0.66 front
set label 4 "dots rode; circles: nearest now" front
plot csv index 5 with filledcurves closed lc rgb purple, csv index 6 with filledcurves closed lc rgb blue, \
     csv index 5 with lines lc rgb purple, csv index 6 with lines lc rgb blue, \
     csv index 8 using 1:2:3:4 with vectors as 1, \
     csv index 9 with points pt 6 ps 1.1 lc rgb ink, \
     csv index 7 with points pt 7 ps 0.6 lc rgb ink

set title "round"
set label 1 at -0.2,1.37 front
set label 3 at 0.4,0.72 front
set label 4 "a core, and a radius around it" front
plot csv index 11 with filledcurves closed lc rgb purple, csv index 2 with filledcurves closed lc rgb blue, \
     csv index 11 with lines lc rgb purple, csv index 2 with lines lc rgb blue, \
     csv index 12 with lines lc rgb purple lw 2.5, \
     csv index 13 with lines lc rgb quiet dt 3, \
     csv index 15 using 1:2:3:4 with vectors as 1, \
     csv index 13 with points pt 6 ps 0.7 lc rgb ink, \
     csv index 14 with points pt 7 ps 0.6 lc rgb ink
unset multiplot
