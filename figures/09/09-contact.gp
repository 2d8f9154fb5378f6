# 09-contact.gp - sh figures/draw/chart.sh figures/09/09-contact.gp DATA.csv CHART.svg
# Blocks: 1 A, 2 B, 3 points, 4 normal; 5 leaf, 6, 7; 8 and 9 leaves, 10, 11
# 12 A over a plane, 13, 14.  (Block 0 is the head.)
high = 250
load "figures/draw/chart.gp"
set datafile separator comma
a = purple; b = blue; normal = orange
unset border
unset tics
set size ratio -1
set style fill solid 0.25 noborder
set multiplot layout 1,4
set lmargin 0.5
set rmargin 0.5
set tmargin 2.6
set bmargin 3
set xrange [-0.78:0.78]
set yrange [-0.55:1.62]
set style arrow 1 head filled size screen 0.012,22 lc rgb normal lw 2.2

set title "rigid on rigid" textcolor rgb ink
set label 1 "A" at 0.2,1.0 center font bold textcolor rgb purple front
set label 2 "B" at 0,-0.1 center font bold textcolor rgb blue front
set label 3 "n" at 0.12,0.86 textcolor rgb normal front
set label 4 "apart = margin" at graph 0.5,-0.06 center textcolor rgb ink front
plot csv index 1 with filledcurves closed lc rgb a, csv index 2 with filledcurves closed lc rgb b, \
     csv index 1 with lines lc rgb a, csv index 2 with lines lc rgb b, \
     csv index 4 using 1:2:3:4 with vectors as 1, \
     csv index 3 with points pt 7 ps 0.91 lc rgb ink

set title "leaf on rigid"
set label 1 at -0.42,0.95 front
set label 3 at 0.02,0.9 front
set label 4 "apart = thickness" front
plot csv index 5 with filledcurves closed lc rgb a, csv index 2 with filledcurves closed lc rgb b, \
     csv index 5 with lines lc rgb a, csv index 2 with lines lc rgb b, \
     csv index 7 using 1:2:3:4 with vectors as 1, \
     csv index 6 with points pt 7 ps 0.91 lc rgb ink

set title "leaf on leaf"
set label 1 at -0.42,0.72 front
set label 2 at 0.42,-0.02 front
set label 3 at 0.0,0.62 front
set label 4 "apart = sum of radii" front
plot csv index 8 with filledcurves closed lc rgb a, csv index 9 with filledcurves closed lc rgb b, \
     csv index 8 with lines lc rgb a, csv index 9 with lines lc rgb b, \
     csv index 11 using 1:2:3:4 with vectors as 1, \
     csv index 10 with points pt 7 ps 0.91 lc rgb ink

set title "particle on plane"
set label 1 at 0.1,0.5 front
unset label 2
set label 3 at 0.2,0.36 front
set label 4 "B = the world" front
set object 1 rectangle from -0.78,-0.5 to 0.78,0 fc rgb b fs solid 0.25 noborder behind
plot csv index 12 with filledcurves closed lc rgb a, csv index 12 with lines lc rgb a, \
     csv index 14 using 1:2:3:4 with vectors as 1, \
     csv index 13 with points pt 7 ps 0.91 lc rgb ink
unset multiplot
