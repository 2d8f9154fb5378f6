# 03-walks.gp - a drawing: sh figures/draw/chart.sh figures/03/03-walks.gp - CHART.svg
high = 320
load "figures/draw/chart.gp"
unset border
unset tics
unset grid
set size ratio -1
set style arrow 1 head filled size 0.09,22 lw 2.4 lc rgb blue
set style arrow 2 head filled size 0.09,22 lw 2.4 lc rgb orange
set style arrow 3 head filled size 0.09,22 lw 2.4 lc rgb green
set style arrow 4 nohead lw 1 lc rgb grey
set multiplot

# From (a, b) to (c, d), shortened at both ends and moved to the left.
pull = 0.2
side = 0.085
len(a, b, c, d) = sqrt((c - a)**2 + (d - b)**2)
X(a, b, c, d, t) = a + (c - a) * t - side * (d - b) / len(a, b, c, d)
Y(a, b, c, d, t) = b + (d - b) * t + side * (c - a) / len(a, b, c, d)
half(n, a, b, c, d, s) = sprintf("set arrow %d from %g,%g to %g,%g as %d", n, X(a, b, c, d, pull / len(a, b, c, d)), Y(a, b, c, d, pull / len(a, b, c, d)), X(a, b, c, d, 1 - pull / len(a, b, c, d)), Y(a, b, c, d, 1 - pull / len(a, b, c, d)), s)

eval box(10, 310, 10, 284)
set label 91 "next: around a face" at screen 0.222222, screen 0.95 center textcolor rgb ink font bold
set xrange [-0.75:2.85]
set yrange [-0.4:2.3]
$corner << EOD
0 0
2 0
1 1.8
0 0
EOD
eval half(1, 0, 0, 2, 0, 2)
eval half(2, 2, 0, 1, 1.8, 1)
eval half(3, 1, 1.8, 0, 0, 1)
set label 1 "h" at 1,0.24 center textcolor rgb orange font bold
set label 2 "next of h" at 1.65,1.0 left textcolor rgb blue
set label 3 "and its\nnext" at 0.35,1.1 right textcolor rgb blue
set label 4 "origin of h" at 0,-0.25 left textcolor rgb ink
plot $corner using 1:2 with lines lc rgb grey, $corner using 1:2 with points pt 7 ps 1.2 lc rgb ink
unset arrow
unset label

eval box(350, 710, 10, 284)
set label 92 "twin, then next: around a vertex" at screen 0.736111, screen 0.95 center textcolor rgb ink font bold
set xrange [-1.95:1.95]
set yrange [-1.5:1.5]
$fan << EOD
1.4 0
0.75 1.25
-0.7 1.2
-1.45 0.1
-0.75 -1.2
0.7 -1.25
1.4 0
EOD
array fx[7] = [1.4, 0.75, -0.7, -1.45, -0.75, 0.7, 1.4]
array fy[7] = [0, 1.25, 1.2, 0.1, -1.2, -1.25, 0]
do for [k = 1:6] {
  eval half(k, 0, 0, fx[k], fy[k], k == 1 ? 2 : 1)
  eval half(10 + k, fx[k], fy[k], 0, 0, 3)
  set arrow 20 + k from 0,0 to fx[k],fy[k] as 4
}
set label 1 "h" at 0.75,0.26 center textcolor rgb orange font bold
set label 2 "its twin" at 1.0,-0.28 center textcolor rgb green
set label 3 "next of\nthe twin" at 0.95,-0.75 left textcolor rgb blue
plot $fan using 1:2 with lines lc rgb grey, $fan using 1:2 with points pt 7 ps 0.9 lc rgb ink, \
     "+" using (0):(0) every ::0::0 with points pt 7 ps 1.4 lc rgb ink
unset multiplot
