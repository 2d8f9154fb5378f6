# 04-regions.gp - sh figures/draw/chart.sh figures/04/04-regions.gp DATA.csv CHART.svg
high = 330
load "figures/draw/chart.gp"
unset border
unset tics
set size ratio -1
near = orange; pale = grey
set multiplot
set clip two
set bmargin at screen 0.005
set tmargin at screen 0.995

# A segment: two lines across its ends make three strips.
set lmargin at screen 0.002
set rmargin at screen 0.430
set xrange [-0.95:4.15]
set yrange [-1.45:3.95]
set object 1 rectangle from graph 0,0 to graph 1,1 behind fc rgb pale(grey, 0.08) fs solid noborder
ex = 2.4; ey = 0.6
set arrow 1 from 0.4+2*ey/2,0.75-2*ex/2 to 0.4-2.2*ey/2,0.75+2.2*ex/2 nohead lc rgb pale lw 1.0 dt 2
set arrow 2 from 2.8+2*ey/2,1.35-2*ex/2 to 2.8-2.0*ey/2,1.35+2.0*ex/2 nohead lc rgb pale lw 1.0 dt 2
set label 1 "+ −" at -0.45,1.9 center textcolor rgb ink font bold
set label 2 "+ +" at 1.42,2.2 center textcolor rgb blue font bold
set label 3 "− +" at 3.35,2.35 center textcolor rgb ink font bold
set label 4 "0" at 0.32,0.42 center textcolor rgb blue font bold
set label 5 "1" at 2.95,1.05 center textcolor rgb blue font bold
plot csv index 0 using 1:2 with linespoints lc rgb blue lw 3 pt 7 ps 1.04
unset label
unset arrow

# A triangle: the lines of its sides make seven regions.
set lmargin at screen 0.435
set rmargin at screen 0.998
set xrange [-1.65:5.05]
set yrange [-1.45:3.95]
signs(s) = s[1:1].' '.s[2:*]
set label 4 "0" at -0.02,0.28 right textcolor rgb blue font bold front
set label 5 "1" at 3.2,0.55 center textcolor rgb blue font bold front
set label 6 "2" at 1.22,2.35 center textcolor rgb blue font bold front
plot csv index 1 using 1:2 with filledcurves closed fc rgb blue fs transparent solid 0.15 noborder, \
     csv index 2 using 1:2 with lines lc rgb pale lw 1.0 dt 2, \
     csv index 1 using 1:2 with lines lc rgb blue lw 2.6, \
     csv index 4 using 1:2:($3-$1):($4-$2) with vectors lc rgb near lw 1.6, \
     csv index 4 using 1:2 with points pt 7 ps 0.78 lc rgb near, \
     csv index 3 using 1:2:3 with labels font bold textcolor rgb ink
unset multiplot
