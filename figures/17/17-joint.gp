# 17-joint.gp - sh figures/draw/chart.sh figures/17/17-joint.gp DATA.csv CHART.svg
high = 280
load "figures/draw/chart.gp"
a = purple; b = blue
unset border
unset tics
set size ratio -1
set style fill solid 0.22 noborder
set lmargin 0.5
set rmargin 0.5
set tmargin 2.6
set bmargin 0.5
set style arrow 2 head filled size screen 0.009,24 lc rgb ink lw 1.6
set style arrow 3 head filled size screen 0.011,22 lc rgb green lw 2.4
set style arrow 4 head filled size screen 0.009,22 lc rgb orange lw 2
set multiplot layout 1,2

set xrange [-1.5:1.5]
set yrange [-0.4:1.4]
set title "two points that should be one" textcolor rgb ink
set label 1 "A" at -1.08,0.62 center font bold textcolor rgb purple front
set label 2 "B" at 1.05,0.62 center font bold textcolor rgb blue front
set label 3 "r_A" at -0.52,0.58 textcolor rgb ink front
set label 4 "r_B" at 0.46,0.5 textcolor rgb ink front
set label 5 "λ" at 0.58,0.2 textcolor rgb green front
set label 6 "– λ" at -0.66,0.38 right textcolor rgb green front
plot csv index 0 with filledcurves closed lc rgb a, csv index 1 with filledcurves closed lc rgb b, \
     csv index 0 with lines lc rgb a, csv index 1 with lines lc rgb b, \
     csv index 4 using 1:2:3:4 with vectors as 2, \
     csv index 5 every ::0::0 using 1:($2+0.07):3:4 with vectors as 3, \
     csv index 5 every ::1::1 using 1:($2-0.07):3:4 with vectors as 3, \
     csv index 2 with points pt 7 ps 0.65 lc rgb ink, \
     csv index 3 with points pt 7 ps 0.91 lc rgb ink
unset label

set title "from the tips to the root"
set xrange [-1.5:1.5]
set yrange [-0.6:1.35]
set label 1 "root" at 0,0.55 center textcolor rgb ink front
plot csv index 6 with filledcurves closed lc rgb b, csv index 6 with lines lc rgb b, \
     csv index 8 using 1:2:3:4 with vectors as 4, \
     csv index 7 with points pt 7 ps 0.85 lc rgb ink
unset multiplot
