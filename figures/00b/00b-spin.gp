# 00b-spin.gp - sh figures/draw/chart.sh figures/00b/00b-spin.gp DATA.csv CHART.svg
high = 330
load "figures/draw/chart.gp"
set multiplot
eval box(15, 345, 25, 298)
set title "Only the push across the arm turns"
unset border
unset tics
set size ratio -1
set xrange [-0.35:3.2]
set yrange [-0.6:2.3]
cx = 2.0; cy = 0.9; l = sqrt(cx*cx + cy*cy); ax = cx/l; ay = cy/l
al = 0.55; ac = 1.05
set style arrow 1 head filled size 0.13,20 lw 2.5
set arrow 1 from 0,0 to cx,cy nohead lw 3 lc rgb grey
set arrow 2 from cx,cy to cx+al*ax-ac*ay,cy+al*ay+ac*ax as 1 lc rgb ink
set arrow 3 from cx,cy to cx-ac*ay,cy+ac*ax as 1 lc rgb orange
set arrow 4 from cx,cy to cx+al*ax,cy+al*ay as 1 lc rgb blue
set arrow 5 from cx-ac*ay,cy+ac*ax to cx+al*ax-ac*ay,cy+al*ay+ac*ax nohead dt 3 lw 1 lc rgb grey
set arrow 6 from cx+al*ax,cy+al*ay to cx+al*ax-ac*ay,cy+al*ay+ac*ax nohead dt 3 lw 1 lc rgb grey
set label 1 "axis" at 0,-0.22 center textcolor rgb quiet
set label 2 "x" at cx*0.5+0.1,cy*0.5-0.16 textcolor rgb ink
set label 3 "F" at cx+al*ax-ac*ay+0.08,cy+al*ay+ac*ax+0.06 textcolor rgb ink
set label 4 "across: turns" at cx-ac*ay-0.1,cy+ac*ax-0.02 right textcolor rgb orange
set label 5 "along:" at cx+al*ax+0.08,cy+al*ay+0.02 textcolor rgb blue
set label 7 "only pulls" at cx+al*ax+0.08,cy+al*ay-0.2 textcolor rgb blue
set label 6 "m" at cx+0.1,cy-0.2 textcolor rgb ink
plot "+" using (0):(0) every ::0::0 with points pt 6 ps 1.4 lw 2 lc rgb ink, \
     "+" using (cx):(cy) every ::0::0 with points pt 7 ps 1.9 lc rgb ink
unset label
unset arrow
set size noratio
eval axes
eval box(420, 700, 50, 298)
set title "A string pulls two weights in"
set xlabel "distance from the axis, m"
set ylabel "turns a second" offset 1,0
set xrange [0.35:1.05]
set yrange [0:3.5]
set label 1 "formula" at 0.62,1.55 textcolor rgb quiet
set label 2 "measured" at 0.47,2.5 textcolor rgb blue
plot 3/(2*pi)/x**2 with lines lc rgb grey lw 1.2, \
     csv index 0 using 2:3 with points pt 7 ps 0.6 lc rgb blue
unset multiplot
