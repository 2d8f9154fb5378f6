# 13-contact.gp - sh figures/draw/chart.sh figures/13/13-contact.gp DATA.csv CHART.svg
high = 290
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
set style arrow 1 head filled size screen 0.011,22 lc rgb orange lw 2.4
set style arrow 2 head filled size screen 0.009,24 lc rgb ink lw 1.6
set style arrow 3 head filled size screen 0.011,22 lc rgb green lw 2.4
set multiplot layout 1,3

set xrange [-1.15:1.15]
set yrange [-0.5:1.8]
set title "where they touch" textcolor rgb ink
set label 1 "A" at 0.52,0.98 center font bold textcolor rgb purple front
set label 2 "B" at 0.6,-0.15 center font bold textcolor rgb blue front
set label 3 "n" at -0.45,1.06 right textcolor rgb orange front
set label 4 "r_A" at -0.1,0.78 textcolor rgb ink front
set label 5 "r_B" at -0.17,0.28 textcolor rgb ink front
set label 6 "g" at -0.36,0.48 textcolor rgb ink front
set arrow 1 from -0.4,0.4 to -0.4,0.56 nohead lc rgb ink lw 1 front
plot csv index 0 with filledcurves closed lc rgb a, csv index 1 with filledcurves closed lc rgb b, \
     csv index 0 with lines lc rgb a, csv index 1 with lines lc rgb b, \
     csv index 4 using 1:2:3:4 with vectors as 2, \
     csv index 5 using 1:2:3:4 with vectors as 1, \
     csv index 2 with points pt 7 ps 0.65 lc rgb ink, \
     csv index 3 with points pt 7 ps 0.91 lc rgb ink
unset arrow

set title "an impulse"
unset label 3
unset label 4
unset label 5
unset label 6
set label 3 "λ n" at -0.36,1.02 left textcolor rgb green front
set label 4 "– λ n" at -0.52,0.05 right textcolor rgb green front
plot csv index 0 with filledcurves closed lc rgb a, csv index 1 with filledcurves closed lc rgb b, \
     csv index 0 with lines lc rgb a, csv index 1 with lines lc rgb b, \
     csv index 6 using 1:2:3:4 with vectors as 3, \
     for [k=7:8] csv index k using 1:2:3:4 with vectors nohead lc rgb ink lw 1.6, \
     for [k=7:8] csv index k using 1:2:3:4 every ::9::9 with vectors as 2, \
     csv index 2 with points pt 7 ps 0.65 lc rgb ink, \
     csv index 3 with points pt 7 ps 0.91 lc rgb ink
unset label
unset object

set title "Coulomb’s cone"
set xrange [-1.15:1.15]
set yrange [-0.5:1.8]
set object 1 rectangle from -1.1,-0.5 to 1.1,0 fc rgb b fs solid 0.22 noborder behind
set object 2 polygon from 0,0 to 0.6,1.2 to -0.6,1.2 to 0,0 fc rgb a fs solid 0.22 noborder behind
set arrow 1 from 0,0 to 0,1.2 as 1
set arrow 2 from 0,0 to 0.36,1.2 as 3
set arrow 3 from 0,1.2 to 0.6,1.2 nohead lc rgb ink lw 1.4
set arrow 4 from 0,1.2 to 0.9,1.2 head filled size screen 0.009,22 lc rgb ink lw 1.4 dt (4,4)
set arrow 5 from 0,0 to 0.6,1.2 as 3
set label 1 "λ" at -0.06,0.75 right textcolor rgb orange front
set label 2 "μ λ" at 0.32,1.3 center textcolor rgb ink front
set label 3 "holds" at 0.06,0.98 textcolor rgb green font small front
set label 4 "slides" at 0.46,0.72 textcolor rgb green font small front
set label 5 "wanted" at 0.9,1.32 center textcolor rgb ink font small front
plot NaN notitle
unset multiplot
